/*
 * The corners of what falls to a view, where rectangles end: three views meet, or two of them at
 * the edge of what is lit. Samples alone would leave a rectangle short by their spacing.
 */
#include "plan.h"
#include "vector.h"

static void add_meeting(const double at[3], unsigned views, struct plan_meetings *meetings)
{
    if (meetings->count == PLAN_MEETINGS_MAX)
        return;
    struct plan_meeting *meeting = &meetings->list[meetings->count++];
    memcpy(meeting->at, at, sizeof meeting->at);
    meeting->views = views;
}

/* Whether a direction lies among the samples: near to one, as samples lie to each other. */
static bool is_lit(const struct plan_samples *samples, const double at[3])
{
    double best = -1, reach = 0;
    for (int i = 0; i < samples->count; i++) {
        double along = dot3(samples->list[i].at, at);
        if (along > best) {
            best = along;
            reach = samples->list[i].reach_rad;
        }
    }
    /* 1 - cos a = a^2 / 2; the diagonal of what a sample stands for is 2.8 times its reach. */
    return reach > 0 && 1 - best < 0.5 * (1.5 * reach) * (1.5 * reach);
}

/* Whether no view has a larger product than view a. */
static bool is_best(const struct plan_state *state, int a, const double at[3])
{
    double most = dot3(state->views[a].selector, at) * (1 + 1e-9);
    for (int v = 0; v < state->count; v++)
        if (dot3(state->views[v].selector, at) > most)
            return false;
    return true;
}

/* The direction that three views share, if they do. */
static void meet_three(const struct plan_samples *samples, const struct plan_state *state, int a,
                       int b, int c, struct plan_meetings *meetings)
{
    double ab[3], ac[3], at[3];
    for (int i = 0; i < 3; i++) {
        ab[i] = state->views[a].selector[i] - state->views[b].selector[i];
        ac[i] = state->views[a].selector[i] - state->views[c].selector[i];
    }
    cross3(ab, ac, at);
    double length = length3(at), product = dot3(state->views[a].selector, at);
    if (!(length > 1e-9 * dot3(state->views[a].selector, state->views[a].selector)))
        return;
    scale3(at, (product > 0 ? 1 : -1) / length);
    if (is_best(state, a, at) && is_lit(samples, at))
        add_meeting(at, 1u << a | 1u << b | 1u << c, meetings);
}

/* Where the border of two views crosses the edge between two samples of it. */
static void meet_edge(const struct plan_samples *samples, const struct plan_state *state, int i,
                      int k, struct plan_meetings *meetings)
{
    int a = state->members[i].view, b = state->members[k].view;
    if (a == b)
        return;
    const double *first = samples->list[i].at, *second = samples->list[k].at;
    double here = dot3(state->views[a].selector, first) - dot3(state->views[b].selector, first);
    double there = dot3(state->views[b].selector, second) - dot3(state->views[a].selector, second);
    double part = here / larger(here + there, 1e-300), at[3];
    for (int n = 0; n < 3; n++)
        at[n] = first[n] + part * (second[n] - first[n]);
    add_meeting(at, 1u << a | 1u << b, meetings);
}

void plan_meet(const struct plan_samples *samples, const struct plan_state *state,
               struct plan_meetings *meetings)
{
    meetings->count = 0;
    for (int e = 0; e < samples->edge_count; e++) {
        const struct plan_edge *edge = &samples->edges[e];
        for (int i = 0; i < edge->count; i++)
            meet_edge(samples, state, edge->first + i, edge->first + (i + 1) % edge->count,
                      meetings);
    }
    for (int a = 0; a < state->count && samples->edge_count > 0; a++)
        for (int b = a + 1; b < state->count; b++)
            for (int c = b + 1; c < state->count; c++)
                meet_three(samples, state, a, b, c, meetings);
}
