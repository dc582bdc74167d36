/*
 * Where the search begins: views in one to three rings round the mean seen direction. A ring of one
 * view looks along it (innermost) or against it (outermost, where more than a half-space is seen).
 * Rings share the pixels as they share the views.
 */
#include <stdlib.h>

#include "plan.h"
#include "vector.h"

static void add_family(struct plan_family *families, int *count, int inner, int middle, int outer)
{
    const int views[3] = {inner, middle, outer};
    for (int phase = 0; phase < 2; phase++) {
        struct plan_family family = {.phase = phase};
        for (int i = 0; i < 3; i++)
            if (views[i] > 0) {
                family.views[family.rings++] = views[i];
                family.count += views[i];
            }
        if (*count < PLAN_FAMILIES_MAX)
            families[(*count)++] = family;
    }
}

int plan_families(int least_views, int most_views, double half_rad,
                  struct plan_family families[PLAN_FAMILIES_MAX])
{
    int count = 0;
    for (int k = least_views; k <= most_views; k++) {
        if (k <= 6 || half_rad < 60 * (pi / 180))
            add_family(families, &count, 0, 0, k);
        for (int inner = 1; inner <= 3; inner++)
            if (k - inner >= inner && k - inner >= 2 && k - inner <= 7)
                add_family(families, &count, 0, inner, k - inner);
        if (half_rad > 80 * (pi / 180) && k >= 8)
            add_family(families, &count, 1, 3, k - 4);
        if (half_rad > 100 * (pi / 180) && k >= 5) {
            add_family(families, &count, 1, k - 2, 1);
            if (k >= 7)
                add_family(families, &count, 1, 3, k - 4);
            if (k >= 6)
                add_family(families, &count, k / 2, k - k / 2 - 1, 1);
        }
    }
    return count;
}

struct share {
    double angle, weight;
};

static int by_angle(const void *a, const void *b)
{
    double x = ((const struct share *)a)->angle, y = ((const struct share *)b)->angle;
    return (x > y) - (x < y);
}

/* The angle to the mean direction below which a part of the pixels is seen. */
static double angle_of_share(const struct share *shares, int count, double pixels, double part)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        sum += shares[i].weight;
        if (sum >= part * pixels)
            return shares[i].angle;
    }
    return shares[count - 1].angle;
}

/* A direction by its angle to the mean and its azimuth round it. */
static void direction(const double frame[9], double angle, double azimuth, double axis[3])
{
    for (int i = 0; i < 3; i++)
        axis[i] = sin(angle) * (cos(azimuth) * frame[i] + sin(azimuth) * frame[3 + i]) -
                  cos(angle) * frame[6 + i];
}

bool plan_family_place(const struct plan_family *family, const struct plan_samples *samples,
                       struct plan_state *state)
{
    double frame[9];
    int placed = 0;
    struct share *shares = malloc((size_t)samples->count * sizeof *shares);
    state->count = family->count;
    if (!shares)
        return false;
    for (int i = 0; i < samples->count; i++)
        shares[i] =
            (struct share){acos(fmin(fmax(dot3(samples->mean, samples->list[i].at), -1), 1)),
                           samples->list[i].weight};
    qsort(shares, (size_t)samples->count, sizeof *shares, by_angle);
    plan_look_along(samples->mean, frame);
    for (int ring = 0; ring < family->rings; ring++) {
        int ring_views = family->views[ring];
        bool last = ring == family->rings - 1;
        double part = (placed + 0.5 * ring_views) / family->count;
        double angle = angle_of_share(shares, samples->count, samples->pixels, part);
        if (ring_views == 1)
            angle = ring == 0 ? 0 : pi;
        else if (ring == 0)
            angle *= 0.8; /* a sector's middle lies farther in than half of its pixels */
        double turn = 0.5 * ((last ? family->phase : 0) + family->rings - 1 - ring);
        for (int i = 0; i < ring_views; i++) {
            struct plan_candidate *view = &state->views[placed++];
            direction(frame, angle, 2 * pi * (i + turn) / ring_views, view->axis);
            memcpy(view->selector, view->axis, sizeof view->selector);
        }
    }
    free(shares);
    return true;
}
