/* What undo takes back and redo brings again: absolute values, step by step. */
#ifndef HISTORY_H
#define HISTORY_H

#include "tool/parameters.h"

enum {
    HISTORY_STEPS_MAX = 10000, /* the oldest are forgotten beyond */
    HISTORY_DRAG = 1000,       /* keys of steps from here on: one step however long it takes */
};

/* Of one mark: whether it has a pixel, and which. */
struct mark_state {
    bool steered;
    double pixel_px[2];
};

/* One step, with all values as they are after it. */
struct change {
    struct values values;
    int mark; /* index of the mark that it changes; -1: none */
    struct mark_state mark_before, mark_after;
    int key;       /* steps of the same key may become one; -1: never */
    double time_s; /* of the last of them */
};

struct history;

/* NULL without memory. Where there is none later, the oldest steps are forgotten early. */
struct history *history_create(const struct values *start);
void history_destroy(struct history *history);

/* Forgets all and begins with these values. */
void history_restart(struct history *history, const struct values *start);

/* Adds a step; what could be redone is gone. */
void history_push(struct history *history, const struct change *change);

/* Whether a change of this key at this time would belong to the last step, and putting it there. */
bool history_merges(const struct history *history, int key, double time_s);
void history_merge(struct history *history, const struct change *change);

/*
 * One step back or forth: the values to be put back and, in `step`, whose mark goes to its state
 * before or after. False where there is none.
 */
bool history_undo(struct history *history, struct values *values, struct change *step);
bool history_redo(struct history *history, struct values *values, struct change *step);

int history_undo_count(const struct history *history);
int history_redo_count(const struct history *history);

/* Every state that it holds, for a change of units of pixels. */
void history_visit(struct history *history,
                   void (*visit)(void *user, struct values *values, struct change *step),
                   void *user);

#endif
