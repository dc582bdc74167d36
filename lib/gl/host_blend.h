/* Blending of draw buffer 0: as the host has it, and as Cupola wants it. */
#ifndef HOST_BLEND_H
#define HOST_BLEND_H

#include "host_state.h"

void host_blend_set(const struct host_features *features, GLboolean on);
void host_blend_equations_set(const struct host_features *features, GLenum rgb, GLenum alpha);
void host_blend_equations_restore(const struct host_features *features, const GLint equation[2]);
void host_blend_factors_set(const struct host_features *features, const GLint factors[4]);

#endif
