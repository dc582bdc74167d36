/* The views that the host draws into: one atlas, one framebuffer, a rectangle each. */
#include "error.h"
#include "instance.h"

/* In OpenGL ES, drawing into floats and filtering them are extensions. */
static int check_format(const cupola_gl *gl, struct cupola_error *error)
{
    const struct host_features *features = &gl->features;
    if (gl->params.format == CUPOLA_FORMAT_RGBA16F && !features->half_float_targets)
        return error_set(error, CUPOLA_ERROR_GL,
                         "views of RGBA16F need GL_EXT_color_buffer_half_float or "
                         "GL_EXT_color_buffer_float, which this OpenGL ES lacks; allowed: RGBA8");
    if (gl->params.format == CUPOLA_FORMAT_RGBA32F &&
        !(features->float_targets && features->float_filter))
        return error_set(error, CUPOLA_ERROR_GL,
                         "views of RGBA32F need %s, which this OpenGL ES lacks; allowed: %s",
                         features->float_targets ? "GL_OES_texture_float_linear"
                                                 : "GL_EXT_color_buffer_float",
                         features->half_float_targets ? "RGBA8 or RGBA16F" : "RGBA8");
    return CUPOLA_OK;
}

int views_create(cupola_gl *gl, struct cupola_error *error)
{
    static const GLenum formats[] = {
        [CUPOLA_FORMAT_RGBA8] = GL_RGBA8,
        [CUPOLA_FORMAT_RGBA16F] = GL_RGBA16F,
        [CUPOLA_FORMAT_RGBA32F] = GL_RGBA32F,
    };
    int status = check_format(gl, error);
    if (status != CUPOLA_OK)
        return status;
    int width = gl->plan.report.atlas_width_px, height = gl->plan.report.atlas_height_px;
    gl->atlas = texture_create(formats[gl->params.format], width, height, GL_LINEAR, error);
    if (!gl->atlas)
        return error->status;
    glGenRenderbuffers(1, &gl->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, gl->depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    GLenum failure = glGetError();
    if (failure == GL_OUT_OF_MEMORY)
        return error_set(error, CUPOLA_ERROR_MEMORY,
                         "the GL has no memory for a depth buffer of %d x %d px", width, height);
    gl->framebuffer = framebuffer_create(gl->atlas);
    if (!gl->framebuffer)
        return error_set(error, CUPOLA_ERROR_GL, "the GL cannot draw into the views' format");
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, gl->depth);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return error_set(error, CUPOLA_ERROR_GL, "the GL cannot draw into views of %d x %d px",
                         width, height);
    /* What lies between the views is never sampled, but it is seen by whoever shows the atlas. */
    const GLfloat black[4] = {0, 0, 0, 0};
    host_set_area(&gl->features, 0, 0, width, height);
    glClearBufferfv(GL_COLOR, 0, black);
    return CUPOLA_OK;
}

void views_destroy(cupola_gl *gl)
{
    glDeleteFramebuffers(1, &gl->framebuffer);
    glDeleteRenderbuffers(1, &gl->depth);
    glDeleteTextures(1, &gl->atlas);
}

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
    const GLfloat farthest = gl->frame.depth.reversed ? 0 : 1;
    host_state_save(&state, &gl->features);
    gl->host_target = state.target;
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    host_set_area(&gl->features, rect.x, rect.y, rect.width, rect.height);
    glClearBufferfv(GL_COLOR, 0, gl->frame.clear_color);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    host_state_restore(&state);
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
    host_set_area(&gl->features, rect.x, rect.y, rect.width, rect.height);
    gl->view_open = true;
    if (view)
        *view = (struct cupola_gl_view){gl->framebuffer, rect, camera};
    return CUPOLA_OK;
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
    host_target_restore(&gl->host_target, &gl->features);
    gl->view_open = false;
    return CUPOLA_OK;
}

unsigned int cupola_gl_atlas(const cupola_gl *gl)
{
    return gl ? gl->atlas : 0;
}
