/* Hosts that leave GL state as it suits nobody else, each in one way; and a clean state again. */
#ifndef HOSTILITIES_H
#define HOSTILITIES_H

#include "state_snapshot.h"

enum { HOSTILE_SIZE = 8, HOSTILE_BYTES = 64 };

/* What the hosts bind. */
static GLuint hostile_textures[SNAPSHOT_UNITS], hostile_samplers[SNAPSHOT_UNITS];
static GLuint hostile_framebuffers[2], hostile_renderbuffer, hostile_vertex_array;
static GLuint hostile_buffers[4], hostile_program, hostile_feedback_program, hostile_pipeline;

static void set_depth_test(void)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
}

static void set_depth_mask(void)
{
    glDepthMask(GL_FALSE);
}

static void set_stencil(void)
{
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 3, 0xf);
    glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
    glStencilMask(0x5);
    glStencilFuncSeparate(GL_BACK, GL_LESS, 200, 0x7f);
    glStencilOpSeparate(GL_BACK, GL_DECR, GL_ZERO, GL_INCR_WRAP);
    glStencilMaskSeparate(GL_BACK, 0x80000042u);
}

static void set_cull(void)
{
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
}

static void set_srgb(void)
{
    glEnable(GL_FRAMEBUFFER_SRGB);
}

static void set_discard(void)
{
    glEnable(GL_RASTERIZER_DISCARD);
}

static void set_restart(void)
{
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(1);
}

static void set_restart_fixed(void)
{
    glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
}

static void set_logic_op(void)
{
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_INVERT);
}

static void set_polygon_offset(void)
{
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1e4f, 1e4f);
}

static void set_smooth(void)
{
    glEnable(GL_POLYGON_SMOOTH);
    glEnable(GL_LINE_SMOOTH);
}

static void set_no_multisample(void)
{
    glDisable(GL_MULTISAMPLE);
}

static void set_alpha_to_coverage(void)
{
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

static void set_alpha_to_one(void)
{
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
}

static void set_sample_coverage(void)
{
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.3f, GL_TRUE);
}

static void set_sample_mask(void)
{
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0x2);
}

static void set_sample_shading(void)
{
    glEnable(GL_SAMPLE_SHADING);
    glMinSampleShading(1.0f);
}

static void set_depth_clamp(void)
{
    glEnable(GL_DEPTH_CLAMP);
    context_depth_range(0.9, 0.1);
}

static void set_no_dither(void)
{
    glDisable(GL_DITHER);
}

static void set_clip_distances(void)
{
    for (int i = 0; i < 8; i++)
        glEnable((GLenum)(GL_CLIP_DISTANCE0 + i));
}

static void set_blend(void)
{
    glEnable(GL_BLEND);
    glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
    glBlendFuncSeparate(GL_DST_COLOR, GL_ONE, GL_CONSTANT_ALPHA, GL_ZERO);
    glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
}

static void set_blend_advanced(void)
{
    glEnable(GL_BLEND);
    glBlendEquation(GL_MULTIPLY_KHR);
}

static void set_blend_of_second_buffer(void)
{
    glEnablei(GL_BLEND, 1);
    glBlendEquationSeparatei(1, GL_MIN, GL_MAX);
    glBlendFuncSeparatei(1, GL_DST_COLOR, GL_SRC_ALPHA, GL_ZERO, GL_DST_ALPHA);
}

static void set_color_mask(void)
{
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    if (!context_has_enable_per_buffer())
        return;
    glColorMaski(1, GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glColorMaski(SNAPSHOT_BUFFERS - 1, GL_FALSE, GL_FALSE, GL_TRUE, GL_TRUE);
}

static void set_polygon_mode(void)
{
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(1.0f);
}

static void set_clip_control(void)
{
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
}

static void set_area(void)
{
    glViewport(3, 5, 7, 11);
    glScissor(2, 1, 3, 4);
    glEnable(GL_SCISSOR_TEST);
}

static void set_viewports(void)
{
    for (GLuint i = 1; i < SNAPSHOT_VIEWPORTS; i++) {
        glViewportIndexedf(i, 1.5f * (GLfloat)i, 2.25f, 6.5f, 7.0f);
        glScissorIndexed(i, 1, (GLint)i, 3, 4);
        glEnablei(GL_SCISSOR_TEST, i);
    }
}

static void set_framebuffers(void)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, hostile_framebuffers[0]);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, hostile_framebuffers[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, hostile_renderbuffer);
}

