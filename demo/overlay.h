/* Text over the picture. */
#ifndef OVERLAY_H
#define OVERLAY_H

#include <stddef.h>

struct overlay;

/* NULL with one line in `message`. Runs where a GL context is current, like all here. */
struct overlay *overlay_create(char *message, size_t message_size);

/* NULL is allowed. */
void overlay_destroy(struct overlay *overlay);

/* Where a text goes, and how. */
struct overlay_place {
    unsigned int framebuffer; /* 0: the window's */
    int width, height;        /* of the framebuffer, px */
    double x, y;              /* of the ground's upper left corner, px from the top left */
    double scale;             /* lines are 12 of it apart, px */
    const unsigned char *ink; /* four bytes RGBA; NULL: white */
    int ground;               /* how opaque it is, 1 to 255; 0: 160 */
};

/* Draws text with a dark ground behind it. */
void overlay_text(struct overlay *overlay, const struct overlay_place *place, const char *text);

/* The size of the ground that a text gets. */
void overlay_size(const char *text, double scale, double *width, double *height);

#endif
