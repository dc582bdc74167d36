/* All state of a GL context that a library could disturb, as numbers to be compared. */
#ifndef STATE_SNAPSHOT_H
#define STATE_SNAPSHOT_H

#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "context.h"

enum { SNAPSHOT_MAX = 1024, SNAPSHOT_UNITS = 12, SNAPSHOT_BUFFERS = 4, SNAPSHOT_VIEWPORTS = 8 };

struct snapshot {
    int count;
    struct {
        GLenum name;
        int index;
        double value;
        bool of_target; /* what view_begin sets for the host */
    } entries[SNAPSHOT_MAX];
};

/* The capabilities that a context of any kind may have and this one has. */
struct capability {
    GLenum name;
    int gl;
    const char *gl_extension;
    int es; /* NO_VERSION: none has it without the extension */
    const char *es_extension;
};

enum { NO_VERSION = 1000 };

static inline void snapshot_add(struct snapshot *all, GLenum name, int index, double value)
{
    if (all->count == SNAPSHOT_MAX)
        return;
    all->entries[all->count].name = name;
    all->entries[all->count].index = index;
    all->entries[all->count].value = value;
    all->entries[all->count++].of_target = false;
}

static const struct capability capabilities[] = {
    {GL_DEPTH_TEST, 33, NULL, 30, NULL},
    {GL_STENCIL_TEST, 33, NULL, 30, NULL},
    {GL_CULL_FACE, 33, NULL, 30, NULL},
    {GL_FRAMEBUFFER_SRGB, 33, NULL, NO_VERSION, "GL_EXT_sRGB_write_control"},
    {GL_RASTERIZER_DISCARD, 33, NULL, 30, NULL},
    {GL_PRIMITIVE_RESTART, 33, NULL, NO_VERSION, NULL},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, 43, "GL_ARB_ES3_compatibility", 30, NULL},
    {GL_COLOR_LOGIC_OP, 33, NULL, NO_VERSION, NULL},
    {GL_POLYGON_OFFSET_FILL, 33, NULL, 30, NULL},
    {GL_POLYGON_OFFSET_LINE, 33, NULL, NO_VERSION, NULL},
    {GL_POLYGON_OFFSET_POINT, 33, NULL, NO_VERSION, NULL},
    {GL_POLYGON_SMOOTH, 33, NULL, NO_VERSION, NULL},
    {GL_LINE_SMOOTH, 33, NULL, NO_VERSION, NULL},
    {GL_MULTISAMPLE, 33, NULL, NO_VERSION, "GL_EXT_multisample_compatibility"},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, 33, NULL, 30, NULL},
    {GL_SAMPLE_ALPHA_TO_ONE, 33, NULL, NO_VERSION, "GL_EXT_multisample_compatibility"},
    {GL_SAMPLE_COVERAGE, 33, NULL, 30, NULL},
    {GL_SAMPLE_MASK, 33, NULL, 31, NULL},
    {GL_SAMPLE_SHADING, 40, "GL_ARB_sample_shading", 32, "GL_OES_sample_shading"},
    {GL_DEPTH_CLAMP, 33, NULL, NO_VERSION, "GL_EXT_depth_clamp"},
    {GL_DITHER, 33, NULL, 30, NULL},
    {GL_PROGRAM_POINT_SIZE, 33, NULL, NO_VERSION, NULL},
    {GL_TEXTURE_CUBE_MAP_SEAMLESS, 33, NULL, NO_VERSION, NULL},
    {GL_CLIP_DISTANCE0, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE1, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE2, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE3, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE4, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE5, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE6, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE7, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance"},
};

enum { CAPABILITIES = sizeof capabilities / sizeof capabilities[0] };

static inline bool capability_exists(const struct capability *c)
{
    return context_has(c->gl, c->gl_extension, c->es, c->es_extension);
}

/* Blending on or off, its functions, and the colour mask of each draw buffer. */
static inline bool context_has_enable_per_buffer(void)
{
    return context_has(33, NULL, 32, "GL_OES_draw_buffers_indexed");
}

static inline bool context_has_blend_per_buffer(void)
{
    return context_has(40, "GL_ARB_draw_buffers_blend", 32, "GL_OES_draw_buffers_indexed");
}

static inline bool context_has_viewports(void)
{
    return context_has(41, "GL_ARB_viewport_array", NO_VERSION, "GL_OES_viewport_array");
}

static inline bool context_has_clip_control(void)
{
    return context_has(45, "GL_ARB_clip_control", NO_VERSION, "GL_EXT_clip_control");
}

static inline bool context_has_pausable_feedback(void)
{
    return context_has(40, "GL_ARB_transform_feedback2", 30, NULL);
}