static void set_program(void)
{
    glUseProgram(hostile_program);
}

static void set_pipeline(void)
{
    glBindProgramPipeline(hostile_pipeline);
}

static void set_vertex_array(void)
{
    glBindVertexArray(hostile_vertex_array);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, hostile_buffers[0]);
    glBindBuffer(GL_ARRAY_BUFFER, hostile_buffers[0]);
    glBindBuffer(GL_UNIFORM_BUFFER, hostile_buffers[0]);
}

static void set_textures(void)
{
    for (int unit = 0; unit < SNAPSHOT_UNITS; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, hostile_textures[unit]);
    }
}

/* By mipmaps where there are none: black; and without interpolation. */
static void set_samplers(void)
{
    for (GLuint unit = 0; unit < SNAPSHOT_UNITS; unit++)
        glBindSampler(unit, hostile_samplers[unit]);
}

static void set_pack_buffer(void)
{
    glBindBuffer(GL_PIXEL_PACK_BUFFER, hostile_buffers[1]);
}

static void set_unpack_buffer(void)
{
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, hostile_buffers[2]);
}

static void set_pack_store(void)
{
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_PACK_ROW_LENGTH, 37);
    glPixelStorei(GL_PACK_SKIP_ROWS, 2);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 1);
}

static void set_pack_swap(void)
{
    glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
}

static void set_unpack_store(void)
{
    glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);
    if (!context_is_es())
        glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 5);
}

static void set_clamp_read(void)
{
    glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
}

/* Into a buffer with room for a few vertices only; points, where Cupola draws triangles. */
static void set_feedback(void)
{
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, hostile_buffers[3]);
    glUseProgram(hostile_feedback_program);
    glBeginTransformFeedback(GL_POINTS);
}

static void set_clear_values(void)
{
    glClearColor(0.9f, 0.1f, 0.8f, 0.2f);
    context_clear_depth(0.25);
    glClearStencil(77);
    if (context_is_es())
        return;
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glPointSize(5.0f);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 300.0f);
}

/* Whether it is seen to matter to the same work done without any care; see host_state.c. */
enum matters {
    MATTERS,
    MAY_MATTER, /* by the GL's rules or to some driver, not seen with the work that is done here */
};

