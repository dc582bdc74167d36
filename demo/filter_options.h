/* The options about antialiasing and noise. */
#ifndef FILTER_OPTIONS_H
#define FILTER_OPTIONS_H

#include "options.h"

/* --aa to --dither. False with one line in the context's message. */
bool filter_options_take(const struct value_context *context, int code, const char *text,
                         struct options *options);

/* What contradicts what, in one line; NULL: nothing. */
const char *filter_options_contradiction(const struct options *options);

#endif
