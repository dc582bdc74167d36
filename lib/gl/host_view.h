/* The host's GL state that only clearing and resolving views changes; host_state.h has the rest. */
#ifndef HOST_VIEW_H
#define HOST_VIEW_H

#include "host_state.h"

/*
 * Whether sRGB formats are encoded when they are written and decoded when they are averaged. In
 * OpenGL ES without GL_EXT_sRGB_write_control it is always on.
 */
GLboolean host_encoding_is_on(const struct host_features *features);

/* The stencil's write mask as clears use it: the first lets all bits through and, asked, returns
 * what it was. */
GLuint host_stencil_unmask(bool asked);
void host_stencil_mask(GLuint mask);

#endif
