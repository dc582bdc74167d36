/* Where the projector may stand and aim, whatever the start says. */
#include "search.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "order.h"
#include "random.h"
#include "rotation.h"
#include "symmetric.h"

enum { TRIALS = 160, STEPS = 8, SUBSET = 4 };

/* A mark as the lens sees it: the direction that its pixel shows, in the lens's frame. */
struct sight {
    double point_m[3];
    double ray[3];
};

struct search {
    const struct model *model;
    struct sight *sights;
    int count;
    double *errors;
    uint64_t seed;
    struct pose start;
    struct pose *best;
    int best_count;
};

int search_most(int count, int values)
{
    int most = (count + values / 2 + 2) / 2;

    return most < count ? most : count;
}

static int random_below(uint64_t *seed, int bound)
{
    return (int)(random_next(seed) % (uint64_t)bound);
}

/* Beyond the rim the curve goes on straight. */
static double angle_of(const struct cupola_lens *lens, double r)
{
    double rim = cupola_lens_angle(lens, 1);

    if (r <= 1)
        return cupola_lens_angle(lens, r);
    return fmin(rim + (r - 1) * (rim - cupola_lens_angle(lens, 0.99)) / 0.01, pi);
}

static void see(const struct model *model, int mark, struct sight *sight)
{
    const struct cupola_output *output = &model->base.output;
    const double *pixel = model->marks->list[mark].pixel_px;
    double x = (pixel[0] - output->circle.center_x_px) / output->circle.radius_px;
    double y = (pixel[1] - output->circle.center_y_px) / output->circle.radius_px;
    double r = hypot(x, y), angle = angle_of(&output->lens, r);

    x *= output->flip & CUPOLA_FLIP_X ? -1 : 1;
    y *= output->flip & CUPOLA_FLIP_Y ? -1 : 1;
    sight->ray[0] = r > 0 ? sin(angle) * x / r : 0;
    sight->ray[1] = r > 0 ? sin(angle) * y / r : 0;
    sight->ray[2] = -cos(angle);
    model_point(model, model->base.radius_m, mark, sight->point_m);
}

/* The direction of a sight's point in the lens's frame; its distance is returned. */
static double direction(const struct pose *pose, const struct sight *sight, double v[3])
{
    double d[3], length;

    for (int i = 0; i < 3; i++)
        d[i] = sight->point_m[i] - pose->position_m[i];
    length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    length = fmax(length, 1e-9);
    for (int i = 0; i < 3; i++)
        d[i] /= length;
    rotation_apply_back(pose->aim, d, v);
    return length;
}

/* The rotation that best leads rays to directions (Horn, J. Opt. Soc. Am. A 4, 1987). */
static void align(const struct sight *sights, const int *subset, int count, struct pose *pose)
{
    double m[9] = {0}, values[4], vectors[16];

    memset(pose->aim, 0, sizeof pose->aim);
    for (int i = 0; i < 3; i++)
        pose->aim[4 * i] = 1;
    for (int s = 0; s < count; s++) {
        double v[3];
        direction(pose, &sights[subset[s]], v);
        for (int i = 0; i < 9; i++)
            m[i] += sights[subset[s]].ray[i / 3] * v[i % 3];
    }
    const double n[16] = {m[0] + m[4] + m[8],  m[5] - m[7], m[6] - m[2], m[1] - m[3], m[5] - m[7],
                          m[0] - m[4] - m[8],  m[1] + m[3], m[6] + m[2], m[6] - m[2], m[1] + m[3],
                          -m[0] + m[4] - m[8], m[5] + m[7], m[1] - m[3], m[6] + m[2], m[5] + m[7],
                          -m[0] - m[4] + m[8]};
    symmetric_eigen(4, n, values, vectors);
    const double *q = vectors + 12;
    double half = atan2(sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), q[0]);
    double length = fmax(sin(half), 1e-12);
    rotation_from_vector(
        (double[3]){2 * half * q[1] / length, 2 * half * q[2] / length, 2 * half * q[3] / length},
        pose->aim);
}

/*
 * One step of Gauss and Newton over the differences between direction and ray. A small rotation w
 * changes a direction v by v x w, a move m of the lens in its own frame by
 * (v (v.m) - m) / distance.
 */
