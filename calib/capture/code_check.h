/* Whether photographs can be those of a series: signs of a wrong order, of a wrong picture. */
#ifndef CODE_CHECK_H
#define CODE_CHECK_H

#include <stdbool.h>
#include <stddef.h>

#include "capture/code_border.h"

/* Sums over what is lit; all zero to begin with. */
struct code_check {
    double lit;              /* pixels that have light enough, and are not cut off */
    double brighter;         /* by how much all light is brighter than none at these */
    double darker;           /* and darker where it is so by as much, which only noise can do */
    double least_contrast;   /* for pixels with light enough */
    double contrast;         /* of one pair: between all light and none */
    double mismatch;         /* by how much its two do not add up to both of them */
    double contrast_square;  /* of one axis */
    double variance;         /* about its sines */
    double judged;           /* pixels of this axis that are lit and not given up before */
    double tested, off;      /* those of clear code and phase, and where the two disagree */
    struct code_phase phase; /* at the borders of the stripes */
    double noise[2];         /* of each axis when it is done, as a part of the contrast */
};

void code_check_begin_pair(struct code_check *check);
void code_check_begin_axis(struct code_check *check);

/* Under all light and none; `lit`: as it is taken. */
void code_check_add_light(struct code_check *check, double contrast, bool lit);

/* Whether most of what seems to be lit is noise. */
bool code_check_is_noise(const struct code_check *check);

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
