/*
 * Pictures painted by the forward way: the direction of each texel, from what a picture of that
 * kind is; nothing of it is the library's. The colour is the direction itself.
 */
#ifndef PAINTED_H
#define PAINTED_H

#include <stdlib.h>

#include "check.h"
#include "cupola/cupola.h"

static const double painted_pi = 3.14159265358979323846;

/* Texel (s, t) of a face, from 0 to 1 as rows are stored, as a host draws faces: with the camera's
 * up so that GL's layout comes out. */
static inline void face_direction(int face, double s, double t, double direction[3])
{
    static const double forward[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                         {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static const double up[6][3] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1},
                                    {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
    const double *f = forward[face], *u = up[face];
    const double right[3] = {f[1] * u[2] - f[2] * u[1], f[2] * u[0] - f[0] * u[2],
                             f[0] * u[1] - f[1] * u[0]};
    for (int i = 0; i < 3; i++)
        direction[i] = f[i] + (2.0 * s - 1.0) * right[i] + (2.0 * t - 1.0) * u[i];
}

static inline void painted_direction(const struct cupola_source *source, int face, double s,
                                     double t, double direction[3])
{
    double fov = source->fov_rad == 0.0 ? painted_pi : source->fov_rad;
    if (source->kind == CUPOLA_SOURCE_DOMEMASTER) {
        double x = 2.0 * s - 1.0, y = 2.0 * t - 1.0, r = hypot(x, y), angle = 0.5 * fov * r;
        direction[0] = r > 0.0 ? sin(angle) * x / r : 0.0;
        direction[1] = r > 0.0 ? sin(angle) * y / r : 0.0;
        direction[2] = -cos(angle);
    } else if (source->kind == CUPOLA_SOURCE_EQUIRECTANGULAR) {
        double longitude = 2.0 * painted_pi * (s - 0.5), latitude = painted_pi * (t - 0.5);
        direction[0] = cos(latitude) * sin(longitude);
        direction[1] = sin(latitude);
        direction[2] = -cos(latitude) * cos(longitude);
    } else {
        face_direction(face, s, t, direction);
    }
    double length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                         direction[2] * direction[2]);
    for (int i = 0; i < 3; i++)
        direction[i] /= length;
}

/* height: of the picture or of a face; an equirectangular picture is twice as wide. */
static inline int painted_width(const struct cupola_source *source, int height)
{
    return source->kind == CUPOLA_SOURCE_EQUIRECTANGULAR ? 2 * height : height;
}

static inline int painted_faces(const struct cupola_source *source)
{
    return source->kind == CUPOLA_SOURCE_CUBE ? 6 : 1;
}

/* RGBA floats, freed by the caller. */
static inline float *painted_picture(const struct cupola_source *source, int height)
{
    int width = painted_width(source, height), faces = painted_faces(source);
    float *picture = malloc(4 * sizeof *picture * (size_t)faces * (size_t)width * (size_t)height);
    assert_non_null(picture);
    float *texel = picture;
    for (int face = 0; face < faces; face++)
        for (int j = 0; j < height; j++)
            for (int i = 0; i < width; i++, texel += 4) {
                double direction[3];
                painted_direction(source, face, (i + 0.5) / width, (j + 0.5) / height, direction);
                for (int c = 0; c < 3; c++)
                    texel[c] = (float)direction[c];
                texel[3] = 1.0f;
            }
    return picture;
}

/* R_y(yaw) R_x(pitch) R_z(roll) transposed, turn by turn: into the picture's own frame. */
static inline void into_picture(const struct cupola_aim *aim, double v[3])
{
    const double angles[3] = {aim->yaw_rad, aim->pitch_rad, aim->roll_rad};
    static const int axes[3][2] = {{2, 0}, {1, 2}, {0, 1}}; /* from the first towards the second */
    for (int turn = 0; turn < 3; turn++) {
        double c = cos(angles[turn]), s = sin(angles[turn]);
        double a = v[axes[turn][0]], b = v[axes[turn][1]];
        v[axes[turn][0]] = c * a + s * b;
        v[axes[turn][1]] = c * b - s * a;
    }
}

/* The direction in the picture that a ray must show, of unit length. */
static inline void shown_direction(const cupola_dome *dome, const struct cupola_source *source,
                                   const struct cupola_ray *ray, double direction[3])
{
    int domemaster = source->kind == CUPOLA_SOURCE_DOMEMASTER;
    int on_screen = source->place == CUPOLA_PLACE_SCREEN ||
                    (source->place == CUPOLA_PLACE_DEFAULT && domemaster);
    double v[3], length = 0.0;
    for (int i = 0; i < 3; i++)
        v[i] = ray->direction[i];
    if (on_screen)
        cupola_dome_to_camera(dome, ray->point_m, v);
    if (domemaster)
        cupola_dome_from_camera(dome, v, v);
    into_picture(&source->orientation, v);
    for (int i = 0; i < 3; i++)
        length += v[i] * v[i];
    for (int i = 0; i < 3; i++)
        direction[i] = v[i] / sqrt(length);
}

/* Random sources of each kind and place by turns. */
static inline struct cupola_source random_source(uint64_t *seed, int number)
{
    return (struct cupola_source){
        .kind = (enum cupola_source_kind)(1 + number % 3),
        .place = (enum cupola_source_place)(number / 3 % 3),
        .fov_rad = random_between(seed, 2.0, 2.0 * painted_pi),
        .orientation = {random_between(seed, -3.0, 3.0), random_between(seed, -1.5, 1.5),
                        random_between(seed, -3.0, 3.0)},
    };
}

#endif
