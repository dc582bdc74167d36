/* What one pixel covers, seen by the eye; the density map. */
#include "density.h"

#include "cupola/resolution.h"
#include "error.h"
#include "vector.h"

double density_ray(const cupola_dome *dome, int output, const double eye_m[3], double x_px,
                   double y_px, struct varying *seen)
{
    const struct projector *projector = &dome->projectors[output];
    struct varying ray, point, inside;
    double place[2];
    circle_place(projector, x_px, y_px, place);
    lens_ray(projector, place, &ray);
    screen_point(projector, &ray, &point);
    point_inside_rim(projector, x_px, y_px, &point, &inside);
    eye_ray(dome, eye_m, &inside, seen);
    return pixel_coverage(projector, x_px, y_px, &point);
}

double density_solid_angle(const struct varying *seen)
{
    double area[3], length = length3(seen->at);
    cross3(seen->dx, seen->dy, area);
    return fabs(dot3(seen->at, area)) / (length * length * length);
}

void density_stretch(const double jacobian[4], double values[2])
{
    const double *j = jacobian;
    double squares = j[0] * j[0] + j[1] * j[1] + j[2] * j[2] + j[3] * j[3];
    double area = fabs(j[0] * j[3] - j[1] * j[2]);
    values[0] = 0.5 * (sqrt(squares + 2 * area) + sqrt(fmax(squares - 2 * area, 0)));
    values[1] = values[0] > 0 ? area / values[0] : 0;
}

int cupola_density_map(const cupola_dome *dome, int output, const double eye_m[3],
                       float *solid_angles_sr, struct cupola_error *error)
{
    if (!dome || !solid_angles_sr)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: a %s",
                         dome ? "solid_angles_sr" : "dome", dome ? "float for each pixel" : "dome");
    if (output < 0 || output >= dome->rig.output_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "output is %d; allowed: 0 to %d", output,
                         dome->rig.output_count - 1);
    const double *eye = eye_m ? eye_m : dome->rig.eye_m;
    double from_centre_m = length3(eye), radius_m = dome->rig.screen.radius_m;
    if (!(from_centre_m < radius_m))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "eye is %g m from the screen's centre; allowed: less than its radius, %g "
                         "m",
                         from_centre_m, radius_m);
    const struct cupola_output *size = &dome->rig.outputs[output];
    for (int y = 0; y < size->height_px; y++)
        for (int x = 0; x < size->width_px; x++) {
            struct varying seen;
            bool lit = density_ray(dome, output, eye, x + 0.5, y + 0.5, &seen) > 0;
            solid_angles_sr[(size_t)y * (size_t)size->width_px + (size_t)x] =
                lit ? (float)density_solid_angle(&seen) : 0;
        }
    return CUPOLA_OK;
}
