/* The host's GL state that only drawing points changes; host_state.h has all the rest. */
#ifndef HOST_POINT_H
#define HOST_POINT_H

#include <epoxy/gl.h>

/* Where there are samples, the GL widens and fades points that are smaller than this. */
struct host_point {
    GLfloat fade_threshold_px; /* 0 in OpenGL ES, which has none */
};

/* Saves it and has points of every size be drawn as they are. */
void host_point_save(struct host_point *point);
/* The latter without asking. */
void host_point_set(void);
void host_point_restore(const struct host_point *point);

#endif
