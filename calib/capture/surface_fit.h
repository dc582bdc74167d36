/*
 * A surface of degree 2 through places, both coordinates at once, by least squares; a few far off
 * are left out. Of degree 2, because a plane is wrong in the middle by as much as the places bend.
 */
#ifndef SURFACE_FIT_H
#define SURFACE_FIT_H

#include <stdbool.h>

enum { SURFACE_TERMS = 6, SURFACE_LEAST = 4 * SURFACE_TERMS /* samples */ };

struct surface_sample {
    double at[2];    /* from the middle of the samples, in any unit, about 1 at most */
    double place[2]; /* what the surface goes through */
    bool left_out;   /* out */
};

struct surface_fit {
    double middle[2]; /* of the surface at (0, 0) */
    double sd[2];     /* of `middle` */
    double spread[2]; /* standard deviation of one sample */
    int kept;
};

/* False where the samples do not span a surface. */
bool surface_fit(struct surface_sample *samples, int count, struct surface_fit *fit);

#endif
