/* How well the marks determine what was solved for. */
#ifndef CERTAINTY_H
#define CERTAINTY_H

#include "solve/model.h"

/* At a solution: the model's values are all 0. */
struct certainty {
    int count;                      /* values */
    double units[MODEL_VALUES_MAX]; /* of the values, at the solution */
    double eigenvalues[MODEL_VALUES_MAX];
    double eigenvectors[MODEL_VALUES_MAX * MODEL_VALUES_MAX]; /* by rows */
    /* Covariance of the values where every coordinate of a pixel is uncertain by 1 px. */
    double covariance[MODEL_VALUES_MAX * MODEL_VALUES_MAX];
    double noise_px; /* of one coordinate, as the residuals show */
    int freedoms;    /* numbers of the marks less values */
};

/* False without memory. */
bool certainty_find(const struct model *model, const bool *rejected, struct certainty *certainty);

/*
 * False with one line that names the values that the marks do not determine. `hint` ends it: what
 * would help.
 */
bool certainty_suffices(const struct model *model, const struct certainty *certainty,
                        const char *hint, char *message);

/* The next value that the marks determine badly, but do; NULL when there is none. From *at = 0. */
const char *certainty_weak(const struct model *model, const struct certainty *certainty, int *at);

/* Fills the standard deviations of the values and those of the viewer's directions. */
bool certainty_report(const struct model *model, const struct certainty *certainty,
                      struct solve_result *result, int output);

#endif
