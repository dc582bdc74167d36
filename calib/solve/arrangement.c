/* How marks lie on the screen. */
#include "arrangement.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "angles.h"
#include "option_values.h"
#include "symmetric.h"

static const double least_off_plane_deg = 3, least_width_deg = 10;

static bool direction(const struct mark *mark, double d[3])
{
    double length = hypot(hypot(mark->place[0], mark->place[1]), mark->place[2]);

    for (int i = 0; i < 3; i++)
        d[i] = length > 0 ? mark->place[i] / length : 0;
    return length > 0;
}

static double product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Sums over the marks: of d, and of d d^T. Returns how many. */
static int sum_up(const struct marks *marks, const bool *rejected, double mean[3], double second[9])
{
    int count = 0;

    memset(mean, 0, 3 * sizeof *mean);
    memset(second, 0, 9 * sizeof *second);
    for (int m = 0; m < marks->count; m++) {
        double d[3];
        if ((rejected && rejected[m]) || !direction(&marks->list[m], d))
            continue;
        count++;
        for (int i = 0; i < 9; i++)
            second[i] += d[i / 3] * d[i % 3];
        for (int i = 0; i < 3; i++)
            mean[i] += d[i];
    }
    for (int i = 0; i < 3 && count > 0; i++)
        mean[i] /= count;
    return count;
}

static double angle_of_cosine(double cosine)
{
    return acos(fmin(fmax(cosine, -1), 1));
}

void arrangement_measure(const struct marks *marks, const bool *rejected,
                         struct arrangement *arrangement)
{
    double mean[3], second[9], about[9], values[3], plane[9], circle[9];
    int count = sum_up(marks, rejected, mean, second);
    double length = sqrt(product(mean, mean));

    for (int i = 0; i < 9; i++)
        about[i] = second[i] - count * mean[i / 3] * mean[i % 3];
    symmetric_eigen(3, second, values, plane);
    symmetric_eigen(3, about, values, circle);
    double middle = product(circle, mean);
    *arrangement = (struct arrangement){.circle_rad = angle_of_cosine(fabs(middle))};
    for (int m = 0; m < marks->count; m++) {
        double d[3];
        if ((rejected && rejected[m]) || !direction(&marks->list[m], d))
            continue;
        double off = asin(fmin(fabs(product(plane, d)), 1));
        double away = length > 1e-9 ? angle_of_cosine(product(mean, d) / length) : 4;
        double aside = fabs(angle_of_cosine(product(circle, d)) - angle_of_cosine(middle));
        arrangement->off_plane_rad = fmax(arrangement->off_plane_rad, off);
        arrangement->width_rad = fmax(arrangement->width_rad, away);
        arrangement->off_circle_rad = fmax(arrangement->off_circle_rad, aside);
    }
}

bool arrangement_suffices(const struct arrangement *arrangement, char *message)
{
    if (!(arrangement->width_rad >= least_width_deg * rad_per_deg)) {
        snprintf(message, MESSAGE_SIZE,
                 "all marks lie close together, within %.1f degrees of their middle; allowed: "
                 "marks over all that the projector lights, %g degrees from their middle at least",
                 arrangement->width_rad / rad_per_deg, least_width_deg);
        return false;
    }
    if (!(arrangement->off_plane_rad >= least_off_plane_deg * rad_per_deg)) {
        snprintf(message, MESSAGE_SIZE,
                 "all marks lie on one meridian (one great circle), within %.1f degrees; allowed: "
                 "some marks aside of it, by %g degrees at least",
                 arrangement->off_plane_rad / rad_per_deg, least_off_plane_deg);
        return false;
    }
    return true;
}

static bool same_place(const struct mark *a, const struct mark *b, double near_px)
{
    double d[3], e[3],
        apart_px = hypot(a->pixel_px[0] - b->pixel_px[0], a->pixel_px[1] - b->pixel_px[1]);

    if (apart_px < near_px || !direction(a, d) || !direction(b, e))
        return true;
    return product(d, e) > cos(1 * rad_per_deg);
}

int arrangement_places(const struct marks *marks, const bool *rejected, double near_px, int most)
{
    enum { PLACES_MAX = 32 };
    int places[PLACES_MAX], count = 0;

    most = most < PLACES_MAX ? most : PLACES_MAX;
    for (int m = 0; m < marks->count && count < most; m++) {
        bool again = rejected && rejected[m];
        for (int i = 0; i < count && !again; i++)
            again = same_place(&marks->list[places[i]], &marks->list[m], near_px);
        if (!again)
            places[count++] = m;
    }
    return count;
}
