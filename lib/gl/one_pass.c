/* All views in one pass: their viewports, the uniform block, begun and ended. */
#include "one_pass.h"

#include <math.h>

#include "error.h"
#include "geometry/vector.h"
#include "gl_objects.h"
#include "host_buffer.h"
#include "instance.h"

/* As std140 lays it out; shaders/pass.glsl. */
struct block {
    GLfloat clip[CUPOLA_VIEWS_MAX][16];
    GLint view_count, padding[3];
};

_Static_assert(CUPOLA_VIEWS_MAX == 8, "the number that stands in shaders/pass.glsl");

int one_pass_create(cupola_gl *gl, struct cupola_error *error)
{
    struct host_buffer host;
    int way = pass_way_find(error);
    if (way < 0)
        return way;
    gl_errors_drop();
    glGenBuffers(1, &gl->pass_buffer);
    if (!gl->pass_buffer)
        return gl_refused(glGetError(), error, "a buffer's name");
    host_buffer_save(&host);
    glBindBuffer(GL_ARRAY_BUFFER, gl->pass_buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof(struct block), NULL, GL_DYNAMIC_DRAW);
    GLenum failure = glGetError();
    guest_name(&gl->guest, GL_BUFFER, gl->pass_buffer, "one pass");
    host_buffer_restore(&host);
    return failure == GL_NO_ERROR
               ? CUPOLA_OK
               : gl_refused(failure, error, "a buffer of %zu bytes", sizeof(struct block));
}

void one_pass_destroy(cupola_gl *gl)
{
    glDeleteBuffers(1, &gl->pass_buffer);
}

static void widen4(const float from[16], double to[16])
{
    for (int i = 0; i < 16; i++)
        to[i] = (double)from[i];
}

static void clip_matrix(const struct cupola_camera *camera, const float *world, GLfloat clip[16])
{
    double projection[16], view[16], to_camera[16], from_camera[16], from_world[16];
    widen4(camera->projection, projection);
    widen4(camera->view, view);
    multiply4(projection, view, from_camera);
    if (world) {
        widen4(world, to_camera);
        multiply4(from_camera, to_camera, from_world);
    }
    for (int i = 0; i < 16; i++)
        clip[i] = (GLfloat)(world ? from_world[i] : from_camera[i]);
}

static void write_block(const cupola_gl *gl, const struct cupola_gl_pass *pass, const float *world)
{
    struct block block = {.view_count = pass->view_count};
    struct host_buffer host;
    for (int i = 0; i < pass->view_count; i++)
        clip_matrix(&pass->views[i].camera, world, block.clip[i]);
    if (!gl->guest.leaves_state)
        host_buffer_save(&host);
    glBindBuffer(GL_ARRAY_BUFFER, gl->pass_buffer);
    glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof block, &block);
    if (!gl->guest.leaves_state)
        host_buffer_restore(&host);
}

static int check(const cupola_gl *gl, const float *world, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (!gl->params.one_pass)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made without one_pass; allowed: one that was made with it");
    if (open_kind(gl))
        return error_set(error, CUPOLA_ERROR_ORDER, "pass_begin inside of a %s; end it first",
                         open_kind(gl));
    if (!gl->frame_begun)
        return error_set(error, CUPOLA_ERROR_ORDER,
                         "pass_begin before frame_begin; begin a frame first");
    for (int i = 0; world && i < 16; i++)
        if (!isfinite(world[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "world[%d] is %g; allowed: any finite number", i, (double)world[i]);
    return CUPOLA_OK;
}

static int describe(const cupola_gl *gl, struct cupola_gl_pass *pass, struct cupola_error *error)
{
    *pass = (struct cupola_gl_pass){.framebuffer = gl->framebuffer,
                                    .buffer = gl->pass_buffer,
                                    .view_count = gl->plan.view_count};
    for (int i = 0; i < pass->view_count; i++) {
        struct cupola_gl_view *view = &pass->views[i];
        *view =
            (struct cupola_gl_view){.framebuffer = gl->framebuffer, .rect = gl->plan.views[i].rect};
        int status = cupola_plan_camera(&gl->plan, i, &gl->frame.depth, &view->camera, error);
        if (status != CUPOLA_OK)
            return status;
    }
    return CUPOLA_OK;
}

static int pass_begin(cupola_gl *gl, const float *world, struct cupola_gl_pass *out,
                      struct cupola_error *error)
{
    struct cupola_gl_pass pass;
    struct guest_work work;
    int status = check(gl, world, error);
    if (status != CUPOLA_OK || (status = describe(gl, &pass, error)) != CUPOLA_OK ||
        (status = guest_check(&gl->guest, error)) != CUPOLA_OK)
        return status;
    guest_begin(&gl->guest, &work, "pass");
    gl->host_target = work.state.target;
    gl->view_grouped = work.grouped;
    if (!gl->guest.leaves_state)
        host_areas_save(&gl->host_areas, pass.view_count);
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    views_clear(gl, -1);
    write_block(gl, &pass, world);
    host_state_restore(&work.state); /* the group stays open for what the host draws */
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    for (int i = 0; i < pass.view_count; i++)
        host_areas_set(i, &pass.views[i].rect);
    gl->pass_open = true;
    if (out)
        *out = pass;
    return CUPOLA_OK;
}

int cupola_gl_pass_begin(cupola_gl *gl, const float world[16], struct cupola_gl_pass *pass,
                         struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, pass_begin(gl, world, pass, error), error);
}

static int pass_end(cupola_gl *gl, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (!gl->pass_open && !gl->guest.lost)
        return error_set(error, CUPOLA_ERROR_ORDER, "pass_end outside of a pass; begin one first");
    int status = guest_check(&gl->guest, error);
    if (status == CUPOLA_ERROR_LOST)
        gl->pass_open = false;
    if (status != CUPOLA_OK)
        return status;
    if (!gl->guest.leaves_state)
        host_areas_restore(&gl->host_areas);
    views_finish(gl, 0, gl->plan.view_count);
    gl->pass_open = false;
    return CUPOLA_OK;
}

int cupola_gl_pass_end(cupola_gl *gl, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, pass_end(gl, error), error);
}
