/* Text in plots, by the library's own letters: no font has to be installed. */
#ifndef PLOT_TEXT_H
#define PLOT_TEXT_H

#include <cairo.h>

/* From the left end of the baseline, in px, y downwards; colour 0 to 1. */
void plot_text(cairo_t *cairo, const char *text, double x, double y, const double color[3]);

#endif
