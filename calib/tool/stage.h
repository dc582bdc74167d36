/*
 * What the tool shows: the projector's image with the pattern that lives on the dome, the simulated
 * theatre beside it, and the text over both. All calls are made where the same GL context (OpenGL
 * 3.3 core) is current; nothing of its state is kept for the caller.
 */
#ifndef STAGE_H
#define STAGE_H

#include <stdbool.h>

#include "target.h"
#include "tool/tool.h"

struct stage;

/* NULL with one line in `message`, MESSAGE_SIZE bytes. */
struct stage *stage_create(char *message);

/* NULL is allowed. */
void stage_destroy(struct stage *stage);

/*
 * Draws a frame of `width` x `height` px into a framebuffer; 0 is the window's. Of 0 x 0 only the
 * projector's image is drawn. False with one line in `message`.
 */
bool stage_draw(struct stage *stage, const struct tool *tool, unsigned int framebuffer, int width,
                int height, char *message);

/*
 * The projector's image of the last frame: what it throws, without what lies over it in the window.
 * TARGET_SRGB, of the output's size, and the stage's.
 */
const struct target *stage_image(const struct stage *stage);

/*
 * From a place in a frame of this size, px from the top left as mice have it, to image coordinates.
 * Where no image is, it is a place beyond its edges.
 */
void stage_pixel(const struct tool *tool, int width, int height, double x, double y,
                 double pixel_px[2]);

#endif