static inline bool context_has_pipelines(void)
{
    return context_has(41, "GL_ARB_separate_shader_objects", 31, NULL);
}

static inline void snapshot_capabilities(struct snapshot *all)
{
    for (int i = 0; i < CAPABILITIES; i++)
        if (capability_exists(&capabilities[i]))
            snapshot_add(all, capabilities[i].name, 0, glIsEnabled(capabilities[i].name));
}

static inline void snapshot_floats(struct snapshot *all, GLenum name, int values)
{
    GLfloat v[4] = {0};
    glGetFloatv(name, v);
    for (int i = 0; i < values; i++)
        snapshot_add(all, name, i, (double)v[i]);
}

static inline void snapshot_values(struct snapshot *all)
{
    static const GLenum names[] = {GL_DEPTH_FUNC,
                                   GL_DEPTH_WRITEMASK,
                                   GL_DEPTH_CLEAR_VALUE,
                                   GL_STENCIL_FUNC,
                                   GL_STENCIL_VALUE_MASK,
                                   GL_STENCIL_FAIL,
                                   GL_STENCIL_PASS_DEPTH_FAIL,
                                   GL_STENCIL_PASS_DEPTH_PASS,
                                   GL_STENCIL_BACK_FUNC,
                                   GL_STENCIL_BACK_VALUE_MASK,
                                   GL_STENCIL_BACK_WRITEMASK,
                                   GL_STENCIL_BACK_FAIL,
                                   GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                                   GL_STENCIL_BACK_PASS_DEPTH_PASS,
                                   GL_STENCIL_WRITEMASK,
                                   GL_STENCIL_CLEAR_VALUE,
                                   GL_CULL_FACE_MODE,
                                   GL_FRONT_FACE,
                                   GL_POLYGON_OFFSET_FACTOR,
                                   GL_SAMPLE_COVERAGE_VALUE,
                                   GL_SAMPLE_COVERAGE_INVERT,
                                   GL_LINE_WIDTH,
                                   GL_CURRENT_PROGRAM,
                                   GL_VERTEX_ARRAY_BINDING,
                                   GL_RENDERBUFFER_BINDING,
                                   GL_ARRAY_BUFFER_BINDING,
                                   GL_ELEMENT_ARRAY_BUFFER_BINDING,
                                   GL_UNIFORM_BUFFER_BINDING,
                                   GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                                   GL_PIXEL_PACK_BUFFER_BINDING,
                                   GL_PIXEL_UNPACK_BUFFER_BINDING,
                                   GL_ACTIVE_TEXTURE,
                                   GL_PACK_ALIGNMENT,
                                   GL_PACK_ROW_LENGTH,
                                   GL_PACK_SKIP_ROWS,
                                   GL_PACK_SKIP_PIXELS,
                                   GL_UNPACK_ALIGNMENT,
                                   GL_UNPACK_ROW_LENGTH,
                                   GL_UNPACK_SKIP_ROWS,
                                   GL_UNPACK_SKIP_PIXELS,
                                   GL_UNPACK_IMAGE_HEIGHT,
                                   GL_UNPACK_SKIP_IMAGES};
    static const GLenum desktop_names[] = {
        GL_POLYGON_MODE,      GL_LOGIC_OP_MODE,    GL_PRIMITIVE_RESTART_INDEX,
        GL_PROVOKING_VERTEX,  GL_POINT_SIZE,       GL_POINT_FADE_THRESHOLD_SIZE,
        GL_CLAMP_READ_COLOR,  GL_PACK_SWAP_BYTES,  GL_PACK_LSB_FIRST,
        GL_PACK_IMAGE_HEIGHT, GL_UNPACK_SWAP_BYTES};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        snapshot_floats(all, names[i], 1);
    for (size_t i = 0; !context_is_es() && i < sizeof desktop_names / sizeof names[0]; i++)
        snapshot_floats(all, desktop_names[i], 1);
    if (context_has_pipelines())
        snapshot_floats(all, GL_PROGRAM_PIPELINE_BINDING, 1);
    snapshot_floats(all, GL_COLOR_CLEAR_VALUE, 4);
    snapshot_floats(all, GL_DEPTH_RANGE, 2);
    snapshot_floats(all, GL_BLEND_COLOR, 4);
    if (context_has_clip_control()) {
        snapshot_floats(all, GL_CLIP_ORIGIN, 1);
        snapshot_floats(all, GL_CLIP_DEPTH_MODE, 1);
    }
    if (context_has_pausable_feedback()) {
        snapshot_floats(all, GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, 1);
        snapshot_floats(all, GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED, 1);
    }
}

