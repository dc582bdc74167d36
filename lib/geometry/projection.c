/* From points to the image of one projector, beyond what it lights. */
#include "cupola/projection.h"

#include "error.h"
#include "points.h"
#include "vector.h"

/* The curve goes on at least this steep, in image circles per half of the field of view. */
static const double least_steepness = 0.1;

/* Up to where a closed form increases; others end at the rim. */
static double last_angle(const struct lens *lens)
{
    switch (lens->model) {
    case CUPOLA_LENS_HEMISPHERIC:
        return 0.5 * pi - 0.1;
    case CUPOLA_LENS_ANGULAR:
    case CUPOLA_LENS_EQUISOLID:
    case CUPOLA_LENS_STEREOGRAPHIC:
        return pi - 0.1;
    default:
        return 0;
    }
}

static double radius_beyond(const struct lens *lens, double angle)
{
    double last = fmax(last_angle(lens), lens->half_fov);
    if (angle <= last)
        return lens_radius(lens, angle);
    double r = lens_radius(lens, last);
    /* At a rim where the inverse is infinitely steep the curve itself is level. */
    double slope = last > lens->half_fov ? (r - lens_radius(lens, last - 1e-6)) / 1e-6
                                         : 1 / lens_angle_slope(lens, r, last);
    return r + (angle - last) * fmax(slope, least_steepness / lens->half_fov);
}

static int prepare(const struct cupola_output *output, struct projector *projector,
                   struct cupola_error *error)
{
    struct cupola_rig rig = {.screen = {.radius_m = 1000}, .output_count = 1};
    rig.outputs[0] = *output;
    int status = cupola_rig_complete(&rig, &rig, error);
    if (status == CUPOLA_OK)
        projector_prepare(&rig.outputs[0], &rig.screen, projector);
    return status;
}

static int project(const struct projector *projector, const double point_m[3], double pixel_px[2],
                   struct cupola_error *error)
{
    double ray[3], v[3], size = 0;
    for (int i = 0; i < 3; i++) {
        ray[i] = point_m[i] - projector->position_m[i];
        size = isfinite(ray[i]) ? fmax(size, fabs(ray[i])) : HUGE_VAL;
    }
    if (!(size > 0) || !isfinite(size))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "point is (%g, %g, %g); allowed: finite, and not where the lens is",
                         point_m[0], point_m[1], point_m[2]);
    /* Points may be so far or near that their squares are no numbers any more. */
    for (int i = 0; i < 3; i++)
        ray[i] /= size;
    transform3_back(projector->aim, ray, v);
    double across = hypot(v[0], v[1]);
    double r = radius_beyond(&projector->lens, atan2(across, -v[2]));
    for (int i = 0; i < 2; i++) {
        double place = across > 0 ? r * v[i] / across : i == 0 ? r : 0;
        pixel_px[i] = projector->center_px[i] + projector->sign[i] * projector->radius_px * place;
    }
    bool framed = pixel_px[0] >= 0 && pixel_px[1] >= 0 && pixel_px[0] <= projector->width_px &&
                  pixel_px[1] <= projector->height_px;
    return framed && r <= 1;
}

int cupola_output_pixel(const struct cupola_output *output, const double point_m[3],
                        double pixel_px[2], struct cupola_error *error)
{
    if (!output || !point_m || !pixel_px)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL",
                         !output    ? "output"
                         : !point_m ? "point_m"
                                    : "pixel_px");
    struct projector projector;
    int status = prepare(output, &projector, error);
    return status == CUPOLA_OK ? project(&projector, point_m, pixel_px, error) : status;
}

int cupola_output_pixels(const struct cupola_output *output, int count, const double *points_m,
                         double *pixels_px, struct cupola_error *error)
{
    if (!output || !points_m || !pixels_px || count < 0)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         count < 0 ? "count is below 0; allowed: 0 or more"
                                   : "output, points_m or pixels_px is NULL");
    struct projector projector;
    int status = prepare(output, &projector, error), lit = 0;
    for (int i = 0; i < count && status >= 0; i++) {
        status = project(&projector, points_m + 3 * (size_t)i, pixels_px + 2 * (size_t)i, error);
        lit += status > 0;
    }
    return status < 0 ? status : lit;
}
