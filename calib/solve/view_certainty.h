/* How uncertain the viewer's directions are. */
#ifndef VIEW_CERTAINTY_H
#define VIEW_CERTAINTY_H

#include "solve/certainty.h"

/*
 * Median and worst over what the output lights, into the result, whose rig is the solved one and
 * whose radius_sd_m is set. False without memory.
 */
bool view_certainty_find(const struct model *model, const struct certainty *certainty,
                         struct solve_result *result, int output);

#endif
