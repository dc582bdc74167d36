/* How many texels a view of one's own needs so that no output pixel gets less than one. */
#ifndef DENSITY_H
#define DENSITY_H

#include <stdbool.h>

#include <cupola/dome.h>

/* Called for places spread over an output: what it lights up, and the ray. */
typedef void density_visit(void *context, const struct cupola_ray *ray);

/* Visits rays of a square output of size_px, spread evenly, and all round its rim. */
void density_each_ray(const cupola_dome *dome, int size_px, density_visit *visit, void *context);

/*
 * Texels per unit of the base plane at distance 1, the same along both sides, that one pixel needs:
 * one over the smaller singular value of the Jacobian from pixels to the plane. `rotation` has the
 * view's right, up and backward axes as rows; `place` (may be NULL) is where the ray meets the
 * plane. False where it does not meet it.
 */
bool density_needed(const struct cupola_ray *ray, const double rotation[9], double place[2],
                    double *texels_per_unit);

#endif
