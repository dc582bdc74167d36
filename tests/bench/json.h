/* The bench's figures as JSON: one object with the machine and a list of comparisons. */
#ifndef JSON_H
#define JSON_H

#include <stdio.h>

#include "comparison.h"

/* Begins the object. */
void json_begin(FILE *file, const struct comparison_wishes *wishes, enum clock clock);

/* One comparison: its family's name, and what it varies with its value (NULL: nothing). */
struct json_heading {
    const char *family;
    const char *varied;
    double value;
};
void json_comparison(FILE *file, bool first, const struct json_heading *heading,
                     const struct setting *setting, const struct reference *reference,
                     const struct contender *contenders, int count, const struct result *results);

void json_end(FILE *file);

#endif
