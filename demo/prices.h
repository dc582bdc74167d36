/* What the views of a scene cost on this machine, measured for the planner. */
#ifndef PRICES_H
#define PRICES_H

#include "show.h"

/*
 * Sets the prices of the setup's plan by drawing a few frames of the scene. Where they cannot be
 * told the plan's own stay and stderr says why. False with one line in `message` where nothing can
 * be drawn.
 */
bool prices_measure(struct show_setup *setup, struct scene *scene, const struct host_camera *camera,
                    char *message);

#endif
