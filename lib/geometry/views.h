/*
 * Which view a ray falls to and where it meets it. shaders/views.glsl says the same under the same
 * names.
 */
#ifndef VIEWS_H
#define VIEWS_H

#include <stdbool.h>

#include "cupola/plan.h"

/* The view whose selector has the largest product with the ray; the first one of equals. */
int view_select(const struct cupola_view *views, int count, const double ray[3]);

/*
 * Where a ray meets the plane at distance 1: the paper's section 3.2.2. False if it points away
 * from it.
 */
bool view_hit(const struct cupola_view *view, const double ray[3], double base[2]);

/* Left, bottom, width and height: of the base rectangle, and of its place in the atlas, 0 to 1. */
void view_base(const struct cupola_view *view, double base[4]);
void view_share(const struct cupola_view *view, const struct cupola_plan_report *report,
                double share[4]);

/* From the base plane to continuous texels of the atlas. */
void view_texel(const struct cupola_view *view, const double base[2], double texel[2]);

#endif
