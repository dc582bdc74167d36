/* The sentence of a resolution: whether the views fit the projector. */
#ifndef ADVICE_H
#define ADVICE_H

#include "cupola/resolution.h"

/* What the pixels of some outputs, or of all, were found to have. */
struct advice_asked {
    bool lit; /* any pixel is */
    bool all; /* outputs, so that every view counts as a whole */
    /* Texels per pixel along the line with the fewest, the least of each view; HUGE_VAL where no
     * pixel falls to it. */
    double fewest[CUPOLA_VIEWS_MAX]; /* by the planner's count, see plan_trace.c */
    double really[CUPOLA_VIEWS_MAX];
};

/*
 * Where a size was wished, all outputs were asked and the views are no coarser than needed, a plan
 * without that size is made to compare with.
 *
 * returns  CUPOLA_OK; CUPOLA_ERROR_MEMORY
 */
int advice_give(const cupola_plan *plan, const struct advice_asked *asked,
                char advice[CUPOLA_ADVICE_MAX], struct cupola_error *error);

#endif
