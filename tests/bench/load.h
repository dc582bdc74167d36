/* Scenes by name: how dear pixels and vertices are. */
#ifndef LOAD_H
#define LOAD_H

#include "comparison.h"

/*
 * light (flat, trilinear), lambert, heavy, heavy:LAMPS, forest:TRIANGLES, directions (colours that
 * change slowly, to judge pictures), or ns:COST: the lamps with which a pixel of the plain view
 * costs so many nanoseconds here at that size, or what comes nearest; it is measured by the clock
 * of `wishes`. False with one line in `message`.
 */
bool load_find(const char *name, const struct comparison_wishes *wishes, int size_px,
               struct load *load, char *message);

/* Whether that is a load's name, else false with one line in `message`; measures nothing. */
bool load_check(const char *name, char *message);

/* Whether these are names of loads, else false with one line in `message`; measures nothing. */
bool loads_check(const char *const *names, int count, char *message);

#endif
