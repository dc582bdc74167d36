/* Angles between colours and rays: see direction_error.h. */
#include "direction_error.h"

#include <stdlib.h>

#include "check.h"

static const double coverage_least = 0.1;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* By both products, exact for small and large angles. */
static double angle_between(const double a[3], const double b[3])
{
    double across[3];
    for (int i = 0; i < 3; i++)
        across[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    return atan2(sqrt(dot(across, across)), dot(a, b));
}

/*
 * The place (x, y) beside the pixel whose ray, by the ray's derivatives, comes nearest to the
 * colour: least squares, two normal equations.
 */
static double displacement_px(const struct cupola_ray *ray, const double shown[3])
{
    double excess[3], length = sqrt(dot(shown, shown));
    for (int i = 0; i < 3; i++)
        excess[i] = shown[i] / length - ray->direction[i];
    double xx = dot(ray->direction_dx, ray->direction_dx);
    double xy = dot(ray->direction_dx, ray->direction_dy);
    double yy = dot(ray->direction_dy, ray->direction_dy);
    double x = dot(ray->direction_dx, excess), y = dot(ray->direction_dy, excess);
    double determinant = xx * yy - xy * xy;
    return hypot(yy * x - xy * y, xx * y - xy * x) / determinant;
}

/* Per pixel, the view that its ray falls to; -1 where too little of it is lit. */
static signed char *views_of_pixels(const struct fixture *fixture, int output)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    signed char *views = malloc((size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(views);
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            struct cupola_ray ray;
            cupola_dome_ray(fixture->dome, output, NULL, i + 0.5, j + 0.5, &ray);
            bool counts = ray.coverage > coverage_least;
            views[j * size->width_px + i] =
                (signed char)(counts ? cupola_plan_select(fixture->plan, ray.direction) : -1);
        }
    return views;
}

static bool at_view_border(const signed char *views, const struct cupola_output *size, int i, int j)
{
    int own = views[j * size->width_px + i];
    for (int y = j - 1; y <= j + 1; y++)
        for (int x = i - 1; x <= i + 1; x++) {
            if (x < 0 || y < 0 || x >= size->width_px || y >= size->height_px)
                continue;
            int other = views[y * size->width_px + x];
            if (other >= 0 && other != own)
                return true;
        }
    return false;
}

/* Takes in one pixel. Written so that a colour that is no number counts as infinitely wrong. */
static void count_pixel(struct direction_error *error, const struct cupola_ray *ray,
                        const float *color, bool border, int i, int j)
{
    const double shown[3] = {(double)color[0], (double)color[1], (double)color[2]};
    double deg = angle_between(shown, ray->direction) * (180.0 / 3.14159265358979323846);
    double px = displacement_px(ray, shown);
    if (!(deg <= error->deg)) {
        error->deg = isfinite(deg) ? deg : (double)INFINITY;
        error->deg_at[0] = i;
        error->deg_at[1] = j;
    }
    if (!(px <= error->px)) {
        error->px = isfinite(px) ? px : (double)INFINITY;
        error->px_at[0] = i;
        error->px_at[1] = j;
    }
    double *part = border ? &error->border_px : &error->interior_px;
    if (!(px <= *part))
        *part = isfinite(px) ? px : (double)INFINITY;
    error->pixels++;
    error->border_pixels += border;
}

struct direction_error direction_error_of(const struct fixture *fixture, int output,
                                          const float *image, const cupola_dome *oracle)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    signed char *views = views_of_pixels(fixture, output);
    struct direction_error error = {0};
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            int place = j * size->width_px + i;
            struct cupola_ray ray;
            if (views[place] < 0)
                continue;
            cupola_dome_ray(oracle, output, NULL, i + 0.5, j + 0.5, &ray);
            count_pixel(&error, &ray, image + 4 * place, at_view_border(views, size, i, j), i, j);
        }
    free(views);
    return error;
}
