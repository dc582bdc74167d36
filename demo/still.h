/* Renders without a window: frames into a framebuffer, the last one into a file. */
#ifndef STILL_H
#define STILL_H

#include "show.h"

/* Where the picture goes when no --output is given: a scene of numbers needs floats. */
const char *still_default_path(const struct options *options);

/* Returns an exit status, with one line in `message` (MESSAGE_SIZE bytes) unless STATUS_OK. */
int still_run(const struct options *options, const struct show_setup *setup, char *message);

#endif
