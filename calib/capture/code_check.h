/* Whether photographs can be those of a series: signs of a wrong order, of a wrong picture. */
#ifndef CODE_CHECK_H
#define CODE_CHECK_H

#include <stdbool.h>
#include <stddef.h>

/* Sums over what is lit; all zero to begin with. */
struct code_check {
    double contrast;        /* of one pair: between all light and none */
    double mismatch;        /* by how much its two do not add up to both of them */
    double contrast_square; /* of one axis */
    double variance;        /* about its sines */
    double tested, off;     /* pixels with code and phase, and those where the two disagree */
    double border[2];       /* phases at the borders of stripes, turned to 0: cosines and sines */
    double borders;         /* how many */
    double noise[2];        /* of each axis when it is done, as a part of the contrast */
};

void code_check_begin_pair(struct code_check *check);
void code_check_begin_axis(struct code_check *check);

/* The direction of a phase between two pixels: that of border 0, 1 ... of the stripes. */
void code_check_add_border(struct code_check *check, unsigned int border, double cosine,
                           double sine);

/* All: false with one line in `message`, MESSAGE_SIZE bytes. */

/* A picture of stripes and its inverse, from these files. */
bool code_check_pair(const struct code_check *check, const char *code, const char *inverse,
                     char *message);

/* All pictures of an axis; its sines have so many steps. */
bool code_check_axis(struct code_check *check, int axis, int steps, char *message);

/* What is worth a warning, where `lit` pixels have light and `lost` of them no place; or "". */
void code_check_warning(const struct code_check *check, double lit, double lost, char *text,
                        size_t text_size);

#endif
