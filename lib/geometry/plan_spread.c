/*
 * Views spread over what is seen so that no ray is far from an axis: where rings leave rays out of
 * reach, or where what is seen is not round. Only angles count here, no texels.
 */
#include "plan.h"
#include "vector.h"

/* The axis that has the largest product with a sample. */
static int nearest(const struct plan_state *state, const struct plan_sample *sample,
                   double *product)
{
    int best = 0;
    *product = -2;
    for (int v = 0; v < state->count; v++) {
        double along = dot3(state->views[v].axis, sample->at);
        if (along > *product) {
            *product = along;
            best = v;
        }
    }
    return best;
}

/* Moves every axis a part of the way to the sample farthest from it of those it is nearest to. */
static void approach(const struct plan_samples *samples, double part, struct plan_state *state)
{
    double least[CUPOLA_VIEWS_MAX];
    const struct plan_sample *farthest[CUPOLA_VIEWS_MAX] = {NULL};
    for (int v = 0; v < state->count; v++)
        least[v] = 2;
    for (int i = 0; i < samples->count; i++) {
        double product;
        int v = nearest(state, &samples->list[i], &product);
        if (product < least[v]) {
            least[v] = product;
            farthest[v] = &samples->list[i];
        }
    }
    for (int v = 0; v < state->count; v++) {
        double *axis = state->views[v].axis;
        if (!farthest[v])
            continue;
        for (int i = 0; i < 3; i++)
            axis[i] += part * (farthest[v]->at[i] - axis[i]);
        scale3(axis, 1 / larger(length3(axis), 1e-12));
    }
}

/* Steps of 1 / n towards the farthest point lead to the middle of the smallest cap round it all. */
void plan_spread_out(const struct plan_samples *samples, struct plan_state *state)
{
    enum { STEPS = 24 };
    for (int step = 0; step < STEPS; step++)
        approach(samples, 1.0 / (step + 4), state);
    for (int v = 0; v < state->count; v++)
        memcpy(state->views[v].selector, state->views[v].axis, sizeof state->views[v].selector);
}

void plan_spread_place(const struct plan_samples *samples, int views, struct plan_state *state)
{
    state->count = 1;
    memcpy(state->views[0].axis, samples->mean, sizeof samples->mean);
    while (state->count < views) {
        double least = 2, product;
        int farthest = 0;
        for (int i = 0; i < samples->count; i++) {
            nearest(state, &samples->list[i], &product);
            if (product < least) {
                least = product;
                farthest = i;
            }
        }
        memcpy(state->views[state->count++].axis, samples->list[farthest].at,
               sizeof samples->list[farthest].at);
    }
    plan_spread_out(samples, state);
}
