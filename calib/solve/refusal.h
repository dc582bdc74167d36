/* What can be said before anything is solved: values that no marks of this kind can determine. */
#ifndef REFUSAL_H
#define REFUSAL_H

#include "solve/solve.h"

/* `free` has no 0 and `count` is how many values it means. False with one line in `message`. */
bool refusal_check(const struct solve_request *request, int free, int count, char *message);

/* Whether that many marks suffice for so many values. */
bool refusal_enough(int marks, int values, const char *which, char *message);

#endif
