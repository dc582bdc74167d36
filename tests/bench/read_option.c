/* Numbers and names of the benches' command lines. */
#include "read_option.h"

#include <stdlib.h>
#include <string.h>

bool read_number(const char *text, double least, double most, double *number)
{
    char *end = NULL;
    double value = strtod(text, &end);

    if (end == text || *end || !(value >= least && value <= most))
        return false;
    *number = value;
    return true;
}

bool read_whole(const char *text, int least, int most, int *number)
{
    double value;

    if (!read_number(text, least, most, &value) || value != (int)value)
        return false;
    *number = (int)value;
    return true;
}

bool read_clock(const char *text, enum clock *clock)
{
    for (int i = 0; i < CLOCKS; i++)
        if (strcmp(text, clock_names[i]) == 0) {
            *clock = (enum clock)i;
            return true;
        }
    return false;
}
