/* A framebuffer of the demo's own with a colour texture, to draw a picture into. */
#ifndef TARGET_H
#define TARGET_H

#include <stdbool.h>
#include <stddef.h>

enum target_kind {
    TARGET_BYTES,  /* RGBA8 */
    TARGET_SRGB,   /* SRGB8_ALPHA8: encoded numbers, which are light to whoever samples them */
    TARGET_FLOATS, /* RGBA32F */
};

struct target {
    unsigned int framebuffer;
    unsigned int texture; /* of the kind that was asked for */
    unsigned int depth;   /* renderbuffer */
    int width;
    int height;
};

/* False with one line in `message` and nothing made where the GL cannot. */
bool target_create(struct target *target, int width, int height, enum target_kind kind,
                   char *message, size_t message_size);

/* All zero afterwards; a target that is all zero is allowed. */
void target_destroy(struct target *target);

#endif
