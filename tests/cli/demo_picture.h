/* Pictures that the demo writes, as numbers. */
#ifndef DEMO_PICTURE_H
#define DEMO_PICTURE_H

#include "process.h"

struct picture {
    float *rgba; /* rows from the bottom up; to be given to cupola_image_free */
    int width;
    int height;
};

/* Runs the demo; the test fails unless it succeeds without a word on stderr. */
void demo_run(struct process *process, const char *command);

/* Runs the demo with a float picture as its output. */
struct picture demo_run_pfm(struct process *process, const char *command);
/* The same, of a literal; the last picture is kept and not to be freed. */
const struct picture *demo_picture_of(struct process *process, const char *command);

const float *picture_pixel(const struct picture *picture, int x, int y);

/* Over all pixels and channels; the test fails if the sizes differ. */
double picture_difference(const struct picture *a, const struct picture *b);

/*
 * The mean over red, green and blue of all pixels that are well inside of the circle, which fills
 * both pictures; and the largest.
 */
double picture_mean_difference(const struct picture *a, const struct picture *b, double *largest);

/*
 * How many pixels of `small` differ by more than 0.015 from `large` from (left, bottom) on.
 */
int picture_others(const struct picture *small, const struct picture *large, int left, int bottom);

#endif
