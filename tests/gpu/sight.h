/*
 * Who looks at a theatre, and at what: a spectator at the eye whose whole picture is lit, and the
 * walls of a room behind the screen as seen there.
 */
#ifndef SIGHT_H
#define SIGHT_H

#include "check.h"
#include "fixture.h"
#include "rig_random.h"

enum { WIDTH = 256, HEIGHT = 192 }; /* of the spectator's picture, px */

/* One theatre, who looks, and the wave number of the walls in 1/(scene unit). */
struct sight {
    struct fixture fixture;
    struct cupola_spectator spectator;
    double half_size[3];
    double wave_number;
};

/* The direction of a place in the spectator's picture, host's camera frame, not of unit length. */
static inline void picture_direction(const struct sight *sight, double x_px, double y_px,
                                     double direction[3])
{
    double half = tan(0.5 * sight->spectator.fov_rad), dome_direction[3];
    double across = half * (2.0 * x_px - WIDTH) / HEIGHT, up = half * (2.0 * y_px / HEIGHT - 1.0);
    const double *axes = sight->spectator.rotation;
    for (int i = 0; i < 3; i++)
        dome_direction[i] = across * axes[i] + up * axes[3 + i] - axes[6 + i];
    cupola_dome_to_camera(sight->fixture.dome, dome_direction, direction);
}

/* Whether all four pixels between which the screen's light is interpolated are lit in full. */
static inline int lit_in_full(const cupola_dome *dome, const double direction[3],
                              struct cupola_ray *ray)
{
    double at[2];
    if (cupola_dome_pixel(dome, 0, NULL, direction, at) != 1)
        return 0;
    for (int i = 0; i < 4; i++) {
        double x = floor(at[0] - 0.5) + 0.5 + (i & 1), y = floor(at[1] - 0.5) + 0.5 + (i >> 1);
        if (cupola_dome_ray(dome, 0, NULL, x, y, ray) != 1 || ray->coverage < 1.0 - 1e-6)
            return 0;
    }
    return cupola_dome_ray(dome, 0, NULL, at[0], at[1], ray);
}

static inline int picture_lit(const struct sight *sight, int step)
{
    struct cupola_ray ray;
    double direction[3];
    for (int y = 0; y <= HEIGHT; y += step)
        for (int x = 0; x <= WIDTH; x += step) {
            picture_direction(sight, x, y, direction);
            if (!lit_in_full(sight->fixture.dome, direction, &ray))
                return 0;
        }
    return 1;
}

/* The mean direction of what is lit, each pixel by its solid angle; host's camera frame. */
static inline void mean_direction(const struct fixture *fixture, double mean[3])
{
    const struct cupola_output *output = fixture_output(fixture, 0);
    double sum[3] = {0, 0, 0};
    for (int y = 2; y < output->height_px; y += 5)
        for (int x = 2; x < output->width_px; x += 5) {
            struct cupola_ray ray;
            if (cupola_dome_ray(fixture->dome, 0, NULL, x + 0.5, y + 0.5, &ray) == 1)
                for (int i = 0; i < 3; i++)
                    sum[i] += ray.coverage * ray.solid_angle_sr * ray.direction[i];
        }
    double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int i = 0; i < 3; i++)
        mean[i] = sum[i] / length;
}

/* Turns the spectator's view to a direction, rolled by any angle. */
static inline void turn_towards(const cupola_dome *dome, const double direction[3], double roll_rad,
                                struct cupola_spectator *spectator)
{
    double forward[3], *right = spectator->rotation, *up = right + 3, *back = right + 6;
    cupola_dome_from_camera(dome, direction, forward);
    double aside[3] = {sin(roll_rad), cos(roll_rad), 0.2 * cos(3.0 * roll_rad)}, length = 0.0;
    for (int i = 0; i < 3; i++)
        back[i] = -forward[i];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        right[i] = aside[j] * back[k] - aside[k] * back[j];
        length += right[i] * right[i];
    }
    for (int i = 0; i < 3; i++)
        right[i] /= sqrt(length);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        up[i] = back[j] * right[k] - back[k] * right[j];
    }
}

/* Where a direction meets the walls, scene units; the eye is inside. */
static inline void wall_point(const struct sight *sight, const double direction[3], double point[3])
{
    const struct cupola_rig *rig = cupola_dome_rig(sight->fixture.dome);
    double eye[3], t = HUGE_VAL;
    cupola_dome_to_camera(sight->fixture.dome, rig->eye_m, eye);
    for (int i = 0; i < 3; i++) {
        double to_wall =
            copysign(sight->half_size[i], direction[i]) - eye[i] * rig->units_per_metre;
        if (direction[i] != 0.0)
            t = fmin(t, to_wall / direction[i]);
    }
    for (int i = 0; i < 3; i++)
        point[i] = eye[i] * rig->units_per_metre + t * direction[i];
}

static inline double wall_step(const struct sight *sight, const double direction[3],
                               const double change[3])
{
    double here[3], there[3], moved[3], square = 0.0;
    for (int i = 0; i < 3; i++)
        moved[i] = direction[i] + change[i];
    wall_point(sight, direction, here);
    wall_point(sight, moved, there);
    for (int i = 0; i < 3; i++)
        square += (there[i] - here[i]) * (there[i] - here[i]);
    return sqrt(square);
}

/* The length on the walls of the coarsest pixel in sight; the longer diagonal bounds every width.
 */
static inline double coarsest_pixel(const struct sight *sight)
{
    double most = 0.0;
    for (int y = 0; y <= HEIGHT; y += 4)
        for (int x = 0; x <= WIDTH; x += 4) {
            double direction[3], diagonals[2][3];
            struct cupola_ray ray;
            picture_direction(sight, x, y, direction);
            assert_true(lit_in_full(sight->fixture.dome, direction, &ray));
            for (int i = 0; i < 3; i++) {
                diagonals[0][i] = ray.direction_dx[i] + ray.direction_dy[i];
                diagonals[1][i] = ray.direction_dx[i] - ray.direction_dy[i];
            }
            for (int i = 0; i < 2; i++)
                most = fmax(most, wall_step(sight, ray.direction, diagonals[i]) / sqrt(2.0));
        }
    return most;
}

/*
 * Looks at the mean lit direction, with the widest opening at which all of the picture is lit; or
 * where that one is narrow (lit parts may be crescents), at one of a grid of lit places.
 */
static inline void look_at_lit_part(struct sight *sight, double roll_rad)
{
    enum { GRID = 7 };
    const struct cupola_output *output = fixture_output(&sight->fixture, 0);
    const cupola_dome *dome = sight->fixture.dome;
    struct cupola_ray ray;
    cupola_spectator_at_eye(dome, &sight->spectator);
    for (double fov_deg = 80.0; fov_deg > 10.0; fov_deg *= 0.93) {
        sight->spectator.fov_rad = radians(fov_deg);
        for (int i = -1; i < (fov_deg > 45.0 ? 0 : GRID * GRID); i++) {
            double x = output->width_px * (i % GRID + 0.5) / GRID;
            double y = output->height_px * (i / GRID + 0.5) / GRID;
            if (i < 0)
                mean_direction(&sight->fixture, ray.direction);
            else if (cupola_dome_ray(dome, 0, NULL, x, y, &ray) != 1)
                continue;
            turn_towards(dome, ray.direction, roll_rad, &sight->spectator);
            if (picture_lit(sight, 4))
                return;
        }
    }
    fail_msg("no part of the screen is lit");
}

#endif
