/* Options of cupola-demo that contradict each other. */
#ifndef OPTION_CHECK_H
#define OPTION_CHECK_H

#include "options.h"

/* What is wrong with the options taken together, in one line; NULL: nothing. */
const char *options_contradiction(const struct options *options);

#endif
