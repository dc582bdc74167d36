/* Targets of the host: bound, and asked what they are made of. */
#ifndef TARGET_GL_H
#define TARGET_GL_H

#include <epoxy/gl.h>
#include <stdbool.h>

#include "cupola/gl.h"
#include "guest.h"

/*
 * Binds a host's framebuffer for drawing and reading; CUPOLA_ERROR_GL, and no error left in the GL,
 * if there is none of that name or it is not complete (for which the host vouches where its state
 * is left); CUPOLA_ERROR_ARGUMENT if its corner is farther away than numbers of pixels can be added
 * to it.
 */
int target_bind(const struct guest *guest, const struct cupola_target *place,
                struct cupola_error *error);

/*
 * For the framebuffer that target_bind has bound: CUPOLA_ERROR_ARGUMENT if one of its colours is a
 * texture that would be sampled while it is drawn into. Textures of name 0 are none.
 */
int target_check_sampled(GLuint framebuffer, const GLuint *textures, int count,
                         struct cupola_error *error);

/*
 * For the framebuffer that target_bind has bound: whether the GL will encode what is drawn into it,
 * which only OpenGL ES does without being asked.
 */
bool target_encodes(const struct host_features *features);

/* Whether draw buffer 0 of the framebuffer that is bound has an sRGB format. */
bool target_is_srgb(const struct host_features *features);

/* Whether draw buffer 0 of the framebuffer that is bound has channels of 32 bit floats. */
bool target_is_float32(const struct host_features *features);

/* An error where an encoding cannot be had because the GL encodes. */
int target_check_encoding(const struct host_features *features, GLuint framebuffer,
                          enum cupola_encoding encoding, struct cupola_error *error);

#endif
