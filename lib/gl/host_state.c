/* Saving and restoring of the host's GL state. */
#include "host_state.h"

#include "host_blend.h"
#include "host_origin.h"

/* Capabilities and what Cupola needs. */
static const struct {
    GLenum name;
    struct origin origin;
    GLboolean wanted;
} capabilities[] = {
    {GL_DEPTH_TEST, EVERYWHERE, GL_FALSE},
    {GL_STENCIL_TEST, EVERYWHERE, GL_FALSE},
    {GL_CULL_FACE, EVERYWHERE, GL_FALSE},
    {GL_FRAMEBUFFER_SRGB, DESKTOP("GL_EXT_sRGB_write_control"), GL_FALSE},
    {GL_RASTERIZER_DISCARD, EVERYWHERE, GL_FALSE},
    {GL_PRIMITIVE_RESTART, DESKTOP(NULL), GL_FALSE},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, {43, "GL_ARB_ES3_compatibility", 30, NULL}, GL_FALSE},
    {GL_COLOR_LOGIC_OP, DESKTOP(NULL), GL_FALSE},
    {GL_POLYGON_OFFSET_FILL, EVERYWHERE, GL_FALSE},
    {GL_POLYGON_SMOOTH, DESKTOP(NULL), GL_FALSE},
    {GL_PROGRAM_POINT_SIZE, DESKTOP(NULL), GL_TRUE},
    {GL_MULTISAMPLE, DESKTOP("GL_EXT_multisample_compatibility"), GL_TRUE},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, EVERYWHERE, GL_FALSE},
    {GL_SAMPLE_ALPHA_TO_ONE, DESKTOP("GL_EXT_multisample_compatibility"), GL_FALSE},
    {GL_SAMPLE_COVERAGE, EVERYWHERE, GL_FALSE},
    {GL_SAMPLE_MASK, {33, NULL, 31, NULL}, GL_FALSE},
    {GL_SAMPLE_SHADING, {40, "GL_ARB_sample_shading", 32, "GL_OES_sample_shading"}, GL_FALSE},
    {GL_DEPTH_CLAMP, DESKTOP("GL_EXT_depth_clamp"), GL_FALSE},
    {GL_DEPTH_BOUNDS_TEST_EXT, {NEVER, "GL_EXT_depth_bounds_test", NEVER, NULL}, GL_FALSE},
    {GL_DITHER, EVERYWHERE, GL_FALSE},
    {GL_CLIP_DISTANCE0, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE1, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE2, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE3, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE4, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE5, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE6, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
    {GL_CLIP_DISTANCE7, DESKTOP("GL_EXT_clip_cull_distance"), GL_FALSE},
};

enum { CAPABILITY_COUNT = sizeof capabilities / sizeof capabilities[0] };

_Static_assert((int)CAPABILITY_COUNT <= (int)HOST_CAPABILITIES_MAX, "room for every capability");

static const struct {
    GLenum name;
    GLint wanted;
    bool desktop; /* not in OpenGL ES */
} pixel_stores[HOST_PIXEL_STORES] = {
    {GL_UNPACK_ALIGNMENT, 1, false}, {GL_UNPACK_ROW_LENGTH, 0, false},
    {GL_UNPACK_SKIP_ROWS, 0, false}, {GL_UNPACK_SKIP_PIXELS, 0, false},
    {GL_UNPACK_SWAP_BYTES, 0, true}, {GL_PACK_ALIGNMENT, 1, false},
    {GL_PACK_ROW_LENGTH, 0, false},  {GL_PACK_SKIP_ROWS, 0, false},
    {GL_PACK_SKIP_PIXELS, 0, false}, {GL_PACK_SWAP_BYTES, 0, true},
};

static const GLenum blend_equations[2] = {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
static const GLenum blend_factors[4] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                        GL_BLEND_DST_ALPHA};

void host_capabilities_find(struct host_features *features)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++)
        features->capabilities[i] = host_has(features, capabilities[i].origin);
}

void host_set_capability(GLenum name, GLboolean on)
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
    host_set_capability(GL_SCISSOR_TEST, test);
}

