/*
 * What a view may see of spheres and boxes: each plane of frustum and borders by itself, so what is
 * beyond none of them counts as seen, even where it misses an edge or a corner.
 */
#include <math.h>

#include "cupola/plan.h"

/*
 * How far rounding may move a plane of floats at a place: each of the four terms is off by half a
 * last digit of a float, 6e-8 of itself, and so is the projection matrix with which hosts draw.
 */
static const double slack = 1e-6;

/*
 * Whether all of a box round `center` that reaches `reach` along each axis, widened by `radius`,
 * lies beyond the plane. Not a number: no.
 */
static bool is_beyond(const float plane[4], const double center[3], const double reach[3],
                      double radius)
{
    double inside = (double)plane[3], size = fabs(inside);
    for (int i = 0; i < 3; i++) {
        double along = (double)plane[i] * center[i], across = fabs((double)plane[i]) * reach[i];
        inside += along + across;
        size += fabs(along) + across;
    }
    return inside + radius < -slack * size;
}

static int sees(const struct cupola_camera *camera, const double center[3], const double reach[3],
                double radius)
{
    for (int p = 0; p < 6; p++)
        if (is_beyond(camera->planes[p], center, reach, radius))
            return 0;
    for (int b = 0; b < camera->border_count && b < CUPOLA_VIEWS_MAX - 1; b++)
        if (is_beyond(camera->borders[b], center, reach, radius))
            return 0;
    return 1;
}

int cupola_camera_sees_sphere(const struct cupola_camera *camera, const float center[3],
                              float radius)
{
    static const double point[3] = {0, 0, 0};
    if (!camera || !center)
        return CUPOLA_ERROR_ARGUMENT;
    const double place[3] = {(double)center[0], (double)center[1], (double)center[2]};
    return sees(camera, place, point, radius < 0 ? 0.0 : (double)radius);
}

int cupola_camera_sees_box(const struct cupola_camera *camera, const float least[3],
                           const float most[3])
{
    double center[3], reach[3];
    if (!camera || !least || !most)
        return CUPOLA_ERROR_ARGUMENT;
    for (int i = 0; i < 3; i++) {
        center[i] = ((double)least[i] + (double)most[i]) / 2;
        reach[i] = fabs((double)most[i] - (double)least[i]) / 2;
    }
    return sees(camera, center, reach, 0.0);
}
