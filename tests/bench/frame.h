/* One frame of a dome, as a host draws it. */
#ifndef FRAME_H
#define FRAME_H

#include "setting.h"

/* Draws all views and warps them. False with one line in `message`. */
bool frame_draw(cupola_gl *gl, const struct setting *setting, const struct cupola_target *target,
                char *message);

#endif
