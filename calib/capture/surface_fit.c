/* Surfaces of degree 2 by least squares. */
#include "capture/surface_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "order.h"
#include "symmetric.h"

static void terms_at(const double at[2], double terms[SURFACE_TERMS])
{
    terms[0] = 1;
    terms[1] = at[0];
    terms[2] = at[1];
    terms[3] = at[0] * at[0];
    terms[4] = at[0] * at[1];
    terms[5] = at[1] * at[1];
}

struct solution {
    double surface[2][SURFACE_TERMS];
    double middle_variance; /* for samples of variance 1 */
};

static bool solve_once(const struct surface_sample *samples, int count, struct solution *solution)
{
    double normal[SURFACE_TERMS * SURFACE_TERMS] = {0};
    double unit[SURFACE_TERMS] = {1};

    memset(solution, 0, sizeof *solution);
    for (int s = 0; s < count; s++) {
        double terms[SURFACE_TERMS];
        if (samples[s].left_out)
            continue;
        terms_at(samples[s].at, terms);
        for (int i = 0; i < SURFACE_TERMS; i++) {
            for (int j = 0; j <= i; j++)
                normal[SURFACE_TERMS * i + j] += terms[i] * terms[j];
            for (int k = 0; k < 2; k++)
                solution->surface[k][i] += terms[i] * samples[s].place[k];
        }
    }
    if (!symmetric_factor(SURFACE_TERMS, normal, 1e-9))
        return false;
    symmetric_substitute(SURFACE_TERMS, normal, solution->surface[0]);
    symmetric_substitute(SURFACE_TERMS, normal, solution->surface[1]);
    symmetric_substitute(SURFACE_TERMS, normal, unit);
    solution->middle_variance = unit[0];
    return true;
}

static double residual(const struct surface_sample *sample, const double surface[SURFACE_TERMS],
                       int k)
{
    double terms[SURFACE_TERMS], sum = -sample->place[k];

    terms_at(sample->at, terms);
    for (int i = 0; i < SURFACE_TERMS; i++)
        sum += terms[i] * surface[i];
    return sum;
}

/* Leaves out what is beyond 4 standard deviations by the median. True if that changed anything. */
static bool leave_out(struct surface_sample *samples, int count, const struct solution *solution,
                      double *sizes)
{
    double limit;
    bool changed = false;

    for (int s = 0; s < count; s++)
        sizes[s] = hypot(residual(&samples[s], solution->surface[0], 0),
                         residual(&samples[s], solution->surface[1], 1));
    order_sort(sizes, count);
    limit = 4 * sizes[count / 2] / 1.1774 + 1e-4; /* median of a Rayleigh distribution */
    for (int s = 0; s < count; s++) {
        bool far = hypot(residual(&samples[s], solution->surface[0], 0),
                         residual(&samples[s], solution->surface[1], 1)) > limit;
        changed |= far != samples[s].left_out;
        samples[s].left_out = far;
    }
    return changed;
}

static void describe(const struct surface_sample *samples, int count,
                     const struct solution *solution, struct surface_fit *fit)
{
    double squares[2] = {0};

    *fit = (struct surface_fit){0};
    for (int s = 0; s < count; s++) {
        if (samples[s].left_out)
            continue;
        fit->kept++;
        for (int k = 0; k < 2; k++) {
            double off = residual(&samples[s], solution->surface[k], k);
            squares[k] += off * off;
        }
    }
    for (int k = 0; k < 2; k++) {
        fit->middle[k] = solution->surface[k][0];
        fit->spread[k] = sqrt(squares[k] / fmax(fit->kept - SURFACE_TERMS, 1));
        fit->sd[k] = fit->spread[k] * sqrt(solution->middle_variance);
    }
}

bool surface_fit(struct surface_sample *samples, int count, struct surface_fit *fit)
{
    struct solution solution;
    double *sizes;
    bool done, changed = true;

    if (count < SURFACE_LEAST || !(sizes = malloc((size_t)count * sizeof *sizes)))
        return false;
    for (int s = 0; s < count; s++)
        samples[s].left_out = false;
    done = solve_once(samples, count, &solution);
    for (int round = 0; round < 6 && done && changed; round++) {
        changed = leave_out(samples, count, &solution, sizes);
        done = !changed || solve_once(samples, count, &solution);
    }
    free(sizes);
    if (done)
        describe(samples, count, &solution, fit);
    return done && fit->kept >= SURFACE_LEAST;
}
