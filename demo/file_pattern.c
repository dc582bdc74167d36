/* Names of numbered files. */
#include "file_pattern.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS_MAX = 9 };

bool file_pattern_path(const char *pattern, long number, const char *face, char path[PATH_MAX])
{
    size_t length = 0;

    for (const char *at = pattern; *at; at++) {
        int written = 1, digits = 0;
        char *end;
        if (*at != '%') {
            path[length] = *at;
        } else if (at[1] == 's') {
            written = snprintf(path + length, PATH_MAX - length, "%s", face);
            at++;
        } else {
            if (at[1] == '0')
                digits = (int)strtol(at + 1, &end, 10);
            else
                end = (char *)(at + 1);
            if (*end != 'd' || digits > DIGITS_MAX || digits < 0)
                return false;
            written = snprintf(path + length, PATH_MAX - length, "%0*ld", digits, number);
            at = end;
        }
        length += (size_t)written;
        if (length >= PATH_MAX)
            return false;
    }
    path[length] = 0;
    return true;
}

bool file_pattern_has_number(const char *pattern)
{
    char zero[PATH_MAX], one[PATH_MAX];

    return file_pattern_path(pattern, 0, "", zero) && file_pattern_path(pattern, 1, "", one) &&
           strcmp(zero, one) != 0;
}
