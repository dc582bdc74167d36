/*
 * Points and rays of one output, each with its change per pixel: design in docs/geometry.md.
 * shaders/points.glsl says the same under the same names.
 */
#ifndef POINTS_H
#define POINTS_H

#include <stdbool.h>

#include "cupola/rig.h"
#include "lens.h"

/* A vector that depends on a place in the image, and its derivatives per pixel. */
struct varying {
    double at[3];
    double dx[3];
    double dy[3];
};

/* One output, ready: nothing here is computed per pixel. */
struct projector {
    struct lens lens;
    double width_px, height_px;
    double center_px[2], radius_px; /* image circle */
    double sign[2];                 /* -1 where the picture is flipped */
    double aim[9];                  /* Q, lens frame to dome frame */
    double position_m[3];           /* L */
    double screen_radius_m;         /* R */
    double cap_cosine;
    bool capped; /* the cap is less than the whole sphere */
};

/* `output` must be complete. */
void projector_prepare(const struct cupola_output *output, const struct cupola_screen *screen,
                       struct projector *projector);

/*
 * From a place in the image to its place in the image circle, {x, y} with r = 1 at the rim; places
 * beyond the rim come out on the rim. Returns r before that.
 */
double circle_place(const struct projector *projector, double x_px, double y_px, double place[2]);

/* The lens ray, unit length, dome frame: Q (sin a cos t, sin a sin t, -cos a). */
void lens_ray(const struct projector *projector, const double place[2], struct varying *ray);

/* D = L + t ray, the point of the screen where a lens ray ends. */
void screen_point(const struct projector *projector, const struct varying *ray,
                  struct varying *point);

/* As circle_place, near the rim half a pixel inside: whether it was moved. */
bool place_inside_rim(const struct projector *projector, double x_px, double y_px, double place[2]);

/*
 * The point of a place in the image, near the rim of one half a pixel inside: at the rim itself the
 * derivatives may be infinite.
 */
void point_inside_rim(const struct projector *projector, double x_px, double y_px,
                      const struct varying *point, struct varying *inside);

/*
 * The part of a pixel's square on the near side of a straight edge: distance_px from the pixel's
 * centre to the edge, positive inside; direction of the edge's normal, any length.
 */
double edge_coverage(double distance_px, double normal_x, double normal_y);

/* The part of the pixel round a place that lies in image circle, screen and frame buffer. */
double pixel_coverage(const struct projector *projector, double x_px, double y_px,
                      const struct varying *point);

/*
 * The way back: from a direction at the lens (dome frame, any length) to image coordinates; what
 * the lens does not reach comes out on the rim. Returns the angle beyond the rim, rad: above 0
 * outside of the lens.
 */
double lens_place(const struct projector *projector, const double direction[3], double pixel_px[2]);

/* The same; false if the lens does not reach it. */
bool lens_pixel(const struct projector *projector, const double direction[3], double pixel_px[2]);

#endif
