/*
 * What is solved for as a list of numbers without units, all of the size of 1 where they are badly
 * wrong, and the pixels that they predict.
 */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>

#include <cupola/rig.h>

#include "solve/solve.h"

enum { MODEL_VALUES_MAX = 14 };

enum model_value {
    VALUE_CIRCLE_X, /* in radii of the circle */
    VALUE_CIRCLE_Y,
    VALUE_CIRCLE_RADIUS, /* logarithm */
    VALUE_FOV,           /* logarithm */
    VALUE_K1,            /* as parts of the first coefficient's term at the rim */
    VALUE_K3,
    VALUE_K5,
    VALUE_K7,
    VALUE_X, /* in radii of the screen */
    VALUE_Y,
    VALUE_Z,
    VALUE_AIM_X, /* a small rotation in the lens's frame, rad */
    VALUE_AIM_Y,
    VALUE_AIM_Z,
    VALUE_RADIUS /* logarithm */
};

/* The place round which the values are 0. */
struct model_base {
    struct cupola_output output;
    double radius_m;
};

struct model {
    const struct marks *marks;
    int free; /* of enum solve_free */
    struct model_base base;
    int count;
    enum model_value values[MODEL_VALUES_MAX];
    double units[MODEL_VALUES_MAX]; /* of one, in the value's own unit at the start */
    double radius_px;               /* of the start's image circle */
    double screen_m;                /* radius of the start's screen */
    const double *weights;          /* of the marks; NULL: 1 each */
};

/* `free` has no 0. The radius of point marks is none of the values: pixels do not tell it. */
void model_begin(struct model *model, const struct solve_request *request, int free);

/* What some values mean. */
void model_apply(const struct model *model, const double *x, struct model_base *solved);

/* The point of a mark, m. */
void model_point(const struct model *model, double radius_m, int mark, double point_m[3]);

/*
 * The pixels of some marks less the predicted ones, times their weights if so wished; without
 * `chosen` of the first. False for an impossible output.
 */
bool model_residuals(const struct model *model, const struct model_base *at, const int *chosen,
                     int count, bool weighted, double *residuals_px);

/*
 * Derivatives of the weighted residuals of some marks by the values, at x, by differences on both
 * sides: jacobian[rows * value + row], two rows a mark. There is room for one value more. Without
 * `chosen` of the first.
 */
void model_jacobian(const struct model *model, const double *x, const int *chosen, int count,
                    double *jacobian);

/* A value's name as in messages: "position x". */
const char *model_value_name(enum model_value value);

/* Pixels per radian, on average from the axis of the lens to its rim. */
double model_px_per_rad(const struct model *model);

#endif
