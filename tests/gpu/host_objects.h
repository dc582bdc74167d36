/* What the hosts of host_state.c bind and draw to, and the clean state of a new context. */
#ifndef HOST_OBJECTS_H
#define HOST_OBJECTS_H

#include "cupola/overlay.h"
#include "fixture.h"
#include "hostilities.h"
#include "rig_random.h"

enum target { TARGET_SRGB, TARGET_SAMPLES, TARGET_FLOAT, TARGETS };
enum { TARGET_WIDTH = 112, TARGET_HEIGHT = 64 };

static GLuint target_framebuffers[TARGETS], target_colors[TARGETS], target_depths[TARGETS];
static GLuint resolve_framebuffer, resolve_color;
static GLuint naive_program, naive_vertex_array, naive_texture;

static inline GLuint target_framebuffer(int target)
{
    return target_framebuffers[target];
}

/* A framebuffer with the target's colour that can be read. */
static inline GLuint target_resolved(int target)
{
    if (target != TARGET_SAMPLES)
        return target_framebuffers[target];
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_framebuffers[target]);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolve_framebuffer);
    glBlitFramebuffer(0, 0, TARGET_WIDTH, TARGET_HEIGHT, 0, 0, TARGET_WIDTH, TARGET_HEIGHT,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return resolve_framebuffer;
}

static void targets_create(void)
{
    const GLenum floats = context_has_floats() ? GL_RGBA32F : GL_RGBA8;
    /* Where the GL always encodes, linear light into sRGB formats is refused. */
    const GLenum srgb =
        context_has(33, NULL, NO_VERSION, "GL_EXT_sRGB_write_control") ? GL_SRGB8_ALPHA8 : GL_RGBA8;
    const GLenum formats[TARGETS] = {srgb, GL_RGBA8, floats};
    glGenFramebuffers(TARGETS, target_framebuffers);
    glGenRenderbuffers(TARGETS, target_colors);
    glGenRenderbuffers(TARGETS, target_depths);
    for (int i = 0; i < TARGETS; i++) {
        GLsizei samples = i == TARGET_SAMPLES ? 4 : 0;
        glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffers[i]);
        glBindRenderbuffer(GL_RENDERBUFFER, target_colors[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], TARGET_WIDTH,
                                         TARGET_HEIGHT);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  target_colors[i]);
        glBindRenderbuffer(GL_RENDERBUFFER, target_depths[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8,
                                         TARGET_WIDTH, TARGET_HEIGHT);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                  target_depths[i]);
        assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    }
    glGenFramebuffers(1, &resolve_framebuffer);
    glGenRenderbuffers(1, &resolve_color);
    glBindFramebuffer(GL_FRAMEBUFFER, resolve_framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, resolve_color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, TARGET_WIDTH, TARGET_HEIGHT);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolve_color);
}

/* Some grey, half of the depth, stencil 0; in a clean state. */
static inline void targets_fill(void)
{
    glClearColor(0.5f, 0.4f, 2.5f, 0.6f);
    context_clear_depth(0.5);
    glClearStencil(0);
    for (int i = 0; i < TARGETS; i++) {
        glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffers[i]);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
}

static GLuint program_of(const char *vertex, const char *fragment, const char *feedback)
{
    const GLuint shaders[] = {context_compile(GL_VERTEX_SHADER, vertex),
                              context_compile(GL_FRAGMENT_SHADER, fragment)};
    GLuint program = glCreateProgram();
    for (int i = 0; i < 2; i++) {
        glAttachShader(program, shaders[i]);
        glDeleteShader(shaders[i]);
    }
    if (feedback)
        glTransformFeedbackVaryings(program, 1, &feedback, GL_INTERLEAVED_ATTRIBS);
    return context_link(program);
}

static void programs_create(void)
{
    static const char vertex[] = "void main() { vec2 corner = vec2(gl_VertexID & 1, gl_VertexID "
                                 ">> 1); gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0); }\n";
    static const char fragment[] = "uniform sampler2D image; out vec4 color;\n"
                                   "void main() { color = textureLod(image, gl_FragCoord.xy / 64.0,"
                                   " 0.0) + vec4(fract(gl_FragCoord.xy / 16.0), 0.0, 0.0); }\n";
    naive_program = program_of(vertex, fragment, NULL);
    hostile_program = program_of(vertex, fragment, NULL);
    hostile_feedback_program = program_of(vertex, fragment, "gl_Position");
    if (context_has_pipelines())
        glGenProgramPipelines(1, &hostile_pipeline);
}

