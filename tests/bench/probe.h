/* Scenes that are hard to sample, by name: what antialiasing is judged by. */
#ifndef PROBE_H
#define PROBE_H

#include "setting.h"

/* How fine a scene's details are. */
struct probe_scale {
    double half_fov_rad;
    double pixel_rad; /* of the output, in the image's middle */
};

/*
 * zone-plate   rings whose frequency grows to what no pixel can show
 * siemens      stars in the middle and near the rim
 * checkers     a room of checks that are three pixels wide straight ahead, or :PX behind the name
 * starfield    points of half a pixel
 * model        `model`, by the demo's sunlight
 *
 * or a load's name (load.h). NULL with one line in `message`.
 */
struct scene *probe_create(const char *name, const struct probe_scale *scale, const char *model,
                           char *message);

/* Whether that is a scene's name, else false with one line in `message`; draws nothing. */
bool probe_check(const char *name, char *message);

/* The five, NULL at the end. */
extern const char *const probe_names[];

/* Whether a scene filters itself by how finely it is drawn, as mipmaps do. */
bool probe_filters_itself(const char *name);

/* The starfield: so many squares of an angular width, the same for the same number. */
struct scene *starfield_create(int stars, double width_rad, char *message);

#endif
