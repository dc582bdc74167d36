/* The way of a viewer who moves: --eye-circle. */
#ifndef EYE_PATH_H
#define EYE_PATH_H

#include "options.h"

/* Frames of one turn where nothing says how many, and how long it takes in a window. */
enum { EYE_PATH_FRAMES = 120 };
#define EYE_PATH_TURN_MS 8000.0

/* Where the eye is after some turns, in metres, dome frame; false: it rests. */
bool eye_path_place(const struct options *options, const struct cupola_rig *rig, double turns,
                    double eye_m[3]);

/* The radius of the sphere that the eye stays in; 0: it rests. */
double eye_path_head_radius_m(const struct options *options);

#endif
