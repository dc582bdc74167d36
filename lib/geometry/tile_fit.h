/* The polynomial of a square's points. */
#ifndef TILE_FIT_H
#define TILE_FIT_H

#include "tiles.h"

enum { TILE_GRID = 3, TILE_GRID_PLACES = TILE_GRID * TILE_GRID };

/* x and y of a place of the grid over a square, rows from the bottom: -1, 0 or 1. */
static inline double tile_grid_x(int i)
{
    return i % TILE_GRID - 1;
}

static inline double tile_grid_y(int i)
{
    return i / TILE_GRID - 1;
}

/* D of a place in the image, computed. */
void tile_point_exact(const struct projector *projector, double x_px, double y_px,
                      double point_m[3]);

/* D by terms, x and y in px from the middle. */
void tile_terms_at(double terms[TILE_TERMS][3], double x, double y, double point_m[3]);

/*
 * Fits the terms of a piece whose square is set, all of it lit. False if they miss the place of any
 * ray that is tried by more than is allowed; `grid` are the points on the grid.
 */
bool tile_fit(const cupola_plan *plan, int output, double grid[TILE_GRID_PLACES][3],
              struct tile_piece *piece);

/* The terms of a quarter, 0 to 3, of a piece: the same polynomial about another middle. */
void tile_quarter(const struct tile_piece *piece, int quarter, struct tile_piece *part);

#endif
