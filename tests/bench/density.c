/* The density test of views that are not planned by the library. */
#include "density.h"

#include <math.h>
#include <stddef.h>

enum { PLACES = 128 /* along a side */, RIM_PLACES = 720 };

void density_each_ray(const cupola_dome *dome, int size_px, density_visit *visit, void *context)
{
    int step = size_px > PLACES ? size_px / PLACES : 1;
    double half = 0.5 * size_px, turn = 2 * 3.14159265358979323846 / RIM_PLACES;
    struct cupola_ray ray;

    for (int j = 0; j < size_px; j += step)
        for (int i = 0; i < size_px; i += step)
            if (cupola_dome_ray(dome, 0, NULL, i + 0.5, j + 0.5, &ray) == 1)
                visit(context, &ray);
    for (int i = 0; i < RIM_PLACES; i++) {
        double radius = 0.999 * half;
        cupola_dome_ray(dome, 0, NULL, half + radius * cos(i * turn), half + radius * sin(i * turn),
                        &ray);
        visit(context, &ray);
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool density_needed(const struct cupola_ray *ray, const double rotation[9], double place[2],
                    double *texels_per_unit)
{
    double ahead = -dot(rotation + 6, ray->direction), j[2][2], sum = 0, area;

    if (!(ahead > 0.05))
        return false;
    for (int row = 0; row < 2; row++) {
        const double *axis = rotation + 3 * row;
        double at = dot(axis, ray->direction) / ahead;
        j[row][0] =
            (dot(axis, ray->direction_dx) + at * dot(rotation + 6, ray->direction_dx)) / ahead;
        j[row][1] =
            (dot(axis, ray->direction_dy) + at * dot(rotation + 6, ray->direction_dy)) / ahead;
        sum += j[row][0] * j[row][0] + j[row][1] * j[row][1];
        if (place)
            place[row] = at;
    }
    area = fabs(j[0][0] * j[1][1] - j[0][1] * j[1][0]);
    *texels_per_unit = (sqrt(sum + 2 * area) + sqrt(fmax(sum - 2 * area, 0))) / (2 * area);
    return isfinite(*texels_per_unit);
}
