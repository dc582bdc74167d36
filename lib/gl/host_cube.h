/* The host's GL state that only showing a cube map changes; host_state.h has all the rest. */
#ifndef HOST_CUBE_H
#define HOST_CUBE_H

#include <epoxy/gl.h>

struct host_cube {
    GLint texture; /* of the active unit */
    GLboolean seamless;
};

/* Saves it and has the GL filter across the edges of faces. */
void host_cube_save(struct host_cube *cube);
/* The latter without asking. */
void host_cube_set(void);
void host_cube_restore(const struct host_cube *cube);

#endif
