/* Rotations as 3x3 matrices by rows, and aims. */
#ifndef ROTATION_H
#define ROTATION_H

#include <cupola/rig.h>

/* Q of an aim: from the lens's frame to the dome's. */
void rotation_from_aim(const struct cupola_aim *aim, double q[9]);

/* The way back, exact as a rotation also where yaw and roll turn about the same axis. */
void rotation_to_aim(const double q[9], struct cupola_aim *aim);

/*
 * R_x of a rig's tilt: from the dome's frame to that of a viewer who sits upright, in which the
 * host's camera looks.
 */
void rotation_from_tilt(double tilt_rad, double q[9]);

/* product = a * b; none of them the same array. */
void rotation_multiply(const double a[9], const double b[9], double product[9]);

/* Turns by |w| radians about w, by the right-hand rule. */
void rotation_from_vector(const double w[3], double q[9]);

/* rotated = q v, and back = transposed q v. */
void rotation_apply(const double q[9], const double v[3], double rotated[3]);
void rotation_apply_back(const double q[9], const double v[3], double rotated[3]);

/* The angle of the rotation that leads from one to the other, rad. */
double rotation_between(const double a[9], const double b[9]);

#endif
