/* From a pixel to the place that it lights, beyond the rim of the lens, too. */
#ifndef LIT_PLACE_H
#define LIT_PLACE_H

#include <stdbool.h>

#include <cupola/dome.h>

/*
 * cupola_output_pixel the other way round: the point so far from the centre, m, that `pixel_px`
 * lights, sought from `near_m` on. False, with the nearest place that the projector does light,
 * where the lens has no such pixel even as its curve goes on.
 */
bool lit_place_find(const cupola_dome *dome, int output, const double pixel_px[2],
                    double distance_m, const double near_m[3], double point_m[3]);

#endif
