/* A simulated camera by rays: for each part of its pixels the projector's place that lights it. */
#ifndef SIMULATE_RAYS_H
#define SIMULATE_RAYS_H

#include "capture/simulate.h"

struct ray_camera;

struct ray_camera *ray_camera_create(const struct simulation *simulation, char *message);
void ray_camera_destroy(struct ray_camera *camera);

/* Light of the screen, ambient and shown, into a photograph that is there. */
void ray_camera_take(const struct ray_camera *camera, const struct photo *shown,
                     struct photo *photo);

#endif
