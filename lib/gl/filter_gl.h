/* What shaders know of the filter: lines and literals that the files of shaders/ rely on. */
#ifndef FILTER_GL_H
#define FILTER_GL_H

#include <stdbool.h>

#include "cupola/gl_params.h"

/*
 * Checks the filter, also against the guard band of the views, and the noise, and makes the filter
 * complete: filter.h.
 */
int filter_params_complete(struct cupola_gl_params *params, int guard_px,
                           struct cupola_error *error);

/* How many texels beyond what pixels hit a guard band has to have. */
int filter_guard_px(const struct cupola_filter *filter);

/* Whether a pixel may send out more rays than one, which no table of rays can hold. */
bool filter_sends_rays(const struct cupola_filter *filter);

/*
 * How far from the middle of its pixel a ray may be, px; in cones that are longer in pixels, as
 * where a lens draws out what it shows, rays are still within a texel or two.
 */
double filter_reach_px(const struct cupola_filter *filter);

/* What images.glsl, light.glsl, filter.glsl and tile.vert want to know of a complete filter. */
enum { FILTER_LINES_MAX = 560 };
void filter_lines(const struct cupola_gl_params *params, char lines[FILTER_LINES_MAX]);

/* The places of rays, as filter.glsl wants them; freed by the caller. NULL: no memory. */
char *filter_places_text(const struct cupola_filter *filter);

#endif
