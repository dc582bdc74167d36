/*
 * An output cut into square tiles, so that few pixels have to be asked what they show:
 *
 *   pure     all of it is lit and falls to one view; the points of the screen are a cubic
 *            polynomial of the pixel's place
 *   pair     the same, but two views border on each other in it
 *   choosing the same, but more than two
 *   exact    rims, and where no polynomial would do: computed pixel by pixel
 *   dark     nothing of it is lit
 *
 * Squares of up to TILE_MOST_PX are cut into four where that helps, down to TILE_LEAST_PX at rims
 * and to TILE_CHOOSING_PX at borders of views. They may stand
 * out beyond the output's right and upper edge.
 *
 * The polynomials are those of the points, and so do not depend on the eye: where that moves, only
 * pure, pair and choosing tiles change sides. How well they do depends on it: for a plan with a
 * head radius they are tried for eyes all over its sphere.
 */
#ifndef TILES_H
#define TILES_H

#include <stdbool.h>

#include "cupola/error.h"
#include "plan.h"

enum { TILE_MOST_PX = 128, TILE_CHOOSING_PX = 8, TILE_LEAST_PX = 8, TILE_TERMS = 10 };

/* By which a pixel of a tile may miss its place in a view. */
#define TILE_ERROR_TEXELS 0.002
/* And its ray, where texels are coarse: no more than another table stage may. */
#define TILE_ERROR_RAD 1e-5

enum tile_kind { TILE_PURE, TILE_PAIR, TILE_CHOOSING, TILE_EXACT, TILE_DARK, TILE_KINDS };

/* As it goes to the GL. */
struct tile {
    float x_px, y_px, side_px; /* lower left corner, in the output's image */
    float view;                /* that all of a pure tile falls to, or one of a pair's */
    /*
     * Of D in metres (dome frame), in px from the tile's middle: 1, x, y, x^2, xy, y^2, x^3, x^2 y,
     * x y^2, y^3. Exact and dark tiles have none.
     */
    float terms[TILE_TERMS][3];
    /* Of a pair, for whoever draws it; not set here, but for its other view. */
    float across[9];
    float lead[3];
    float other;
};

/* A square whose points have a polynomial, whatever the eye. */
struct tile_piece {
    int x_px, y_px, side_px;
    double terms[TILE_TERMS][3];
};

struct tiles {
    int output;
    int most_px;             /* the largest there may be */
    double reach_px;         /* of a pixel's rays, from its middle */
    int width_px, height_px; /* of the whole squares that cover the output */
    int piece_count, piece_most;
    struct tile_piece *pieces;
    int count[TILE_KINDS], most[TILE_KINDS];
    struct tile *tiles[TILE_KINDS];
};

/*
 * Cuts an output, into squares of most_px: TILE_LEAST_PX to TILE_MOST_PX, by powers of 2. Rays of
 * pixels lie within reach_px of their middles: a tile is only pure if all of them fall to one view.
 * CUPOLA_OK or CUPOLA_ERROR_MEMORY.
 */
int tiles_create(const cupola_plan *plan, int output, int most_px, double reach_px,
                 struct tiles *tiles, struct cupola_error *error);
void tiles_destroy(struct tiles *tiles);

/*
 * Cuts pieces into pure, pair and choosing tiles again, for a plan whose eye or views have changed
 * since. Allocates nothing; where there is no room for more tiles, larger ones choose.
 */
void tiles_refit(const cupola_plan *plan, struct tiles *tiles);

/* D of a place by the polynomial of a tile. */
void tile_point(const struct tile *tile, double x_px, double y_px, double point_m[3]);

#endif
