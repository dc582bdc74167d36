/* The host's GL state that only drawing points changes; host_state.h has all the rest. */
#ifndef HOST_POINT_H
#define HOST_POINT_H

#include "host_state.h"

struct host_point {
    /* Where there are samples, the GL widens and fades points that are smaller than this. */
    GLfloat fade_threshold_px; /* 0 in OpenGL ES, which has none */
    /* Of compatibility profiles: points are round where there are samples, but for sprites. */
    GLboolean smooth, sprite;
};

/* Saves it and has points of every size be drawn as they are: squares. */
void host_point_save(struct host_point *point, const struct host_features *features);
/* The latter without asking. */
void host_point_set(const struct host_features *features);
void host_point_restore(const struct host_point *point, const struct host_features *features);

#endif
