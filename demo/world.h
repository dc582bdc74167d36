/* What the options ask to be drawn, and the camera in it. */
#ifndef WORLD_H
#define WORLD_H

#include <stdio.h>

#include "film.h"
#include "host_camera.h"
#include "options.h"
#include "scene.h"

struct world {
    struct scene *scene; /* NULL where there is a film */
    struct film *film;   /* shown instead of a scene; NULL: none */
    struct host_camera camera;
    double up[3]; /* world */
    int way;      /* of enum cupola_pass_way: views are drawn in one pass; 0: one by one */
};

/*
 * Loads or makes the scene and places the camera; a place that was chosen for a MODEL is printed to
 * `news`, and to stderr that views cannot be drawn in one pass where that was asked for. STATUS_OK,
 * or another status with one line in message (MESSAGE_SIZE bytes) and nothing made. Runs where a GL
 * context is current.
 */
int world_create(struct world *world, const struct options *options, const struct cupola_rig *rig,
                 FILE *news, char *message);

void world_destroy(struct world *world);

/* Whether --look and --up define a camera; checked before any work, where the place is known. */
int world_check_camera(const struct options *options, char *message);

#endif
