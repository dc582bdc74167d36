/*
 * The mask in the GL: one buffer with the shapes of all views, in texels of the atlas, drawn into
 * depth or stencil alone.
 */
#include "error.h"
#include "filter_gl.h"
#include "gl_objects.h"
#include "host_buffer.h"
#include "host_mask.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"

/* Where views can be placed: as far as targets. */
enum { CORNER_MAX_PX = 1 << 24 };

int mask_check_params(const struct cupola_gl_params *params, struct cupola_error *error)
{
    bool atlas = params->storage == CUPOLA_STORAGE_ATLAS;
    if (params->mask < CUPOLA_MASK_AUTO || params->mask > CUPOLA_MASK_STENCIL)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "mask is %d; allowed: %d to %d",
                         (int)params->mask, CUPOLA_MASK_AUTO, CUPOLA_MASK_STENCIL);
    if (atlas && params->mask == CUPOLA_MASK_DEPTH && params->depth == CUPOLA_DEPTH_NONE)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "mask is depth, and the views have none; allowed: auto, none");
    if (atlas && params->mask == CUPOLA_MASK_STENCIL && !views_format_has_stencil(params->depth))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "mask is stencil, and the views' depth format has none; allowed: %s or a "
                         "depth format with stencil",
                         params->depth == CUPOLA_DEPTH_NONE ? "none" : "depth");
    return CUPOLA_OK;
}

/* What is made; a host's textures may be masked in either way. */
static enum cupola_mask choose(const cupola_gl *gl)
{
    const struct cupola_gl_params *params = &gl->params;
    if (!shows_source(gl, CUPOLA_SOURCE_VIEWS))
        return CUPOLA_MASK_NONE;
    if (params->mask != CUPOLA_MASK_AUTO)
        return params->mask;
    bool depth = params->storage != CUPOLA_STORAGE_ATLAS || params->depth != CUPOLA_DEPTH_NONE;
    return depth && !gl->plan.unmasked ? CUPOLA_MASK_DEPTH : CUPOLA_MASK_NONE;
}

static GLsizeiptr vertex_bytes(int count)
{
    return (GLsizeiptr)((size_t)count * sizeof(struct mask_vertex));
}

static void upload(const struct mask *mask)
{
    glBufferSubData(GL_ARRAY_BUFFER, 0, vertex_bytes(mask->vertex_count), mask->vertices);
}

static int create_buffer(cupola_gl *gl, struct cupola_error *error)
{
    struct mask_pass *pass = &gl->mask;
    struct host_buffer host;
    glGenBuffers(1, &pass->buffer);
    if (!pass->buffer)
        return gl_refused(glGetError(), error, "a buffer for the mask");
    pass->array = vertex_array_create(&gl->guest, "mask", error);
    if (!pass->array)
        return error->status;
    host_buffer_save(&host);
    glBindBuffer(GL_ARRAY_BUFFER, pass->buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(struct mask_vertex), NULL);
    gl_errors_drop();
    glBufferData(GL_ARRAY_BUFFER, vertex_bytes(pass->mask.vertex_most), NULL,
                 gl->plan.head_radius_m > 0 ? GL_DYNAMIC_DRAW : GL_STATIC_DRAW);
    upload(&pass->mask);
    GLenum failure = glGetError();
    guest_name(&gl->guest, GL_BUFFER, pass->buffer, "mask of the views");
    host_buffer_restore(&host);
    return failure == GL_NO_ERROR ? CUPOLA_OK : gl_refused(failure, error, "a buffer for the mask");
}

static int create_program(cupola_gl *gl, struct cupola_error *error)
{
    static const struct shader_file vertex = {"mask.vert", shader_mask_vert};
    static const struct shader_file fragment = {"mask.frag", shader_mask_frag};
    struct mask_pass *pass = &gl->mask;
    pass->program = program_create_by(&vertex, "", &fragment, 1, error);
    if (!pass->program)
        return error->status;
    pass->area = glGetUniformLocation(pass->program, "area");
    pass->nearest = glGetUniformLocation(pass->program, "nearest");
    guest_name(&gl->guest, GL_PROGRAM, pass->program, "mask of the views");
    return CUPOLA_OK;
}

int mask_pass_create(cupola_gl *gl, struct cupola_error *error)
{
    struct mask_pass *pass = &gl->mask;
    bool middles = gl->params.storage == CUPOLA_STORAGE_ATLAS && gl->sample_count <= 1;
    pass->kind = choose(gl);
    if (pass->kind == CUPOLA_MASK_NONE)
        return CUPOLA_OK;
    int status = mask_create(&gl->plan, middles, &pass->mask, error);
    if (status == CUPOLA_OK)
        status = create_buffer(gl, error);
    if (status == CUPOLA_OK)
        status = create_program(gl, error);
    if (status == CUPOLA_OK && !(gl->plan.head_radius_m > 0))
        mask_settle(&pass->mask);
    return status;
}

void mask_pass_destroy(struct mask_pass *pass)
{
    glDeleteProgram(pass->program);
    glDeleteVertexArrays(1, &pass->array);
    glDeleteBuffers(1, &pass->buffer);
}

