/* The places of the marks as stickers on the simulated screen, to steer the cross-hair onto. */
#ifndef STICKERS_H
#define STICKERS_H

#include <cupola/theatre.h>

#include "tool/tool.h"

struct stickers;

/* NULL with one line in `message`, MESSAGE_SIZE bytes. Where a GL context is current, like all. */
struct stickers *stickers_create(char *message);

/* NULL is allowed. */
void stickers_destroy(struct stickers *stickers);

/*
 * Over what a spectator inside of the screen sees, in a rectangle {left, bottom, width, height} of
 * a framebuffer: a ring round each place of the tool's marks on the screen of the theatre.
 */
void stickers_draw(const struct stickers *stickers, const struct tool *tool,
                   const struct cupola_spectator *spectator, unsigned int framebuffer,
                   const int rectangle[4]);

/*
 * Where the spectator sees a point of the dome frame, in px of the framebuffer. False where it is
 * behind the spectator or outside of the rectangle.
 */
bool sticker_place(const struct cupola_spectator *spectator, const double point_m[3],
                   const int rectangle[4], double place_px[2]);

#endif
