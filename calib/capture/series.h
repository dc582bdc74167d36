/*
 * The pictures that the projector shows: all light and none, Gray code of both coordinates each
 * with its inverse, and sines shifted step by step. Along each axis a code numbers half periods of
 * the sine; so whatever a code's border leaves open the phase decides.
 */
#ifndef SERIES_H
#define SERIES_H

#include <stdbool.h>

enum {
    SERIES_STEPS_MIN = 4, /* one more than a sine has unknowns: the rest tells the noise */
    SERIES_STEPS_MAX = 16,
    SERIES_PERIOD_MIN = 8, /* px */
    SERIES_PERIOD_MAX = 1024,
    SERIES_NAME_MAX = 31,
};

struct series {
    int size_px[2]; /* of the projector's frame buffer */
    int period_px;  /* of the sines, even */
    int steps;      /* of the sines' phase, in one period */
};

enum series_kind {
    SERIES_WHITE,
    SERIES_BLACK,
    SERIES_CODE,    /* a bit of the Gray code, the most significant first */
    SERIES_INVERSE, /* the same, bright and dark exchanged */
    SERIES_SINE,    /* 1/2 + 1/2 cos(2 pi (x / period - step / steps)) */
};

/* One of its pictures. */
struct series_picture {
    enum series_kind kind;
    int axis;  /* 0: x, 1: y */
    int index; /* the bit's place, 0 being the most significant one; or the step */
};

/* A period that a camera with about as many pixels resolves and whose phase is still exact. */
int series_period_for(int width_px, int height_px);

/* How many bits the code of an axis has. */
int series_bits(const struct series *series, int axis);

/* How many pictures there are. */
int series_count(const struct series *series);

/* The number'th of them; where its first picture of a kind stands is series_find's answer. */
struct series_picture series_picture(const struct series *series, int number);
int series_find(const struct series *series, struct series_picture wanted);

/* "07-x-code-2": the number and what it shows, so that the order of names is that of pictures. */
void series_name(const struct series *series, int number, char name[SERIES_NAME_MAX + 1]);

/* Linear light, 0 to 1, of pixel (i, j) of a picture, counted from the bottom left. */
double series_light(const struct series *series, const struct series_picture *picture, int i,
                    int j);

/*
 * From the light along one axis to the place, px: the half period that the code names and the phase
 * in it. `off` is by how many half periods the two differ, 0 to 1: up to 1/2 for what is right.
 */
double series_place(const struct series *series, unsigned int code, double phase_rad, double *off);

/* From a Gray code to the number that it stands for. */
unsigned int series_from_gray(unsigned int gray);

#endif
