/*
 * The borders of the stripes in photographs: each of them tells which phase the sines have there,
 * which is half a turn at every other one and none at the rest.
 */
#ifndef CODE_BORDER_H
#define CODE_BORDER_H

#include <stdbool.h>

struct code_border {
    double cosine, sine; /* turned to 0 */
    int pairs;           /* of neighbouring pixels */
};

/* Of one axis; one of `list` for each stripe and the one before. */
struct code_borders {
    struct code_border *list;
    unsigned int count;
};

/* What those of many pairs say together. */
struct code_phase {
    double off_rad;   /* 0 where the sines begin as the stripes do */
    double agreement; /* of the borders with each other, 0 to 1 */
    int borders;
};

/* False without memory. */
bool code_borders_begin(struct code_borders *borders, int bits);

/* One pixel: the number of its stripe and the direction of its sines. */
struct code_pixel {
    unsigned int stripe;
    double cosine, sine;
};

void code_borders_add(struct code_borders *borders, const struct code_pixel *pixel,
                      const struct code_pixel *neighbour);

/* All of a border's pairs count as one: they share what is wrong with the light there. */
struct code_phase code_borders_end(struct code_borders *borders);

#endif
