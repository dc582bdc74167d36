/*
 * A domemaster that is white up to its rim and black beyond it, and what must be seen of it: the
 * colour of a pixel is the part of it that lies inside of the rim. Areas are counted, not computed.
 */
#ifndef DISC_H
#define DISC_H

#include <stdlib.h>

#include "check.h"

enum { DISC_STEPS = 32 };

/* The part of a pixel at a distance below `radius_px` from the middle. */
static inline double disc_part(double x_px, double y_px, double middle_px, double radius_px)
{
    int inside = 0;
    double beyond = hypot(x_px + 0.5 - middle_px, y_px + 0.5 - middle_px) - radius_px;
    if (fabs(beyond) > 0.71) /* half a pixel's diagonal */
        return beyond < 0.0;
    for (int j = 0; j < DISC_STEPS; j++)
        for (int i = 0; i < DISC_STEPS; i++)
            inside += hypot(x_px + (i + 0.5) / DISC_STEPS - middle_px,
                            y_px + (j + 0.5) / DISC_STEPS - middle_px) < radius_px;
    return (double)inside / (DISC_STEPS * DISC_STEPS);
}

/* RGBA floats, freed by the caller; its circle is smaller than the square by `missing_px`. */
static inline float *disc_picture(int side_px, double missing_px)
{
    float *picture = malloc(4 * sizeof *picture * (size_t)side_px * (size_t)side_px);
    double middle = 0.5 * side_px;
    assert_non_null(picture);
    for (int i = 0; i < side_px * side_px; i++) {
        double part = disc_part(i % side_px, i / side_px, middle, middle - missing_px);
        for (int c = 0; c < 4; c++)
            picture[4 * i + c] = c < 3 ? (float)part : 1.0f;
    }
    return picture;
}

/* The largest difference from white mixed with a border, by the part of the pixel, in a square. */
static inline double disc_error(const float *image, int side_px, double radius_px,
                                const float border[4])
{
    double worst = 0.0;
    for (int i = 0; i < side_px * side_px; i++) {
        double part = disc_part(i % side_px, i / side_px, 0.5 * side_px, radius_px);
        for (int c = 0; c < 4; c++) {
            double expected = (double)border[c] + part * (1.0 - (double)border[c]);
            double error = fabs((double)image[4 * i + c] - expected);
            worst = error <= worst ? worst : error;
        }
    }
    return worst;
}

#endif
