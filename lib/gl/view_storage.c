/*
 * What the views are drawn into: an atlas, a rectangle of it for each view, with depth. With
 * several samples per texel the host draws into renderbuffers of the same size, and view_end
 * resolves them.
 */
#include "error.h"
#include "instance.h"

static const struct {
    const char *name, *in_words;
    GLenum internal;
} colors[] = {
    [CUPOLA_FORMAT_RGBA8] = {"RGBA8", "views of RGBA8", GL_RGBA8},
    [CUPOLA_FORMAT_RGBA16F] = {"RGBA16F", "views of RGBA16F", GL_RGBA16F},
    [CUPOLA_FORMAT_RGBA32F] = {"RGBA32F", "views of RGBA32F", GL_RGBA32F},
    [CUPOLA_FORMAT_SRGB8] = {"SRGB8", "views of SRGB8", GL_SRGB8_ALPHA8},
};

static const struct {
    const char *name;
    GLenum internal; /* GL_NONE: no depth */
    GLenum attachment;
} depths[] = {
    [CUPOLA_DEPTH_32F] = {"32F", GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT},
    [CUPOLA_DEPTH_24] = {"24", GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT},
    [CUPOLA_DEPTH_32F_STENCIL_8] = {"32F and stencil 8", GL_DEPTH32F_STENCIL8,
                                    GL_DEPTH_STENCIL_ATTACHMENT},
    [CUPOLA_DEPTH_24_STENCIL_8] = {"24 and stencil 8", GL_DEPTH24_STENCIL8,
                                   GL_DEPTH_STENCIL_ATTACHMENT},
    [CUPOLA_DEPTH_NONE] = {"none", GL_NONE, GL_NONE},
};

enum {
    COLOR_COUNT = sizeof colors / sizeof colors[0],
    DEPTH_COUNT = sizeof depths / sizeof depths[0],
};

int views_check_params(const struct cupola_gl_params *params, struct cupola_error *error)
{
    if ((unsigned int)params->format >= COLOR_COUNT)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "format is %d; allowed: 0 to %d",
                         (int)params->format, COLOR_COUNT - 1);
    if ((unsigned int)params->depth >= DEPTH_COUNT)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "depth format is %d; allowed: 0 to %d",
                         (int)params->depth, DEPTH_COUNT - 1);
    return CUPOLA_OK;
}

/* In OpenGL ES, drawing into floats and filtering them are extensions. */
static int check_format(const cupola_gl *gl, struct cupola_error *error)
{
    const struct host_features *features = &gl->features;
    if (gl->params.format == CUPOLA_FORMAT_RGBA16F && !features->half_float_targets)
        return error_set(error, CUPOLA_ERROR_GL,
                         "views of RGBA16F need GL_EXT_color_buffer_half_float or "
                         "GL_EXT_color_buffer_float, which this OpenGL ES lacks; allowed: RGBA8 or "
                         "SRGB8");
    if (gl->params.format == CUPOLA_FORMAT_RGBA32F &&
        !(features->float_targets && features->float_filter))
        return error_set(
            error, CUPOLA_ERROR_GL,
            "views of RGBA32F need %s, which this OpenGL ES lacks; allowed: %sRGBA8 or "
            "SRGB8",
            features->float_targets ? "GL_OES_texture_float_linear" : "GL_EXT_color_buffer_float",
            features->half_float_targets ? "RGBA16F, " : "");
    return CUPOLA_OK;
}

/* How many samples a renderbuffer of a format may have; 1 where none of several is to be had. */
static GLint samples_most(const cupola_gl *gl, GLenum internal)
{
    GLint counts = 0, most = 0;
    if (!(gl->features.es || epoxy_gl_version() >= 42 ||
          epoxy_has_gl_extension("GL_ARB_internalformat_query"))) {
        glGetIntegerv(GL_MAX_SAMPLES, &most);
        return most < 1 ? 1 : most;
    }
    /* They come in falling order. */
    glGetInternalformativ(GL_RENDERBUFFER, internal, GL_NUM_SAMPLE_COUNTS, 1, &counts);
    if (counts > 0)
        glGetInternalformativ(GL_RENDERBUFFER, internal, GL_SAMPLES, 1, &most);
    return most < 1 ? 1 : most;
}

static int check_samples(const cupola_gl *gl, struct cupola_error *error)
{
    GLenum depth = depths[gl->params.depth].internal;
    GLint most = samples_most(gl, colors[gl->params.format].internal);
    if (depth != GL_NONE) {
        GLint most_of_depth = samples_most(gl, depth);
        most = most < most_of_depth ? most : most_of_depth;
    }
    if (gl->params.samples >= 0 && gl->params.samples <= most)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "samples is %d; allowed by this GL for views of %s with depth %s: 0 to %d",
                     gl->params.samples, colors[gl->params.format].name,
                     depths[gl->params.depth].name, most);
}

