/*
 * The test grid: lines on the screen sphere every 15 degrees off the dome's axis and round it, as
 * seen from the eye. Drawn over a view after the scene.
 */
#ifndef GRID_H
#define GRID_H

#include <stddef.h>

#include <cupola/plan.h>

struct grid;

/*
 * way: of enum cupola_pass_way, or 0. NULL with one line in `message`. Runs where a GL context is
 * current, like all here.
 */
struct grid *grid_create(int way, char *message, size_t message_size);

/* NULL is allowed. */
void grid_destroy(struct grid *grid);

/* After the scene: inside of one view of the plan, or inside of a pass of all `count` from 0 on. */
void grid_draw(struct grid *grid, const cupola_dome *dome, const cupola_plan *plan, int first,
               int count);

#endif
