/* Least squares over the pixels of some of the marks, by cminpack. */
#ifndef FIT_H
#define FIT_H

#include "solve/model.h"

/*
 * Moves the model's base to the least sum of squares over the chosen marks. With a bound > 0 a
 * residual of length d counts as d / sqrt(1 + (d / bound)^2), so that none counts more than the
 * bound (Geman and McClure). False without memory or where the start is impossible.
 */
bool fit_marks(struct model *model, const int *chosen, int count, double bound_px, int steps);

#endif
