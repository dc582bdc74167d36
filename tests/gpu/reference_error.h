/*
 * How far an image of the warp is from that of the reference, from the same atlas. Where views have
 * equal claims to a ray, that of any of them will do.
 */
#ifndef REFERENCE_ERROR_H
#define REFERENCE_ERROR_H

#include "cupola/cupola.h"

struct image_error {
    double inside, edge; /* all of the pixel lit or none; a part of it */
    int edge_pixels, lit_pixels;
};

/* What images are of. */
struct compared {
    const cupola_plan *plan;
    const float *atlas;  /* RGBA floats */
    const float *border; /* RGBA */
};

/* RGBA floats of one output; freed by the caller. */
float *reference_image(const struct compared *compared, int output);

/* The largest differences of any channel. */
struct image_error image_error_of(const struct compared *compared, int output, const float *shown,
                                  const float *expected);

#endif
