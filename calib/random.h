/* Numbers by chance that are the same in every run. */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

/* The next one, all 64 bits; the state may begin anywhere. */
uint64_t random_next(uint64_t *state);

#endif
