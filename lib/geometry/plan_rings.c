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

/* Rings of an output, out to where the farthest of its image is lit. */
struct rings {
    const cupola_dome *dome;
    const double *eye_m;
    int output, count;
    double outer_px;
};

/*
 * The solid angle of a ring, at the lens, over what the slope in its middle says: near the rim of a
 * hemispheric lens of 180 degrees the slope is infinite.
 */
static double ring_spread(const struct rings *rings, int ring)
{
    const struct projector *projector = &rings->dome->projectors[rings->output];
    const struct lens *lens = &projector->lens;
    double width = rings->outer_px / projector->radius_px / rings->count;
    double r = (ring + 0.5) * width, middle = lens_angle(lens, r);
    double inner = lens_angle(lens, ring * width), outer = lens_angle(lens, (ring + 1) * width);
    double by_slope = sin(middle) * lens_angle_slope(lens, r, middle) * width;
    double exact = cos(inner) - cos(outer);
    return by_slope > 0.1 * exact ? exact / by_slope : 1;
}

/* Adds the lit samples of a ring; returns their number. */
static int add_ring(const struct rings *rings, int ring, struct plan_samples *samples)
{
    double weight = pi * rings->outer_px * rings->outer_px / (3.0 * rings->count * rings->count);
    double spread = ring_spread(rings, ring);
    double r_px = rings->outer_px * (ring + 0.5) / rings->count;
    int lit = 0;
    for (int i = 0; i < 6 * ring + 3; i++) {
        double azimuth = 2 * pi * (i + 0.25) / (6 * ring + 3);
        if (!add_place(rings->dome, rings->eye_m, rings->output, r_px, azimuth, samples))
            continue;
        plan_sample_weigh(&samples->list[samples->count - 1], weight, weight * spread);
        lit++;
    }
    return lit;
}

/* Adds samples without weight along the edge of what is lit. */
static void add_edge(struct rings *rings, struct plan_samples *samples)
{
    struct plan_edge edge = {.first = samples->count};
    int places = 6 * rings->count;
    rings->outer_px = 0;
    for (int i = 0; i < places; i++) {
        double azimuth = 2 * pi * i / places;
        double r_px = lit_radius(rings->dome, rings->eye_m, rings->output, azimuth);
        rings->outer_px = larger(rings->outer_px, r_px);
        if (add_place(rings->dome, rings->eye_m, rings->output, r_px, azimuth, samples))
            plan_sample_weigh(&samples->list[samples->count - 1], 0, 0);
    }
    edge.count = samples->count - edge.first;
    samples->edges[samples->edge_count++] = edge;
}

/* As many rings more as it takes to have samples enough; false where that would be too many. */
static bool add_output(struct rings *rings, struct plan_samples *samples)
{
    int wanted = 2 * rings->count * rings->count, most = PLAN_RINGS_MORE * rings->count;
    add_edge(rings, samples);
    const int before = samples->count;
    while (rings->outer_px > 0) {
        int lit = 0;
        samples->count = before;
        for (int ring = 0; ring < rings->count; ring++)
            lit += add_ring(rings, ring, samples);
        if (lit >= wanted)
            return true;
        int next = (int)ceil(rings->count * 1.05 * sqrt(wanted / larger(lit, 1)));
        if (next > most)
            return false;
        rings->count = next;
    }
    return false;
}

bool plan_rings_add(const cupola_dome *dome, const double eye_m[3], int count,
                    struct plan_samples *samples)
{
    const int before = samples->count;
    samples->edge_count = 0;
    for (int output = 0; output < dome->rig.output_count; output++) {
        struct rings rings = {.dome = dome, .eye_m = eye_m, .output = output, .count = count};
        if (!add_output(&rings, samples)) {
            samples->count = before;
            samples->edge_count = 0;
            return false;
        }
    }
    return true;
}
