/*
 * The search: families on few samples, moved ring by ring; the best of them on more samples, moved
 * view by view.
 *
 * The selector of a view is its axis divided by the cube root of its texels per unit of area: the
 * texels that a piece of solid angle costs in a view are s_u s_v / (axis . ray)^3, so that rays
 * fall to the view in which they are cheapest. The search may shift that border too.
 */
#include <math.h>
#include <stdio.h>

#include "plan.h"
#include "vector.h"

struct search {
    const struct plan_samples *samples;
    const struct plan_prices *prices;
    struct plan_scratch scratch;
    struct plan_state now, trial;
    int evaluations;
};

static bool search_create(const struct plan_samples *samples, const struct plan_prices *prices,
                          struct search *search)
{
    *search = (struct search){.samples = samples, .prices = prices};
    return plan_state_create(samples->count, &search->now) &&
           plan_state_create(samples->count, &search->trial) &&
           plan_scratch_create(samples->count, &search->scratch);
}

static void search_release(struct search *search)
{
    plan_state_release(&search->now);
    plan_state_release(&search->trial);
    plan_scratch_release(&search->scratch);
}

static void evaluate(struct search *search, struct plan_state *state)
{
    plan_evaluate(search->samples, search->prices, &search->scratch, state);
    search->evaluations++;
}

/* Keeps the trial if it is cheaper. */
static bool accept(struct search *search)
{
    if (!(search->trial.cost < search->now.cost * (1 - 1e-6)))
        return false;
    struct plan_state better = search->trial;
    search->trial = search->now;
    search->now = better;
    return true;
}

static void begin_trial(struct search *search)
{
    plan_state_copy(&search->now, search->samples->count, &search->trial);
}

/* Gives every view the selector that suits its densities; kept if that is cheaper. */
static bool balance(struct search *search)
{
    begin_trial(search);
    struct plan_state *trial = &search->trial;
    for (int v = 0; v < trial->count; v++) {
        const double *density = trial->fits[v].density;
        if (!(density[0] * density[1] > 0))
            return false;
        double length = 1 / cbrt(density[0] * density[1]);
        for (int i = 0; i < 3; i++)
            trial->views[v].selector[i] = length * trial->views[v].axis[i];
    }
    evaluate(search, trial);
    return accept(search);
}

/* Moves an axis by an angle towards a direction at right angles to it; its selector goes along. */
static void move_axis(struct plan_candidate *view, const double side[3], double step)
{
    double length = length3(view->selector);
    for (int i = 0; i < 3; i++)
        view->axis[i] = cos(step) * view->axis[i] + sin(step) * side[i];
    scale3(view->axis, 1 / length3(view->axis));
    for (int i = 0; i < 3; i++)
        view->selector[i] = length * view->axis[i];
}

/* At right angles to an axis, away from the mean direction; false where that is undefined. */
static bool outwards(const double axis[3], const double mean[3], double side[3])
{
    double along = dot3(axis, mean);
    for (int i = 0; i < 3; i++)
        side[i] = along * axis[i] - mean[i];
    double length = length3(side);
    if (!(length > 1e-3))
        return false;
    scale3(side, 1 / length);
    return true;
}

/* Moves a whole ring outwards. */
static bool try_ring(struct search *search, int first, int views, double step)
{
    begin_trial(search);
    for (int v = first; v < first + views; v++) {
        double side[3];
        if (!outwards(search->trial.views[v].axis, search->samples->mean, side))
            return false;
        move_axis(&search->trial.views[v], side, step);
    }
    evaluate(search, &search->trial);
    return accept(search);
}

static void descend_rings(struct search *search, const struct plan_family *family, double step,
                          double stop)
{
    balance(search);
    while (step > stop) {
        bool better = false;
        for (int ring = 0, first = 0; ring < family->rings; first += family->views[ring++]) {
            if (family->views[ring] == 1)
                continue;
            if (try_ring(search, first, family->views[ring], -step) ||
                try_ring(search, first, family->views[ring], step))
                better = true;
        }
        if (balance(search))
            better = true;
        if (!better)
            step *= 0.5;
    }
}

/* One move of one view: its axis sideways or up, or its borders. */
static bool try_view(struct search *search, int v, int way, double step)
{
    begin_trial(search);
    struct plan_candidate *view = &search->trial.views[v];
    if (way < 2)
        move_axis(view, search->now.fits[v].rotation + 3 * way, step);
    else
        scale3(view->selector, 1 + step);
    plan_reevaluate(search->samples, search->prices, &search->scratch, v, &search->trial);
    search->evaluations++;
    return accept(search);
}

