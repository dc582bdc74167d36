/* Families of comparisons: what varies in each, and who takes part. */
#ifndef FAMILIES_H
#define FAMILIES_H

#include <stdio.h>

#include "load.h"
#include "options.h"

struct bench {
    struct options options;
    FILE *file;
    int comparisons;
    int others;       /* contenders besides the first of each comparison */
    struct load load; /* of the scene that is there */
    struct scene *scene;
    char message[MESSAGE_SIZE];
};

/* Measures and writes what the options wish for of it. False with one line in `bench->message`. */
bool family_run(struct bench *bench, enum family family);

/* Whether a name is that of a contender in any family. */
bool family_has(const char *contender);

#endif
