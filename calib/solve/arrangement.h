/* How marks lie on the screen, whatever they are to determine. */
#ifndef ARRANGEMENT_H
#define ARRANGEMENT_H

#include <stdbool.h>

#include "marks.h"

struct arrangement {
    double off_plane_rad;  /* furthest from the one plane through the centre that fits best */
    double width_rad;      /* furthest from their middle */
    double off_circle_rad; /* furthest from the one circle, great or small, that fits best */
    double circle_rad;     /* half-angle of that circle */
};

/* Of the marks that are not rejected; `rejected` may be NULL. Directions from the centre. */
void arrangement_measure(const struct marks *marks, const bool *rejected,
                         struct arrangement *arrangement);

/*
 * False with one line where several values together cannot come from such an arrangement: all on
 * one meridian or all close together.
 */
bool arrangement_suffices(const struct arrangement *arrangement, char *message);

/*
 * How many different places are marked; counts up to `most`. Marks within a degree of each other
 * or with pixels within `near_px` of each other are one place that was measured again.
 */
int arrangement_places(const struct marks *marks, const bool *rejected, double near_px, int most);

#endif
