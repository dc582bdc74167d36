/*
 * Random theatres with marks, for the tests of what is solved from them: which pixel lights which
 * place by formulas of the tests' own, and how well anybody could solve them (Cramer and Rao).
 */
#ifndef SOLVE_THEATRE_H
#define SOLVE_THEATRE_H

#include <stdint.h>

#include <cupola/rig.h>

#include "solve/solve.h"

enum { THEATRE_MARKS = 24, THEATRE_VALUES = 14 };

/* How the values of a theatre are counted here. */
enum theatre_value {
    T_X,
    T_Y,
    T_Z,
    T_YAW,
    T_PITCH,
    T_ROLL,
    T_CIRCLE_X,
    T_CIRCLE_Y,
    T_CIRCLE_RADIUS,
    T_FOV,
    T_K3,
    T_K5,
    T_RADIUS
};

struct theatre {
    struct cupola_rig truth;
    double noise_px; /* 0.05 degrees by the mean pixels per degree */
    struct marks marks;
    struct mark list[THEATRE_MARKS];
};

/* Where noise comes in. */
enum noise { NOISE_PIXELS, NOISE_DIRECTIONS, NOISE_NONE };

/* A theatre by its seed, with marks all over what its projector lights. */
void theatre_random(uint64_t seed, struct theatre *theatre);

/* Moves the marks off by 0.05 degrees; `scale` 1. */
void theatre_add_noise(struct theatre *theatre, enum noise noise, double scale, uint64_t seed);

/* The rig with whatever is to be solved for forgotten. */
void theatre_start(const struct theatre *theatre, int free, uint64_t seed, struct cupola_rig *rig);

/* One value of a rig, and how to move it. */
double theatre_value(const struct cupola_rig *rig, int value);
void theatre_move(struct cupola_rig *rig, int value, double by);

/* The pixel that lights a mark's place: the tests' own formulas. */
void theatre_pixel(const struct cupola_rig *rig, const struct mark *mark, enum marks_kind kind,
                   double pixel_px[2]);

/* The values that `free` means; returns how many. */
int theatre_values(const struct theatre *theatre, int free, int values[THEATRE_VALUES]);

/* The least standard deviations of these values for any unbiased estimator. */
void theatre_bound(const struct theatre *theatre, const int *values, int count, enum noise noise,
                   double *sd);

/* Angles by which the viewer's directions are wrong, rad: median and worst over what is lit. */
void theatre_direction_error(const struct theatre *theatre, const struct cupola_rig *solved,
                             double *median_rad, double *worst_rad);

double theatre_gauss(uint64_t *seed);

#endif
