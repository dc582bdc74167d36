/* What an error message must say: the value, and what is allowed instead. */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <stdio.h>
#include <string.h>

#include "check.h"
#include "cupola/error.h"

/* The first five characters of a number as %g prints it: its unit and digits are the library's. */
static inline int message_has_number(const char *message, double value)
{
    char text[64];
    if (isnan(value))
        return strstr(message, "nan") != NULL;
    snprintf(text, sizeof text, "%.6g", value);
    if (strlen(text) > 5)
        text[5] = '\0';
    return strstr(message, text) != NULL;
}

/* One sentence that names the value (an angle may be told in degrees) and what is allowed. */
static inline void check_message(const struct cupola_error *error, double value)
{
    int named = message_has_number(error->message, value) ||
                message_has_number(error->message, value * (180.0 / 3.14159265358979323846));
    if (named && strstr(error->message, "allowed") && !strchr(error->message, '\n'))
        return;
    fail_msg("the message must name %g and what is allowed, but is: %s", value, error->message);
}

/* A call that answers so, with a message that says a word. */
static inline void check_refused_saying(int status, int expected, const struct cupola_error *error,
                                        const char *word)
{
    assert_int_equal(status, expected);
    assert_int_equal(error->status, expected);
    if (!strstr(error->message, word))
        fail_msg("'%s' does not say '%s'", error->message, word);
}

#endif
