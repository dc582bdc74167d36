/* The bench's figures as JSON: one object with the machine and a list of comparisons. */
#ifndef JSON_H
#define JSON_H

#include <stdio.h>

#include "comparison.h"

/* Members of an object, each followed by a comma; what JSON has no number for is null. */
void json_put_text(FILE *file, const char *name, const char *text);
void json_put_number(FILE *file, const char *name, double value);
void json_put_quartiles(FILE *file, const char *name, const struct quartiles *quartiles);
/* What the figures were measured on; no comma follows. */
void json_put_machine(FILE *file, enum clock clock);

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

/*
 * Ends what was written to the file `path`, or to stdout where that is NULL; false with one line in
 * `message` where not all of it could be.
 */
bool json_close(FILE *file, const char *path, char *message);

#endif
