/*
 * Prices from measured times: weighted least squares with no price below 0.
 *
 * Each trial is a row (1, shaded, allocated, views, drawn) and its time. Times are off by a part of
 * themselves, so rows are weighed by theirs. Columns are centred, so that what all trials share is
 * in no price, and scaled to unit length. With four unknowns every set of prices above 0 is tried
 * (15 of them): the best one whose solution has none below 0. A price whose standard error is too
 * large is set to its default, as a part of a shaded texel's price, and the others are fitted anew.
 */
#include <math.h>

#include "cost_trials.h"
#include "error.h"
#include "plan.h"

enum { SHADED, ALLOCATED, VIEWS, DRAWN, PRICES };

/* In the price of a shaded texel. */
static const double usual[PRICES] = {1, PLAN_ALLOCATED_USUAL, PLAN_VIEW_USUAL, 0};

/* In the same: less than this is as good as nothing, and need not be told from it. */
static const double small[PRICES] = {1, 0.1, 0.01, 0.2};

/* A price is told if its standard error is at most this part of it. */
static const double error_most = 0.5;

/* What times are off by at least, as a part of them: few trials may agree by chance. */
static const double noise_least = 0.005;

struct system {
    double products[PRICES][PRICES], with_time[PRICES]; /* of centred columns of unit length */
    double length[PRICES];
    double time; /* square of the centred times' length */
};

struct fit {
    double price[PRICES], error[PRICES]; /* s; standard errors */
};

/* The column of a price; that of shaded texels has with it what is not told. */
static double amount(const struct cupola_cost_trial *trial, int price, unsigned told)
{
    const double amounts[PRICES] = {trial->texels_shaded, trial->texels_allocated, trial->views,
                                    trial->directions_drawn};
    double sum = amounts[price];
    if (price == SHADED)
        for (int i = 1; i < PRICES; i++)
            sum += told >> i & 1 ? 0 : usual[i] * amounts[i];
    return sum;
}

/* Of each trial; their sum is the number of trials. */
static void weigh(const struct cupola_cost_trial *trials, int count, double *weight)
{
    double longest = 0, sum = 0;
    for (int t = 0; t < count; t++)
        longest = fmax(longest, trials[t].seconds);
    for (int t = 0; t < count; t++) {
        double off = longest > 0 ? trials[t].seconds / longest + 0.02 : 1;
        weight[t] = 1 / (off * off);
        sum += weight[t];
    }
    for (int t = 0; t < count; t++)
        weight[t] *= count / sum;
}

static void scale(const double mean[PRICES], int count, struct system *system)
{
    for (int i = 0; i < PRICES; i++) {
        double length = sqrt(system->products[i][i]);
        /* A column that hardly changes can tell nothing. */
        system->length[i] = length > 1e-3 * mean[i] * sqrt(count) ? length : 0;
    }
    for (int i = 0; i < PRICES; i++) {
        for (int k = 0; k < PRICES; k++)
            system->products[i][k] /= system->length[i] > 0 && system->length[k] > 0
                                          ? system->length[i] * system->length[k]
                                          : HUGE_VAL;
        system->with_time[i] /= system->length[i] > 0 ? system->length[i] : HUGE_VAL;
    }
}

static void build(const struct cupola_cost_trial *trials, int count, unsigned told,
                  struct system *system)
{
    double mean[PRICES] = {0}, mean_time = 0, weight[CUPOLA_COST_TRIALS_MAX];
    weigh(trials, count, weight);
    *system = (struct system){.length = {0}};
    for (int t = 0; t < count; t++) {
        mean_time += weight[t] * trials[t].seconds / count;
        for (int i = 0; i < PRICES; i++)
            mean[i] += weight[t] * amount(&trials[t], i, told) / count;
    }
    for (int t = 0; t < count; t++) {
        double time = trials[t].seconds - mean_time;
        system->time += weight[t] * time * time;
        for (int i = 0; i < PRICES; i++) {
            double centred = weight[t] * (amount(&trials[t], i, told) - mean[i]);
            system->with_time[i] += centred * time;
            for (int k = 0; k < PRICES; k++)
                system->products[i][k] += centred * (amount(&trials[t], k, told) - mean[k]);
        }
    }
    scale(mean, count, system);
}

/* Gauss on the chosen columns; false where they cannot be told apart. */
static bool solve(const struct system *system, unsigned chosen, const double right[PRICES],
                  double solution[PRICES])
{
    static const double least_pivot = 1e-4;
    double rows[PRICES][PRICES + 1];
    int columns[PRICES], n = 0;
    for (int i = 0; i < PRICES; i++)
        if (chosen >> i & 1)
            columns[n++] = i;
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < n; k++)
            rows[i][k] = system->products[columns[i]][columns[k]];
        rows[i][n] = right[columns[i]];
    }
    for (int i = 0; i < n; i++) {
        if (!(rows[i][i] > least_pivot))
            return false;
        for (int k = i + 1; k < n; k++) {
            double factor = rows[k][i] / rows[i][i];
            for (int c = i; c <= n; c++)
                rows[k][c] -= factor * rows[i][c];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        double value = rows[i][n];
        for (int k = i + 1; k < n; k++)
            value -= rows[i][k] * solution[columns[k]];
        solution[columns[i]] = value / rows[i][i];
    }
    return true;
}

static bool is_allowed(const double solution[PRICES])
{
    for (int i = 0; i < PRICES; i++)
        if (!(solution[i] >= 0))
            return false;
    return true;
}

