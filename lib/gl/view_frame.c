/* The views of a frame: each is cleared, handed to the host, and resolved when it ends. */
#include "error.h"
#include "host_view.h"
#include "instance.h"

int cupola_gl_frame_begin(cupola_gl *gl, const struct cupola_frame *frame,
                          struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (!shows_source(gl, CUPOLA_SOURCE_VIEWS))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made without views; allowed: one whose sources have them");
    if (gl->params.storage != CUPOLA_STORAGE_ATLAS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made for textures of the host's, which cupola_gl_views_import "
                         "takes; allowed: one with storage atlas");
    if (gl->view_open)
        return error_set(error, CUPOLA_ERROR_ORDER, "frame_begin inside of a view; end it first");
    struct cupola_frame wished = frame ? *frame : (struct cupola_frame){.clear_color = {0}};
    struct cupola_camera camera;
    int status = cupola_plan_camera(&gl->plan, 0, &wished.depth, &camera, error);
    if (status != CUPOLA_OK)
        return status;
    gl->frame = wished;
    gl->frame_begun = true;
    return gl->plan.view_count;
}

/* Colour in linear light, depth to the far end, stencil to 0. */
static void clear_view(const cupola_gl *gl)
{
    const struct cupola_frame *frame = &gl->frame;
    const GLfloat farthest = frame->depth.reversed ? 0 : 1;
    bool stencil = views_have_stencil(gl);
    GLint stencil_mask = stencil ? host_stencil_unmask() : 0;
    host_encoding_set(&gl->features, GL_TRUE); /* host_state_restore puts it back */
    glClearBufferfv(GL_COLOR, 0, frame->clear_color);
    if (stencil)
        glClearBufferfi(GL_DEPTH_STENCIL, 0, farthest, 0);
    else if (gl->depth)
        glClearBufferfv(GL_DEPTH, 0, &farthest);
    if (stencil)
        host_stencil_mask(stencil_mask);
}

int cupola_gl_view_begin(cupola_gl *gl, int index, struct cupola_gl_view *view,
                         struct cupola_error *error)
{
    struct cupola_camera camera;
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (!gl->frame_begun || gl->view_open)
        return error_set(error, CUPOLA_ERROR_ORDER, "view_begin %s",
                         gl->view_open ? "inside of a view; end it first"
                                       : "before frame_begin; begin a frame first");
    int status = cupola_plan_camera(&gl->plan, index, &gl->frame.depth, &camera, error);
    if (status != CUPOLA_OK || (status = context_check(error)) != CUPOLA_OK)
        return status;

    struct cupola_rect rect = gl->plan.views[index].rect;
    struct host_state state;
    host_state_save(&state, &gl->features);
    gl->host_target = state.target;
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    host_set_area(&gl->features, rect.x, rect.y, rect.width, rect.height);
    clear_view(gl);
    host_state_restore(&state);
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    host_set_area(&gl->features, rect.x, rect.y, rect.width, rect.height);
    gl->view_open = true;
    gl->open_rect = rect;
    if (view)
        *view = (struct cupola_gl_view){gl->framebuffer, rect, camera};
    return CUPOLA_OK;
}

/*
 * The view's samples into the atlas. Of the host's state only the scissor test and the encoding
 * concern a blit; each sample is decoded, and their mean encoded.
 */
static void resolve_view(const cupola_gl *gl)
{
    const struct cupola_rect *rect = &gl->open_rect;
    int right = rect->x + rect->width, top = rect->y + rect->height;
    GLboolean encoding = host_encoding_enable(&gl->features);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, gl->framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, gl->resolved);
    host_set_area(&gl->features, rect->x, rect->y, rect->width, rect->height);
    glBlitFramebuffer(rect->x, rect->y, right, top, rect->x, rect->y, right, top,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    host_encoding_set(&gl->features, encoding);
}

int cupola_gl_view_end(cupola_gl *gl, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (!gl->view_open)
        return error_set(error, CUPOLA_ERROR_ORDER, "view_end outside of a view; begin one first");
    int status = context_check(error);
    if (status != CUPOLA_OK)
        return status;
    if (gl->resolved)
        resolve_view(gl);
    host_target_restore(&gl->host_target, &gl->features);
    gl->view_open = false;
    return CUPOLA_OK;
}
