/* Numbers and names of the benches' command lines. */
#ifndef READ_OPTION_H
#define READ_OPTION_H

#include <stdbool.h>

#include "stopwatch.h"

/* A whole word that is a number within bounds; false where it is none. */
bool read_number(const char *text, double least, double most, double *number);
bool read_whole(const char *text, int least, int most, int *number);

/* By its name. */
bool read_clock(const char *text, enum clock *clock);

#endif
