/*
 * Photographs: one number of light per pixel, from PNG, JPEG or PFM files and into them. Rows from
 * the bottom up.
 */
#ifndef PHOTO_H
#define PHOTO_H

#include <stdbool.h>

struct photo {
    int width;
    int height;
    float
        *light; /* linear, mean of the three colours; 1 is the brightest that a PNG or JPEG holds */
};

enum { PHOTO_SIDE_MAX = 16384, PHOTO_PIXELS_MAX = 100000000 };

/* How a file's numbers become light. */
enum photo_encoding {
    PHOTO_SRGB,   /* a camera's usual; PFM files are linear all the same */
    PHOTO_LINEAR, /* the numbers are light */
};

/* What a file is written as; the name of the file ends as photo_suffix says. */
enum photo_format {
    PHOTO_PNG8,  /* sRGB */
    PHOTO_PNG16, /* sRGB */
    PHOTO_PFM,   /* linear */
};

/* "png", "png16", "pfm"; NULL beyond. */
const char *photo_format_name(int index);
const char *photo_suffix(enum photo_format format);

/* False with one line in `message`, MESSAGE_SIZE bytes; nothing is then to be freed. */
bool photo_create(struct photo *photo, int width, int height, char *message);
bool photo_read(const char *path, enum photo_encoding encoding, struct photo *photo, char *message);

/* Whether a photograph may be of this size; the message begins with `name`. */
bool photo_size_is_allowed(const char *name, int width, int height, char *message);

/* As grey, whole or not at all. */
bool photo_write(const char *path, const struct photo *photo, enum photo_format format,
                 char *message);

/* All zero afterwards. */
void photo_free(struct photo *photo);

/* Whether a file of that name holds no light above 1. */
bool photo_cuts_off(const char *name);

/* Whether a file's name ends like that of a photograph. */
bool photo_is_named(const char *name);

#endif