static void descend_views(struct search *search, double step, double stop, int most)
{
    int last = search->evaluations + most;
    /* Under a mask the borders are best where balance() puts them, to 0.02 %. */
    int ways = search->prices->unmasked ? 3 : 2;
    while (step > stop && search->evaluations < last) {
        double before = search->now.cost;
        for (int v = 0; v < search->now.count; v++)
            for (int way = 0; way < ways; way++)
                if (!try_view(search, v, way, -step))
                    try_view(search, v, way, step);
        balance(search);
        if (!(search->now.cost < before * (1 - 5e-4)))
            step *= 0.5;
    }
}

/* Beyond it rings may begin far from what they come to. */
static const double wide_rad = 91 * (pi / 180);

/*
 * A family that begins much dearer than the best one found is left out. Wide ones may begin with
 * rays that are a little out of reach, and are moved out of that.
 */
static bool is_hopeless(const struct search *search, double least)
{
    static const double little = 1.4;
    double cost = search->now.cost;
    if (search->samples->half_rad < wide_rad)
        return cost > 1.5 * least;
    return cost > 4 * least && !(cost < little * PLAN_IMPOSSIBLE);
}

enum { FINALISTS = 4, MOVES_MAX = 100 };

struct finalist {
    struct plan_family family;
    struct plan_candidate views[CUPOLA_VIEWS_MAX];
    double cost;
};

/* Inserts in order of cost; of equals the first one stays first. */
static void insert_finalist(struct finalist finalists[FINALISTS], const struct finalist *next)
{
    struct finalist moved = *next;
    for (int i = 0; i < FINALISTS; i++)
        if (moved.cost < finalists[i].cost * (1 - 1e-4)) {
            struct finalist worse = finalists[i];
            finalists[i] = moved;
            moved = worse;
        }
}

static void clear_finalists(struct finalist finalists[FINALISTS])
{
    for (int i = 0; i < FINALISTS; i++)
        finalists[i] = (struct finalist){.cost = PLAN_IMPOSSIBLE * 1e3};
}

static void add_finalist(const struct search *search, const struct plan_family *family,
                         struct finalist finalists[FINALISTS])
{
    struct finalist found = {.family = *family, .cost = search->now.cost};
    memcpy(found.views, search->now.views, sizeof found.views);
    insert_finalist(finalists, &found);
}

/* Families come in pairs, by the phase of their outermost ring: places the better one. */
static bool place_better_phase(struct search *search, const struct plan_family pair[2], int *better)
{
    if (!plan_family_place(&pair[1], search->samples, &search->now))
        return false;
    evaluate(search, &search->now);
    double turned = search->now.cost;
    balance(search);
    begin_trial(search);
    if (!plan_family_place(&pair[0], search->samples, &search->trial))
        return false;
    evaluate(search, &search->trial);
    *better = search->trial.cost <= turned * (1 + 2e-3) ? 0 : 1;
    if (*better == 0) {
        struct plan_state first = search->trial;
        search->trial = search->now;
        search->now = first;
    }
    return true;
}

static bool run_families(struct search *search, const struct plan_question *question,
                         struct finalist finalists[FINALISTS])
{
    struct plan_family families[PLAN_FAMILIES_MAX];
    const struct plan_samples *samples = search->samples;
    int count =
        plan_families(question->least_views, question->most_views, samples->half_rad, families);
    for (int f = 0; f + 1 < count; f += 2) {
        int better;
        if (!place_better_phase(search, &families[f], &better))
            return false;
        if (is_hopeless(search, finalists[0].cost))
            continue;
        const struct plan_family *family = &families[f + better];
        descend_rings(search, family, 0.12 * samples->half_rad, 0.03 * samples->half_rad);
        add_finalist(search, family, finalists);
    }
    return true;
}

/* Views that are spread out, not in rings: of as many as there may be, and fewer if that pays. */
static void run_spread(struct search *search, const struct plan_question *question,
                       struct finalist finalists[FINALISTS])
{
    const struct plan_samples *samples = search->samples;
    double least = PLAN_IMPOSSIBLE * 1e2;
    for (int k = question->most_views; k >= question->least_views; k--) {
        const struct plan_family family = {.count = k};
        double step = 0.12 * samples->half_rad / sqrt(k);
        plan_spread_place(samples, k, &search->now);
        evaluate(search, &search->now);
        balance(search);
        if (search->now.cost < PLAN_IMPOSSIBLE)
            descend_views(search, step, 0.5 * step, MOVES_MAX / 2);
        add_finalist(search, &family, finalists);
        if (!(search->now.cost < least))
            return;
        least = search->now.cost;
    }
}

