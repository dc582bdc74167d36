/* Random theatres, their command lines, and how a picture is compared with the ray tracer's. */
#ifndef RAY_RIG_H
#define RAY_RIG_H

#include <stdbool.h>
#include <stddef.h>

#include "ray_tracer.h"

/* A theatre, and the options that ask the demo for it. */
struct ray_rig {
    struct theatre theatre;
    char command[1000];
};

/* Number `number` of the sequence: lenses and sizes take turns, all else is random. */
void ray_rig_make(struct ray_rig *rig, int number, int width_px, int height_px, uint64_t *random);

enum { TILES = 32, BLOCKS = 4, MOVES = 4 };

/* Least squares: the sums over the pixels at edges. */
struct sums {
    double matrix[MOVES][MOVES], side[MOVES];
};

/* How far a picture lies from where it must be, each with its standard error. */
struct displacement {
    double move_px[MOVES], error_px[MOVES];
};

struct comparison {
    long plain, plain_wrong; /* pixels with one colour only in reach of their filter */
    long edge, edge_wrong;   /* pixels with several: outside of the range of these */
    long rim, rim_wrong;     /* pixels at the border of circle or screen, or outside */
    struct sums tiles[TILES][TILES];
    bool has_edges;            /* enough of them to measure the whole; else it is all 0 */
    struct displacement whole; /* right, up, outwards and counter-clockwise at the rim */
    struct displacement blocks[BLOCKS * BLOCKS]; /* right, up; all 0 where edges are few */
};

/* A picture of the theatre's size, three bytes a pixel, its first row at the top. */
void ray_compare(struct comparison *comparison, const struct tracer *tracer,
                 const unsigned char *picture, bool print_wrong);

/* Whether the picture agrees in colours and place. */
bool ray_comparison_is_good(const struct comparison *comparison);

void ray_comparison_print(const struct comparison *comparison);

#endif
