/* Pictures of what the tool shows, without a window: for scripts and documents. */
#ifndef STILL_H
#define STILL_H

#include <stdbool.h>

#include "tool/tool.h"

struct still;

/* Makes a GL context without a display, current on this thread. NULL with one line in `message`. */
struct still *still_create(char *message);

/* NULL is allowed. */
void still_destroy(struct still *still);

/*
 * Writes a picture, PNG or PFM by the path's end, whole or not at all. A size of 0 x 0 means the
 * projector's image alone, as it throws it; else a window of that size. False with one line in
 * `message`.
 */
bool still_write(struct still *still, const struct tool *tool, int width, int height,
                 const char *path, char *message);

/* Draws the same and throws it away. */
bool still_draw(struct still *still, const struct tool *tool, int width, int height, char *message);

#endif
