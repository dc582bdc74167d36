/* Whether the framebuffer that target_bind has bound has colours that can be drawn or read. */
#ifndef TARGET_COLOR_H
#define TARGET_COLOR_H

#include <epoxy/gl.h>
#include <stdbool.h>

#include "cupola/error.h"

/* CUPOLA_ERROR_GL where draw buffer 0 is none or holds integers: draws would be lost. */
int target_check_color(GLuint framebuffer, struct cupola_error *error);

/* CUPOLA_ERROR_GL after the GL has refused to read: says why, as far as that can be told. */
int target_unreadable(GLuint framebuffer, GLenum failure, struct cupola_error *error);

#endif
