/* Which marks belong together and which are wrong. */
#include "consensus.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "order.h"
#include "rotation.h"
#include "solve/fit.h"
#include "solve/search.h"
#include "solve/weights.h"
#include "symmetric.h"

enum { SAMPLE = 300, ROUNDS = 40 };

int consensus_least(int values)
{
    return (values + 3) / 2;
}

/* The lengths of residuals; impossible ones are as far as can be. `lengths` has twice the room. */
static void measure(const struct model *model, const int *chosen, int count, double *lengths)
{
    bool possible = model_residuals(model, &model->base, chosen, count, false, lengths);

    for (int i = 0; i < count; i++)
        lengths[i] = possible ? hypot(lengths[2 * i], lengths[2 * i + 1]) : HUGE_VAL;
}

static double most_of(const struct model *model, const int *chosen, int count, double *lengths)
{
    measure(model, chosen, count, lengths);
    return order_ranked(lengths, count, search_most(count, model->count));
}

/* Evenly out of all, where there are more than are needed. */
static int choose(const struct model *model, int *chosen)
{
    int all = model->marks->count, count = all < SAMPLE ? all : SAMPLE;

    for (int i = 0; i < count; i++)
        chosen[i] = (int)((long long)i * all / count);
    return count;
}

/* The bound follows the residuals inwards: far marks pull at first and let go in the end. */
static double refine(struct model *model, const int *chosen, int count, double *lengths)
{
    enum { TIMES = 3, STEPS = 30 };
    double least_px = 1e-7 * model->radius_px;
    double error_px = most_of(model, chosen, count, lengths);

    for (int i = 0; i < TIMES; i++) {
        struct model before = *model;
        double bound_px = fmin(fmax(3 * error_px, least_px), 2 * model->radius_px);
        if (!fit_marks(model, chosen, count, bound_px, STEPS))
            break;
        double now_px = most_of(model, chosen, count, lengths);
        if (!(now_px < error_px)) {
            *model = before;
            break;
        }
        bool settled = now_px > 0.7 * error_px;
        error_px = now_px;
        if (settled)
            break;
    }
    return error_px;
}

static void take_pose(struct model *model, const struct pose *pose)
{
    memcpy(model->base.output.position_m, pose->position_m, sizeof pose->position_m);
    rotation_to_aim(pose->aim, &model->base.output.aim);
}

bool consensus_find(struct model *model, double *error_px)
{
    int chosen[SAMPLE], count = choose(model, chosen);
    double lengths[2 * SAMPLE], best_px = HUGE_VAL;
    struct pose poses[SEARCH_POSES];
    int found = search_poses(model, chosen, count, poses);
    struct model best = *model;

    for (int i = 0; i < found; i++) {
        struct model trial = *model;
        take_pose(&trial, &poses[i]);
        /* The other poses are for lenses that the start knows badly. */
        if (i > 0 && poses[i].error_rad > 4 * poses[0].error_rad &&
            best_px < 2 * poses[0].error_rad * model_px_per_rad(model))
            break;
        double now_px = refine(&trial, chosen, count, lengths);
        if (!(now_px < best_px))
            continue;
        best_px = now_px;
        best = trial;
    }
    if (!isfinite(best_px))
        return false;
    *model = best;
    *error_px = best_px;
    return true;
}

/* The state of the marks while it is decided which are wrong. */
struct settling {
    struct model *model;
    int all;
    int *kept;
    int kept_count;
    double *residuals; /* of all marks */
    double *jacobian;  /* of all marks */
    double inverse[MODEL_VALUES_MAX * MODEL_VALUES_MAX];
    double *weights;
    bool *rejected;
};

/* The inverse of J^T J over the kept marks; what they do not tell counts as told badly. */
static void invert(struct settling *settling)
{
    int n = settling->model->count;
    double normal[MODEL_VALUES_MAX * MODEL_VALUES_MAX] = {0};
    double values[MODEL_VALUES_MAX], vectors[MODEL_VALUES_MAX * MODEL_VALUES_MAX];

    for (int i = 0; i < n; i++) {
        const double *a = settling->jacobian + (size_t)i * 2 * (size_t)settling->all;
        for (int j = 0; j <= i; j++) {
            const double *b = settling->jacobian + (size_t)j * 2 * (size_t)settling->all;
            double sum = 0;
            for (int m = 0; m < settling->all; m++) {
                if (!settling->rejected[m])
                    sum += a[2 * m] * b[2 * m] + a[2 * m + 1] * b[2 * m + 1];
            }
            normal[n * i + j] = normal[n * j + i] = sum;
        }
    }
    symmetric_eigen(n, normal, values, vectors);
    memset(settling->inverse, 0, sizeof settling->inverse);
    for (int k = 0; k < n; k++) {
        double value = fmax(values[k], 1e-13 * values[n - 1]);
        for (int i = 0; i < n * n; i++)
            settling->inverse[i] += vectors[n * k + i / n] * vectors[n * k + i % n] / value;
    }
}

/* J C J^T of one mark: how its pixel is uncertain with the solution; xx, xy, yy. */
static void spread(const struct settling *settling, int mark, double g[3])
{
    int n = settling->model->count;

    g[0] = g[1] = g[2] = 0;
    for (int i = 0; i < n; i++) {
        const double *a =
            settling->jacobian + 2 * ((size_t)i * (size_t)settling->all + (size_t)mark);
        for (int j = 0; j < n; j++) {
            const double *b =
                settling->jacobian + 2 * ((size_t)j * (size_t)settling->all + (size_t)mark);
            double c = settling->inverse[n * i + j];
            g[0] += a[0] * c * b[0];
            g[1] += a[0] * c * b[1];
            g[2] += a[1] * c * b[1];
        }
    }
}

