/* A solution as JSON. */
#ifndef SOLVE_JSON_H
#define SOLVE_JSON_H

#include <stdio.h>

#include "solve/solve.h"

void solve_json_write(FILE *file, const struct solve_request *request,
                      const struct solve_result *result);

#endif
