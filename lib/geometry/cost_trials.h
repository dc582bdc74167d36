/* The plans by which prices are measured. */
#ifndef COST_TRIALS_H
#define COST_TRIALS_H

#include "cupola/cost.h"

enum { COST_TRIALS = 9 };

/* Whether views of a trial are drawn without a mask, whatever the host wishes. */
bool cost_trial_is_maskless(int index);

/* The plan of a trial, 0 to COST_TRIALS - 1, for cupola_plan_destroy; wishes may be NULL. */
int cost_trial_plan(const cupola_dome *dome, const struct cupola_plan_params *wishes, int index,
                    cupola_plan **plan, struct cupola_error *error);

#endif
