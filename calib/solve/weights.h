/*
 * How much each mark counts. Marks are off in two ways: in the pixel, by the hand that steers, and
 * in the place, by whoever measured it; the second counts in pixels by how large the screen looks
 * from the lens there. Both are taken to be equally large on average; where only one of them is
 * there, the loss is a few per cent, instead of some 15 where the wrong one is assumed.
 */
#ifndef WEIGHTS_H
#define WEIGHTS_H

#include "solve/model.h"

/* One weight a mark, at the model's base; 1 where both ways count the same. */
void weights_find(const struct model *model, double *weights);

#endif
