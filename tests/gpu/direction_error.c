/* Angles between colours and rays: see direction_error.h. */
#include "direction_error.h"

#include <stdlib.h>

#include "check.h"
#include "worse.h"

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

/* What one pixel should show. */
struct expected {
    struct cupola_ray ray;
    int view; /* that the ray falls to; -1 where too little of the pixel is lit */
};

static struct expected *expected_of(const struct fixture *fixture, int output,
                                    const cupola_dome *oracle)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    struct expected *pixels =
        malloc((size_t)size->width_px * (size_t)size->height_px * sizeof *pixels);
    assert_non_null(pixels);
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            struct expected *pixel = &pixels[j * size->width_px + i];
            cupola_dome_ray(oracle, output, NULL, i + 0.5, j + 0.5, &pixel->ray);
            bool counts = pixel->ray.coverage > coverage_least;
            pixel->view = counts ? cupola_plan_select(fixture->plan, pixel->ray.direction) : -1;
        }
    return pixels;
}

static bool at_view_border(const struct expected *pixels, const struct cupola_output *size, int i,
                           int j)
{
    int own = pixels[j * size->width_px + i].view;
    for (int y = j - 1; y <= j + 1; y++)
        for (int x = i - 1; x <= i + 1; x++) {
            if (x < 0 || y < 0 || x >= size->width_px || y >= size->height_px)
                continue;
            int other = pixels[y * size->width_px + x].view;
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
        error->deg = worse_of(error->deg, deg);
        error->deg_at[0] = i;
        error->deg_at[1] = j;
    }
    if (!(px <= error->px)) {
        error->px = worse_of(error->px, px);
        error->px_at[0] = i;
        error->px_at[1] = j;
    }
    double *part = border ? &error->border_px : &error->interior_px;
    *part = worse_of(*part, px);
    error->pixels++;
    error->border_pixels += border;
}

struct direction_error direction_error_of(const struct fixture *fixture, int output,
                                          const float *image, const cupola_dome *oracle)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    struct expected *pixels = expected_of(fixture, output, oracle);
    struct direction_error error = {.deg = 0};
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            int place = j * size->width_px + i;
            if (pixels[place].view < 0)
                continue;
            count_pixel(&error, &pixels[place].ray, image + 4 * place,
                        at_view_border(pixels, size, i, j), i, j);
        }
    free(pixels);
    return error;
}