static bool run_all(struct search *search, const struct plan_question *question,
                    struct finalist finalists[FINALISTS])
{
    clear_finalists(finalists);
    if (!run_families(search, question, finalists))
        return false;
    if (search->samples->half_rad > wide_rad || !(finalists[0].cost < PLAN_IMPOSSIBLE))
        run_spread(search, question, finalists);
    return true;
}

static void begin_at(const struct finalist *finalist, struct search *search)
{
    search->now.count = finalist->family.count;
    memcpy(search->now.views, finalist->views, sizeof finalist->views);
    evaluate(search, &search->now);
}

static void keep_in(struct finalist *finalist, const struct search *search)
{
    memcpy(finalist->views, search->now.views, sizeof finalist->views);
    finalist->cost = search->now.cost;
}

/*
 * Moves each view of a finalist on its own. Where that gains little the rings stay as they are:
 * symmetric, and a gain of the size of what the samples leave open is none.
 */
static void loosen(struct search *search, struct finalist *finalist)
{
    static const double worth_while = 1 - 5e-3;
    double step = 0.12 * search->samples->half_rad / sqrt(finalist->family.count);
    begin_at(finalist, search);
    descend_views(search, step, 0.25 * step, MOVES_MAX);
    if (search->now.cost < worth_while * finalist->cost)
        keep_in(finalist, search);
}

void plan_choice_insert(struct plan_choice choices[PLAN_CHOICES], const struct plan_choice *next)
{
    struct plan_choice moved = *next;
    for (int i = 0; i < PLAN_CHOICES; i++)
        if (choices[i].count == 0 || moved.cost < choices[i].cost) {
            struct plan_choice worse = choices[i];
            choices[i] = moved;
            if (worse.count == 0)
                return;
            moved = worse;
        }
}

static void conclude(const struct search *search, const struct plan_family *family,
                     struct plan_choice choices[PLAN_CHOICES])
{
    const struct plan_state *state = &search->now;
    struct plan_choice choice = {.layout = CUPOLA_LAYOUT_ROTATED,
                                 .count = state->count,
                                 .drawn = plan_drawn(search->samples, state),
                                 .cost = state->cost};
    int length = 0;
    if (family->rings == 0)
        snprintf(choice.family, sizeof choice.family, "free %d", family->count);
    for (int ring = 0; ring < family->rings; ring++)
        length += snprintf(choice.family + length, sizeof choice.family - (size_t)length, "%s%d",
                           ring > 0 ? "+" : "", family->views[ring]);
    for (int v = 0; v < state->count; v++) {
        memcpy(choice.views[v].rotation, state->fits[v].rotation, sizeof choice.views[v].rotation);
        memcpy(choice.views[v].selector, state->views[v].selector, sizeof choice.views[v].selector);
        choice.views[v].area = state->fits[v].area;
    }
    plan_choice_insert(choices, &choice);
}

static void sort_finalists(struct finalist finalists[FINALISTS])
{
    struct finalist sorted[FINALISTS];
    clear_finalists(sorted);
    for (int f = 0; f < FINALISTS; f++)
        insert_finalist(sorted, &finalists[f]);
    memcpy(finalists, sorted, sizeof sorted);
}

/* The finalists in smaller steps; the best of them are moved view by view. */
static void run_finals(struct search *search, struct finalist finalists[FINALISTS],
                       struct plan_choice choices[PLAN_CHOICES])
{
    enum { LOOSENED = 1 };
    double half = search->samples->half_rad;
    for (int f = 0; f < FINALISTS && finalists[f].family.count > 0; f++) {
        begin_at(&finalists[f], search);
        descend_rings(search, &finalists[f].family, 0.03 * half, 0.006 * half);
        keep_in(&finalists[f], search);
    }
    sort_finalists(finalists);
    for (int f = 0; f < FINALISTS && finalists[f].family.count > 0; f++) {
        if (f < LOOSENED)
            loosen(search, &finalists[f]);
        begin_at(&finalists[f], search);
        conclude(search, &finalists[f].family, choices);
    }
}

int plan_search(const struct plan_question *question, struct plan_choice choices[PLAN_CHOICES])
{
    struct search coarse = {.evaluations = 0}, fine = coarse;
    struct finalist finalists[FINALISTS];
    bool done = search_create(question->coarse, &question->prices, &coarse) &&
                search_create(question->fine, &question->prices, &fine) &&
                run_all(&coarse, question, finalists);
    if (done)
        run_finals(&fine, finalists, choices);
    search_release(&coarse);
    search_release(&fine);
    return done ? CUPOLA_OK : CUPOLA_ERROR_MEMORY;
}
