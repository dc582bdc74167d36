/* From a pixel to the place that it lights: Newton's method on the sphere. */
#include "lit_place.h"

#include <math.h>
#include <string.h>

#include <cupola/projection.h>

static const double close_px = 1e-4, longest_step = 0.1; /* rad */

static void set_length(double length, double v[3])
{
    double scale = length / sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    for (int i = 0; i < 3; i++)
        v[i] *= scale;
}

/* Two vectors of length 1 across v, of any length, and across each other. */
static void find_across(const double v[3], double a[3], double b[3])
{
    int least = fabs(v[0]) < fabs(v[1]) ? 0 : 1;
    double unit[3] = {least == 0, least == 1, 0};

    for (int i = 0; i < 3; i++)
        a[i] = v[(i + 1) % 3] * unit[(i + 2) % 3] - v[(i + 2) % 3] * unit[(i + 1) % 3];
    for (int i = 0; i < 3; i++)
        b[i] = v[(i + 1) % 3] * a[(i + 2) % 3] - v[(i + 2) % 3] * a[(i + 1) % 3];
    set_length(1, a);
    set_length(1, b);
}

/* One step; false at the goal or where there is none. */
static bool step(const struct cupola_output *output, const double goal_px[2], double distance_m,
                 double at_m[3], double *off_px)
{
    const double little = 1e-6;
    double across[2][3], points_m[9], px[6], d[2][2], off[2];

    find_across(at_m, across[0], across[1]);
    for (int i = 0; i < 9; i++)
        points_m[i] = at_m[i % 3] + (i < 3 ? 0 : little * distance_m * across[i / 3 - 1][i % 3]);
    *off_px = HUGE_VAL;
    if (cupola_output_pixels(output, 3, points_m, px, NULL) < 0)
        return false;
    for (int i = 0; i < 2; i++) {
        off[i] = goal_px[i] - px[i];
        d[i][0] = (px[2 + i] - px[i]) / little;
        d[i][1] = (px[4 + i] - px[i]) / little;
    }
    *off_px = hypot(off[0], off[1]);
    double determinant = d[0][0] * d[1][1] - d[0][1] * d[1][0];
    double by[2] = {(d[1][1] * off[0] - d[0][1] * off[1]) / determinant,
                    (d[0][0] * off[1] - d[1][0] * off[0]) / determinant};
    double length = hypot(by[0], by[1]);
    if (*off_px < close_px || !isfinite(length))
        return false;
    for (int i = 0; i < 3; i++)
        at_m[i] += fmin(1, longest_step / length) * distance_m *
                   (by[0] * across[0][i] + by[1] * across[1][i]);
    set_length(distance_m, at_m);
    return true;
}

static bool seek(const struct cupola_output *output, const double goal_px[2], double distance_m,
                 const double from_m[3], double found_m[3])
{
    enum { STEPS_MAX = 40 };
    double off_px = HUGE_VAL;

    memcpy(found_m, from_m, 3 * sizeof *found_m);
    set_length(distance_m, found_m);
    for (int i = 0; i < STEPS_MAX && step(output, goal_px, distance_m, found_m, &off_px); i++)
        continue;
    return off_px < close_px;
}

bool lit_place_find(const cupola_dome *dome, int output, const double pixel_px[2],
                    double distance_m, const double near_m[3], double point_m[3])
{
    const struct cupola_output *projector = &cupola_dome_rig(dome)->outputs[output];
    struct cupola_ray ray;

    /* Within the rim this is the place but for a distance that is not the screen's radius. */
    if (cupola_dome_ray(dome, output, NULL, pixel_px[0], pixel_px[1], &ray) < 0) {
        memcpy(point_m, near_m, 3 * sizeof *point_m);
        return false;
    }
    if (seek(projector, pixel_px, distance_m, ray.point_m, point_m) ||
        seek(projector, pixel_px, distance_m, near_m, point_m))
        return true;
    memcpy(point_m, ray.point_m, 3 * sizeof *point_m);
    return false;
}