static void bindings_create(void)
{
    static const GLubyte texels[4 * HOSTILE_SIZE * HOSTILE_SIZE] = {230, 51,  102, 102, 26,
                                                                    77,  204, 102, 179};
    glGenTextures(SNAPSHOT_UNITS, hostile_textures);
    glGenTextures(1, &naive_texture);
    glGenSamplers(SNAPSHOT_UNITS, hostile_samplers);
    for (int i = 0; i <= SNAPSHOT_UNITS; i++) {
        glBindTexture(GL_TEXTURE_2D, i < SNAPSHOT_UNITS ? hostile_textures[i] : naive_texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, HOSTILE_SIZE, HOSTILE_SIZE, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, texels);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }
    for (int i = 0; i < SNAPSHOT_UNITS; i++) {
        glSamplerParameteri(hostile_samplers[i], GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glSamplerParameteri(hostile_samplers[i], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glGenFramebuffers(2, hostile_framebuffers);
    for (int i = 0; i < 2; i++) {
        glBindFramebuffer(GL_FRAMEBUFFER, hostile_framebuffers[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               hostile_textures[i], 0);
    }
    glGenRenderbuffers(1, &hostile_renderbuffer);
    glGenVertexArrays(1, &hostile_vertex_array);
    glGenVertexArrays(1, &naive_vertex_array);
    glGenBuffers(4, hostile_buffers);
    for (int i = 0; i < 4; i++) {
        glBindBuffer(GL_ARRAY_BUFFER, hostile_buffers[i]);
        glBufferData(GL_ARRAY_BUFFER, HOSTILE_BYTES, NULL, GL_STATIC_DRAW);
    }
}

/* Views that are encoded, have a stencil and are resolved: what those need of the state, too. */
static struct fixture sampled;

static inline void sampled_create(void)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 48);
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_SRGB8,
                                            .depth = CUPOLA_DEPTH_24_STENCIL_8,
                                            .samples = 2,
                                            .one_pass = cupola_pass_way(NULL) > 0};
    fixture_make(&rig, NULL, &params, &sampled);
}

static void objects_create(void)
{
    targets_create();
    programs_create();
    bindings_create();
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void objects_release(void)
{
    glDeleteFramebuffers(TARGETS, target_framebuffers);
    glDeleteRenderbuffers(TARGETS, target_colors);
    glDeleteRenderbuffers(TARGETS, target_depths);
    glDeleteFramebuffers(1, &resolve_framebuffer);
    glDeleteRenderbuffers(1, &resolve_color);
    glDeleteProgram(naive_program);
    glDeleteProgram(hostile_program);
    glDeleteProgram(hostile_feedback_program);
    glDeleteTextures(SNAPSHOT_UNITS, hostile_textures);
    glDeleteTextures(1, &naive_texture);
    glDeleteSamplers(SNAPSHOT_UNITS, hostile_samplers);
    glDeleteFramebuffers(2, hostile_framebuffers);
    glDeleteRenderbuffers(1, &hostile_renderbuffer);
    glDeleteVertexArrays(1, &hostile_vertex_array);
    glDeleteVertexArrays(1, &naive_vertex_array);
    glDeleteBuffers(4, hostile_buffers);
    if (hostile_pipeline)
        glDeleteProgramPipelines(1, &hostile_pipeline);
}

static void reset_capabilities(void)
{
    for (int i = 0; i < CAPABILITIES; i++) {
        GLenum name = capabilities[i].name;
        if (!capability_exists(&capabilities[i]))
            continue;
        if (name == GL_MULTISAMPLE || name == GL_DITHER)
            glEnable(name);
        else
            glDisable(name);
    }
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}

static void reset_desktop_values(void)
{
    glPrimitiveRestartIndex(0);
    glLogicOp(GL_COPY);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPointSize(1.0f);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1.0f);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
}

static void reset_values(void)
{
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    context_depth_range(0.0, 1.0);
    glStencilFunc(GL_ALWAYS, 0, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilMask(~0u);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glPolygonOffset(0.0f, 0.0f);
    glSampleCoverage(1.0f, GL_FALSE);
    if (context_has(33, NULL, 31, NULL))
        glSampleMaski(0, ~0u);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendColor(0.0f, 0.0f, 0.0f, 0.0f);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glLineWidth(1.0f);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    context_clear_depth(1.0);
    glClearStencil(0);
    if (context_has_clip_control())
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    if (!context_is_es())
        reset_desktop_values();
}

static void reset_bindings(void)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glUseProgram(0);
    if (context_has_pipelines())
        glBindProgramPipeline(0);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (GLuint unit = SNAPSHOT_UNITS; unit-- > 0;) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, 0);
        glBindSampler(unit, 0);
    }
}

static void reset_pixel_stores(void)
{
    static const GLenum zero[] = {GL_PACK_ROW_LENGTH,    GL_PACK_SKIP_ROWS,   GL_PACK_SKIP_PIXELS,
                                  GL_UNPACK_ROW_LENGTH,  GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                                  GL_UNPACK_IMAGE_HEIGHT};
    for (size_t i = 0; i < sizeof zero / sizeof zero[0]; i++)
        glPixelStorei(zero[i], 0);
    if (!context_is_es()) {
        glPixelStorei(GL_PACK_SWAP_BYTES, GL_FALSE);
        glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

static void state_reset(void)
{
    GLboolean active = GL_FALSE;
    if (context_has_pausable_feedback())
        glGetBooleanv(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, &active);
    if (active)
        glEndTransformFeedback();
    reset_capabilities();
    reset_values();
    reset_bindings();
    reset_pixel_stores();
    glViewport(0, 0, TARGET_WIDTH, TARGET_HEIGHT);
    glScissor(0, 0, TARGET_WIDTH, TARGET_HEIGHT);
}

static const float laid_color[4] = {0.9f, 0.2f, 0.1f, 0.5f};

/* A spot that lets half of the warp through. */
static const struct cupola_overlay laid_over = {
    CUPOLA_OVERLAY_DISC, {0.1, 0.2, -1.0}, 0.7, .color = laid_color};

#endif
