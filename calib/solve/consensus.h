/* Which marks belong together and which are wrong. */
#ifndef CONSENSUS_H
#define CONSENSUS_H

#include "solve/model.h"

/*
 * From any start to where most of the marks agree, whatever the others say. How far most of them
 * are off, px, in *error_px. False without memory or where no pose is possible.
 */
bool consensus_find(struct model *model, double *error_px);

/*
 * From there to least squares over all marks that are not wrong, and which those are. A mark
 * is wrong whose residual, in the solution without it and with its noise as the others show it,
 * would be met in one of 500 clean sets of marks. The model keeps the
 * weights. False without memory.
 */
bool consensus_settle(struct model *model, double error_px, double *weights, bool *rejected);

/* Fewest marks that can be solved for that many values. */
int consensus_least(int values);

#endif
