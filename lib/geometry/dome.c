/* Questions to a dome: pixel to point and ray, direction to pixel. */
#include "dome.h"

#include <stdlib.h>

#include "error.h"
#include "vector.h"

int cupola_dome_create(const struct cupola_rig *rig, cupola_dome **dome, struct cupola_error *error)
{
    struct cupola_rig complete;
    int status = cupola_rig_complete(rig, &complete, error);
    if (status != CUPOLA_OK)
        return status;
    if (!dome)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "dome is NULL; allowed: a place for it");
    cupola_dome *made = calloc(1, sizeof *made);
    if (!made)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a dome (%zu bytes)",
                         sizeof *made);
    made->rig = complete;
    rotation_x(complete.tilt_rad, made->tilt);
    for (int i = 0; i < complete.output_count; i++)
        projector_prepare(&complete.outputs[i], &complete.screen, &made->projectors[i]);
    *dome = made;
    return CUPOLA_OK;
}

void cupola_dome_destroy(cupola_dome **dome)
{
    if (!dome)
        return;
    free(*dome);
    *dome = NULL;
}

const struct cupola_rig *cupola_dome_rig(const cupola_dome *dome)
{
    return dome ? &dome->rig : NULL;
}

void cupola_dome_to_camera(const cupola_dome *dome, const double dome_vector[3],
                           double camera_vector[3])
{
    if (dome && dome_vector && camera_vector)
        transform3(dome->tilt, dome_vector, camera_vector);
}

void cupola_dome_from_camera(const cupola_dome *dome, const double camera_vector[3],
                             double dome_vector[3])
{
    if (dome && camera_vector && dome_vector)
        transform3_back(dome->tilt, camera_vector, dome_vector);
}

void eye_ray(const cupola_dome *dome, const double eye_m[3], const struct varying *point,
             struct varying *ray)
{
    double v[3] = {point->at[0] - eye_m[0], point->at[1] - eye_m[1], point->at[2] - eye_m[2]};
    transform3(dome->tilt, v, ray->at);
    transform3(dome->tilt, point->dx, ray->dx);
    transform3(dome->tilt, point->dy, ray->dy);
}

void eye_point(const cupola_dome *dome, const double eye_m[3], const double direction[3],
               double point_m[3])
{
    double u[3], radius = dome->rig.screen.radius_m;
    transform3_back(dome->tilt, direction, u);
    scale3(u, 1 / length3(u));
    double along = dot3(eye_m, u);
    double t = sqrt(along * along - dot3(eye_m, eye_m) + radius * radius) - along;
    for (int i = 0; i < 3; i++)
        point_m[i] = eye_m[i] + t * u[i];
}

/* The eye to use, or NULL if the question makes no sense. */
static const double *check_question(const cupola_dome *dome, int output, const double *eye_m)
{
    if (!dome || output < 0 || output >= dome->rig.output_count)
        return NULL;
    if (!eye_m)
        return dome->rig.eye_m;
    return length3(eye_m) < dome->rig.screen.radius_m ? eye_m : NULL;
}

/* The change of a unit vector when the vector of length `length` changes by `change`. */
static void unit_change(const double unit[3], double length, const double change[3],
                        double result[3])
{
    double along = dot3(unit, change);
    for (int i = 0; i < 3; i++)
        result[i] = (change[i] - along * unit[i]) / length;
}

int cupola_dome_ray(const cupola_dome *dome, int output, const double eye_m[3], double x_px,
                    double y_px, struct cupola_ray *ray)
{
    const double *eye = check_question(dome, output, eye_m);
    if (!eye || !ray || !isfinite(x_px) || !isfinite(y_px))
        return CUPOLA_ERROR_ARGUMENT;

    const struct projector *projector = &dome->projectors[output];
    double place[2];
    struct varying lens, point, view;
    circle_place(projector, x_px, y_px, place);
    lens_ray(projector, place, &lens);
    screen_point(projector, &lens, &point);
    eye_ray(dome, eye, &point, &view);

    memcpy(ray->point_m, point.at, sizeof ray->point_m);
    memcpy(ray->lens_direction, lens.at, sizeof ray->lens_direction);
    memcpy(ray->direction, view.at, sizeof ray->direction);
    ray->distance_m = length3(view.at);
    scale3(ray->direction, 1 / ray->distance_m);
    unit_change(ray->direction, ray->distance_m, view.dx, ray->direction_dx);
    unit_change(ray->direction, ray->distance_m, view.dy, ray->direction_dy);
    double area[3];
    cross3(ray->direction_dx, ray->direction_dy, area);
    ray->solid_angle_sr = length3(area);
    ray->coverage = pixel_coverage(projector, x_px, y_px, &point);
    return ray->coverage > 0;
}

int cupola_dome_pixel(const cupola_dome *dome, int output, const double eye_m[3],
                      const double direction[3], double pixel_px[2])
{
    const double *eye = check_question(dome, output, eye_m);
    if (!eye || !direction || !pixel_px)
        return CUPOLA_ERROR_ARGUMENT;
    /* By the largest component first: the square of a short vector may be no number of its own. */
    double largest = fmax(fmax(fabs(direction[0]), fabs(direction[1])), fabs(direction[2]));
    if (!(largest > 0 && isfinite(direction[0]) && isfinite(direction[1]) &&
          isfinite(direction[2])))
        return CUPOLA_ERROR_ARGUMENT;

    const struct projector *projector = &dome->projectors[output];
    double point[3], at_lens[3], found[2], radius = dome->rig.screen.radius_m;
    double scaled[3] = {direction[0] / largest, direction[1] / largest, direction[2] / largest};
    eye_point(dome, eye, scaled, point);
    for (int i = 0; i < 3; i++)
        at_lens[i] = point[i] - projector->position_m[i];
    const double slack = 1e-9;
    if (projector->capped && -point[2] / radius < projector->cap_cosine - slack)
        return 0;
    if (!lens_pixel(projector, at_lens, found))
        return 0;
    if (!(found[0] >= 0 && found[0] <= projector->width_px && found[1] >= 0 &&
          found[1] <= projector->height_px))
        return 0;
    memcpy(pixel_px, found, sizeof found);
    return 1;
}
