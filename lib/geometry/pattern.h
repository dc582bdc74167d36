/*
 * Where the rays of a cone are in the unit disc and what they weigh. The shaders have the same
 * numbers as literals.
 */
#ifndef PATTERN_H
#define PATTERN_H

#include <stdint.h>

#include "cupola/antialiasing.h"

struct pattern_place {
    double x, y;   /* within the unit disc */
    double weight; /* those of a pattern sum to 1 */
};

struct pattern {
    int count;
    struct pattern_place places[CUPOLA_RAYS_MAX];
};

/*
 * `count` is 1 to CUPOLA_RAYS_MAX. For each place there is the one across the middle, of the same
 * weight, but for rings of odd numbers; the mean of all is the middle.
 */
void pattern_make(enum cupola_pattern kind, int count, struct pattern *pattern);

/* Turns a pattern until its last place is on the x axis, right of the middle. */
void pattern_align(struct pattern *pattern);

/*
 * By what angle a pixel's pattern is turned, counter-clockwise: the upper 24 bits of a hash, as a
 * part of a whole turn, so that floats have it exactly.
 */
uint32_t pattern_hash(uint32_t x, uint32_t y, uint32_t seed);
double pattern_turn_rad(uint32_t x, uint32_t y, uint32_t seed);

#endif
