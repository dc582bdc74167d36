/* Scenes by name: how dear pixels and vertices are. */
#ifndef LOAD_H
#define LOAD_H

#include "setting.h"

/*
 * light, lambert, heavy, heavy:LAMPS, forest:TRIANGLES, directions (colours that change slowly, to
 * judge pictures), or ns:COST: the lamps with which a pixel of the plain view costs so many
 * nanoseconds here, which is measured. False with one line in `message`.
 */
bool load_find(const char *name, struct load *load, char *message);

#endif