static bool step(const struct search *search, const int *subset, int count, struct pose *pose)
{
    double a[36] = {0}, b[6] = {0}, turn[9], move[3], before[9];
    int free = search->model->free;

    for (int s = 0; s < count; s++) {
        const struct sight *sight = &search->sights[subset[s]];
        double v[3], distance = direction(pose, sight, v), rows[3][6];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                rows[i][j] = i == j ? 0 : (j - i + 3) % 3 == 1 ? -v[3 - i - j] : v[3 - i - j];
                rows[i][3 + j] = (v[i] * v[j] - (i == j)) / distance;
            }
            for (int j = 0; j < 6; j++) {
                b[j] -= rows[i][j] * (v[i] - sight->ray[i]);
                for (int k = 0; k < 6; k++)
                    a[6 * j + k] += rows[i][j] * rows[i][k];
            }
        }
    }
    for (int j = 0; j < 6; j++) {
        bool fixed = !(free & (j < 3 ? SOLVE_AIM : SOLVE_POSITION));
        a[7 * j] += fixed ? 1e12 : 1e-6 * count;
    }
    if (!symmetric_solve(6, a, b))
        return false;
    rotation_apply(pose->aim, b + 3, move);
    double length = sqrt(move[0] * move[0] + move[1] * move[1] + move[2] * move[2]);
    double most = 0.4 * search->model->screen_m;
    for (int i = 0; i < 3; i++)
        pose->position_m[i] += move[i] * (length > most ? most / length : 1);
    memcpy(before, pose->aim, sizeof before);
    rotation_from_vector(b, turn);
    rotation_multiply(before, turn, pose->aim);
    return true;
}

static void judge(struct search *search, struct pose *pose)
{
    for (int i = 0; i < search->count; i++) {
        double v[3], square = 0;
        direction(pose, &search->sights[i], v);
        for (int k = 0; k < 3; k++)
            square += (v[k] - search->sights[i].ray[k]) * (v[k] - search->sights[i].ray[k]);
        search->errors[i] = square;
    }
    int most = search_most(search->count, search->model->count);
    pose->error_rad = sqrt(order_ranked(search->errors, search->count, most));
}

static bool same_pose(const struct search *search, const struct pose *a, const struct pose *b)
{
    double square = 0;

    for (int i = 0; i < 3; i++)
        square += pow((a->position_m[i] - b->position_m[i]) / search->model->screen_m, 2);
    return square < 0.1 * 0.1 && rotation_between(a->aim, b->aim) < 0.1;
}

/* Into the list, unless there are better ones or a better one that is the same. */
static void offer(struct search *search, const struct pose *pose)
{
    struct pose *best = search->best;
    int at = search->best_count;

    for (int i = 0; i < search->best_count; i++) {
        if (!same_pose(search, &best[i], pose))
            continue;
        if (pose->error_rad < best[i].error_rad)
            best[i] = *pose;
        at = -1;
        break;
    }
    if (at == SEARCH_POSES)
        at = best[SEARCH_POSES - 1].error_rad > pose->error_rad ? SEARCH_POSES - 1 : -1;
    else if (at >= 0)
        search->best_count++;
    if (at >= 0)
        best[at] = *pose;
    for (int i = search->best_count - 1; i > 0; i--) {
        if (!(best[i].error_rad < best[i - 1].error_rad))
            continue;
        struct pose better = best[i];
        best[i] = best[i - 1];
        best[i - 1] = better;
    }
}

static void try_subset(struct search *search, const int *subset, int count, bool from_centre)
{
    struct pose pose = search->start;
    double square = 0;

    if (from_centre && search->model->free & SOLVE_POSITION)
        memset(pose.position_m, 0, sizeof pose.position_m);
    if (search->model->free & SOLVE_AIM)
        align(search->sights, subset, count, &pose);
    for (int i = 0; i < STEPS; i++) {
        if (!step(search, subset, count, &pose))
            return;
    }
    for (int i = 0; i < 3; i++)
        square += pow(pose.position_m[i] / search->model->screen_m, 2);
    if (!(square < 1.5 * 1.5))
        return;
    judge(search, &pose);
    offer(search, &pose);
}

static void try_all(struct search *search, int *all)
{
    for (int i = 0; i < search->count; i++)
        all[i] = i;
    try_subset(search, all, search->count, true);
    try_subset(search, all, search->count, false);
    for (int t = 0; t < TRIALS && search->count > SUBSET; t++) {
        for (int i = 0; i < SUBSET; i++) {
            int other = i + random_below(&search->seed, search->count - i);
            int kept = all[i];
            all[i] = all[other];
            all[other] = kept;
        }
        try_subset(search, all, SUBSET, t % 4 != 3);
    }
}

int search_poses(const struct model *model, const int *chosen, int count,
                 struct pose poses[SEARCH_POSES])
{
    struct search search = {.model = model, .count = count, .seed = 1, .best = poses};
    int *all = malloc((size_t)count * sizeof *all);

    search.sights = malloc((size_t)count * sizeof *search.sights);
    search.errors = malloc((size_t)count * sizeof *search.errors);
    if (all && search.sights && search.errors) {
        for (int i = 0; i < count; i++)
            see(model, chosen[i], &search.sights[i]);
        memcpy(search.start.position_m, model->base.output.position_m,
               sizeof search.start.position_m);
        rotation_from_aim(&model->base.output.aim, search.start.aim);
        judge(&search, &search.start);
        offer(&search, &search.start);
        if (model->free & (SOLVE_POSITION | SOLVE_AIM))
            try_all(&search, all);
    }
    free(all);
    free(search.sights);
    free(search.errors);
    return search.best_count;
}