/* Of all columns that can be told apart; a column that cannot has none. */
static void find_errors(const struct system *system, unsigned told, double variance,
                        struct fit *fit)
{
    for (int i = 0; i < PRICES; i++) {
        double unit[PRICES] = {0}, inverse[PRICES] = {0};
        unit[i] = 1;
        bool found = told >> i & 1 && system->length[i] > 0 && solve(system, told, unit, inverse) &&
                     inverse[i] > 0;
        fit->error[i] = found ? sqrt(variance * inverse[i]) / system->length[i] : HUGE_VAL;
    }
}

/* The prices of the set among those to be told that explains most; 0 where none does. */
static void fit_told(const struct cupola_cost_trial *trials, int count, unsigned told,
                     struct fit *fit)
{
    struct system system;
    double most = 0, noise = 0, weight[CUPOLA_COST_TRIALS_MAX];
    int unknown = 1;
    build(trials, count, told, &system);
    *fit = (struct fit){.price = {0}};
    for (unsigned chosen = 1; chosen < 1u << PRICES; chosen++) {
        double solution[PRICES] = {0}, gain = 0;
        if ((chosen & ~told) || !solve(&system, chosen, system.with_time, solution) ||
            !is_allowed(solution))
            continue;
        for (int i = 0; i < PRICES; i++)
            gain += solution[i] * system.with_time[i];
        if (!(gain > most * (1 + 1e-9)))
            continue;
        most = gain;
        for (int i = 0; i < PRICES; i++)
            fit->price[i] = solution[i] > 0 ? solution[i] / system.length[i] : 0;
    }
    weigh(trials, count, weight);
    for (int t = 0; t < count; t++)
        noise = fmax(noise, noise_least * trials[t].seconds * sqrt(weight[t]));
    for (int i = 0; i < PRICES; i++)
        unknown += told >> i & 1;
    double left = fmax(system.time - most, 0) / (count > unknown ? count - unknown : 1);
    find_errors(&system, told, fmax(left, noise * noise), fit);
}

/* Takes the price that is least certain to its default, one after the other. */
static unsigned fit_certain(const struct cupola_cost_trial *trials, int count, struct fit *fit)
{
    unsigned told = (1u << PRICES) - 1;
    for (;;) {
        int least = 0;
        double worst = error_most;
        fit_told(trials, count, told, fit);
        for (int i = 1; i < PRICES; i++) {
            double part = fit->error[i] / fmax(fit->price[i], small[i] * fit->price[SHADED]);
            if (told >> i & 1 && !(part <= worst)) {
                worst = isnan(part) ? HUGE_VAL : part;
                least = i;
            }
        }
        if (least == 0)
            return told;
        told &= ~(1u << least);
    }
}

static int check_trial(const struct cupola_cost_trial *trial, int index, struct cupola_error *error)
{
    static const char *const names[] = {"texels shaded", "texels allocated", "number of views",
                                        "directions drawn", "time in seconds"};
    const double values[] = {trial->texels_shaded, trial->texels_allocated, trial->views,
                             trial->directions_drawn, trial->seconds};
    for (int i = 0; i < PRICES + 1; i++)
        if (!(values[i] >= 0 && values[i] <= 1e9))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "%s of trial %d is %g; allowed: 0 to 1e9", names[i], index, values[i]);
    return CUPOLA_OK;
}

/* What is not told stays at 0, the default; what costs nothing is not 0. */
static double stated(const struct fit *fit, unsigned told, int price, double shaded)
{
    return told >> price & 1 ? fmin(fmax(fit->price[price] / shaded, 1e-9), 1e6) : 0;
}

int cupola_cost_fit(const struct cupola_cost_trial *trials, int count, struct cupola_cost *cost,
                    struct cupola_error *error)
{
    struct fit fit;
    if (!trials || !cost)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: %s",
                         trials ? "cost" : "trials", trials ? "a place for prices" : "3 to 64");
    if (count < 3 || count > CUPOLA_COST_TRIALS_MAX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "number of trials is %d; allowed: 3 to %d",
                         count, CUPOLA_COST_TRIALS_MAX);
    for (int t = 0; t < count; t++) {
        int status = check_trial(&trials[t], t, error);
        if (status != CUPOLA_OK)
            return status;
    }
    unsigned told = fit_certain(trials, count, &fit);
    /* Where other things take nearly all the time, the most that texels may cost is enough. */
    bool others = told & ~1u && fit.price[SHADED] > 0 && isfinite(fit.error[SHADED]);
    if (!(fit.error[SHADED] <= error_most * fit.price[SHADED]) && !others)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "%d trials cannot tell what a shaded texel costs; allowed: trials that "
                         "take longer where they shade more",
                         count);
    double shaded = fmax(fit.price[SHADED], fit.error[SHADED]);
    *cost = (struct cupola_cost){.view = stated(&fit, told, VIEWS, shaded),
                                 .texel_allocated = stated(&fit, told, ALLOCATED, shaded),
                                 .vertices = stated(&fit, told, DRAWN, shaded)};
    return CUPOLA_OK;
}

int cupola_cost_trial_of(const cupola_plan *plan, bool unmasked, struct cupola_cost_trial *trial)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    if (!report || !trial)
        return CUPOLA_ERROR_ARGUMENT;
    *trial = (struct cupola_cost_trial){
        .texels_shaded =
            unmasked ? report->texels_shaded_per_pixel : report->texels_masked_per_pixel,
        .texels_allocated = report->texels_shaded_per_pixel,
        .views = report->views,
        .directions_drawn = report->directions_drawn,
    };
    return CUPOLA_OK;
}
