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

#include <cupola/lens.h>

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
};

bool value_number(const struct value_context *context, const char *text, struct number_range range,
                  double *number);
bool value_integer(const struct value_context *context, const char *text, int low, int high,
                   int *number);

/* `count` numbers with commas between them; `shape` shows them in messages: "X,Y,Z". */
bool value_numbers(const struct value_context *context, const char *text, const char *shape,
                   struct number_range range, int count, double *numbers);

/* "WxH", 1 to 32768 each. */
bool value_size(const struct value_context *context, const char *text, int *width, int *height);

/* One name out of a list that `name_of` gives by index until it returns NULL. */
bool value_name(const struct value_context *context, const char *text,
                const char *(*name_of)(int index), int *index);

/* The names of such a list in one string: "a, b, c". */
void value_name_list(const char *(*name_of)(int index), char *list, size_t list_size);

/* A plain number that is all of the text; false for anything else, NaN and infinity, too. */
bool parse_number(const char *text, double *number);

/*
 * A measured lens: lines "angle_deg,radius", with or without a line that says just this in front.
 * Empty lines and lines that begin with # are passed over.
 */
bool lens_table_read(const char *path, struct cupola_lens *lens, char *message);

#endif
