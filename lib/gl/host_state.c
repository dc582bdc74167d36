/* Saving and restoring of the host's GL state. */
#include "host_state.h"

/* Capabilities, the first version that knows them and what Cupola needs. */
static const struct {
    GLenum name;
    int version;
    GLboolean wanted;
} capabilities[] = {
    {GL_DEPTH_TEST, 33, GL_FALSE},
    {GL_STENCIL_TEST, 33, GL_FALSE},
    {GL_CULL_FACE, 33, GL_FALSE},
    {GL_FRAMEBUFFER_SRGB, 33, GL_FALSE},
    {GL_RASTERIZER_DISCARD, 33, GL_FALSE},
    {GL_PRIMITIVE_RESTART, 33, GL_FALSE},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, 43, GL_FALSE},
    {GL_COLOR_LOGIC_OP, 33, GL_FALSE},
    {GL_POLYGON_OFFSET_FILL, 33, GL_FALSE},
    {GL_POLYGON_SMOOTH, 33, GL_FALSE},
    {GL_MULTISAMPLE, 33, GL_TRUE},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, 33, GL_FALSE},
    {GL_SAMPLE_ALPHA_TO_ONE, 33, GL_FALSE},
    {GL_SAMPLE_COVERAGE, 33, GL_FALSE},
    {GL_SAMPLE_MASK, 33, GL_FALSE},
    {GL_DEPTH_CLAMP, 33, GL_FALSE},
    {GL_DITHER, 33, GL_FALSE},
    {GL_CLIP_DISTANCE0, 33, GL_FALSE},
    {GL_CLIP_DISTANCE1, 33, GL_FALSE},
    {GL_CLIP_DISTANCE2, 33, GL_FALSE},
    {GL_CLIP_DISTANCE3, 33, GL_FALSE},
    {GL_CLIP_DISTANCE4, 33, GL_FALSE},
    {GL_CLIP_DISTANCE5, 33, GL_FALSE},
    {GL_CLIP_DISTANCE6, 33, GL_FALSE},
    {GL_CLIP_DISTANCE7, 33, GL_FALSE},
};

enum { CAPABILITY_COUNT = sizeof capabilities / sizeof capabilities[0], BLEND = CAPABILITY_COUNT };

_Static_assert((int)BLEND < (int)HOST_CAPABILITIES_MAX, "room for every capability and blending");

static const GLenum pixel_stores[HOST_PIXEL_STORES] = {
    GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
    GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_ROWS,   GL_PACK_SKIP_PIXELS,
};

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

/* From 4.1 on there are several viewports, and glViewport would set them all. */
static void set_viewport(int version, const GLfloat v[4])
{
    if (version >= 41)
        glViewportIndexedf(0, v[0], v[1], v[2], v[3]);
    else
        glViewport((GLint)v[0], (GLint)v[1], (GLsizei)v[2], (GLsizei)v[3]);
}

static void set_scissor(int version, const GLint s[4], GLboolean test)
{
    if (version >= 41) {
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

void host_target_restore(const struct host_target *target, int version)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)target->draw_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)target->read_framebuffer);
    set_viewport(version, target->viewport);
    set_scissor(version, target->scissor, target->scissor_test);
}

void host_set_area(int version, GLint x, GLint y, GLsizei width, GLsizei height)
{
    const GLfloat viewport[4] = {(GLfloat)x, (GLfloat)y, (GLfloat)width, (GLfloat)height};
    const GLint scissor[4] = {x, y, width, height};
    set_viewport(version, viewport);
    set_scissor(version, scissor, GL_TRUE);
}

static void save_fixed_function(struct host_state *state)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++) {
        if (state->version < capabilities[i].version)
            continue;
        state->capabilities[i] = glIsEnabled(capabilities[i].name);
        set_capability(capabilities[i].name, capabilities[i].wanted);
    }
    state->capabilities[BLEND] = glIsEnabledi(GL_BLEND, 0);
    glDisablei(GL_BLEND, 0);
    glGetBooleani_v(GL_COLOR_WRITEMASK, 0, state->color_mask);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &state->depth_mask);
    glDepthMask(GL_TRUE);
    glGetIntegerv(GL_POLYGON_MODE, state->polygon_mode);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    if (state->version >= 45) {
        glGetIntegerv(GL_CLIP_ORIGIN, &state->clip_origin);
        glGetIntegerv(GL_CLIP_DEPTH_MODE, &state->clip_depth);
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

static void save_bindings(struct host_state *state)
{
    glGetIntegerv(GL_CURRENT_PROGRAM, &state->program);
    if (state->version >= 41)
        glGetIntegerv(GL_PROGRAM_PIPELINE_BINDING, &state->pipeline);
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
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &state->unpack_buffer);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &state->pack_buffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (int i = 0; i < HOST_PIXEL_STORES; i++) {
        glGetIntegerv(pixel_stores[i], &state->pixel_stores[i]);
        bool alignment =
            pixel_stores[i] == GL_UNPACK_ALIGNMENT || pixel_stores[i] == GL_PACK_ALIGNMENT;
        glPixelStorei(pixel_stores[i], alignment ? 1 : 0);
    }
}

void host_state_save(struct host_state *state)
{
    state->version = epoxy_gl_version();
    host_target_save(&state->target);
    save_fixed_function(state);
    save_bindings(state);
}

static void restore_fixed_function(const struct host_state *state)
{
    for (int i = 0; i < CAPABILITY_COUNT; i++)
        if (state->version >= capabilities[i].version)
            set_capability(capabilities[i].name, state->capabilities[i]);
    if (state->capabilities[BLEND])
        glEnablei(GL_BLEND, 0);
    glColorMaski(0, state->color_mask[0], state->color_mask[1], state->color_mask[2],
                 state->color_mask[3]);
    glDepthMask(state->depth_mask);
    glPolygonMode(GL_FRONT_AND_BACK, (GLenum)state->polygon_mode[0]);
    if (state->version >= 45)
        glClipControl((GLenum)state->clip_origin, (GLenum)state->clip_depth);
}

static void restore_bindings(const struct host_state *state)
{
    for (int i = 0; i < HOST_PIXEL_STORES; i++)
        glPixelStorei(pixel_stores[i], state->pixel_stores[i]);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)state->unpack_buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)state->pack_buffer);
    for (int unit = 0; unit < HOST_TEXTURE_UNITS; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, (GLuint)state->textures[unit]);
        glBindSampler((GLuint)unit, (GLuint)state->samplers[unit]);
    }
    glActiveTexture((GLenum)state->active_texture);
    glBindRenderbuffer(GL_RENDERBUFFER, (GLuint)state->renderbuffer);
    glBindVertexArray((GLuint)state->vertex_array);
    if (state->version >= 41)
        glBindProgramPipeline((GLuint)state->pipeline);
    glUseProgram((GLuint)state->program);
}

void host_state_restore(const struct host_state *state)
{
    restore_bindings(state);
    restore_fixed_function(state);
    host_target_restore(&state->target, state->version);
}
