/*
 * The values of command-line options as numbers and names. Nothing here depends on the locale,
 * because the demo never calls setlocale.
 *
 * Every reader returns false with one line in the message that names the option, what was given
 * and what is allowed.
 */
#ifndef OPTION_VALUES_H
#define OPTION_VALUES_H

#include <stdbool.h>
#include <stddef.h>

enum { MESSAGE_SIZE = 1536 };

/* The place of an error: which option, and where its line goes (MESSAGE_SIZE bytes). */
struct value_context {
    const char *option; /* with its dashes */
    char *message;
};

/* What numbers an option takes. */
struct number_range {
    double low;
    double high;
    bool above_low; /* low itself is not allowed */
    bool degrees;   /* typed in degrees, kept in radians; the limits are in degrees */
};

bool value_number(const struct value_context *context, const char *text, struct number_range range,
                  double *number);
bool value_integer(const struct value_context *context, const char *text, int low, int high,
                   int *number);

/*
 * `least` to `most` numbers (8 at most) with commas between them; those that are missing are 0.
 * `shape` shows them in messages: "X,Y,Z".
 */
bool value_numbers(const struct value_context *context, const char *text, const char *shape,
                   struct number_range range, int least, int most, double *numbers);

/* "WxH", 1 to 32768 each. */
bool value_size(const struct value_context *context, const char *text, int *width, int *height);

/* One name out of a list that `name_of` gives by index until it returns NULL. */
bool value_name(const struct value_context *context, const char *text,
                const char *(*name_of)(int index), int *index);

/* The names of such a list in one string: "a, b, c". */
void value_name_list(const char *(*name_of)(int index), char *list, size_t list_size);

/* A plain number that is all of the text; false for anything else, NaN and infinity, too. */
bool parse_number(const char *text, double *number);

/* The one conversion of what was typed in degrees. The text must be one for parse_number. */
double angle_rad(const char *text_deg);

/* Of enum cupola_goal, then the one that is measured; NULL beyond. */
const char *goal_name(int index);

#endif
