/* The demo in a window. */
#ifndef WINDOW_H
#define WINDOW_H

#include "show.h"

/* Beside the exit statuses: there is no display to open a window on. */
enum { WINDOW_NO_DISPLAY = -1 };

/*
 * Opens a window and runs until it is closed or has shown the wished number of frames. Returns an
 * exit status or WINDOW_NO_DISPLAY, with one line in `message` (MESSAGE_SIZE bytes) unless
 * STATUS_OK.
 */
int window_run(const struct options *options, const struct show_setup *setup, char *message);

#endif
