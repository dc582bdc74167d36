/* Whether residuals are noise. */
#include "misfit.h"

#include <math.h>
#include <stdio.h>

#include "option_values.h"
#include "solve/fit.h"
#include "solve/refusal.h"

enum { SAMPLE = 300, LEAST_FREEDOMS = 6 };

static int choose(const struct marks *marks, const bool *rejected, int *chosen)
{
    int kept = 0, count = 0, seen = 0;

    for (int i = 0; i < marks->count; i++)
        kept += !rejected[i];
    int most = kept < SAMPLE ? kept : SAMPLE;
    for (int i = 0; i < marks->count && count < most; i++) {
        if (!rejected[i] && (long long)count * kept <= (long long)seen++ * most)
            chosen[count++] = i;
    }
    return count;
}

/* HUGE_VAL: impossible. */
static double squares(const struct model *model, const int *chosen, int count, bool weighted)
{
    double residuals_px[2 * SAMPLE], sum = 0;

    if (!model_residuals(model, &model->base, chosen, count, weighted, residuals_px))
        return HUGE_VAL;
    for (int i = 0; i < 2 * count; i++)
        sum += residuals_px[i] * residuals_px[i];
    return sum;
}

/*
 * By chance two more values lessen a sum of squares by the factor s with s^(-f/2), where f numbers
 * are left over. Residuals
 * that would be a tenth shorter are no misfit that matters.
 */
static bool tells(double before, double after, int freedoms)
{
    const double chance = 1e-5, least = 1.25;
    double ratio = before / after;

    return ratio > least * least && -0.5 * freedoms * log(ratio) < log(chance);
}

struct looking {
    const struct solve_request *request;
    struct model now;
    int chosen[SAMPLE], count;
    double before, best; /* sums of squares */
    struct misfit *misfit;
    bool found;
};

/* With this free and, unless it is negative, with another lens model. */
static void look(struct looking *looking, int free, int lens, double share, const char *name)
{
    struct model trial;
    char message[MESSAGE_SIZE];
    int count = looking->count;

    model_begin(&trial, looking->request, free);
    trial.base = looking->now.base;
    trial.weights = looking->now.weights;
    if (lens >= 0)
        trial.base.output.lens.model = (enum cupola_lens_model)lens;
    if (2 * count - trial.count < LEAST_FREEDOMS ||
        !refusal_combination(looking->request, free, message) ||
        cupola_lens_validate(&trial.base.output.lens, NULL) < 0 ||
        !fit_marks(&trial, looking->chosen, count, 0, 30))
        return;
    double after = squares(&trial, looking->chosen, count, true);
    if (!(after < share * looking->best) || !tells(looking->before, after, 2 * count - trial.count))
        return;
    looking->best = after;
    looking->found = true;
    looking->misfit->freed_px = sqrt(squares(&trial, looking->chosen, count, false) / count);
    snprintf(looking->misfit->what, sizeof looking->misfit->what,
             lens < 0 ? "%s free, too," : "the lens model \"%s\"", name);
}

/* Of two that explain the same the later is named; another lens model has to do far better. */
static void look_at_all(struct looking *looking)
{
    const double same = 1.01, far_better = 0.5;
    int free = looking->now.free;
    enum cupola_lens_model model = looking->now.base.output.lens.model;
    const char *name;

    for (int i = 0; (name = solve_free_name(i)); i++) {
        struct model trial;
        model_begin(&trial, looking->request, free | 1 << i);
        if (trial.count > looking->now.count)
            look(looking, free | 1 << i, -1, same, name);
    }
    for (int i = 0; (name = cupola_lens_model_name(i)); i++) {
        if (i != (int)model && i != CUPOLA_LENS_POLYNOMIAL && i != CUPOLA_LENS_TABLE)
            look(looking, free & SOLVE_CIRCLE_RADIUS ? free : free | SOLVE_LENS, i, far_better,
                 name);
    }
}

bool misfit_find(const struct solve_request *request, const struct model *solved,
                 const bool *rejected, struct misfit *misfit)
{
    struct looking looking = {.request = request, .now = *solved, .misfit = misfit};
    int count = choose(request->marks, rejected, looking.chosen);

    looking.count = count;
    if (count == 0 || !fit_marks(&looking.now, looking.chosen, count, 0, 30)) /* these alone */
        return false;
    looking.before = looking.best = squares(&looking.now, looking.chosen, count, true);
    if (!(looking.before > 1e-10 * count * solved->radius_px * solved->radius_px) ||
        !isfinite(looking.before))
        return false;
    misfit->rms_px = sqrt(squares(&looking.now, looking.chosen, count, false) / count);
    look_at_all(&looking);
    return looking.found;
}
