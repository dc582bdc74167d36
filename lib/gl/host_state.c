/* Saving and restoring of the host's GL state. */
#include "host_state.h"

enum { NEVER = 1000 }; /* not part of any version */

/* Capabilities, the version or extension that brought them and what Cupola needs. */
static const struct {
    GLenum name;
    int version;
    const char *extension;
    GLboolean wanted;
} capabilities[] = {
    {GL_DEPTH_TEST, 33, NULL, GL_FALSE},
    {GL_STENCIL_TEST, 33, NULL, GL_FALSE},
    {GL_CULL_FACE, 33, NULL, GL_FALSE},
    {GL_FRAMEBUFFER_SRGB, 33, NULL, GL_FALSE},
    {GL_RASTERIZER_DISCARD, 33, NULL, GL_FALSE},
    {GL_PRIMITIVE_RESTART, 33, NULL, GL_FALSE},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, 43, "GL_ARB_ES3_compatibility", GL_FALSE},
    {GL_COLOR_LOGIC_OP, 33, NULL, GL_FALSE},
    {GL_POLYGON_OFFSET_FILL, 33, NULL, GL_FALSE},
    {GL_POLYGON_SMOOTH, 33, NULL, GL_FALSE},
    {GL_MULTISAMPLE, 33, NULL, GL_TRUE},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, 33, NULL, GL_FALSE},
    {GL_SAMPLE_ALPHA_TO_ONE, 33, NULL, GL_FALSE},
    {GL_SAMPLE_COVERAGE, 33, NULL, GL_FALSE},
    {GL_SAMPLE_MASK, 33, NULL, GL_FALSE},
    {GL_SAMPLE_SHADING, 40, "GL_ARB_sample_shading", GL_FALSE},
    {GL_DEPTH_CLAMP, 33, NULL, GL_FALSE},
    {GL_DEPTH_BOUNDS_TEST_EXT, NEVER, "GL_EXT_depth_bounds_test", GL_FALSE},
    {GL_DITHER, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE0, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE1, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE2, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE3, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE4, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE5, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE6, 33, NULL, GL_FALSE},
    {GL_CLIP_DISTANCE7, 33, NULL, GL_FALSE},
};

enum { CAPABILITY_COUNT = sizeof capabilities / sizeof capabilities[0] };

_Static_assert((int)CAPABILITY_COUNT <= (int)HOST_CAPABILITIES_MAX, "room for every capability");

static const struct {
    GLenum name;
    GLint wanted;
} pixel_stores[HOST_PIXEL_STORES] = {
    {GL_UNPACK_ALIGNMENT, 1},   {GL_UNPACK_ROW_LENGTH, 0}, {GL_UNPACK_SKIP_ROWS, 0},
    {GL_UNPACK_SKIP_PIXELS, 0}, {GL_UNPACK_SWAP_BYTES, 0}, {GL_PACK_ALIGNMENT, 1},
    {GL_PACK_ROW_LENGTH, 0},    {GL_PACK_SKIP_ROWS, 0},    {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SWAP_BYTES, 0},
};

static const GLenum blend_equations[2] = {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
static const GLenum blend_factors[4] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                        GL_BLEND_DST_ALPHA};

static bool has(int version, int since, const char *extension)
{
    return version >= since || (extension && epoxy_has_gl_extension(extension));
}

void host_features_find(struct host_features *features)
{
    int version = epoxy_gl_version();
    features->viewport_array = has(version, 41, "GL_ARB_viewport_array");
    features->clip_control = has(version, 45, "GL_ARB_clip_control");
    features->blend_per_buffer = has(version, 40, "GL_ARB_draw_buffers_blend");
    features->transform_feedback = has(version, 40, "GL_ARB_transform_feedback2");
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &features->draw_buffers);
    if (features->draw_buffers > HOST_DRAW_BUFFERS_MAX)
        features->draw_buffers = HOST_DRAW_BUFFERS_MAX;
    for (int i = 0; i < CAPABILITY_COUNT; i++)
        features->capabilities[i] =
            has(version, capabilities[i].version, capabilities[i].extension);
}

