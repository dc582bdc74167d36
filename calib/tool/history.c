/* Undo and redo: an array that grows as far as it may, and then forgets its oldest steps. */
#include "tool/history.h"

#include <stdlib.h>
#include <string.h>

enum { STEPS_AT_FIRST = 32 };

/* Changes of one value that follow each other this closely are one step. */
static const double moment_s = 1;

struct history {
    struct values start; /* before the first step that is still known */
    int count;
    int position; /* how many of them are done */
    int room;
    struct change *steps;
};

struct history *history_create(const struct values *start)
{
    struct history *history = malloc(sizeof *history);

    if (!history)
        return NULL;
    history->room = STEPS_AT_FIRST;
    history->steps = malloc(STEPS_AT_FIRST * sizeof *history->steps);
    if (!history->steps) {
        free(history);
        return NULL;
    }
    history_restart(history, start);
    return history;
}

void history_restart(struct history *history, const struct values *start)
{
    history->start = *start;
    history->count = history->position = 0;
}

void history_destroy(struct history *history)
{
    if (history)
        free(history->steps);
    free(history);
}

/* A tenth at once, so that not every step moves all others. */
static void forget(struct history *history)
{
    int steps = (history->count + 9) / 10;

    history->start = history->steps[steps - 1].values;
    history->count -= steps;
    history->position -= steps;
    memmove(history->steps, history->steps + steps,
            (size_t)history->count * sizeof *history->steps);
}

static bool grow(struct history *history)
{
    int room = 2 * history->room < HISTORY_STEPS_MAX ? 2 * history->room : HISTORY_STEPS_MAX;
    struct change *more = NULL;

    if (room > history->room)
        more = realloc(history->steps, (size_t)room * sizeof *more);
    if (!more)
        return false;
    history->steps = more;
    history->room = room;
    return true;
}

void history_push(struct history *history, const struct change *change)
{
    history->count = history->position;
    if (history->count == history->room && !grow(history))
        forget(history);
    history->steps[history->count++] = *change;
    history->position = history->count;
}

bool history_merges(const struct history *history, int key, double time_s)
{
    const struct change *last;

    if (key < 0 || history->position == 0 || history->position < history->count)
        return false;
    last = &history->steps[history->position - 1];
    return last->key == key &&
           (key >= HISTORY_DRAG || (time_s >= last->time_s && time_s - last->time_s <= moment_s));
}

void history_merge(struct history *history, const struct change *change)
{
    struct change *last = &history->steps[history->position - 1];

    last->values = change->values;
    last->time_s = change->time_s;
}

bool history_undo(struct history *history, struct values *values, struct change *step)
{
    if (history->position == 0)
        return false;
    *step = history->steps[--history->position];
    *values = history->position > 0 ? history->steps[history->position - 1].values : history->start;
    /* What comes next is a step of its own. */
    if (history->position > 0)
        history->steps[history->position - 1].key = -1;
    return true;
}

bool history_redo(struct history *history, struct values *values, struct change *step)
{
    if (history->position == history->count)
        return false;
    history->steps[history->position].key = -1;
    *step = history->steps[history->position++];
    *values = step->values;
    return true;
}

int history_undo_count(const struct history *history)
{
    return history->position;
}

int history_redo_count(const struct history *history)
{
    return history->count - history->position;
}

void history_visit(struct history *history,
                   void (*visit)(void *user, struct values *values, struct change *step),
                   void *user)
{
    visit(user, &history->start, NULL);
    for (int i = 0; i < history->count; i++)
        visit(user, &history->steps[i].values, &history->steps[i]);
}
