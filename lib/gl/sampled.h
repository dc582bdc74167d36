/* Textures that are sampled: whether they can be, where the GL can be asked. */
#ifndef SAMPLED_H
#define SAMPLED_H

#include <epoxy/gl.h>
#include <stdbool.h>

#include "guest.h"

/*
 * Width, height and layers of the base level of a texture that is bound. False where the GL cannot
 * be asked, as OpenGL ES 3.0; a texture without texels has size 0.
 */
bool texture_size(const struct host_features *features, GLenum target, GLint size[3]);

/*
 * CUPOLA_ERROR_ARGUMENT where a texture has no texels, holds no colours (integers, depth, stencil)
 * or lacks levels although mipmaps are wished for. It is bound, or made so for the while if it is a
 * GL_TEXTURE_CUBE_MAP. Asks nothing and is content where OpenGL ES 3.0 cannot answer.
 */
int sampled_check(const struct host_features *features, GLenum target, GLuint texture, bool mipmaps,
                  struct cupola_error *error);

/* The same in frames, which ask nothing where the host's state is left. */
int sampled_check_in_frame(const struct guest *guest, GLenum target, GLuint texture, bool mipmaps,
                           struct cupola_error *error);

#endif
