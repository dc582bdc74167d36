/* Angles: radians in code, degrees only where people read. */
#ifndef ANGLE_H
#define ANGLE_H

static const double pi = 3.14159265358979323846;

/* 180 degrees may come out of a conversion a few units in the last place too large. */
static const double angle_slack = 1e-12;

/* Both, as two arguments of a message. */
#define RAD_AND_DEG(angle_rad) (angle_rad), (angle_rad) * (180.0 / pi)

#endif
