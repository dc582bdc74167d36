/*
 * The rays of a pixel: docs/antialiasing.md. shaders/filter.glsl says the same under the same
 * names.
 */
#ifndef FILTER_H
#define FILTER_H

#include <stdbool.h>

#include "cupola/antialiasing.h"
#include "dome.h"
#include "pattern.h"
#include "points.h"

/* The most rays of a footprint, whatever samples are allowed. */
#define FOOTPRINT_RAYS_MAX 8

/* Checks a filter and writes it with no member 0 that means something else. */
int filter_check(const struct cupola_filter *filter, struct cupola_filter *complete,
                 struct cupola_error *error);

/* A place near a pixel's centre and what part of the pixel's light it stands for. */
struct filter_place {
    double x_px, y_px;
    double weight;
};

/*
 * How places of the unit disc become places round a pixel's centre, so that the rays lie in a round
 * cone that has the pixel's solid angle: x = cone[0] d.x + cone[1] d.y, y = cone[2] d.y. `ray` is
 * of any length.
 */
void filter_cone(const struct varying *ray, double cone[3]);

/* Texels per pixel where a ray meets a view: du/dx, du/dy, dv/dx, dv/dy. */
void filter_jacobian(const struct cupola_view *view, const struct varying *ray, double jacobian[4]);

/*
 * The larger singular value of the jacobian, texels per pixel, and its direction in the image, unit
 * length: (half + q, xy), or (xy, q - half) where half < 0, with xx, xy and yy the products of
 * the columns (du/dx, dv/dx) and (du/dy, dv/dy), half = (xx - yy) / 2 and q = hypot(half, xy);
 * s = sqrt((xx + yy) / 2 + q).
 */
double filter_long_axis(const double jacobian[4], double axis[2]);

/* Rays of the method adaptive: texels covered, |det|, less 1e-3, rounded up; 1 to samples. */
int filter_adaptive_count(const double jacobian[4], int samples);

/*
 * Places of the method adaptive: those of an aligned pattern in a disc of a pixel's area, with the
 * pattern's x axis along the long axis: x = (axis[0] d.x - axis[1] d.y) / sqrt(pi),
 * y = (axis[1] d.x + axis[0] d.y) / sqrt(pi).
 */
void filter_adaptive_places(const struct pattern *aligned, const double axis[2],
                            const double turn[2], struct filter_place *places);

/*
 * Places of the method footprint, of equal weight along the long axis. N = s + FOOTPRINT_MORE,
 * rounded up, 1 to samples, at most FOOTPRINT_RAYS_MAX; their distance from each other, in texels,
 * is sqrt((s^2 - FOOTPRINT_BLUR) / (N^2 - 1)), at least 0, divided by s in pixels; place k is
 * axis (k - (N - 1) / 2) times that. Returns N.
 */
#define FOOTPRINT_BLUR 0.6
#define FOOTPRINT_MORE 0.4
int filter_footprint(const double jacobian[4], int samples, struct filter_place *places);

/* Places of the method cone, turned by (cosine, sine) first. */
void filter_cone_places(const struct pattern *pattern, const double cone[3], const double turn[2],
                        struct filter_place *places);

/* A pixel's centre, ready to send out rays. */
struct filter_pixel {
    int x, y;
    const struct projector *projector;
    double coverage;    /* 0: not lit, and what follows is not set */
    double place[2];    /* in the image circle, at most on its rim */
    struct varying ray; /* host's camera frame; near the rim the changes of half a pixel inside */
    double jacobian[4]; /* in the view that the centre's ray falls to */
};

/* x and y as for cupola_filter_rays. */
void filter_pixel_prepare(const cupola_plan *plan, int output, int x, int y,
                          struct filter_pixel *pixel);

/* Keeps a place within the image circle: across the pixel's middle, or there. */
void filter_reflect(const struct filter_pixel *pixel, struct filter_place *place);

/* How many places the pattern has that a complete filter asks for; 0: it asks for none. */
int filter_pattern_count(const struct cupola_filter *complete, const struct filter_pixel *pixel);

/* Makes the pattern of such a number that a complete filter asks for: aligned for adaptive. */
void filter_pattern(const struct cupola_filter *complete, int count, struct pattern *pattern);

/* The places of the rays of a lit pixel, within the image circle. Returns how many. */
int filter_places(const struct cupola_filter *complete, const struct pattern *pattern,
                  const struct filter_pixel *pixel, struct filter_place *places);

/* The ray of a place, of any length. */
void filter_direction(const struct filter_pixel *pixel, const struct filter_place *place,
                      double direction[3]);

#endif