void host_target_forget_deleted(struct host_target *target)
{
    if (target->draw_framebuffer && !glIsFramebuffer((GLuint)target->draw_framebuffer))
        target->draw_framebuffer = 0;
    if (target->read_framebuffer && !glIsFramebuffer((GLuint)target->read_framebuffer))
        target->read_framebuffer = 0;
}

void host_target_restore(const struct host_target *target, const struct host_features *features)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)target->draw_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)target->read_framebuffer);
    set_viewport(features, target->viewport);
    set_scissor(features, target->scissor, target->scissor_test);
}

void host_set_viewport(const struct host_features *features, GLint x, GLint y, GLsizei width,
                       GLsizei height)
{
    const GLfloat viewport[4] = {(GLfloat)x, (GLfloat)y, (GLfloat)width, (GLfloat)height};
    set_viewport(features, viewport);
}

void host_set_area(const struct host_features *features, GLint x, GLint y, GLsizei width,
                   GLsizei height)
{
    const GLfloat viewport[4] = {(GLfloat)x, (GLfloat)y, (GLfloat)width, (GLfloat)height};
    const GLint scissor[4] = {x, y, width, height};
    set_viewport(features, viewport);
    set_scissor(features, scissor, GL_TRUE);
}

void host_set_encoding(const struct host_features *features, bool encoding)
{
    if (!features->srgb_always)
        host_set_capability(GL_FRAMEBUFFER_SRGB, encoding);
}

/* Questions about the host's state, where it is kept. */
static void ask(const struct host_state *state, GLenum name, GLint *values)
{
    if (state->kept)
        glGetIntegerv(name, values);
}

static GLboolean is_on(const struct host_state *state, GLenum capability)
{
    return state->kept ? glIsEnabled(capability) : GL_FALSE;
}

