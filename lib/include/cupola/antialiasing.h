/*
 * Antialiasing: how many rays a pixel sends out, where they go and how they are weighed. All of it
 * is the same in C and on a GPU.
 *
 * With v the ray of a pixel's centre and dv/dx, dv/dy its changes per pixel (near a rim those half
 * a pixel inside of it), the ray at (x, y) pixels from the centre is v + x dv/dx + y dv/dy. One
 * that would leave the image circle goes to (-x, -y) instead, and if that leaves it, too, through
 * the centre. Every ray chooses its view by itself.
 */
#ifndef CUPOLA_ANTIALIASING_H
#define CUPOLA_ANTIALIASING_H

#include <stdbool.h>
#include <stdint.h>

#include "plan.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most rays that a pixel may send out. */
#define CUPOLA_RAYS_MAX 64

/* The first three of the paper's section 3.3.2, and what goes beyond it. */
enum cupola_antialiasing {
    /* The weighted mean of the texels round the hit: of 4, bilinear; or of 9, with weights 1 2 1 in
     * either direction where the hit is a texel's middle, which takes a guard band of 2 texels. */
    CUPOLA_ANTIALIASING_TEXTURE = 0,
    CUPOLA_ANTIALIASING_NONE, /* the nearest texel */
    /* Rays in a round cone about the centre's that has the pixel's solid angle, weighed by their
     * distance from its middle: about 1 - d^2, d 1 at its edge. */
    CUPOLA_ANTIALIASING_CONE,
    /* The same, but each pixel has as many rays as it covers texels, from the density map: at least
     * one. Where they are so few the cone is as long and as wide as the pixel, not round, and the
     * pattern lies along the long axis of the texels that it covers. */
    CUPOLA_ANTIALIASING_ADAPTIVE,
    /* Rays of equal weight along the long axis of the ellipse of texels that a pixel covers, about
     * as many as it is long in texels, at most 8; so far apart that together with the blur of the
     * bilinear taps they are as wide as the pixel. */
    CUPOLA_ANTIALIASING_FOOTPRINT,
};

/* Where the rays of a cone are. */
enum cupola_pattern {
    CUPOLA_PATTERN_REGULAR = 0,  /* evenly on rings */
    CUPOLA_PATTERN_ROTATED_GRID, /* a grid turned so that no two share a row or a column */
    CUPOLA_PATTERN_BLUE_NOISE,   /* without order, but far from each other */
};

/* All zero: bilinear. */
struct cupola_filter {
    enum cupola_antialiasing method; /* 0: bilinear */
    /* Rays of a cone; at most, where their number is not the same everywhere. 1 to
     * CUPOLA_RAYS_MAX; 0: 4. Texture: texels, 4 or 9; 0: 4. None: 0 or 1. */
    int samples;
    enum cupola_pattern pattern; /* of cone and adaptive */
    bool turned;                 /* by an angle that differs from pixel to pixel, by `seed` */
    uint32_t seed;               /* of those angles, and of the noise of dither_bits */
};

/* One ray of a pixel. */
struct cupola_pixel_ray {
    double x_px;         /* to the right, from the pixel's centre */
    double y_px;         /* upwards, likewise */
    double weight;       /* those of a pixel sum to 1 */
    double direction[3]; /* unit length, host's camera frame */
};

/*
 * The rays of one pixel.
 *
 * filter   NULL: all zero
 * plan     whose views and rig it is; nothing of it is kept
 * output   index
 * x, y     column and row of the pixel, 0 in the lower left corner
 * rays     out: up to CUPOLA_RAYS_MAX of them
 * error    may be NULL
 * returns  how many; 0: the pixel is not lit; CUPOLA_ERROR_ARGUMENT for an impossible filter, a
 *          pixel that is not there, or if plan or rays is NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_filter_rays(const struct cupola_filter *filter, const cupola_plan *plan,
                                  int output, int x, int y,
                                  struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX],
                                  struct cupola_error *error);

/*
 * Names as on command lines: none, texture, cone, adaptive, footprint; regular, rotated-grid,
 * blue-noise.
 *
 * method   of enum cupola_antialiasing
 * pattern  of enum cupola_pattern
 * name     as the other function gives it
 * returns  a static string, NULL for a number that is none; the way back: of the enum, or
 *          CUPOLA_ERROR_ARGUMENT, for NULL too
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_antialiasing_name(int method);
CUPOLA_API int cupola_antialiasing_find(const char *name);
CUPOLA_API const char *cupola_pattern_name(int pattern);
CUPOLA_API int cupola_pattern_find(const char *name);

#ifdef __cplusplus
}
#endif

#endif