static void set_capability(GLenum name, GLboolean on)
{
    if (on)
        glEnable(name);
    else
        glDisable(name);
}

void host_target_save(struct host_target *target)
{
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target->draw_framebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &target->read_framebuffer);
    glGetFloatv(GL_VIEWPORT, target->viewport);
    glGetIntegerv(GL_SCISSOR_BOX, target->scissor);
    target->scissor_test = glIsEnabled(GL_SCISSOR_TEST);
}

/* Where there are several viewports, glViewport would set them all. */
static void set_viewport(const struct host_features *features, const GLfloat v[4])
{
    if (features->viewport_array)
        glViewportIndexedf(0, v[0], v[1], v[2], v[3]);
    else
        glViewport((GLint)v[0], (GLint)v[1], (GLsizei)v[2], (GLsizei)v[3]);
}

static void set_scissor(const struct host_features *features, const GLint s[4], GLboolean test)
{
    if (features->viewport_array) {
        glScissorIndexed(0, s[0], s[1], s[2], s[3]);
        if (test)
            glEnablei(GL_SCISSOR_TEST, 0);
        else
            glDisablei(GL_SCISSOR_TEST, 0);
        return;
    }
    glScissor(s[0], s[1], s[2], s[3]);
    set_capability(GL_SCISSOR_TEST, test);
}

void host_target_restore(const struct host_target *target, const struct host_features *features)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)target->draw_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)target->read_framebuffer);
    set_viewport(features, target->viewport);
    set_scissor(features, target->scissor, target->scissor_test);
}

void host_set_area(const struct host_features *features, GLint x, GLint y, GLsizei width,
                   GLsizei height)
{
    const GLfloat viewport[4] = {(GLfloat)x, (GLfloat)y, (GLfloat)width, (GLfloat)height};
    const GLint scissor[4] = {x, y, width, height};
    set_viewport(features, viewport);
    set_scissor(features, scissor, GL_TRUE);
}

static void set_blending(const struct host_features *features, const GLint equation[2],
                         const GLint factors[4])
{
    GLenum e[2] = {(GLenum)equation[0], (GLenum)equation[1]};
    GLenum f[4] = {(GLenum)factors[0], (GLenum)factors[1], (GLenum)factors[2], (GLenum)factors[3]};
    if (features->blend_per_buffer) {
        glBlendEquationSeparatei(0, e[0], e[1]);
        glBlendFuncSeparatei(0, f[0], f[1], f[2], f[3]);
    } else {
        glBlendEquationSeparate(e[0], e[1]);
        glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
    }
}

void host_set_adding(const struct host_features *features)
{
    const GLint equation[2] = {GL_FUNC_ADD, GL_FUNC_ADD};
    const GLint factors[4] = {GL_ONE, GL_ONE, GL_ZERO, GL_ONE};
    set_blending(features, equation, factors);
    glEnablei(GL_BLEND, 0);
}

/* A running transform feedback would record our triangles and refuse our programs. */
static void pause_feedback(struct host_state *state)
{
    GLboolean active = GL_FALSE, paused = GL_FALSE;
    if (state->features->transform_feedback) {
        glGetBooleanv(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, &active);
        glGetBooleanv(GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED, &paused);
    }
    state->paused_feedback = active && !paused;
    if (state->paused_feedback)
        glPauseTransformFeedback();
}

/* Our shaders have one output: what they would leave in further draw buffers is undefined. */
static void save_color_masks(struct host_state *state)
{
    for (int i = 0; i < state->features->draw_buffers; i++) {
        GLboolean written = i == 0;
        glGetBooleani_v(GL_COLOR_WRITEMASK, (GLuint)i, state->color_masks[i]);
        glColorMaski((GLuint)i, written, written, written, written);
    }
}

