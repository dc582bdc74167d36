/* Objects of the GL that are more than names: made, each checked and named; found, bound. */
#ifndef GL_OBJECTS_H
#define GL_OBJECTS_H

#include <epoxy/gl.h>
#include <stdbool.h>

#include "cupola/error.h"
#include "guest.h"

/* A 2-D texture without mipmaps, clamped to its edge. 0 on failure. */
GLuint texture_create(GLenum internal_format, int width_px, int height_px, GLenum filter,
                      struct cupola_error *error);

/* A framebuffer with one colour texture; left bound. 0 on failure; `what` is drawn into it. */
GLuint framebuffer_create(GLuint texture, const char *what, struct cupola_error *error);

/*
 * Binds a texture to the active unit; false, and no error left in the GL, if there is none of that
 * name or it is of another kind. The target is GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY or
 * GL_TEXTURE_CUBE_MAP.
 */
bool texture_bind(GLenum target, GLuint name);

/* The same without being left bound; where the host's state is left, the host vouches for it. */
bool texture_found(const struct guest *guest, GLenum target, GLuint name);

/* A vertex array without any attribute so far; left bound. 0 on failure. */
GLuint vertex_array_create(const struct guest *guest, const char *name, struct cupola_error *error);

/* A sampler: bilinear, without mipmaps, clamped to the edge. Unit 0 has none then. 0 on failure. */
GLuint sampler_create(const struct guest *guest, const char *name, struct cupola_error *error);

void draw_fullscreen(GLuint vertex_array);

#endif
