/*
 * The dome: a rig made ready for questions. Which point of the screen does a pixel light, which way
 * does the viewer look to see it, and which pixel does a direction come from?
 *
 * A dome never changes once it is made; any number of threads may ask it at the same time. All of
 * this is geometry in double precision, without any GL.
 */
#ifndef CUPOLA_DOME_H
#define CUPOLA_DOME_H

#include "rig.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cupola_dome cupola_dome;

/* What one place of an output's image shows to one eye. */
struct cupola_ray {
    double point_m[3];      /* D, the point of the screen that it lights, dome frame */
    double direction[3];    /* from the eye to D, unit length, host's camera frame */
    double direction_dx[3]; /* change of `direction` per pixel to the right, 1/px */
    double direction_dy[3]; /* change of `direction` per pixel upwards, 1/px */
    double distance_m;      /* from the eye to D */
    double solid_angle_sr;  /* of one pixel at this place, seen by the eye */
    double coverage;        /* how much of the pixel lies in image circle, screen and frame, 0-1 */
    double lens_direction[3]; /* from the lens to D, unit length, dome frame */
};

/*
 * Makes a dome from a rig. The rig is copied.
 *
 * rig      0 means the default in every member
 * dome     out: the new dome, to be given to cupola_dome_destroy; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT for an impossible rig; CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_dome_create(const struct cupola_rig *rig, cupola_dome **dome,
                                  struct cupola_error *error);

/*
 * Destroys a dome and sets the handle to NULL; NULL and a handle that is NULL are allowed.
 *
 * thread   any, but no other may use the dome any more
 * since    0.1
 */
CUPOLA_API void cupola_dome_destroy(cupola_dome **dome);

/*
 * The rig of a dome.
 *
 * returns  it, complete; lives as long as the dome; NULL without a dome
 * thread   any
 * since    0.1
 */
CUPOLA_API const struct cupola_rig *cupola_dome_rig(const cupola_dome *dome);

/*
 * From a place in an output's image to the point that it lights and the ray from the eye.
 *
 * With the lens at L, its ray l and the screen's radius R, the point is D = L + t l with
 * t = -L.l + sqrt((L.l)^2 - |L|^2 + R^2), and the ray is D - E for an eye at E: the paper's section
 * 3.3 made exact. Places beyond the rim (r > 1) are answered as the nearest place on the rim.
 *
 * output   index, 0 to the rig's output_count - 1
 * eye_m    dome frame, inside the sphere; NULL: the rig's eye
 * x_px, y_px
 *          continuous image coordinates, origin bottom left: a pixel's centre is at halves
 * ray      out
 * returns  1: some of the pixel round this place is lit (coverage above 0); 0: none of it is, and
 *          the ray is that of the nearest place; CUPOLA_ERROR_ARGUMENT for an output that is not
 *          there, an eye outside of the sphere or a coordinate that is no finite number
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_dome_ray(const cupola_dome *dome, int output, const double eye_m[3],
                               double x_px, double y_px, struct cupola_ray *ray);

/*
 * The way back, for picking, cursors and overlays: from a direction to the place in the image that
 * shows it.
 *
 * output     index
 * eye_m      dome frame; NULL: the rig's eye
 * direction  from the eye, host's camera frame, any length above 0
 * pixel_px   out: continuous image coordinates {x, y}; untouched unless 1 is returned
 * returns    1: this place is lit; 0: the direction lies outside of lens, screen or frame buffer;
 *            CUPOLA_ERROR_ARGUMENT as for cupola_dome_ray
 * thread     any
 * since      0.1
 */
CUPOLA_API int cupola_dome_pixel(const cupola_dome *dome, int output, const double eye_m[3],
                                 const double direction[3], double pixel_px[2]);

/*
 * Between the dome frame and the frame of the host's camera: R_x(tilt) and its inverse. For points,
 * metres on both sides.
 *
 * dome_vector, camera_vector
 *          the first is read and the second written, or the other way round; two different arrays
 * thread   any
 * since    0.1
 */
CUPOLA_API void cupola_dome_to_camera(const cupola_dome *dome, const double dome_vector[3],
                                      double camera_vector[3]);
CUPOLA_API void cupola_dome_from_camera(const cupola_dome *dome, const double camera_vector[3],
                                        double dome_vector[3]);

#ifdef __cplusplus
}
#endif

#endif
