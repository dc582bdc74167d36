/* What a setup wishes of the views, in the library's terms: format, samples, depth. */
#ifndef VIEW_WISHES_H
#define VIEW_WISHES_H

#include "show.h"

/*
 * Of what the setup shows: sRGB where colours are mixed in linear light and encoded again at the
 * end, linear where numbers come out as they are, and for a reference.
 */
enum cupola_encoding view_wishes_encoding(const struct show_setup *setup);

/*
 * Whether it shows colours of the screen, not numbers: scenes draw such, and picture files of bytes
 * hold them.
 */
bool view_wishes_colors(const struct show_setup *setup);

struct cupola_gl_params view_wishes_params(const struct show_setup *setup);

/* Also sets clip control as the frame's depth needs it; view_wishes_done sets it back. */
struct cupola_frame view_wishes_frame(const struct show_setup *setup, const struct scene *scene,
                                      double near_distance, double far_distance);
void view_wishes_done(const struct show_setup *setup);

#endif