/* A renderbuffer of the atlas' size. 0 on failure. */
static GLuint renderbuffer_create(const cupola_gl *gl, GLenum internal, GLint samples,
                                  const char *what, struct cupola_error *error)
{
    int width = gl->plan.report.atlas_width_px, height = gl->plan.report.atlas_height_px;
    GLuint name = 0;
    gl_errors_drop();
    glGenRenderbuffers(1, &name);
    if (!name) {
        gl_refused(glGetError(), error, "a renderbuffer's name");
        return 0;
    }
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    if (samples > 1)
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal, width, height);
    else
        glRenderbufferStorage(GL_RENDERBUFFER, internal, width, height);
    GLenum failure = glGetError();
    if (failure == GL_NO_ERROR) {
        guest_name(&gl->guest, GL_RENDERBUFFER, name, "%s of views, %d x %d px", what, width,
                   height);
        return name;
    }
    glDeleteRenderbuffers(1, &name);
    gl_refused(failure, error, "a %s buffer of %d x %d px and %d samples", what, width, height,
               samples > 1 ? samples : 1);
    return 0;
}

/* The framebuffer that the host draws into; it stays bound. */
static int create_framebuffer(cupola_gl *gl, struct cupola_error *error)
{
    if (gl->samples) {
        glGenFramebuffers(1, &gl->framebuffer);
        if (!gl->framebuffer)
            return gl_refused(glGetError(), error, "a framebuffer's name");
        glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  gl->samples);
    } else if (!(gl->framebuffer =
                     framebuffer_create(gl->atlas, colors[gl->params.format].in_words, error))) {
        return error->status;
    }
    if (gl->depth)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, depths[gl->params.depth].attachment,
                                  GL_RENDERBUFFER, gl->depth);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return error_set(error, CUPOLA_ERROR_GL,
                         "the GL cannot draw into views of %s with depth %s and %d samples",
                         colors[gl->params.format].name, depths[gl->params.depth].name,
                         gl->params.samples);
    guest_name(&gl->guest, GL_FRAMEBUFFER, gl->framebuffer, "views");
    return CUPOLA_OK;
}

/* Renderbuffers for several samples, and the framebuffer that they are resolved into. */
static int create_samples(cupola_gl *gl, struct cupola_error *error)
{
    gl->resolved = framebuffer_create(gl->atlas, colors[gl->params.format].in_words, error);
    if (!gl->resolved)
        return error->status;
    guest_name(&gl->guest, GL_FRAMEBUFFER, gl->resolved, "resolved views");
    gl->samples = renderbuffer_create(gl, colors[gl->params.format].internal, gl->params.samples,
                                      "color", error);
    return gl->samples ? CUPOLA_OK : (int)error->status;
}

int views_create(cupola_gl *gl, struct cupola_error *error)
{
    int width = gl->plan.report.atlas_width_px, height = gl->plan.report.atlas_height_px;
    const GLfloat black[4] = {0, 0, 0, 0};
    int status = check_format(gl, error);
    if (status != CUPOLA_OK || (status = check_samples(gl, error)) != CUPOLA_OK)
        return status;
    gl->atlas = texture_create(colors[gl->params.format].internal, width, height, GL_LINEAR, error);
    if (!gl->atlas)
        return error->status;
    guest_name(&gl->guest, GL_TEXTURE, gl->atlas, "views, %d x %d px %s", width, height,
               colors[gl->params.format].name);
    if (gl->params.samples > 1 && (status = create_samples(gl, error)) != CUPOLA_OK)
        return status;
    if (depths[gl->params.depth].internal != GL_NONE) {
        gl->depth = renderbuffer_create(gl, depths[gl->params.depth].internal, gl->params.samples,
                                        "depth", error);
        if (!gl->depth)
            return error->status;
    }
    status = create_framebuffer(gl, error);
    if (status != CUPOLA_OK)
        return status;
    /* What lies between the views is never sampled, but it is seen by whoever shows the atlas. */
    glBindFramebuffer(GL_FRAMEBUFFER, gl->resolved ? gl->resolved : gl->framebuffer);
    host_set_area(&gl->features, 0, 0, width, height);
    glClearBufferfv(GL_COLOR, 0, black);
    return CUPOLA_OK;
}

const char *views_format_name(const cupola_gl *gl)
{
    return colors[gl->params.format].name;
}

const char *views_depth_name(const cupola_gl *gl)
{
    return depths[gl->params.depth].name;
}

bool views_have_stencil(const cupola_gl *gl)
{
    return depths[gl->params.depth].attachment == GL_DEPTH_STENCIL_ATTACHMENT;
}

void views_destroy(cupola_gl *gl)
{
    glDeleteFramebuffers(1, &gl->framebuffer);
    glDeleteFramebuffers(1, &gl->resolved);
    glDeleteRenderbuffers(1, &gl->samples);
    glDeleteRenderbuffers(1, &gl->depth);
    glDeleteTextures(1, &gl->atlas);
}

unsigned int cupola_gl_atlas(const cupola_gl *gl)
{
    return gl ? gl->atlas : 0;
}
