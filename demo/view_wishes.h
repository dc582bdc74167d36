/* What a setup wishes of the views, in the library's terms: format, samples, depth. */
#ifndef VIEW_WISHES_H
#define VIEW_WISHES_H

#include "show.h"

struct cupola_gl_params view_wishes_params(const struct show_setup *setup);

/* Also sets clip control as the frame's depth needs it; view_wishes_done sets it back. */
struct cupola_frame view_wishes_frame(const struct show_setup *setup, const struct scene *scene,
                                      double near_distance, double far_distance);
void view_wishes_done(const struct show_setup *setup);

#endif