static const struct hostility {
    const char *name;
    void (*set)(void);
    int gl;
    const char *gl_extension;
    int es;
    const char *es_extension;
    enum matters matters;
} hostilities[] = {
    {"depth test that nothing passes", set_depth_test, 33, NULL, 30, NULL, MATTERS},
    {"no depth written", set_depth_mask, 33, NULL, 30, NULL, MATTERS},
    {"stencil test that nothing passes", set_stencil, 33, NULL, 30, NULL, MATTERS},
    {"all faces culled", set_cull, 33, NULL, 30, NULL, MATTERS},
    {"conversion to sRGB", set_srgb, 33, NULL, NO_VERSION, "GL_EXT_sRGB_write_control", MATTERS},
    {"rasterizer discard", set_discard, 33, NULL, 30, NULL, MATTERS},
    {"primitive restart", set_restart, 33, NULL, NO_VERSION, NULL, MAY_MATTER},
    {"primitive restart, fixed index", set_restart_fixed, 43, "GL_ARB_ES3_compatibility", 30, NULL,
     MAY_MATTER},
    {"logic op", set_logic_op, 33, NULL, NO_VERSION, NULL, MATTERS},
    {"polygon offset", set_polygon_offset, 33, NULL, 30, NULL, MAY_MATTER},
    {"smooth polygons", set_smooth, 33, NULL, NO_VERSION, NULL, MAY_MATTER},
    {"no multisampling", set_no_multisample, 33, NULL, NO_VERSION,
     "GL_EXT_multisample_compatibility", MAY_MATTER},
    {"alpha to coverage", set_alpha_to_coverage, 33, NULL, 30, NULL, MATTERS},
    {"alpha to one", set_alpha_to_one, 33, NULL, NO_VERSION, "GL_EXT_multisample_compatibility",
     MATTERS},
    {"sample coverage", set_sample_coverage, 33, NULL, 30, NULL, MATTERS},
    {"sample mask", set_sample_mask, 33, NULL, 31, NULL, MATTERS},
    {"shading by sample", set_sample_shading, 40, "GL_ARB_sample_shading", 32,
     "GL_OES_sample_shading", MAY_MATTER},
    {"depth clamp and range", set_depth_clamp, 33, NULL, NO_VERSION, "GL_EXT_depth_clamp",
     MAY_MATTER},
    {"no dithering", set_no_dither, 33, NULL, 30, NULL, MAY_MATTER},
    {"clip distances", set_clip_distances, 33, NULL, NO_VERSION, "GL_EXT_clip_cull_distance",
     MAY_MATTER},
    {"blending", set_blend, 33, NULL, 30, NULL, MATTERS},
    {"advanced blending", set_blend_advanced, NO_VERSION, "GL_KHR_blend_equation_advanced", 32,
     "GL_KHR_blend_equation_advanced", MATTERS},
    {"blending of the second buffer", set_blend_of_second_buffer, 40, "GL_ARB_draw_buffers_blend",
     32, "GL_OES_draw_buffers_indexed", MATTERS},
    {"color mask", set_color_mask, 33, NULL, 30, NULL, MATTERS},
    {"lines for polygons", set_polygon_mode, 33, NULL, NO_VERSION, NULL, MATTERS},
    {"clip control", set_clip_control, 45, "GL_ARB_clip_control", NO_VERSION, "GL_EXT_clip_control",
     MAY_MATTER},
    {"viewport and scissor", set_area, 33, NULL, 30, NULL, MATTERS},
    {"more viewports", set_viewports, 41, "GL_ARB_viewport_array", NO_VERSION,
     "GL_OES_viewport_array", MATTERS},
    {"framebuffers, renderbuffer", set_framebuffers, 33, NULL, 30, NULL, MATTERS},
    {"program", set_program, 33, NULL, 30, NULL, MATTERS},
    {"program pipeline", set_pipeline, 41, "GL_ARB_separate_shader_objects", 31, NULL, MAY_MATTER},
    {"vertex array, buffers", set_vertex_array, 33, NULL, 30, NULL, MATTERS},
    {"textures, active unit", set_textures, 33, NULL, 30, NULL, MATTERS},
    {"sampler objects", set_samplers, 33, NULL, 30, NULL, MATTERS},
    {"pack buffer", set_pack_buffer, 33, NULL, 30, NULL, MATTERS},
    {"unpack buffer", set_unpack_buffer, 33, NULL, 30, NULL, MATTERS},
    {"pack storage", set_pack_store, 33, NULL, 30, NULL, MATTERS},
    {"pack with bytes swapped", set_pack_swap, 33, NULL, NO_VERSION, NULL, MATTERS},
    {"unpack storage", set_unpack_store, 33, NULL, 30, NULL, MAY_MATTER},
    {"clamped reading", set_clamp_read, 33, NULL, NO_VERSION, NULL, MATTERS},
    {"transform feedback", set_feedback, 40, "GL_ARB_transform_feedback2", 30, NULL, MATTERS},
    {"clear values and the rest", set_clear_values, 33, NULL, 30, NULL, MAY_MATTER},
};

enum { HOSTILITIES = sizeof hostilities / sizeof hostilities[0] };

#endif
