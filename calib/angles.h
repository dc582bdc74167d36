/* The numbers that angles are turned into each other by. */
#ifndef ANGLES_H
#define ANGLES_H

static const double pi = 3.14159265358979323846;
static const double rad_per_deg = 3.14159265358979323846 / 180;
static const double deg_per_rad = 180 / 3.14159265358979323846;

#endif
