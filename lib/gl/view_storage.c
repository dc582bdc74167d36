/*
 * What the views are drawn into: an atlas, a rectangle of it for each view, with depth. With
 * several samples per texel the host draws into renderbuffers of the same size, and view_end
 * resolves them.
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "error.h"
#include "gl_objects.h"
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
    SAMPLES_MAX = 64, /* more are not looked for */
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

/* The numbers of samples that a renderbuffer of a format may have: bit n - 1 for n of them. */
static uint64_t sample_counts(const cupola_gl *gl, GLenum internal)
{
    GLint counts[SAMPLES_MAX] = {0}, count = 0, most = 0;
    uint64_t found = 1;
    if (!(gl->features.es || epoxy_gl_version() >= 42 ||
          epoxy_has_gl_extension("GL_ARB_internalformat_query"))) {
        glGetIntegerv(GL_MAX_SAMPLES, &most); /* which of them is not to be known */
        for (GLint n = 2; n <= most && n <= SAMPLES_MAX; n++)
            found |= (uint64_t)1 << (n - 1);
        return found;
    }
    glGetInternalformativ(GL_RENDERBUFFER, internal, GL_NUM_SAMPLE_COUNTS, 1, &count);
    if (count > 0)
        glGetInternalformativ(GL_RENDERBUFFER, internal, GL_SAMPLES, SAMPLES_MAX, counts);
    for (int i = 0; i < count && i < SAMPLES_MAX; i++)
        if (counts[i] >= 1 && counts[i] <= SAMPLES_MAX)
            found |= (uint64_t)1 << (counts[i] - 1);
    return found;
}

static int refuse_samples(const cupola_gl *gl, uint64_t counts, struct cupola_error *error)
{
    char list[4 * SAMPLES_MAX] = "";
    int most = 1;
    for (int n = 1; n <= SAMPLES_MAX; n++) {
        size_t length = strlen(list);
        if (!(counts >> (n - 1) & 1))
            continue;
        snprintf(list + length, sizeof list - length, "%s%d", n > 1 ? ", " : "", n);
        most = n;
    }
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "samples is %d; allowed by this GL for views of %s with depth %s: 0 to %d, of "
                     "which it has %s",
                     gl->params.samples, colors[gl->params.format].name,
                     depths[gl->params.depth].name, most, list);
}

/* The smallest number, at least the one wished, that colour and depth may both have. */
static int choose_samples(const cupola_gl *gl, int *samples, struct cupola_error *error)
{
    GLenum depth = depths[gl->params.depth].internal;
    uint64_t counts = sample_counts(gl, colors[gl->params.format].internal);
    if (depth != GL_NONE)
        counts &= sample_counts(gl, depth);
    if (gl->params.samples < 0)
        return refuse_samples(gl, counts, error);
    for (int n = gl->params.samples > 1 ? gl->params.samples : 1; n <= SAMPLES_MAX; n++)
        if (counts >> (n - 1) & 1) {
            *samples = n;
            return CUPOLA_OK;
        }
    return refuse_samples(gl, counts, error);
}

/* A renderbuffer of the atlas' size. 0 on failure. */
static GLuint renderbuffer_create(cupola_gl *gl, GLenum internal, GLint samples, const char *what,
                                  struct cupola_error *error)
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
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &gl->sample_count);
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
static int create_samples(cupola_gl *gl, int samples, struct cupola_error *error)
{
    gl->resolved = framebuffer_create(gl->atlas, colors[gl->params.format].in_words, error);
    if (!gl->resolved)
        return error->status;
    guest_name(&gl->guest, GL_FRAMEBUFFER, gl->resolved, "resolved views");
    gl->samples =
        renderbuffer_create(gl, colors[gl->params.format].internal, samples, "color", error);
    return gl->samples ? CUPOLA_OK : (int)error->status;
}

int views_create(cupola_gl *gl, struct cupola_error *error)
{
    int width = gl->plan.report.atlas_width_px, height = gl->plan.report.atlas_height_px;
    const GLfloat black[4] = {0, 0, 0, 0};
    int samples = 1, status = check_format(gl, error);
    if (status != CUPOLA_OK || (status = choose_samples(gl, &samples, error)) != CUPOLA_OK)
        return status;
    gl->atlas = texture_create(colors[gl->params.format].internal, width, height, GL_LINEAR, error);
    if (!gl->atlas)
        return error->status;
    guest_name(&gl->guest, GL_TEXTURE, gl->atlas, "views, %d x %d px %s", width, height,
               colors[gl->params.format].name);
    if (samples > 1 && (status = create_samples(gl, samples, error)) != CUPOLA_OK)
        return status;
    if (depths[gl->params.depth].internal != GL_NONE) {
        gl->depth =
            renderbuffer_create(gl, depths[gl->params.depth].internal, samples, "depth", error);
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

bool views_format_has_stencil(enum cupola_depth_format format)
{
    return depths[format].attachment == GL_DEPTH_STENCIL_ATTACHMENT;
}

bool views_have_stencil(const cupola_gl *gl)
{
    return views_format_has_stencil(gl->params.depth);
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
