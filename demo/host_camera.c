/* The host's own camera. */
#include "host_camera.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double distance(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static void cross(const double a[3], const double b[3], double product[3])
{
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

static bool normalize(double v[3])
{
    double length = hypot(hypot(v[0], v[1]), v[2]);

    if (!(length > 0) || !isfinite(length))
        return false;
    for (int i = 0; i < 3; i++)
        v[i] /= length;
    return true;
}

bool host_camera_set(struct host_camera *camera, const double place[3], const double *look,
                     const double *up, char *message, size_t message_size)
{
    double back[3] = {0, 0, 1}, right[3], upward[3] = {0, 1, 0};

    for (int i = 0; look && i < 3; i++)
        back[i] = place[i] - look[i];
    if (!normalize(back)) {
        snprintf(message, message_size,
                 "--look: %g,%g,%g is where the camera stands; allowed: another point", look[0],
                 look[1], look[2]);
        return false;
    }
    if (up)
        memcpy(upward, up, sizeof upward);
    if (!normalize(upward)) {
        snprintf(message, message_size, "--up: 0,0,0 is not allowed; allowed: a direction");
        return false;
    }
    cross(upward, back, right);
    if (dot(right, right) < 1e-18) {
        snprintf(message, message_size,
                 "--up: %g,%g,%g%s is the line of sight; allowed: a direction beside it",
                 up ? up[0] : 0, up ? up[1] : 1, up ? up[2] : 0, up ? "" : " (the default)");
        return false;
    }
    normalize(right);
    cross(back, right, upward);
    memcpy(camera->place, place, sizeof camera->place);
    memcpy(camera->rotation, right, sizeof right);
    memcpy(camera->rotation + 3, upward, sizeof upward);
    memcpy(camera->rotation + 6, back, sizeof back);
    return true;
}

void host_camera_matrix(const struct host_camera *camera, float matrix[16])
{
    for (int row = 0; row < 3; row++) {
        const double *axis = camera->rotation + 3 * row;
        for (int column = 0; column < 3; column++)
            matrix[4 * column + row] = (float)axis[column];
        matrix[12 + row] = (float)-dot(axis, camera->place);
        matrix[4 * row + 3] = 0;
    }
    matrix[15] = 1;
}

void host_camera_eye(const struct host_camera *camera, const cupola_dome *dome, double eye[3],
                     double world[3])
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);

    cupola_dome_to_camera(dome, rig->eye_m, eye);
    for (int i = 0; i < 3; i++)
        eye[i] *= rig->units_per_metre;
    for (int i = 0; i < 3; i++)
        world[i] = camera->place[i] + camera->rotation[i] * eye[0] +
                   camera->rotation[3 + i] * eye[1] + camera->rotation[6 + i] * eye[2];
}

void host_camera_move(struct host_camera *camera, const double step[3])
{
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 3; i++)
            camera->place[i] += step[axis] * camera->rotation[3 * axis + i];
}

/* Rodrigues' formula; axis of unit length. */
static void rotate(double v[3], const double axis[3], double angle_rad)
{
    double side[3], along = dot(axis, v);
    double c = cos(angle_rad), s = sin(angle_rad);

    cross(axis, v, side);
    for (int i = 0; i < 3; i++)
        v[i] = c * v[i] + s * side[i] + (1 - c) * along * axis[i];
}

void host_camera_turn(struct host_camera *camera, const double up[3], double yaw_rad,
                      double pitch_rad)
{
    double axis[3];
    double *right = camera->rotation, *upward = right + 3, *back = right + 6;

    memcpy(axis, up, sizeof axis);
    if (normalize(axis)) {
        for (int i = 0; i < 3; i++)
            rotate(camera->rotation + 3 * i, axis, yaw_rad);
    }
    memcpy(axis, right, sizeof axis);
    rotate(upward, axis, pitch_rad);
    rotate(back, axis, pitch_rad);
    /* Rounding must not add up over a long flight. */
    normalize(back);
    cross(upward, back, right);
    normalize(right);
    cross(back, right, upward);
}

void scene_range_update(struct scene_range *range, const struct scene *scene, const double eye[3],
                        double *near_distance, double *far_distance)
{
    double moved, left;

    if (!(scene->radius > 0)) {
        *near_distance = 0.1;
        *far_distance = 1000;
        return;
    }
    *far_distance = 1.01 * (distance(eye, scene->center) + scene->radius);
    moved = range->known ? distance(eye, range->place) : 0;
    /* After a step of 1 the nearest surface is at most 1 nearer. */
    if (!range->known || moved > range->distance / 2) {
        range->distance = scene_distance(scene, eye);
        memcpy(range->place, eye, sizeof range->place);
        range->known = true;
        moved = 0;
    }
    left = range->distance - moved;
    /*
     * A ray in the corner of a view may be six times as long as it is deep. The floor keeps some
     * resolution in depth where the eye touches a surface.
     */
    *near_distance = fmax(0.15 * left, 1e-5 * *far_distance);
    *near_distance = fmin(*near_distance, 0.5 * *far_distance);
}
