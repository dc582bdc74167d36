/*
 * One projector alone, without a screen: from points of the dome frame to the places of its image
 * that light them, also where its image has no such place. For whoever finds out where a projector
 * stands; a theatre that is known is asked by dome.h.
 */
#ifndef CUPOLA_PROJECTION_H
#define CUPOLA_PROJECTION_H

#include "rig.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The place in an output's image that lights a point: dome.h's cupola_dome_ray the other way round,
 * of a point instead of the eye's direction, and without a limit. Beyond the rim of the lens the
 * curve r(angle) goes on, increasing and without a step: closed forms as they are as far as they
 * increase, polynomials and tables, and all others from there, straight on. So an error of pixels
 * stays a smooth function of what is solved for. A camera with a fisheye lens is such an output,
 * too.
 *
 * output    0 means the default in every member; it stands within 1000 m of the origin
 * point_m   dome frame, finite, not the place of the lens itself
 * pixel_px  out: continuous image coordinates, origin bottom left; untouched unless 0 or 1 is
 *           returned
 * error     may be NULL
 * returns   1: within the image circle and the frame buffer; 0: beyond;
 *           CUPOLA_ERROR_ARGUMENT for an impossible output or point
 * thread    any
 * since     0.1
 */
CUPOLA_API int cupola_output_pixel(const struct cupola_output *output, const double point_m[3],
                                   double pixel_px[2], struct cupola_error *error);

/*
 * The same for many points, in much less time than one by one.
 *
 * count     of points, 0 or more
 * points_m  x, y, z of each
 * pixels_px out: x, y of each; those before an impossible point are written
 * output, error
 *           as for cupola_output_pixel
 * returns   how many lie within the image circle and the frame buffer, or CUPOLA_ERROR_ARGUMENT
 * thread    any
 * since     0.1
 */
CUPOLA_API int cupola_output_pixels(const struct cupola_output *output, int count,
                                    const double *points_m, double *pixels_px,
                                    struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
