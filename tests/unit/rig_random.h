/*
 * Seeded random rigs, shared by the tests: every failure replays by its seed. What is drawn is
 * within what a rig allows, and well conditioned: lenses stay away from the rims where their own
 * inverse is singular, and eye and lens within 0.8 of the screen's radius.
 */
#ifndef RIG_RANDOM_H
#define RIG_RANDOM_H

#include <string.h>

#include "check.h"
#include "cupola/rig.h"
#include "geometry/angle.h"

static inline double radians(double degrees)
{
    return degrees * (pi / 180.0);
}

/* An integer from low to high, both included. */
static inline int random_int(uint64_t *seed, int low, int high)
{
    return low + (int)(random_between(seed, 0.0, 1.0) * (double)(high - low + 1));
}

static inline void random_in_ball(uint64_t *seed, double radius, double point[3])
{
    double square;
    do {
        square = 0.0;
        for (int i = 0; i < 3; i++) {
            point[i] = random_between(seed, -1.0, 1.0);
            square += point[i] * point[i];
        }
    } while (square > 1.0);
    for (int i = 0; i < 3; i++)
        point[i] *= radius;
}

/* Rows of slightly uneven steps, in an odd unit, as someone would have measured them. */
static inline void random_lens_table(uint64_t *seed, double half_fov, struct cupola_lens *lens)
{
    double radius = 0.0;
    lens->table_count = random_int(seed, 2, 20);
    for (int i = 0; i < lens->table_count; i++) {
        radius += random_between(seed, 0.8, 1.2) * 0.037;
        lens->table[i].angle_rad = half_fov * (double)(i + 1) / (double)lens->table_count;
        lens->table[i].radius = radius;
    }
}

/*
 * A lens of one model. Polynomials are strictly increasing up to 110 degrees: the slope there is at
 * least 1 - 3 0.04 3.7 - 5 0.003 13.6 - 7 0.0003 50 > 0.2.
 */
static inline struct cupola_lens random_lens(uint64_t *seed, enum cupola_lens_model model,
                                             double fov_rad)
{
    struct cupola_lens lens;
    memset(&lens, 0, sizeof lens);
    lens.model = model;
    lens.fov_rad = fov_rad;
    if (model == CUPOLA_LENS_POLYNOMIAL) {
        lens.k[0] = 1.0;
        lens.k[1] = random_between(seed, -0.04, 0.05);
        lens.k[2] = random_between(seed, -0.003, 0.005);
        lens.k[3] = random_between(seed, -0.0003, 0.0005);
    }
    if (model == CUPOLA_LENS_TABLE) {
        random_lens_table(seed, fov_rad / 2.0, &lens);
        /* Rounding of the division above may leave the last angle a bit short of the half. */
        lens.fov_rad = 0.0;
    }
    return lens;
}

/* Any model, 90 to 220 degrees; hemispheric up to 160, where an angle is 6 times a radius. */
static inline struct cupola_lens random_any_lens(uint64_t *seed)
{
    enum cupola_lens_model model = (enum cupola_lens_model)random_int(seed, 0, 5);
    double most = model == CUPOLA_LENS_HEMISPHERIC ? 160.0 : 220.0;
    return random_lens(seed, model, radians(random_between(seed, 90.0, most)));
}

/* One projector for a screen of radius 1: odd sizes, truncated and off-centre circles, flips. */
static inline void random_output(uint64_t *seed, double offset, struct cupola_output *output)
{
    static const int sizes[4][2] = {{317, 241}, {128, 128}, {160, 100}, {101, 203}};
    const int *size = sizes[random_int(seed, 0, 3)];
    memset(output, 0, sizeof *output);
    output->width_px = size[0];
    output->height_px = size[1];
    if (random_int(seed, 0, 1)) {
        output->circle.center_x_px = size[0] * random_between(seed, 0.4, 0.6);
        output->circle.center_y_px = size[1] * random_between(seed, 0.3, 0.7);
        output->circle.radius_px = size[0] * random_between(seed, 0.4, 0.6);
    }
    output->flip = random_int(seed, 0, 3);
    output->lens = random_any_lens(seed);
    random_in_ball(seed, offset, output->position_m);
}

/*
 * A rig with one output. Eye and lens within `offset` of the screen's radius from its centre; aim
 * and tilt any. Complete.
 */
static inline struct cupola_rig random_rig(uint64_t *seed, double offset)
{
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    random_output(seed, offset, &rig.outputs[0]);
    rig.screen.radius_m = random_between(seed, 0.5, 12.0);
    random_in_ball(seed, offset * rig.screen.radius_m, rig.eye_m);
    for (int i = 0; i < 3; i++)
        rig.outputs[0].position_m[i] *= rig.screen.radius_m;
    rig.outputs[0].aim.yaw_rad = random_between(seed, -3.0, 3.0);
    rig.outputs[0].aim.pitch_rad = random_between(seed, -1.5, 1.5);
    rig.outputs[0].aim.roll_rad = random_between(seed, -3.0, 3.0);
    rig.tilt_rad = random_between(seed, -3.0, 3.0);
    rig.units_per_metre = random_between(seed, 0.5, 100.0);

    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_rig_complete(&rig, &rig, &error) != CUPOLA_OK)
        fail_msg("random rig: %s", error.message);
    return rig;
}

/* The plain theatre that most facts are said about: eye and projector at the centre, no tilt. */
static inline struct cupola_rig plain_rig(enum cupola_lens_model model, double fov_deg, int size_px)
{
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    rig.outputs[0].width_px = size_px;
    rig.outputs[0].height_px = size_px;
    rig.outputs[0].lens.model = model;
    rig.outputs[0].lens.fov_rad = radians(fov_deg);
    return rig;
}

#endif
