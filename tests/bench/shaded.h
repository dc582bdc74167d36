/* How many texels of Cupola's views are shaded, as the GL counts them. */
#ifndef SHADED_H
#define SHADED_H

#include <cupola/gl.h>

/*
 * Texels of all views that something just behind the nearest distance shows on: those that no mask
 * covers. Below 0 with one line in `message`.
 */
double shaded_texels(cupola_gl *gl, char *message);

#endif
