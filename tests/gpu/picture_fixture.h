/* Existing pictures ready to be shown: textures of them, and what the warp makes of those. */
#ifndef PICTURE_FIXTURE_H
#define PICTURE_FIXTURE_H

#include <stddef.h>

#include "fixture.h"

/* Of every gl of picture_fixture_make. */
extern const float picture_border[4];

/* A theatre for pictures alone. */
void picture_fixture_make(const struct cupola_rig *rig, struct fixture *fixture);

/* A texture of RGBA floats in the shape of painted.h; of a cube six faces of that height. */
void picture_upload(struct cupola_source *source, const float *picture, int height);

/* The image of output 0 with the source in it: RGBA floats, freed by the caller. */
float *picture_shown(const struct fixture *fixture, const struct cupola_source *source);

/* Random numbers from 0 to 1, RGBA; freed by the caller. */
float *picture_noise(size_t texels);

/* The distance of two colours, alpha included. */
double picture_pixel_error(const float *shown, const float *expected);

#endif
