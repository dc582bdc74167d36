/* Residuals over the dome as a picture. */
#ifndef RESIDUAL_PLOT_H
#define RESIDUAL_PLOT_H

#include <stdio.h>

#include "solve/solve.h"

/*
 * Writes a PNG to a file, called `path` where it fails. False with one line in `message`,
 * MESSAGE_SIZE bytes.
 */
bool residual_plot_write(FILE *file, const char *path, const struct solve_request *request,
                         const struct solve_result *result, char *message);

#endif
