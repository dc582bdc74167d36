/* The GL context that a test program runs in. */
#ifndef CONTEXT_H
#define CONTEXT_H

#include <epoxy/gl.h>
#include <stdbool.h>

/* Whether the environment asks for OpenGL ES, CUPOLA_TEST_API=es, instead of desktop OpenGL. */
bool context_is_es(void);

/*
 * Makes a context without a display current and prints its renderer. Ends the program with 77,
 * which Meson counts as skipped, where no context at all can be had, and with 1 where there is one
 * that is too old. With CUPOLA_GPU_REQUIRED=1 in the environment it is 1 in either case.
 */
void context_open(void);
void context_close(void);

/* Whether the context has such a version of its API, or a newer one, or the extension (or NULL). */
bool context_has(int gl, const char *gl_extension, int es, const char *es_extension);

/* Whether RGBA32F can be drawn into and filtered. */
bool context_has_floats(void);

/*
 * The first lines of a shader, in place of a #version line of its own: version, and in OpenGL ES
 * full precision for all that has none.
 */
const char *context_shader_head(void);
GLuint context_compile(GLenum kind, const char *source);

/* Of a vertex and a fragment shader without that line. */
GLuint context_program(const char *vertex, const char *fragment);

/* A shader of whole texts, attached; false, and the compiler's words printed, if it is refused. */
bool context_attach(GLuint program, GLenum kind, const char *const *texts, int count);

/* The program itself; the test fails with the linker's words. */
GLuint context_link(GLuint program);

/* glReadPixels of RGBA as floats, where OpenGL ES would only give bytes. */
void context_read_pixels(int width, int height, float *rgba);

/* glClearDepth, glDepthRange; by other names in OpenGL ES. */
void context_clear_depth(double depth);
void context_depth_range(double near_depth, double far_depth);

#endif
