/* The inside of a dome, for plan, reference and GL. */
#ifndef DOME_PRIVATE_H
#define DOME_PRIVATE_H

#include "cupola/dome.h"
#include "points.h"

struct cupola_dome {
    struct cupola_rig rig;
    double tilt[9]; /* dome frame to the host's camera frame */
    struct projector projectors[CUPOLA_OUTPUTS_MAX];
};

/* D - E, turned into the host's camera frame; not of unit length. */
void eye_ray(const cupola_dome *dome, const double eye_m[3], const struct varying *point,
             struct varying *ray);

/* The way back: where a direction from the eye (host's camera frame) meets the screen. */
void eye_point(const cupola_dome *dome, const double eye_m[3], const double direction[3],
               double point_m[3]);

#endif