/* A running transform feedback would record our triangles and refuse our programs. */
static void pause_feedback(struct host_state *state)
{
    GLboolean active = GL_FALSE, paused = GL_FALSE;
    if (state->kept && state->features->transform_feedback) {
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
    if (!state->features->mask_per_buffer) {
        ask(state, GL_COLOR_WRITEMASK, state->color_masks[0]);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        return;
    }
    for (int i = 0; i < state->features->draw_buffers; i++) {
        GLboolean written = i == 0;
        /* As integers: OpenGL ES 3.0 has no indexed question for truth values. */
        if (state->kept)
            glGetIntegeri_v(GL_COLOR_WRITEMASK, (GLuint)i, state->color_masks[i]);
        glColorMaski((GLuint)i, written, written, written, written);
    }
}

static void restore_color_masks(const struct host_state *state)
{
    int buffers = state->features->mask_per_buffer ? state->features->draw_buffers : 1;
    for (int i = 0; i < buffers; i++) {
        GLboolean mask[4];
        for (int channel = 0; channel < 4; channel++)
            mask[channel] = state->color_masks[i][channel] != 0;
        if (state->features->mask_per_buffer)
            glColorMaski((GLuint)i, mask[0], mask[1], mask[2], mask[3]);
        else
            glColorMask(mask[0], mask[1], mask[2], mask[3]);
    }
}

static void save_fixed_function(struct host_state *state)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++) {
        if (!state->features->capabilities[i])
            continue;
        state->capabilities[i] = is_on(state, capabilities[i].name);
        host_set_capability(capabilities[i].name, capabilities[i].wanted);
    }
    state->blend = is_on(state, GL_BLEND); /* of draw buffer 0 where there are several */
    host_blend_set(state->features, GL_FALSE);
    for (int i = 0; i < 2; i++)
        ask(state, blend_equations[i], &state->blend_equation[i]);
    for (int i = 0; i < 4; i++)
        ask(state, blend_factors[i], &state->blend_factors[i]);
    /* An advanced one is refused with our programs as long as any draw buffer blends. */
    host_blend_equations_set(state->features, GL_FUNC_ADD, GL_FUNC_ADD);
    save_color_masks(state);
    if (state->kept)
        glGetBooleanv(GL_DEPTH_WRITEMASK, &state->depth_mask);
    glDepthMask(GL_TRUE);
    if (state->features->polygon_mode) {
        ask(state, GL_POLYGON_MODE, state->polygon_mode);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    if (state->features->clip_control) {
        ask(state, GL_CLIP_ORIGIN, &state->clip_origin);
        ask(state, GL_CLIP_DEPTH_MODE, &state->clip_depth);
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

static void save_bindings(struct host_state *state)
{
    ask(state, GL_CURRENT_PROGRAM, &state->program);
    ask(state, GL_VERTEX_ARRAY_BINDING, &state->vertex_array);
    ask(state, GL_RENDERBUFFER_BINDING, &state->renderbuffer);
    ask(state, GL_ACTIVE_TEXTURE, &state->active_texture);
    for (int unit = 0; unit < state->features->texture_units; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        ask(state, GL_TEXTURE_BINDING_2D, &state->textures[unit]);
        ask(state, GL_SAMPLER_BINDING, &state->samplers[unit]);
        glBindSampler((GLuint)unit, 0);
    }
    glActiveTexture(GL_TEXTURE0);
    if (state->features->texture_arrays)
        ask(state, GL_TEXTURE_BINDING_2D_ARRAY, &state->texture_array);
}

static void save_pixel_transfer(struct host_state *state)
{
    ask(state, GL_PIXEL_UNPACK_BUFFER_BINDING, &state->unpack_buffer);
    ask(state, GL_PIXEL_PACK_BUFFER_BINDING, &state->pack_buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (int i = 0; i < HOST_PIXEL_STORES; i++) {
        if (state->features->es && pixel_stores[i].desktop)
            continue;
        ask(state, pixel_stores[i].name, &state->pixel_stores[i]);
        glPixelStorei(pixel_stores[i].name, pixel_stores[i].wanted);
    }
    if (!state->features->es) {
        ask(state, GL_CLAMP_READ_COLOR, &state->clamp_read_color);
        glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    }
}

static void save(struct host_state *state)
{
    pause_feedback(state);
    if (state->kept)
        host_target_save(&state->target);
    save_fixed_function(state);
    save_bindings(state);
    save_pixel_transfer(state);
}

void host_state_save(struct host_state *state, const struct host_features *features)
{
    state->features = features;
    state->kept = true;
    save(state);
}

void host_state_set(struct host_state *state, const struct host_features *features)
{
    state->features = features;
    state->kept = false;
    save(state);
}

static void restore_fixed_function(const struct host_state *state)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++)
        if (state->features->capabilities[i])
            host_set_capability(capabilities[i].name, state->capabilities[i]);
    host_blend_set(state->features, state->blend);
    host_blend_equations_restore(state->features, state->blend_equation);
    host_blend_factors_set(state->features, state->blend_factors);
    restore_color_masks(state);
    glDepthMask(state->depth_mask);
    if (state->features->polygon_mode)
        glPolygonMode(GL_FRONT_AND_BACK, (GLenum)state->polygon_mode[0]);
    if (state->features->clip_control)
        glClipControl((GLenum)state->clip_origin, (GLenum)state->clip_depth);
}

static void restore_bindings(const struct host_state *state)
{
    for (int unit = 0; unit < state->features->texture_units; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, (GLuint)state->textures[unit]);
        glBindSampler((GLuint)unit, (GLuint)state->samplers[unit]);
    }
    if (state->features->texture_arrays) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D_ARRAY, (GLuint)state->texture_array);
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
        if (!state->features->es || !pixel_stores[i].desktop)
            glPixelStorei(pixel_stores[i].name, state->pixel_stores[i]);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)state->unpack_buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)state->pack_buffer);
    if (!state->features->es)
        glClampColor(GL_CLAMP_READ_COLOR, (GLenum)state->clamp_read_color);
}

void host_state_restore(const struct host_state *state)
{
    if (!state->kept) {
        host_set_encoding(state->features, false);
        return;
    }
    restore_pixel_transfer(state);
    restore_bindings(state);
    restore_fixed_function(state);
    host_target_restore(&state->target, state->features);
    if (state->paused_feedback)
        glResumeTransformFeedback();
}
