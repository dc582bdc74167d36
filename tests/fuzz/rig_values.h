/* A rig out of a fuzzer's bytes, and what is asked of vectors. */
#ifndef RIG_VALUES_H
#define RIG_VALUES_H

#include "cupola/rig.h"
#include "lens_values.h"

static inline struct cupola_output take_output(struct values *values, double screen_m, int side_px)
{
    struct cupola_output output;
    memset(&output, 0, sizeof output);
    output.width_px = take_int(values, 1, side_px);
    output.height_px = take_int(values, 1, side_px);
    output.circle.center_x_px = take_double(values, output.width_px);
    output.circle.center_y_px = take_double(values, output.height_px);
    output.circle.radius_px = fabs(take_double(values, output.width_px));
    output.flip = take_byte(values) % 5;
    output.lens = take_lens(values);
    for (int i = 0; i < 3; i++)
        output.position_m[i] = take_double(values, screen_m);
    output.aim.yaw_rad = take_double(values, pi);
    output.aim.pitch_rad = take_double(values, pi);
    output.aim.roll_rad = take_double(values, pi);
    return output;
}

static inline struct cupola_rig take_rig(struct values *values, int side_px)
{
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    rig.screen.radius_m = fabs(take_double(values, 5));
    rig.screen.cap_rad = fabs(take_double(values, pi));
    double scale_m = rig.screen.radius_m > 0 ? rig.screen.radius_m : 1;
    for (int i = 0; i < 3; i++)
        rig.eye_m[i] = take_double(values, scale_m);
    rig.tilt_rad = take_double(values, pi);
    rig.units_per_metre = take_double(values, 1);
    int count = take_byte(values);
    rig.output_count = count < 128 ? 1 : count % 4;
    for (int i = 0; i < rig.output_count; i++)
        rig.outputs[i] = take_output(values, scale_m, side_px);
    return rig;
}

static inline int is_unit(const double v[3])
{
    return fabs(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) - 1) <= 1e-6;
}

static inline int is_finite3(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

#endif
