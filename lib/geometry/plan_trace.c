/* The ray of one place of an image, as the planner looks at it. */
#include <math.h>

#include "plan.h"
#include "vector.h"

/*
 * Towards the rim of a lens of nearly 360 degrees a pixel covers no angle at all across the radius,
 * since the whole rim shows one point, and no finite density would do. There a pixel counts as no
 * narrower than a quarter of the lens's mean radial step; up to 280 degrees this changes nothing.
 */
void plan_widen_collapsed(const struct projector *projector, const double place[2],
                          struct varying *ray)
{
    if (projector->lens.half_fov < PLAN_COLLAPSES_RAD)
        return;
    double r = hypot(place[0], place[1]);
    if (!(r > 0.5))
        return;
    double sine = sin(lens_angle(&projector->lens, fmin(r, 1)));
    double missing = (0.25 * projector->lens.half_fov - sine / r) / projector->radius_px;
    if (!(missing > 0))
        return;
    double tangent[3] = {-place[1] / r, place[0] / r, 0}, in_dome[3];
    transform3(projector->aim, tangent, in_dome);
    for (int i = 0; i < 3; i++) {
        ray->dx[i] += missing * projector->sign[0] * tangent[0] * in_dome[i];
        ray->dy[i] += missing * projector->sign[1] * tangent[1] * in_dome[i];
    }
}

static double inside_frame(const struct projector *projector, double x_px, double y_px)
{
    double across = fmin(x_px, projector->width_px - x_px);
    return fmin(across, fmin(y_px, projector->height_px - y_px));
}

static double inside_screen(const struct projector *projector, const struct varying *point)
{
    if (!projector->capped)
        return HUGE_VAL;
    double slope = hypot(point->dx[2], point->dy[2]) / projector->screen_radius_m;
    double excess = -point->at[2] / projector->screen_radius_m - projector->cap_cosine;
    return excess / fmax(slope, 1e-12);
}

void plan_sample_of(const struct varying *ray, struct plan_sample *sample)
{
    double length = length3(ray->at), normal[3];
    for (int i = 0; i < 3; i++)
        sample->at[i] = ray->at[i] / length;
    double along_x = dot3(ray->dx, sample->at), along_y = dot3(ray->dy, sample->at);
    for (int i = 0; i < 3; i++) {
        sample->dx[i] = (ray->dx[i] - along_x * sample->at[i]) / length;
        sample->dy[i] = (ray->dy[i] - along_y * sample->at[i]) / length;
    }
    cross3(sample->dx, sample->dy, normal);
    double square = larger(dot3(normal, normal), 1e-300);
    cross3(sample->dy, normal, sample->x_of);
    cross3(normal, sample->dx, sample->y_of);
    scale3(sample->x_of, 1 / square);
    scale3(sample->y_of, 1 / square);
}

double plan_trace(const cupola_dome *dome, const double eye_m[3], int output, double x_px,
                  double y_px, struct plan_sample *sample)
{
    const struct projector *projector = &dome->projectors[output];
    struct varying lens, point, seen;
    double place[2];
    double inside_px = (1 - circle_place(projector, x_px, y_px, place)) * projector->radius_px;
    lens_ray(projector, place, &lens);
    plan_widen_collapsed(projector, place, &lens);
    screen_point(projector, &lens, &point);
    eye_ray(dome, eye_m, &point, &seen);
    plan_sample_of(&seen, sample);
    inside_px = fmin(inside_px, inside_frame(projector, x_px, y_px));
    return fmin(inside_px, inside_screen(projector, &point));
}
