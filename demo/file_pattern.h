/* Names of numbered files: patterns with %d or %0Nd in them. */
#ifndef FILE_PATTERN_H
#define FILE_PATTERN_H

#include <limits.h>
#include <stdbool.h>

/*
 * Writes the path of a file: %d or %0Nd is its number, %s its face. False where the pattern has
 * anything else after a %, or the path would be too long.
 */
bool file_pattern_path(const char *pattern, long number, const char *face, char path[PATH_MAX]);

/* Whether the pattern is one, with a number in it. */
bool file_pattern_has_number(const char *pattern);

#endif
