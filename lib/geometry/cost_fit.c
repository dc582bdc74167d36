/*
 * Prices from measured times: least squares with no price below 0.
 *
 * Each trial is a row (1, shaded, allocated, views, drawn) and its time; columns are centred, so
 * that what all trials share is in no price, and scaled to unit length. With four unknowns every
 * set of prices above 0 is tried (15 of them): the best one whose solution has none below 0.
 */
#include <math.h>

#include "cupola/cost.h"
#include "error.h"

enum { PRICES = 4 };

struct system {
    double products[PRICES][PRICES], with_time[PRICES]; /* of centred columns of unit length */
    double length[PRICES];
};

static double amount(const struct cupola_cost_trial *trial, int price)
{
    const double amounts[PRICES] = {trial->texels_shaded, trial->texels_allocated, trial->views,
                                    trial->directions_drawn};
    return amounts[price];
}

static void build(const struct cupola_cost_trial *trials, int count, struct system *system)
{
    double mean[PRICES] = {0}, mean_time = 0;
    *system = (struct system){.length = {0}};
    for (int t = 0; t < count; t++) {
        mean_time += trials[t].seconds / count;
        for (int i = 0; i < PRICES; i++)
            mean[i] += amount(&trials[t], i) / count;
    }
    for (int t = 0; t < count; t++)
        for (int i = 0; i < PRICES; i++) {
            double centred = amount(&trials[t], i) - mean[i];
            system->with_time[i] += centred * (trials[t].seconds - mean_time);
            for (int k = 0; k < PRICES; k++)
                system->products[i][k] += centred * (amount(&trials[t], k) - mean[k]);
        }
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

/* Gauss on the chosen columns; false where they cannot be told apart, or a price is below 0. */
static bool solve(const struct system *system, unsigned chosen, double solution[PRICES],
                  double *gain)
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
        rows[i][n] = system->with_time[columns[i]];
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
    *gain = 0;
    for (int i = n - 1; i >= 0; i--) {
        double value = rows[i][n];
        for (int k = i + 1; k < n; k++)
            value -= rows[i][k] * solution[columns[k]];
        value /= rows[i][i];
        if (!(value >= 0))
            return false;
        solution[columns[i]] = value;
        *gain += value * system->with_time[columns[i]];
    }
    return true;
}

/* The prices of the set that explains most; 0 where none does. */
static void solve_best(const struct system *system, double prices[PRICES])
{
    double most = 0;
    for (int i = 0; i < PRICES; i++)
        prices[i] = 0;
    for (unsigned chosen = 1; chosen < 1u << PRICES; chosen++) {
        double solution[PRICES] = {0}, gain;
        if (!solve(system, chosen, solution, &gain) || !(gain > most * (1 + 1e-9)))
            continue;
        most = gain;
        for (int i = 0; i < PRICES; i++)
            prices[i] = solution[i] > 0 ? solution[i] / system->length[i] : 0;
    }
}

static int check_trial(const struct cupola_cost_trial *trial, int index, struct cupola_error *error)
{
    static const char *const names[] = {"texels shaded", "texels allocated", "number of views",
                                        "directions drawn", "time in seconds"};
    const double values[] = {trial->texels_shaded, trial->texels_allocated, trial->views,
                             trial->directions_drawn, trial->seconds};
    for (int i = 0; i < PRICES + 1; i++)
        if (!(values[i] >= 0 && values[i] <= 1e9) || (i == 0 && values[i] == 0))
            return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s of trial %d is %g; allowed: %s",
                             names[i], index, values[i],
                             i == 0 ? "above 0, up to 1e9" : "0 to 1e9");
    return CUPOLA_OK;
}

/* 0 would mean the default. */
static double stated(double price)
{
    return fmin(fmax(price, 1e-9), 1e6);
}

int cupola_cost_fit(const struct cupola_cost_trial *trials, int count, struct cupola_cost *cost,
                    struct cupola_error *error)
{
    struct system system;
    double prices[PRICES];
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
    build(trials, count, &system);
    solve_best(&system, prices);
    if (!(prices[0] > 0))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "%d trials cannot tell what a shaded texel costs; allowed: trials that "
                         "take longer where they shade more",
                         count);
    *cost = (struct cupola_cost){.view = stated(prices[2] / prices[0]),
                                 .texel_allocated = stated(prices[1] / prices[0]),
                                 .vertices = stated(prices[3] / prices[0])};
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
