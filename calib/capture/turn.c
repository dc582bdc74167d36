/* Rotations as matrices. */
#include "capture/turn.h"

#include <math.h>

void turn_multiply(const double a[9], const double b[9], double product[9])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            product[3 * i + j] =
                a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
}

/* By an angle round axis 0, 1 or 2. */
static void about_axis(int axis, double angle_rad, double turn[9])
{
    int next = (axis + 1) % 3, last = (axis + 2) % 3;

    for (int i = 0; i < 9; i++)
        turn[i] = 0;
    turn[4 * axis] = 1;
    turn[4 * next] = turn[4 * last] = cos(angle_rad);
    turn[3 * next + last] = -sin(angle_rad);
    turn[3 * last + next] = sin(angle_rad);
}

void turn_about_x(double angle_rad, double turn[9])
{
    about_axis(0, angle_rad, turn);
}

void turn_of_aim(const struct cupola_aim *aim, double turn[9])
{
    double yaw[9], pitch[9], roll[9], both[9];

    about_axis(1, aim->yaw_rad, yaw);
    about_axis(0, aim->pitch_rad, pitch);
    about_axis(2, aim->roll_rad, roll);
    turn_multiply(pitch, roll, both);
    turn_multiply(yaw, both, turn);
}

void turn_to_aim(const double turn[9], struct cupola_aim *aim)
{
    double level = hypot(turn[3], turn[4]);

    aim->pitch_rad = atan2(-turn[5], level);
    if (level > 1e-9) {
        aim->yaw_rad = atan2(turn[2], turn[8]);
        aim->roll_rad = atan2(turn[3], turn[4]);
    } else { /* straight up or down: yaw and roll are one */
        aim->yaw_rad = atan2(-turn[6], turn[0]);
        aim->roll_rad = 0;
    }
}

void turn_about_vector(const double vector_rad[3], double turn[9])
{
    double x = vector_rad[0], y = vector_rad[1], z = vector_rad[2];
    double angle = sqrt(x * x + y * y + z * z);
    double a = angle > 1e-8 ? sin(angle) / angle : 1;
    double b = angle > 1e-4 ? (1 - cos(angle)) / (angle * angle) : 0.5;
    const double cross[9] = {0, -z, y, z, 0, -x, -y, x, 0};
    double square[9];

    turn_multiply(cross, cross, square);
    for (int i = 0; i < 9; i++)
        turn[i] = (i % 4 == 0) + a * cross[i] + b * square[i];
}
