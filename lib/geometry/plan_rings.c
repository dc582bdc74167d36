/*
 * Samples in rings round the middle of every image circle: views in rings see them alike whatever
 * their number, so that no grid's corners and edges decide between one tilt and the next. Ring i
 * has 6 i + 3 samples of equal area; edges have samples without weight.
 */
#include <math.h>

#include "plan.h"

static struct plan_sample *add(struct plan_samples *samples)
{
    return samples->count < samples->capacity ? &samples->list[samples->count++] : NULL;
}

/* One place of an image: true if it is lit and was added. */
static bool add_place(const cupola_dome *dome, const double eye_m[3], int output, double r_px,
                      double azimuth, struct plan_samples *samples)
{
    const struct projector *projector = &dome->projectors[output];
    struct plan_sample *sample = add(samples);
    double x_px = projector->center_px[0] + r_px * cos(azimuth);
    double y_px = projector->center_px[1] + r_px * sin(azimuth);
    if (sample && plan_trace(dome, eye_m, output, x_px, y_px, sample) >= 0)
        return true;
    samples->count -= sample != NULL;
    return false;
}

/* How far from the circle's middle, which must be lit, the image is lit. */
static double lit_radius(const cupola_dome *dome, const double eye_m[3], int output, double azimuth)
{
    const struct projector *projector = &dome->projectors[output];
    double low = 0, high = projector->radius_px;
    struct plan_sample ignored;
    for (int i = 0; i < 20; i++) {
        double r = i == 0 ? high : 0.5 * (low + high);
        double x = projector->center_px[0] + r * cos(azimuth);
        double y = projector->center_px[1] + r * sin(azimuth);
        bool lit = plan_trace(dome, eye_m, output, x, y, &ignored) >= 0;
        if (lit && i == 0)
            return r;
        *(lit ? &low : &high) = r;
    }
    return low;
}

/*
 * The solid angle of a ring, at the lens, over what the slope in its middle says: near the rim of a
 * hemispheric lens of 180 degrees the slope is infinite.
 */
static double ring_spread(const struct projector *projector, int ring, int rings)
{
    const struct lens *lens = &projector->lens;
    double r = (ring + 0.5) / rings, middle = lens_angle(lens, r);
    double inner = lens_angle(lens, (double)ring / rings);
    double outer = lens_angle(lens, (ring + 1.0) / rings);
    double by_slope = sin(middle) * lens_angle_slope(lens, r, middle) / rings;
    double exact = cos(inner) - cos(outer);
    return by_slope > 0.1 * exact ? exact / by_slope : 1;
}

/* Returns how many of the ring's samples are lit. */
static int add_ring(const cupola_dome *dome, const double eye_m[3], int output, int ring, int rings,
                    struct plan_samples *samples)
{
    const struct projector *projector = &dome->projectors[output];
    double radius = projector->radius_px, weight = pi * radius * radius / (3.0 * rings * rings);
    double spread = ring_spread(projector, ring, rings);
    int lit = 0;
    for (int i = 0; i < 6 * ring + 3; i++) {
        double azimuth = 2 * pi * (i + 0.25) / (6 * ring + 3);
        if (!add_place(dome, eye_m, output, radius * (ring + 0.5) / rings, azimuth, samples))
            continue;
        plan_sample_weigh(&samples->list[samples->count - 1], weight, weight * spread);
        lit++;
    }
    return lit;
}

bool plan_rings_add(const cupola_dome *dome, const double eye_m[3], int rings,
                    struct plan_samples *samples)
{
    const int before = samples->count;
    for (int output = 0; output < dome->rig.output_count; output++) {
        int lit = 0;
        for (int ring = 0; ring < rings; ring++)
            lit += add_ring(dome, eye_m, output, ring, rings, samples);
        for (int i = 0; i < 6 * rings; i++) {
            double azimuth = 2 * pi * i / (6 * rings);
            double r_px = lit_radius(dome, eye_m, output, azimuth);
            if (add_place(dome, eye_m, output, r_px, azimuth, samples))
                plan_sample_weigh(&samples->list[samples->count - 1], 0, 0);
        }
        /* Too little of the circle is lit for rings to say much about it. */
        if (lit < 2 * rings * rings) {
            samples->count = before;
            return false;
        }
    }
    return true;
}