/*
 * What the sum of squares loses without a kept mark or gains with another: r (I -+ G)^-1 r. That a
 * mark alone decides something (no residual is then possible) makes it 0.
 */
static double weight(const struct settling *settling, int mark)
{
    double g[3], sign = settling->rejected[mark] ? 1 : -1;
    const double *r = settling->residuals + 2 * mark;

    spread(settling, mark, g);
    double xx = 1 + sign * g[0], xy = sign * g[1], yy = 1 + sign * g[2];
    double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-6))
        return 0;
    return (r[0] * r[0] * yy - 2 * r[0] * r[1] * xy + r[1] * r[1] * xx) / determinant;
}

static double squares(struct settling *settling)
{
    double sum = 0;
    bool possible = model_residuals(settling->model, &settling->model->base, NULL, settling->all,
                                    true, settling->residuals);

    for (int i = 0; i < 2 * settling->all; i++) {
        if (!possible)
            settling->residuals[i] = 1e6;
        if (!settling->rejected[i / 2])
            sum += settling->residuals[i] * settling->residuals[i];
    }
    return sum;
}

/*
 * How many times its noise a mark is off, against what chance allows: above 1 it is wrong. The
 * ratio of two sums of squares of 2 and f freedoms exceeds F by chance with (1 + 2 F / f)^(-f/2).
 */
static double excess(const struct settling *settling, int mark, double sum)
{
    double w = weight(settling, mark);
    int freedoms = 2 * settling->kept_count - settling->model->count;
    double floor_px = 1e-6 * settling->model->radius_px;
    double chance = 0.002 / settling->all;

    if (!settling->rejected[mark]) {
        freedoms -= 2;
        sum -= w;
    }
    if (freedoms <= 0)
        return 0;
    double allowed = 0.5 * freedoms * (pow(chance, -2.0 / freedoms) - 1);
    double variance = fmax(sum / freedoms, floor_px * floor_px);
    return 0.5 * w / variance / allowed;
}

static void list_kept(struct settling *settling)
{
    settling->kept_count = 0;
    for (int i = 0; i < settling->all; i++) {
        if (!settling->rejected[i])
            settling->kept[settling->kept_count++] = i;
    }
}

/* One round: all that pass come in, the worst that does not goes out. True when nothing changed. */
static bool judge(struct settling *settling, bool may_return)
{
    int worst = -1;
    double worst_excess = 1, sum = squares(settling);
    bool changed = false;
    int least = consensus_least(settling->model->count);

    invert(settling);
    for (int i = 0; i < settling->all; i++) {
        double now = excess(settling, i, sum);
        if (settling->rejected[i] && now <= 1 && may_return) {
            settling->rejected[i] = false;
            changed = true;
        } else if (!settling->rejected[i] && now > worst_excess) {
            worst = i;
            worst_excess = now;
        }
    }
    if (worst >= 0 && settling->kept_count > least) {
        settling->rejected[worst] = true;
        changed = true;
    }
    return !changed;
}

/* The noise of most marks, from how far most are off, tells who is in from the start. */
static void begin(struct settling *settling, double error_px)
{
    int all = settling->all, n = settling->model->count;
    double share = (search_most(all, n) - 0.5) / all;
    double noise_px =
        error_px / sqrt(-2 * log(1 - share)) * sqrt(2.0 * all / fmax(2.0 * all - n, 1));

    measure(settling->model, NULL, all, settling->residuals);
    for (int i = 0; i < all; i++)
        settling->rejected[i] = !(settling->residuals[i] <= fmax(3 * noise_px, 1.01 * error_px));
    list_kept(settling);
}

static bool settle(struct settling *settling, double error_px)
{
    begin(settling, error_px);
    for (int round = 0; round < ROUNDS; round++) {
        if (round < 2)
            weights_find(settling->model, settling->weights);
        if (!fit_marks(settling->model, settling->kept, settling->kept_count, 0, 100))
            return false;
        double zero[MODEL_VALUES_MAX] = {0};
        model_jacobian(settling->model, zero, NULL, settling->all, settling->jacobian);
        if (judge(settling, round < ROUNDS / 2) && round > 0)
            return true;
        list_kept(settling);
    }
    return fit_marks(settling->model, settling->kept, settling->kept_count, 0, 100);
}

bool consensus_settle(struct model *model, double error_px, double *weights, bool *rejected)
{
    size_t all = (size_t)model->marks->count;
    struct settling settling = {
        .model = model, .all = (int)all, .weights = weights, .rejected = rejected};
    bool settled = false;

    model->weights = weights;
    settling.kept = malloc(all * sizeof *settling.kept);
    settling.residuals = malloc(2 * all * sizeof *settling.residuals);
    settling.jacobian = malloc(2 * all * (size_t)(model->count + 1) * sizeof *settling.jacobian);
    if (settling.kept && settling.residuals && settling.jacobian) {
        settled = settle(&settling, error_px);
    }
    free(settling.kept);
    free(settling.residuals);
    free(settling.jacobian);
    return settled;
}
