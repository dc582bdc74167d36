/* What can be said before anything is solved: values that no marks of this kind can determine. */
#ifndef REFUSAL_H
#define REFUSAL_H

#include "solve/solve.h"

/*
 * `free` has no 0, `count` is how many values it means, `near_px` as below. False with one line in
 * `message`.
 */
bool refusal_check(const struct solve_request *request, int free, int count, double near_px,
                   char *message);

/* Of that the part that does not ask the marks but for their kind. */
bool refusal_combination(const struct solve_request *request, int free, char *message);

/*
 * Whether the marks that are not rejected (`rejected` may be NULL), `count` of them, suffice for so
 * many values: in number and at different places. `near_px`: of arrangement_places.
 */
bool refusal_enough(const struct marks *marks, const bool *rejected, int count, double near_px,
                    int values, char *message);

#endif
