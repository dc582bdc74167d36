/* Text over the picture. */
#ifndef OVERLAY_H
#define OVERLAY_H

#include <stddef.h>

struct overlay;

/* NULL with one line in `message`. Runs where a GL context is current, like all here. */
struct overlay *overlay_create(char *message, size_t message_size);

/* NULL is allowed. */
void overlay_destroy(struct overlay *overlay);

/*
 * Draws text with a dark ground behind it into the default framebuffer of `width` x `height` px; x
 * and y are of its upper left corner, from the top left. Lines are 12 scale px apart.
 */
void overlay_text(struct overlay *overlay, int width, int height, double x, double y, double scale,
                  const char *text);

/* The size of the ground that a text gets. */
void overlay_size(const char *text, double scale, double *width, double *height);

#endif
