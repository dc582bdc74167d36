/*
 * What a perfect dome would show: the mean, in linear light, of many whole frames, each of whose
 * pixels sends its one ray through another place in it.
 */
#ifndef TRUTH_H
#define TRUTH_H

#include "setting.h"

struct truth;

/*
 * The setting is kept, and drawn as it is whenever; density: of the views, as in plan.h. NULL with
 * one line in `message`.
 */
struct truth *truth_create(const struct setting *setting, double density, char *message);
void truth_destroy(struct truth *truth);

/*
 * Draws as many frames as rays go through a pixel. light: out, RGB, rows from the bottom up. False
 * with one line in `message`. The same rays every time: what differs between two pictures is the
 * scene.
 */
bool truth_draw(struct truth *truth, int rays, float *light, char *message);

#endif
