/* All state of a GL context that a library could disturb, as numbers to be compared. */
#ifndef STATE_SNAPSHOT_H
#define STATE_SNAPSHOT_H

#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { SNAPSHOT_MAX = 1024, SNAPSHOT_UNITS = 4, SNAPSHOT_BUFFERS = 4, SNAPSHOT_VIEWPORTS = 3 };

struct snapshot {
    int count;
    struct {
        GLenum name;
        int index;
        double value;
        bool of_target; /* what view_begin sets for the host */
    } entries[SNAPSHOT_MAX];
};

static inline bool context_has(int since, const char *extension)
{
    return epoxy_gl_version() >= since || (extension && epoxy_has_gl_extension(extension));
}

static inline void snapshot_add(struct snapshot *all, GLenum name, int index, double value)
{
    if (all->count == SNAPSHOT_MAX)
        return;
    all->entries[all->count].name = name;
    all->entries[all->count].index = index;
    all->entries[all->count].value = value;
    all->entries[all->count++].of_target = false;
}

static inline void snapshot_capabilities(struct snapshot *all)
{
    static const GLenum names[] = {GL_DEPTH_TEST,
                                   GL_STENCIL_TEST,
                                   GL_CULL_FACE,
                                   GL_FRAMEBUFFER_SRGB,
                                   GL_RASTERIZER_DISCARD,
                                   GL_PRIMITIVE_RESTART,
                                   GL_COLOR_LOGIC_OP,
                                   GL_POLYGON_OFFSET_FILL,
                                   GL_POLYGON_OFFSET_LINE,
                                   GL_POLYGON_OFFSET_POINT,
                                   GL_POLYGON_SMOOTH,
                                   GL_LINE_SMOOTH,
                                   GL_MULTISAMPLE,
                                   GL_SAMPLE_ALPHA_TO_COVERAGE,
                                   GL_SAMPLE_ALPHA_TO_ONE,
                                   GL_SAMPLE_COVERAGE,
                                   GL_SAMPLE_MASK,
                                   GL_DEPTH_CLAMP,
                                   GL_DITHER,
                                   GL_PROGRAM_POINT_SIZE,
                                   GL_TEXTURE_CUBE_MAP_SEAMLESS};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        snapshot_add(all, names[i], 0, glIsEnabled(names[i]));
    for (int i = 0; i < 8; i++)
        snapshot_add(all, GL_CLIP_DISTANCE0, i, glIsEnabled((GLenum)(GL_CLIP_DISTANCE0 + i)));
    if (context_has(43, "GL_ARB_ES3_compatibility"))
        snapshot_add(all, GL_PRIMITIVE_RESTART_FIXED_INDEX, 0,
                     glIsEnabled(GL_PRIMITIVE_RESTART_FIXED_INDEX));
    if (context_has(40, "GL_ARB_sample_shading"))
        snapshot_add(all, GL_SAMPLE_SHADING, 0, glIsEnabled(GL_SAMPLE_SHADING));
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
                                   GL_STENCIL_REF,
                                   GL_STENCIL_VALUE_MASK,
                                   GL_STENCIL_FAIL,
                                   GL_STENCIL_WRITEMASK,
                                   GL_STENCIL_CLEAR_VALUE,
                                   GL_CULL_FACE_MODE,
                                   GL_FRONT_FACE,
                                   GL_POLYGON_MODE,
                                   GL_POLYGON_OFFSET_FACTOR,
                                   GL_LOGIC_OP_MODE,
                                   GL_SAMPLE_COVERAGE_VALUE,
                                   GL_SAMPLE_COVERAGE_INVERT,
                                   GL_PRIMITIVE_RESTART_INDEX,
                                   GL_PROVOKING_VERTEX,
                                   GL_LINE_WIDTH,
                                   GL_POINT_SIZE,
                                   GL_CLAMP_READ_COLOR,
                                   GL_PROGRAM_PIPELINE_BINDING,
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
                                   GL_PACK_SWAP_BYTES,
                                   GL_PACK_LSB_FIRST,
                                   GL_PACK_IMAGE_HEIGHT,
                                   GL_UNPACK_ALIGNMENT,
                                   GL_UNPACK_ROW_LENGTH,
                                   GL_UNPACK_SKIP_ROWS,
                                   GL_UNPACK_SKIP_PIXELS,
                                   GL_UNPACK_SWAP_BYTES,
                                   GL_UNPACK_IMAGE_HEIGHT,
                                   GL_UNPACK_SKIP_IMAGES};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (names[i] != GL_PROGRAM_PIPELINE_BINDING ||
            context_has(41, "GL_ARB_separate_shader_objects"))
            snapshot_floats(all, names[i], 1);
    snapshot_floats(all, GL_COLOR_CLEAR_VALUE, 4);
    snapshot_floats(all, GL_DEPTH_RANGE, 2);
    snapshot_floats(all, GL_BLEND_COLOR, 4);
    if (context_has(45, "GL_ARB_clip_control")) {
        snapshot_floats(all, GL_CLIP_ORIGIN, 1);
        snapshot_floats(all, GL_CLIP_DEPTH_MODE, 1);
    }
    if (context_has(40, "GL_ARB_transform_feedback2")) {
        snapshot_floats(all, GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, 1);
        snapshot_floats(all, GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED, 1);
    }
}

static inline void snapshot_buffers(struct snapshot *all)
{
    static const GLenum blending[] = {GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA,
                                      GL_BLEND_SRC_RGB,      GL_BLEND_DST_RGB,
                                      GL_BLEND_SRC_ALPHA,    GL_BLEND_DST_ALPHA};
    bool each = context_has(40, "GL_ARB_draw_buffers_blend");
    for (int buffer = 0; buffer < SNAPSHOT_BUFFERS; buffer++) {
        GLboolean mask[4];
        snapshot_add(all, GL_BLEND, buffer, glIsEnabledi(GL_BLEND, (GLuint)buffer));
        glGetBooleani_v(GL_COLOR_WRITEMASK, (GLuint)buffer, mask);
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
    snapshot_floats(all, GL_DRAW_BUFFER, 1);
    snapshot_floats(all, GL_READ_BUFFER, 1);
    snapshot_floats(all, GL_VIEWPORT, 4);
    snapshot_floats(all, GL_SCISSOR_BOX, 4);
    snapshot_add(all, GL_SCISSOR_TEST, 0, glIsEnabled(GL_SCISSOR_TEST));
    for (int i = first; i < all->count; i++)
        all->entries[i].of_target = true;
    if (!context_has(41, "GL_ARB_viewport_array"))
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
