/*
 * What of the views no pixel samples, as shapes to be drawn before anything else. The lit part of
 * every output is cut into squares, small ones along its edge, whose points on the screen do not
 * depend on the eye:
 *
 *   mask_squares  the squares
 *   mask          from the squares, for an eye, to the texels that are needed
 *   mask_shapes   from those to the shapes that leave them free
 *
 * A texel is needed if its middle lies in what the lit part covers of a view, widened by the guard
 * band, which is all that filters and warps that keep to the guard band may touch.
 */
#ifndef MASK_H
#define MASK_H

#include <stdbool.h>
#include <stdint.h>

#include "cupola/error.h"
#include "plan.h"

/* By this more than the guard band, in texels: what warps in single precision may miss. */
#define MASK_SLACK_TEXELS 0.05

/* A square of an image: its corners on the screen, by rows, in the host's camera frame, m. */
struct mask_square {
    float x[4], y[4], z[4];
    float margin; /* by which its box in a view is widened on each side, as a part of it */
};

/* A corner of a triangle, in texels of the atlas. */
struct mask_vertex {
    float x, y;
};

/* The needed texels of one view, from its rectangle's corner: a bit for each, rows upwards. */
struct mask_texels {
    int x, y, width, height;
    int words; /* 64-bit words of a row */
    uint64_t *bits;
    /* Beyond the straight lines by which other views take over nothing is needed: a x + b y + c at
     * least 0, in texels. */
    double lines[CUPOLA_VIEWS_MAX][3];
    int line_count;
};

struct mask {
    bool middles; /* of needed texels are left free; else all of them */
    bool whole;   /* nothing is masked: rays that lie apart however near their places are */
    int square_count, square_most;
    struct mask_square *squares;
    struct mask_texels texels[CUPOLA_VIEWS_MAX];
    int vertex_count, vertex_most;
    bool growing, failed; /* while it is made for the first time */
    struct mask_vertex *vertices;
    int first[CUPOLA_VIEWS_MAX], count[CUPOLA_VIEWS_MAX]; /* of each view's vertices */
};

/*
 * For the plan's eye and views as they are. Middles: it is enough to leave the middles of needed
 * texels free. CUPOLA_OK or CUPOLA_ERROR_MEMORY.
 */
int mask_create(const cupola_plan *plan, bool middles, struct mask *mask,
                struct cupola_error *error);
void mask_destroy(struct mask *mask);

/*
 * The same again after eye or views of the plan have changed. Allocates nothing; where there is no
 * room for more shapes, some texels more are shaded.
 */
void mask_refit(const cupola_plan *plan, struct mask *mask);

/* Gives back what only mask_refit needs. */
void mask_settle(struct mask *mask);

static inline bool mask_needs(const struct mask_texels *texels, int x, int y)
{
    return texels->bits[(size_t)y * (size_t)texels->words + (size_t)x / 64] >> (x % 64) & 1;
}

/* ---- between the files of the mask ---- */

/* False: no memory. */
bool mask_squares_cut(const cupola_plan *plan, struct mask *mask);

/* Adds the shapes of a view, whose texels have been marked. */
void mask_shapes_add(struct mask *mask, int view);

#endif
