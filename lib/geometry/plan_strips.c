/*
 * The asymmetric layout: one orientation, and its plane divided into columns and rows.
 */
#include <math.h>
#include <stdio.h>

#include "plan.h"
#include "vector.h"

static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* An upright orientation that looks along the mean seen direction. */
static void look_along_mean(const double mean[3], double rotation[9])
{
    const double up[3] = {0, 1, 0};
    double right[3], back[3] = {-mean[0], -mean[1], -mean[2]};
    cross3(mean, up, right);
    /* Near the zenith "upright" means little: keep the host's right, as a planetarium does. */
    if (length3(right) < 0.2) {
        double along = back[0];
        for (int i = 0; i < 3; i++)
            right[i] = (i == 0) - along * back[i];
    }
    scale3(right, 1 / length3(right));
    double upright[3];
    cross3(back, right, upright);
    memcpy(rotation, right, sizeof right);
    memcpy(rotation + 3, upright, sizeof upright);
    memcpy(rotation + 6, back, sizeof back);
}

/* Where the rays meet the plane of an orientation: left, right, bottom, top. False: not all do. */
static bool meet_plane(const struct plan_samples *samples, const double rotation[9],
                       double bounds[4])
{
    bounds[0] = bounds[2] = HUGE_VAL;
    bounds[1] = bounds[3] = -HUGE_VAL;
    for (int i = 0; i < samples->count; i++) {
        double q[3];
        transform3(rotation, samples->list[i].at, q);
        if (!(-q[2] >= PLAN_REACH_COSINE - 1e-9))
            return false;
        for (int axis = 0; axis < 2; axis++) {
            bounds[2 * axis] = smaller(bounds[2 * axis], q[axis] / -q[2]);
            bounds[2 * axis + 1] = larger(bounds[2 * axis + 1], q[axis] / -q[2]);
        }
    }
    return samples->count > 0;
}

/*
 * The plane cut into columns and rows at equal angles. A cut between the parts k and k + 1 of an
 * axis is where their selectors' products are equal: part k has k a - (sum of the cuts before it),
 * the upper envelope of lines of growing slope; the selector of a cell is the sum of both axes.
 */
static void cut_plane(const double bounds[4], const double rotation[9], int columns, int rows,
                      struct plan_state *state)
{
    const int parts[2] = {columns, rows};
    double offset[2][CUPOLA_VIEWS_MAX];
    for (int axis = 0; axis < 2; axis++) {
        double least = atan(bounds[2 * axis]), largest = atan(bounds[2 * axis + 1]), sum = 0;
        for (int k = 0; k < parts[axis]; k++) {
            if (k > 0)
                sum += tan(least + (largest - least) * k / parts[axis]);
            offset[axis][k] = sum;
        }
    }
    state->count = columns * rows;
    state->orientation = rotation;
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++) {
            double selector[3] = {column, row, offset[0][column] + offset[1][row]};
            transform3_back(rotation, selector, state->views[row * columns + column].selector);
        }
}

static void conclude(const struct plan_samples *samples, const struct plan_state *state,
                     int columns, int rows, struct plan_choice choices[PLAN_CHOICES])
{
    /* Of near equals the one whose views are lit alike. */
    static const double preference = 0.995;
    struct plan_choice choice = {.layout = CUPOLA_LAYOUT_ASYMMETRIC,
                                 .count = state->count,
                                 .drawn = plan_drawn(samples, state),
                                 .cost = preference * state->cost};
    snprintf(choice.family, sizeof choice.family, "%dx%d", columns, rows);
    for (int v = 0; v < state->count; v++) {
        memcpy(choice.views[v].rotation, state->orientation, sizeof choice.views[v].rotation);
        memcpy(choice.views[v].selector, state->views[v].selector, sizeof choice.views[v].selector);
    }
    plan_choice_insert(choices, &choice);
}

int plan_strips(const struct plan_question *question, struct plan_choice choices[PLAN_CHOICES])
{
    const struct plan_samples *samples = question->fine;
    double mean[9], bounds[4];
    look_along_mean(samples->mean, mean);
    const double *rotation = identity;
    if (!meet_plane(samples, identity, bounds)) {
        rotation = mean;
        if (!meet_plane(samples, mean, bounds))
            return CUPOLA_OK;
    }
    struct plan_state state;
    struct plan_scratch scratch = {.footprints = NULL};
    bool done =
        plan_state_create(samples->count, &state) && plan_scratch_create(samples->count, &scratch);
    for (int count = question->least_views; count <= question->most_views && done; count++)
        for (int rows = 1; rows <= count; rows++) {
            if (count % rows != 0)
                continue;
            cut_plane(bounds, rotation, count / rows, rows, &state);
            plan_evaluate(samples, &question->prices, &scratch, &state);
            if (state.cost < PLAN_IMPOSSIBLE)
                conclude(samples, &state, count / rows, rows, choices);
        }
    plan_state_release(&state);
    plan_scratch_release(&scratch);
    return done ? CUPOLA_OK : CUPOLA_ERROR_MEMORY;
}
