/* The window in which patterns are shown, one pixel of theirs to one of the projector's. */
#ifndef SHOWN_H
#define SHOWN_H

#include <stdbool.h>

#include "capture/photo.h"

struct shown;

/* What somebody asks for while a pattern is shown. */
enum shown_wish { SHOWN_STAY, SHOWN_NEXT, SHOWN_BACK, SHOWN_END };

/*
 * Opens it on a monitor (-1: the first), over all of it or as a window. NULL with one line in
 * `message`, MESSAGE_SIZE bytes, also where the monitor is of another size.
 */
struct shown *shown_create(int width, int height, int monitor, bool window, char *message);

/* Shows a picture; it is on the screen when this returns. */
void shown_picture(struct shown *shown, const struct photo *picture);

/*
 * Waits for `wait_s` seconds at most, below 0: for ever, until there is a wish. An interruption is
 * the wish to end.
 */
enum shown_wish shown_wait(struct shown *shown, double wait_s);

/* NULL is allowed. */
void shown_destroy(struct shown *shown);

#endif
