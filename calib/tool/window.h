/* The tool in a window. */
#ifndef WINDOW_H
#define WINDOW_H

#include "tool/tool.h"

struct window_wishes {
    int monitor;       /* index, 0: the primary one */
    int width, height; /* of a window; 0: the whole monitor */
    int swap_interval; /* 0: as fast as it can */
    int frames;        /* so many are drawn, whether anything has changed or not; 0: no end */
    /* Called before every frame and some hundred times a second, for an eye that a tracker moves;
     * NULL: nothing moves by itself. A frame is drawn only where something has changed. */
    void (*before_frame)(struct tool *tool, void *user);
    void *user;
};

/*
 * Opens a window and runs until tool->ends or it is closed. Keys go to the tool as they are pressed
 * and repeated. Returns an exit status, with one line in `message` unless STATUS_OK.
 */
int window_run(struct tool *tool, const struct window_wishes *wishes, char *message);

#endif