void mask_pass_forget(struct mask_pass *pass)
{
    mask_destroy(&pass->mask);
}

/* The shapes for the eye as it is now, if it has moved since. */
static void follow(cupola_gl *gl)
{
    struct host_buffer host;
    bool kept = !gl->guest.leaves_state;
    if (gl->mask.moves == gl->moves || !(gl->plan.head_radius_m > 0))
        return; /* an eye may be told to move from 0 to -0 */
    mask_refit(&gl->plan, &gl->mask.mask);
    if (kept)
        host_buffer_save(&host);
    glBindBuffer(GL_ARRAY_BUFFER, gl->mask.buffer);
    upload(&gl->mask.mask);
    if (kept)
        host_buffer_restore(&host);
    gl->mask.moves = gl->moves;
}

void mask_lay(cupola_gl *gl, int view, enum cupola_mask kind, const struct cupola_rect *area,
              bool reversed)
{
    const struct mask *mask = &gl->mask.mask;
    struct host_mask host;
    follow(gl);
    host_mask_begin(&host, &gl->features, kind == CUPOLA_MASK_STENCIL, !gl->guest.leaves_state);
    glUseProgram(gl->mask.program);
    glUniform4f(gl->mask.area, (GLfloat)area->x, (GLfloat)area->y, (GLfloat)area->width,
                (GLfloat)area->height);
    glUniform1f(gl->mask.nearest, reversed ? 1 : -1);
    glBindVertexArray(gl->mask.array);
    if (view < 0)
        glDrawArrays(GL_TRIANGLES, 0, mask->vertex_count);
    else
        glDrawArrays(GL_TRIANGLES, mask->first[view], mask->count[view]);
    host_mask_end(&host, &gl->features);
}

/* Whether a host's view may be masked there. */
static int check_rect(const cupola_gl *gl, int index, const struct cupola_rect *rect,
                      struct cupola_error *error)
{
    const struct cupola_rect *planned = &gl->plan.views[index].rect;
    int guard = gl->plan.guard_px;
    if (rect->x < -CORNER_MAX_PX || rect->x > CORNER_MAX_PX || rect->y < -CORNER_MAX_PX ||
        rect->y > CORNER_MAX_PX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "the rectangle's corner is (%d, %d); allowed: -2^24 to 2^24", rect->x,
                         rect->y);
    /* What filters reach has to lie within the guard band. */
    int reach = filter_guard_px(&gl->params.filter);
    int width = (reach * planned->width + guard - 1) / guard;
    int height = (reach * planned->height + guard - 1) / guard;
    if (rect->width < width || rect->height < height)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "view %d of %d x %d texels is masked in %d x %d; allowed: %d x %d at "
                         "least, where the guard band of %d texels is %s",
                         index, planned->width, planned->height, rect->width, rect->height, width,
                         height, guard, reach > 1 ? "two" : "one");
    return CUPOLA_OK;
}

static int check(cupola_gl *gl, int index, enum cupola_mask mask, const struct cupola_rect *rect,
                 struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (gl->params.storage == CUPOLA_STORAGE_ATLAS || gl->mask.kind == CUPOLA_MASK_NONE)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made for views of its own, or without masks; allowed: one with "
                         "views, storage textures or layers and a mask");
    if (index < 0 || index >= gl->plan.view_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "view is %d; allowed: 0 to %d", index,
                         gl->plan.view_count - 1);
    if (mask != CUPOLA_MASK_DEPTH && mask != CUPOLA_MASK_STENCIL)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "mask is %d; allowed: depth (%d), "
                         "stencil (%d)",
                         (int)mask, CUPOLA_MASK_DEPTH, CUPOLA_MASK_STENCIL);
    int status = rect ? check_rect(gl, index, rect, error) : CUPOLA_OK;
    return status == CUPOLA_OK ? guest_check(&gl->guest, error) : status;
}

static int mask_view(cupola_gl *gl, int index, enum cupola_mask mask,
                     const struct cupola_rect *rect, bool reversed, struct cupola_error *error)
{
    struct guest_work work;
    int status = check(gl, index, mask, rect, error);
    if (status != CUPOLA_OK)
        return status;
    if (!gl->guest.leaves_state &&
        glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return error_set(error, CUPOLA_ERROR_GL,
                         "the framebuffer that is bound for drawing is not complete");
    const struct cupola_rect *planned = &gl->plan.views[index].rect;
    struct cupola_rect place = rect ? *rect : *planned;
    if (!rect)
        place.x = place.y = 0;
    guest_begin(&gl->guest, &work, "mask of view %d", index);
    host_set_area(&gl->features, place.x, place.y, place.width, place.height);
    mask_lay(gl, index, mask, planned, reversed);
    guest_end(&gl->guest, &work);
    return CUPOLA_OK;
}

int cupola_gl_mask(cupola_gl *gl, int index, enum cupola_mask mask, const struct cupola_rect *rect,
                   bool reversed, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, mask_view(gl, index, mask, rect, reversed, error), error);
}
