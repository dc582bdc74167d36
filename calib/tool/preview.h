/*
 * The simulated theatre beside the image: what really stands there throws the images that were made
 * with the rig that is being set up.
 */
#ifndef PREVIEW_H
#define PREVIEW_H

#include "tool/tool.h"

struct preview_room;

/* NULL with one line in `message`. */
struct preview_room *preview_create(char *message);

/* NULL is allowed. Where a GL context is current, like below. */
void preview_destroy(struct preview_room *preview);

/*
 * Draws the theatre into a rectangle of a framebuffer (x, y from the bottom left, width, height,
 * px). `made` are the pictures that the projectors of tool->rig throw, textures of sRGB; if more
 * stand there, they are dark. The theatre is built again only where it has changed.
 */
bool preview_draw(struct preview_room *preview, const struct tool *tool,
                  const unsigned int made[CUPOLA_OUTPUTS_MAX], unsigned int framebuffer,
                  const int rectangle[4], char *message);

#endif
