/* How far an image whose colours are directions is from what the rays of a dome say. */
#ifndef DIRECTION_ERROR_H
#define DIRECTION_ERROR_H

#include "fixture.h"

struct direction_error {
    double deg;         /* the largest angle between colour and ray */
    double px;          /* the largest displacement in the image that explains the colour */
    int deg_at[2];      /* pixels */
    int px_at[2];       /*   where they are */
    double interior_px; /* `px` where all eight neighbours fall to the same view */
    double border_px;   /* `px` where one does not */
    int pixels;         /* compared */
    int border_pixels;
};

/*
 * Every pixel covered by more than a tenth; where it is covered in part, colour and a border of
 * zero are mixed, which leaves the direction as it is. `oracle` is the dome that the rays are taken
 * from, the fixture's own or a wrong one.
 */
struct direction_error direction_error_of(const struct fixture *fixture, int output,
                                          const float *image, const cupola_dome *oracle);

#endif
