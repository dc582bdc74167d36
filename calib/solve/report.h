/* A solution in words and numbers for people. */
#ifndef REPORT_H
#define REPORT_H

#include <stdio.h>

#include "solve/solve.h"

/* All residuals with `verbose`, else the ten longest. */
void report_write(FILE *file, const struct solve_request *request,
                  const struct solve_result *result, bool verbose);

#endif