static inline void snapshot_buffers(struct snapshot *all)
{
    static const GLenum blending[] = {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA,
                                      GL_BLEND_SRC_RGB,      GL_BLEND_DST_RGB,
                                      GL_BLEND_SRC_ALPHA,    GL_BLEND_DST_ALPHA};
    bool each = context_has_blend_per_buffer();
    bool enables = context_has_enable_per_buffer();
    for (int buffer = 0; buffer < (enables ? SNAPSHOT_BUFFERS : 1); buffer++) {
        GLint mask[4];
        if (enables)
            glGetIntegeri_v(GL_COLOR_WRITEMASK, (GLuint)buffer, mask);
        else
            glGetIntegerv(GL_COLOR_WRITEMASK, mask);
        snapshot_add(all, GL_BLEND, buffer,
                     enables ? glIsEnabledi(GL_BLEND, (GLuint)buffer) : glIsEnabled(GL_BLEND));
        for (int i = 0; i < 4; i++)
            snapshot_add(all, GL_COLOR_WRITEMASK, 4 * buffer + i, mask[i]);
        for (int i = 0; i < 6 && (each || buffer == 0); i++) {
            GLint value = 0;
            if (each)
                glGetIntegeri_v(blending[i], (GLuint)buffer, &value);
            else
                glGetIntegerv(blending[i], &value);
            snapshot_add(all, blending[i], buffer, value);
        }
    }
}

static inline void snapshot_units(struct snapshot *all)
{
    static const GLenum bindings[] = {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_CUBE_MAP,
                                      GL_TEXTURE_BINDING_2D_ARRAY, GL_SAMPLER_BINDING};
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (int unit = 0; unit < SNAPSHOT_UNITS; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        for (int i = 0; i < 4; i++) {
            GLint value = 0;
            glGetIntegerv(bindings[i], &value);
            snapshot_add(all, bindings[i], unit, value);
        }
    }
    glActiveTexture((GLenum)active);
}

/* What view_begin sets: marked. Viewports and scissor rectangles of higher index are not. */
static inline void snapshot_target(struct snapshot *all)
{
    int first = all->count;
    snapshot_floats(all, GL_DRAW_FRAMEBUFFER_BINDING, 1);
    snapshot_floats(all, GL_READ_FRAMEBUFFER_BINDING, 1);
    snapshot_floats(all, GL_DRAW_BUFFER0, 1);
    snapshot_floats(all, GL_STENCIL_REF, 1);
    snapshot_floats(all, GL_STENCIL_BACK_REF,
                    1); /* both told within what the framebuffer can hold */
    snapshot_floats(all, GL_READ_BUFFER, 1);
    snapshot_floats(all, GL_VIEWPORT, 4);
    snapshot_floats(all, GL_SCISSOR_BOX, 4);
    snapshot_add(all, GL_SCISSOR_TEST, 0, glIsEnabled(GL_SCISSOR_TEST));
    for (int i = first; i < all->count; i++)
        all->entries[i].of_target = true;
    if (!context_has_viewports())
        return;
    for (int viewport = 1; viewport < SNAPSHOT_VIEWPORTS; viewport++) {
        GLfloat v[4];
        GLint s[4];
        glGetFloati_v(GL_VIEWPORT, (GLuint)viewport, v);
        glGetIntegeri_v(GL_SCISSOR_BOX, (GLuint)viewport, s);
        for (int i = 0; i < 4; i++) {
            snapshot_add(all, GL_VIEWPORT, 4 * viewport + i, (double)v[i]);
            snapshot_add(all, GL_SCISSOR_BOX, 4 * viewport + i, s[i]);
        }
        snapshot_add(all, GL_SCISSOR_TEST, viewport,
                     glIsEnabledi(GL_SCISSOR_TEST, (GLuint)viewport));
    }
}

static inline void snapshot_take(struct snapshot *all)
{
    all->count = 0;
    snapshot_target(all);
    snapshot_capabilities(all);
    snapshot_values(all);
    snapshot_buffers(all);
    snapshot_units(all);
}

/* How many numbers differ; each is printed after `where` unless that is NULL. */
static inline int snapshot_differences(const struct snapshot *a, const struct snapshot *b,
                                       bool also_target, const char *where)
{
    int differences = a->count != b->count;
    for (int i = 0; i < a->count && i < b->count; i++) {
        if (a->entries[i].value == b->entries[i].value || (a->entries[i].of_target && !also_target))
            continue;
        differences++;
        if (where)
            printf("%s: state 0x%04x [%d] was %g and is %g\n", where, a->entries[i].name,
                   a->entries[i].index, a->entries[i].value, b->entries[i].value);
    }
    return differences;
}

#endif
