/* The views of a frame: each is cleared, handed to the host, and resolved when it ends. */
#include "error.h"
#include "host_view.h"
#include "instance.h"

static int frame_begin(cupola_gl *gl, const struct cupola_frame *frame, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (!shows_source(gl, CUPOLA_SOURCE_VIEWS))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made without views; allowed: one whose sources have them");
    if (gl->params.storage != CUPOLA_STORAGE_ATLAS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made for textures of the host's, which cupola_gl_views_import "
                         "takes; allowed: one with storage atlas");
    if (open_kind(gl))
        return error_set(error, CUPOLA_ERROR_ORDER, "frame_begin inside of a %s; end it first",
                         open_kind(gl));
    struct cupola_frame wished = frame ? *frame : (struct cupola_frame){.clear_color = {0}};
    struct cupola_camera camera;
    int status = cupola_plan_camera(&gl->plan, 0, &wished.depth, &camera, error);
    if (status != CUPOLA_OK ||
        (status = color_check("clear_color", wished.clear_color, error)) != CUPOLA_OK)
        return status;
    gl->frame = wished;
    gl->frame_begun = true;
    gl->views_begun = 0;
    return gl->plan.view_count;
}

int cupola_gl_frame_begin(cupola_gl *gl, const struct cupola_frame *frame,
                          struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, frame_begin(gl, frame, error), error);
}

/* Colour in linear light, depth to the far end, stencil to 0. */
static void clear_area(const cupola_gl *gl)
{
    const struct cupola_frame *frame = &gl->frame;
    const GLfloat farthest = frame->depth.reversed ? 0 : 1;
    bool stencil = views_have_stencil(gl), kept = !gl->guest.leaves_state;
    GLuint stencil_mask = stencil ? host_stencil_unmask(kept) : 0;
    if (gl->params.format == CUPOLA_FORMAT_SRGB8)
        host_set_encoding(&gl->features, true); /* until host_state_restore */
    glClearBufferfv(GL_COLOR, 0, frame->clear_color);
    if (stencil)
        glClearBufferfi(GL_DEPTH_STENCIL, 0, farthest, 0);
    else if (gl->depth)
        glClearBufferfv(GL_DEPTH, 0, &farthest);
    if (stencil && kept)
        host_stencil_mask(stencil_mask);
}

/*
 * The first view of a frame clears and masks the whole atlas: most GLs only note that all of a
 * framebuffer is clear, but draw where a part of it is to be. A view that begins again, or for
 * another eye, clears its own part.
 */
void views_clear(cupola_gl *gl, int index)
{
    const struct cupola_plan_report *report = &gl->plan.report;
    struct cupola_rect area = {0, 0, report->atlas_width_px, report->atlas_height_px};
    bool all = index < 0, first = all || !gl->views_begun, moved = gl->moves != gl->moves_begun;
    unsigned int view = all ? (1u << gl->plan.view_count) - 1u : 1u << index;
    bool alone = !first && (moved || gl->views_begun & view);
    if (alone)
        area = gl->plan.views[index].rect;
    if (first || alone) {
        host_set_area(&gl->features, area.x, area.y, area.width, area.height);
        clear_area(gl);
        if (gl->mask.kind != CUPOLA_MASK_NONE)
            mask_lay(gl, alone ? index : -1, gl->mask.kind, &area, gl->frame.depth.reversed);
    }
    if (first)
        gl->moves_begun = gl->moves;
    gl->views_begun |= view;
}

static int view_begin(cupola_gl *gl, int index, struct cupola_gl_view *view,
                      struct cupola_error *error)
{
    struct cupola_camera camera;
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (open_kind(gl))
        return error_set(error, CUPOLA_ERROR_ORDER, "view_begin inside of a %s; end it first",
                         open_kind(gl));
    if (!gl->frame_begun)
        return error_set(error, CUPOLA_ERROR_ORDER,
                         "view_begin before frame_begin; begin a frame first");
    int status = cupola_plan_camera(&gl->plan, index, &gl->frame.depth, &camera, error);
    if (status != CUPOLA_OK || (status = guest_check(&gl->guest, error)) != CUPOLA_OK)
        return status;

    struct cupola_rect rect = gl->plan.views[index].rect;
    struct guest_work work;
    guest_begin(&gl->guest, &work, "view %d", index);
    gl->host_target = work.state.target;
    gl->view_grouped = work.grouped;
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    views_clear(gl, index);
    host_state_restore(&work.state); /* the group stays open for what the host draws */
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    host_set_area(&gl->features, rect.x, rect.y, rect.width, rect.height);
    gl->view_open = true;
    gl->open_view = index;
    if (view)
        *view = (struct cupola_gl_view){gl->framebuffer, rect, camera};
    return CUPOLA_OK;
}

int cupola_gl_view_begin(cupola_gl *gl, int index, struct cupola_gl_view *view,
                         struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, view_begin(gl, index, view, error), error);
}

/*
 * The views' samples into the atlas. Of the host's state only the scissor test and the encoding
 * concern a blit; each sample is decoded, and their mean encoded.
 */
static void resolve_views(const cupola_gl *gl, int first, int count)
{
    bool encoding = !gl->guest.leaves_state && host_encoding_is_on(&gl->features);
    host_set_encoding(&gl->features, true);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, gl->framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0); /* the host may have read something else */
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, gl->resolved);
    for (int i = first; i < first + count; i++) {
        const struct cupola_rect *rect = &gl->plan.views[i].rect;
        int right = rect->x + rect->width, top = rect->y + rect->height;
        host_set_area(&gl->features, rect->x, rect->y, rect->width, rect->height);
        glBlitFramebuffer(rect->x, rect->y, right, top, rect->x, rect->y, right, top,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    host_set_encoding(&gl->features, encoding);
}

void views_finish(cupola_gl *gl, int first, int count)
{
    if (gl->resolved)
        resolve_views(gl, first, count);
    if (!gl->guest.leaves_state) {
        host_target_forget_deleted(&gl->host_target);
        host_target_restore(&gl->host_target, &gl->features);
    }
    guest_group_close(&gl->guest, gl->view_grouped);
    gl->views_drawn = true;
}

static int view_end(cupola_gl *gl, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (!gl->view_open && !gl->guest.lost)
        return error_set(error, CUPOLA_ERROR_ORDER, "view_end outside of a view; begin one first");
    int status = guest_check(&gl->guest, error);
    if (status == CUPOLA_ERROR_LOST)
        gl->view_open = false;
    if (status != CUPOLA_OK)
        return status;
    views_finish(gl, gl->open_view, 1);
    gl->view_open = false;
    return CUPOLA_OK;
}

int cupola_gl_view_end(cupola_gl *gl, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, view_end(gl, error), error);
}
