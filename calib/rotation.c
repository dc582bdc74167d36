/* Rotations as 3x3 matrices by rows, and aims. */
#include "rotation.h"

#include <math.h>
#include <string.h>

void rotation_multiply(const double a[9], const double b[9], double product[9])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            product[3 * i + j] =
                a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
}

/* About axis 0 (x), 1 (y) or 2 (z). */
static void about(int axis, double angle_rad, double q[9])
{
    int next = (axis + 1) % 3, last = (axis + 2) % 3;

    memset(q, 0, 9 * sizeof *q);
    q[3 * axis + axis] = 1;
    q[3 * next + next] = q[3 * last + last] = cos(angle_rad);
    q[3 * last + next] = sin(angle_rad);
    q[3 * next + last] = -sin(angle_rad);
}

void rotation_from_tilt(double tilt_rad, double q[9])
{
    about(0, tilt_rad, q);
}

void rotation_from_aim(const struct cupola_aim *aim, double q[9])
{
    double yaw[9], pitch[9], roll[9], tilted[9];

    about(1, aim->yaw_rad, yaw);
    about(0, aim->pitch_rad, pitch);
    about(2, aim->roll_rad, roll);
    rotation_multiply(pitch, roll, tilted);
    rotation_multiply(yaw, tilted, q);
}

/*
 * The axis of the lens, -Q e_z, is (-sin yaw cos pitch, sin pitch, -cos yaw cos pitch). Near the
 * poles yaw is what rounding makes of it; roll is what is left with that yaw, so that the product
 * is right.
 */
void rotation_to_aim(const double q[9], struct cupola_aim *aim)
{
    double across = hypot(q[2], q[8]);
    double back[9], yaw[9], rest[9];

    aim->yaw_rad = across > 1e-12 ? atan2(q[2], q[8]) : 0;
    aim->pitch_rad = atan2(-q[5], across);
    about(1, -aim->yaw_rad, yaw);
    rotation_multiply(yaw, q, rest);
    about(0, -aim->pitch_rad, back);
    rotation_multiply(back, rest, yaw);
    aim->roll_rad = atan2(yaw[3], yaw[0]);
}

void rotation_from_vector(const double w[3], double q[9])
{
    double angle = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    double s = angle > 1e-8 ? sin(angle) / angle : 1;
    double half = sin(0.5 * angle);
    double c = angle > 1e-8 ? 2 * half * half / (angle * angle) : 0.5;

    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            q[3 * i + j] = c * w[i] * w[j] + (i == j ? 1 - c * angle * angle : 0);
    }
    q[1] -= s * w[2];
    q[2] += s * w[1];
    q[3] += s * w[2];
    q[5] -= s * w[0];
    q[6] -= s * w[1];
    q[7] += s * w[0];
}

void rotation_apply(const double q[9], const double v[3], double rotated[3])
{
    for (int i = 0; i < 3; i++)
        rotated[i] = q[3 * i] * v[0] + q[3 * i + 1] * v[1] + q[3 * i + 2] * v[2];
}

void rotation_apply_back(const double q[9], const double v[3], double rotated[3])
{
    for (int i = 0; i < 3; i++)
        rotated[i] = q[i] * v[0] + q[3 + i] * v[1] + q[6 + i] * v[2];
}

double rotation_between(const double a[9], const double b[9])
{
    double square = 0;

    for (int i = 0; i < 9; i++)
        square += (a[i] - b[i]) * (a[i] - b[i]);
    return 2 * asin(fmin(sqrt(square / 8), 1)); /* |A - B| = 2 sqrt(2) sin(angle / 2) */
}
