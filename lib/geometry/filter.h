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

/* Rays of the method adaptive: texels covered, |det|, rounded up; 1 to samples. */
int filter_adaptive_count(const double jacobian[4], int samples);

/*
 * Places of the method footprint. With s the larger singular value of the jacobian, s > 0, and
 * (cx, cy) its direction in the image: N = ceil(s - 0.25), 1 to samples, at most
 * FOOTPRINT_RAYS_MAX; place k is (cx, cy) ((k + 1/2) / N - 1/2). Returns N.
 */
int filter_footprint(const double jacobian[4], int samples, struct filter_place *places);

/*
 * The places of the rays of a pixel whose turn is (cosine, sine); `pattern` is that of cone or of
 * adaptive with the right number. `cone` as above.
 */
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

/* The places of the rays of a lit pixel, within the image circle. Returns how many. */
int filter_places(const struct cupola_filter *complete, const struct pattern *pattern,
                  const struct filter_pixel *pixel, struct filter_place *places);

/* The ray of a place, of any length. */
void filter_direction(const struct filter_pixel *pixel, const struct filter_place *place,
                      double direction[3]);

#endif
