/* Renders without a window: frames into a framebuffer, the last one into a file. */
#ifndef STILL_H
#define STILL_H

#include "show.h"

/* Returns an exit status, with one line in `message` (MESSAGE_SIZE bytes) unless STATUS_OK. */
int still_run(const struct options *options, const struct show_setup *setup, char *message);

#endif