static void save_fixed_function(struct host_state *state)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++) {
        if (!state->features->capabilities[i])
            continue;
        state->capabilities[i] = glIsEnabled(capabilities[i].name);
        set_capability(capabilities[i].name, capabilities[i].wanted);
    }
    state->blend = glIsEnabledi(GL_BLEND, 0);
    glDisablei(GL_BLEND, 0);
    for (int i = 0; i < 2; i++)
        glGetIntegerv(blend_equations[i], &state->blend_equation[i]);
    for (int i = 0; i < 4; i++)
        glGetIntegerv(blend_factors[i], &state->blend_factors[i]);
    save_color_masks(state);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &state->depth_mask);
    glDepthMask(GL_TRUE);
    glGetIntegerv(GL_POLYGON_MODE, state->polygon_mode);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    if (state->features->clip_control) {
        glGetIntegerv(GL_CLIP_ORIGIN, &state->clip_origin);
        glGetIntegerv(GL_CLIP_DEPTH_MODE, &state->clip_depth);
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

static void save_bindings(struct host_state *state)
{
    glGetIntegerv(GL_CURRENT_PROGRAM, &state->program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &state->vertex_array);
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &state->renderbuffer);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &state->active_texture);
    for (int unit = 0; unit < HOST_TEXTURE_UNITS; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &state->textures[unit]);
        glGetIntegerv(GL_SAMPLER_BINDING, &state->samplers[unit]);
        glBindSampler((GLuint)unit, 0);
    }
    glActiveTexture(GL_TEXTURE0);
}

static void save_pixel_transfer(struct host_state *state)
{
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &state->unpack_buffer);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &state->pack_buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (int i = 0; i < HOST_PIXEL_STORES; i++) {
        glGetIntegerv(pixel_stores[i].name, &state->pixel_stores[i]);
        glPixelStorei(pixel_stores[i].name, pixel_stores[i].wanted);
    }
    glGetIntegerv(GL_CLAMP_READ_COLOR, &state->clamp_read_color);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
}

void host_state_save(struct host_state *state, const struct host_features *features)
{
    state->features = features;
    pause_feedback(state);
    host_target_save(&state->target);
    save_fixed_function(state);
    save_bindings(state);
    save_pixel_transfer(state);
}

static void restore_fixed_function(const struct host_state *state)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++)
        if (state->features->capabilities[i])
            set_capability(capabilities[i].name, state->capabilities[i]);
    if (state->blend)
        glEnablei(GL_BLEND, 0);
    else
        glDisablei(GL_BLEND, 0);
    set_blending(state->features, state->blend_equation, state->blend_factors);
    for (int i = 0; i < state->features->draw_buffers; i++) {
        const GLboolean *mask = state->color_masks[i];
        glColorMaski((GLuint)i, mask[0], mask[1], mask[2], mask[3]);
    }
    glDepthMask(state->depth_mask);
    glPolygonMode(GL_FRONT_AND_BACK, (GLenum)state->polygon_mode[0]);
    if (state->features->clip_control)
        glClipControl((GLenum)state->clip_origin, (GLenum)state->clip_depth);
}

static void restore_bindings(const struct host_state *state)
{
    for (int unit = 0; unit < HOST_TEXTURE_UNITS; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, (GLuint)state->textures[unit]);
        glBindSampler((GLuint)unit, (GLuint)state->samplers[unit]);
    }
    glActiveTexture((GLenum)state->active_texture);
    glBindRenderbuffer(GL_RENDERBUFFER, (GLuint)state->renderbuffer);
    glBindVertexArray((GLuint)state->vertex_array);
    /* A program that the host has deleted lives only while it is in use: gone it is no error. */
    if (state->program == 0 || glIsProgram((GLuint)state->program))
        glUseProgram((GLuint)state->program);
    else
        glUseProgram(0);
}

static void restore_pixel_transfer(const struct host_state *state)
{
    for (int i = 0; i < HOST_PIXEL_STORES; i++)
        glPixelStorei(pixel_stores[i].name, state->pixel_stores[i]);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)state->unpack_buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)state->pack_buffer);
    glClampColor(GL_CLAMP_READ_COLOR, (GLenum)state->clamp_read_color);
}

void host_state_restore(const struct host_state *state)
{
    restore_pixel_transfer(state);
    restore_bindings(state);
    restore_fixed_function(state);
    host_target_restore(&state->target, state->features);
    if (state->paused_feedback)
        glResumeTransformFeedback();
}
