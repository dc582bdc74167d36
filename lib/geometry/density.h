/*
 * What one pixel covers, seen by the eye. shaders/density.frag has the solid angle
 * under the same name.
 */
#ifndef DENSITY_H
#define DENSITY_H

#include "dome.h"

/*
 * The ray of a pixel's middle and its changes per pixel, host's camera frame, not of unit length;
 * near the rim those half a pixel inside of it. Returns the pixel's coverage.
 */
double density_ray(const cupola_dome *dome, int output, const double eye_m[3], double x_px,
                   double y_px, struct varying *seen);

/* Of a pixel, sr: |v . (dv/dx x dv/dy)| / |v|^3. */
double density_solid_angle(const struct varying *seen);

/* The singular values of a change of place (filter_jacobian), the greater first. */
void density_stretch(const double jacobian[4], double values[2]);

#endif
