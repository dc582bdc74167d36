/*
 * Points and rays once more, for comparison: in long double, aims as quaternions, the screen found
 * by bisection along the ray and curves inverted by bisection. Nothing here is written as the
 * library writes it, so that both are not wrong in the same way.
 */
#ifndef ORACLE_H
#define ORACLE_H

#include "cupola/dome.h"
#include "rig_random.h"

struct oracle_ray {
    long double point[3];     /* D, dome frame */
    long double lens_ray[3];  /* dome frame, unit length */
    long double direction[3]; /* host's camera frame, unit length */
};

static inline long double oracle_dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline long double oracle_polynomial(const double k[4], long double angle)
{
    long double sum = 0.0L, power = angle;
    for (int i = 0; i < 4; i++) {
        sum += (long double)k[i] * power;
        power *= angle * angle;
    }
    return sum;
}

static inline long double oracle_polynomial_angle(const struct cupola_lens *lens,
                                                  long double radius)
{
    long double low = 0.0L, high = (long double)lens->fov_rad / 2.0L;
    long double wanted = radius * oracle_polynomial(lens->k, high);
    for (int i = 0; i < 80; i++) {
        long double middle = (low + high) / 2.0L;
        if (oracle_polynomial(lens->k, middle) < wanted)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2.0L;
}

/* angle(r). A table has no closed form: its own tests are in lens.c, here the library is asked. */
static inline long double oracle_angle(const struct cupola_lens *lens, long double radius)
{
    long double half = (long double)lens->fov_rad / 2.0L, s;
    switch (lens->model) {
    case CUPOLA_LENS_ANGULAR:
        return radius * half;
    case CUPOLA_LENS_HEMISPHERIC:
        s = radius * sinl(half);
        return atan2l(s, sqrtl(1.0L - s * s));
    case CUPOLA_LENS_EQUISOLID:
        s = radius * radius * (1.0L - cosl(half)); /* 1 - cos of the angle */
        return atan2l(sqrtl(s * (2.0L - s)), 1.0L - s);
    case CUPOLA_LENS_STEREOGRAPHIC:
        s = radius * sinl(half) / (1.0L + cosl(half));
        return atan2l(2.0L * s, 1.0L - s * s);
    case CUPOLA_LENS_POLYNOMIAL:
        return oracle_polynomial_angle(lens, radius);
    default:
        return (long double)cupola_lens_angle(lens, (double)radius);
    }
}

/* q = a b, (w, x, y, z) */
static inline void oracle_quaternion_times(const long double a[4], const long double b[4],
                                           long double q[4])
{
    q[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
    q[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
    q[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
    q[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

static inline void oracle_rotate(const long double q[4], const long double v[3], long double out[3])
{
    long double conjugate[4] = {q[0], -q[1], -q[2], -q[3]};
    long double pure[4] = {0.0L, v[0], v[1], v[2]}, half[4], whole[4];
    oracle_quaternion_times(q, pure, half);
    oracle_quaternion_times(half, conjugate, whole);
    for (int i = 0; i < 3; i++)
        out[i] = whole[i + 1];
}

static inline void oracle_aim(const struct cupola_aim *aim, const long double v[3],
                              long double out[3])
{
    long double yaw = (long double)aim->yaw_rad / 2.0L, pitch = (long double)aim->pitch_rad / 2.0L;
    long double roll = (long double)aim->roll_rad / 2.0L, both[4], all[4];
    oracle_quaternion_times((long double[4]){cosl(yaw), 0.0L, sinl(yaw), 0.0L},
                            (long double[4]){cosl(pitch), sinl(pitch), 0.0L, 0.0L}, both);
    oracle_quaternion_times(both, (long double[4]){cosl(roll), 0.0L, 0.0L, sinl(roll)}, all);
    oracle_rotate(all, v, out);
}

static inline void oracle_hit(const double from[3], const long double ray[3], double radius,
                              long double point[3])
{
    long double low = 0.0L, high = 2.5L * (long double)radius;
    for (int i = 0; i < 80; i++) {
        long double middle = (low + high) / 2.0L;
        for (int j = 0; j < 3; j++)
            point[j] = (long double)from[j] + middle * ray[j];
        if (oracle_dot(point, point) < (long double)radius * (long double)radius)
            low = middle;
        else
            high = middle;
    }
}

/* What a place of output 0 of a complete rig shows; beyond the rim the nearest place of it. */
static inline struct oracle_ray oracle_ray_at(const struct cupola_rig *rig, const double eye[3],
                                              double x_px, double y_px)
{
    const struct cupola_output *output = &rig->outputs[0];
    long double x = ((long double)x_px - (long double)output->circle.center_x_px) /
                    (long double)output->circle.radius_px;
    long double y = ((long double)y_px - (long double)output->circle.center_y_px) /
                    (long double)output->circle.radius_px;
    if (output->flip & CUPOLA_FLIP_X)
        x = -x;
    if (output->flip & CUPOLA_FLIP_Y)
        y = -y;
    long double r = hypotl(x, y), theta = atan2l(y, x);
    long double angle = oracle_angle(&output->lens, r < 1.0L ? r : 1.0L);
    long double in_lens[3] = {sinl(angle) * cosl(theta), sinl(angle) * sinl(theta), -cosl(angle)};

    struct oracle_ray ray;
    oracle_aim(&output->aim, in_lens, ray.lens_ray);
    oracle_hit(output->position_m, ray.lens_ray, rig->screen.radius_m, ray.point);
    long double v[3];
    for (int i = 0; i < 3; i++)
        v[i] = ray.point[i] - (long double)eye[i];
    long double length = sqrtl(oracle_dot(v, v)), tilt = (long double)rig->tilt_rad / 2.0L;
    for (int i = 0; i < 3; i++)
        v[i] /= length;
    oracle_rotate((long double[4]){cosl(tilt), sinl(tilt), 0.0L, 0.0L}, v, ray.direction);
    return ray;
}

/* Angle between two vectors of any length, without the loss that acos has at small angles. */
static inline double angle_between(const double a[3], const double b[3])
{
    double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
    double z = a[0] * b[1] - a[1] * b[0];
    return atan2(sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

static inline cupola_dome *dome_of(const struct cupola_rig *rig)
{
    cupola_dome *dome = NULL;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_dome_create(rig, &dome, &error) != CUPOLA_OK)
        fail_msg("dome: %s", error.message);
    return dome;
}

#endif
