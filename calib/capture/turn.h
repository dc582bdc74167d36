/* Rotations as matrices, rows first, whose columns are the turned axes. */
#ifndef TURN_H
#define TURN_H

#include <cupola/rig.h>

/* product = a b; another array than both. */
void turn_multiply(const double a[9], const double b[9], double product[9]);

/* R_x(angle). */
void turn_about_x(double angle_rad, double turn[9]);

/* Q = R_y(yaw) R_x(pitch) R_z(roll), and the way back. */
void turn_of_aim(const struct cupola_aim *aim, double turn[9]);
void turn_to_aim(const double turn[9], struct cupola_aim *aim);

/* By the vector's length in radians, round it. */
void turn_about_vector(const double vector_rad[3], double turn[9]);

#endif
