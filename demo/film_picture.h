/* One picture file, as texels for GL. */
#ifndef FILM_PICTURE_H
#define FILM_PICTURE_H

#include <stdbool.h>

struct film_picture {
    unsigned char *bytes; /* RGBA, rows from the bottom up; NULL for a file of floats */
    float *floats;        /* the same in floats; NULL for one of bytes */
    int width;
    int height;
};

/* False with one line in `message`, MESSAGE_SIZE bytes. To be given to film_picture_free. */
bool film_picture_read(const char *path, struct film_picture *picture, char *message);
void film_picture_free(struct film_picture *picture);

/* Turns the picture by half of a turn. */
void film_picture_turn(struct film_picture *picture);

#endif
