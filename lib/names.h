/* Names of enumerators, as in files and on command lines. */
#ifndef NAMES_H
#define NAMES_H

#include <stddef.h>
#include <string.h>

#include "cupola/error.h"

/* The name of a number, NULL if it has none. */
static inline const char *name_of_number(const char *const *names, int count, int number)
{
    return number >= 0 && number < count ? names[number] : NULL;
}

/* The number of a name, CUPOLA_ERROR_ARGUMENT if nothing is called that. */
static inline int number_of_name(const char *const *names, int count, const char *name)
{
    for (int number = 0; name && number < count; number++)
        if (strcmp(name, names[number]) == 0)
            return number;
    return CUPOLA_ERROR_ARGUMENT;
}

#endif
