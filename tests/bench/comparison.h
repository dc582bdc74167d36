/*
 * Contenders side by side: in every round each of them draws one frame, and each begins as many
 * rounds as any other, so that whatever else the machine does falls on all alike.
 */
#ifndef COMPARISON_H
#define COMPARISON_H

#include <stdbool.h>

#include "contender.h"
#include "reference.h"
#include "stopwatch.h"

enum { CONTENDERS_MAX = 32 };

struct comparison_wishes {
    int frames; /* rounds that count */
    int warm_up;
    enum clock clock;
    bool warp_alone; /* views are drawn once; only the warp is timed */
};

struct result {
    char skipped[MESSAGE_SIZE]; /* why it did not take part; empty: it did */
    struct contender_facts facts;
    struct quartiles time_ms;
    struct quartiles wall_ms;
    double ratio;                 /* of its median to the first contender's */
    struct quartiles round_ratio; /* of its time to the first contender's in the same round */
    double psnr_db;               /* 0: not compared */
};

/*
 * The first contender is what the others are measured in. `reference` may be NULL. False with one
 * line in `message` where it cannot take part, or a frame fails.
 */
bool compare_contenders(const struct setting *setting, const struct contender *contenders,
                        int count, const struct comparison_wishes *wishes,
                        const struct reference *reference, struct result *results, char *message);

#endif
