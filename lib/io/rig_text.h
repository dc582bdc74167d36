/*
 * The text of a rig file, looked through before libconfig (1.5) gets it, which
 *   - ends the process on some @include lines,
 *   - takes whole numbers modulo 2^32 without a word,
 *   - reads numbers by the host's locale, and only as double,
 *   - refuses an array of 0 and 0.5, because one of them is whole,
 *   - takes a comment that is never closed,
 *   - loses the memory of a string that stands where none may.
 * So libconfig gets a copy in which every number and every string is a 1, and their texts stand
 * here in the order of the file.
 */
#ifndef RIG_TEXT_H
#define RIG_TEXT_H

#include "cupola/error.h"

struct rig_text {
    char *structure;        /* for libconfig */
    char *values;           /* their texts one after another, each with a final 0 */
    const char *next_value; /* for rig_text_next_value */
    const char *end;        /* of values */
};

/*
 * text     with a final 0; expects the C locale
 * name     of the file, for messages
 * opened   out: to be given to rig_text_close
 * returns  CUPOLA_OK; CUPOLA_ERROR_SYNTAX; CUPOLA_ERROR_ARGUMENT for a number that is too large;
 *          CUPOLA_ERROR_MEMORY
 */
int rig_text_open(const char *text, const char *name, struct rig_text *opened,
                  struct cupola_error *error);
void rig_text_close(struct rig_text *text);

/* The next number, or string with its quotes, in the order of the file, or NULL. Lives as long as
 * the text. */
const char *rig_text_next_value(struct rig_text *text);

/* Some of a line, for messages; beyond the last one, "the end". Returns the line, which is at most
 * the last. */
enum { RIG_EXCERPT_SIZE = 64 };
int rig_text_excerpt(const char *text, int line, char excerpt[RIG_EXCERPT_SIZE]);

#endif
