/* A surfaceless GL context, the way cupola-demo makes its own. */
#include "context.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "headless.h"

enum { EXIT_SKIPPED = 77 };

static struct headless *headless;

bool context_is_es(void)
{
    const char *api = getenv("CUPOLA_TEST_API");
    return api && strcmp(api, "es") == 0;
}

void context_open(void)
{
    /* A version in the message means that there was a context. */
    static const char too_old[] = "the OpenGL";
    char message[256];
    headless = context_is_es() ? headless_create_es(message, sizeof message)
                               : headless_create(message, sizeof message);
    if (!headless) {
        const char *required = getenv("CUPOLA_GPU_REQUIRED");
        int skipped = strncmp(message, too_old, sizeof too_old - 1) != 0 &&
                      !(required && strcmp(required, "1") == 0);
        fprintf(stderr, "%s: %s\n", skipped ? "skipped" : "failed", message);
        exit(skipped ? EXIT_SKIPPED : EXIT_FAILURE);
    }
    printf("renderer: %s, %s%s\n", (const char *)glGetString(GL_RENDERER),
           context_is_es() ? "" : "OpenGL ", (const char *)glGetString(GL_VERSION));
    fflush(stdout);
}

void context_close(void)
{
    headless_destroy(headless);
    headless = NULL;
}

bool context_has(int gl, const char *gl_extension, int es, const char *es_extension)
{
    const char *extension = context_is_es() ? es_extension : gl_extension;
    return epoxy_gl_version() >= (context_is_es() ? es : gl) ||
           (extension && epoxy_has_gl_extension(extension));
}

bool context_has_floats(void)
{
    return !context_is_es() || (epoxy_has_gl_extension("GL_EXT_color_buffer_float") &&
                                epoxy_has_gl_extension("GL_OES_texture_float_linear"));
}

const char *context_shader_head(void)
{
    return context_is_es() ? "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                             "precision highp sampler2D;\n"
                           : "#version 330 core\n";
}

static bool compile(GLuint shader, const char *const *texts, int count)
{
    char log[2048] = "";
    GLint compiled = GL_FALSE;
    glShaderSource(shader, count, texts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!compiled)
        print_message("  shader: %s\n", log);
    return compiled;
}

GLuint context_compile(GLenum kind, const char *source)
{
    const char *const texts[2] = {context_shader_head(), source};
    GLuint shader = glCreateShader(kind);
    assert_true(compile(shader, texts, 2));
    return shader;
}

bool context_attach(GLuint program, GLenum kind, const char *const *texts, int count)
{
    GLuint shader = glCreateShader(kind);
    bool compiled = compile(shader, texts, count);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    return compiled;
}

GLuint context_link(GLuint program)
{
    char log[2048] = "";
    GLint linked = GL_FALSE;
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    if (!linked)
        fail_msg("program: %s", log);
    return program;
}

GLuint context_program(const char *vertex, const char *fragment)
{
    const char *const vertex_texts[2] = {context_shader_head(), vertex};
    const char *const fragment_texts[2] = {context_shader_head(), fragment};
    GLuint program = glCreateProgram();
    assert_true(context_attach(program, GL_VERTEX_SHADER, vertex_texts, 2));
    assert_true(context_attach(program, GL_FRAGMENT_SHADER, fragment_texts, 2));
    return context_link(program);
}

void context_read_pixels(int width, int height, float *rgba)
{
    GLint buffer = GL_NONE, type = GL_FLOAT;
    if (context_is_es()) {
        glGetIntegerv(GL_READ_BUFFER, &buffer);
        glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, (GLenum)buffer,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    }
    if (type == GL_FLOAT) {
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, rgba);
        return;
    }
    unsigned char *bytes = calloc(4 * (size_t)width, (size_t)height);
    assert_non_null(bytes);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    for (int i = 0; i < 4 * width * height; i++)
        rgba[i] = (float)bytes[i] / 255.0f;
    free(bytes);
}

void context_clear_depth(double depth)
{
    if (context_is_es())
        glClearDepthf((GLfloat)depth);
    else
        glClearDepth(depth);
}

void context_depth_range(double near_depth, double far_depth)
{
    if (context_is_es())
        glDepthRangef((GLfloat)near_depth, (GLfloat)far_depth);
    else
        glDepthRange(near_depth, far_depth);
}
