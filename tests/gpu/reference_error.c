/* Images against those of the reference: see reference_error.h. */
#include "reference_error.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "worse.h"

static const float *texel_at(const struct cupola_plan_report *report, const float *atlas, int x,
                             int y)
{
    return atlas + 4 * (y * report->atlas_width_px + x);
}

/* One pixel by another view: bilinear, four texels that all lie in the view. */
static void color_by_view(const struct compared *compared, int view, const struct cupola_ray *ray,
                          double color[4])
{
    const struct cupola_plan_report *report = cupola_plan_report(compared->plan);
    double texel[2] = {0.5, 0.5};
    cupola_plan_texel(compared->plan, view, ray->direction, texel);
    int i = (int)floor(texel[0] - 0.5), j = (int)floor(texel[1] - 0.5);
    double u = texel[0] - 0.5 - i, v = texel[1] - 0.5 - j;
    const struct cupola_rect *rect = &cupola_plan_view(compared->plan, view)->rect;
    assert_true(i >= rect->x && j >= rect->y && i + 1 < rect->x + rect->width &&
                j + 1 < rect->y + rect->height);
    for (int c = 0; c < 4; c++) {
        double low = (1.0 - u) * (double)texel_at(report, compared->atlas, i, j)[c] +
                     u * (double)texel_at(report, compared->atlas, i + 1, j)[c];
        double high = (1.0 - u) * (double)texel_at(report, compared->atlas, i, j + 1)[c] +
                      u * (double)texel_at(report, compared->atlas, i + 1, j + 1)[c];
        double edge = (double)compared->border[c];
        color[c] = edge + ray->coverage * ((1.0 - v) * low + v * high - edge);
    }
}

static double color_error(const float *shown, const double expected[4])
{
    double worst = 0.0;
    for (int c = 0; c < 4; c++)
        worst = worse_of(worst, fabs((double)shown[c] - expected[c]));
    return worst;
}

/* Where views have equal claims to a ray, the one that fits best; infinite where one is ahead. */
static double error_by_equal_views(const struct compared *compared, const float *shown,
                                   const struct cupola_ray *ray)
{
    double claims[CUPOLA_VIEWS_MAX] = {0.0}, best = (double)INFINITY;
    int own = cupola_plan_select(compared->plan, ray->direction);
    int views = cupola_plan_view_count(compared->plan);
    for (int v = 0; v < views; v++)
        for (int i = 0; i < 3; i++)
            claims[v] += cupola_plan_view(compared->plan, v)->selector[i] * ray->direction[i];
    for (int v = 0; v < views; v++) {
        double color[4];
        if (v == own || claims[v] < claims[own] - 1e-6)
            continue;
        color_by_view(compared, v, ray, color);
        best = fmin(best, color_error(shown, color));
    }
    return best;
}

struct image_error image_error_of(const struct compared *compared, int output, const float *shown,
                                  const float *expected)
{
    const cupola_dome *dome = cupola_plan_dome(compared->plan);
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[output];
    struct image_error error = {0.0, 0.0, 0, 0};
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            const float *pixel = shown + 4 * (j * size->width_px + i);
            const float *wish = expected + 4 * (j * size->width_px + i);
            const double color[4] = {(double)wish[0], (double)wish[1], (double)wish[2],
                                     (double)wish[3]};
            struct cupola_ray ray;
            cupola_dome_ray(dome, output, NULL, i + 0.5, j + 0.5, &ray);
            bool edge = ray.coverage > 0.0 && ray.coverage < 0.9999;
            double off = color_error(pixel, color), *part = edge ? &error.edge : &error.inside;
            if (!(off <= *part) && ray.coverage > 0.0)
                off = fmin(off, error_by_equal_views(compared, pixel, &ray));
            *part = worse_of(*part, off);
            error.edge_pixels += edge;
            error.lit_pixels += ray.coverage > 0.0;
        }
    return error;
}

float *reference_image(const struct compared *compared, int output)
{
    const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(compared->plan));
    const struct cupola_output *size = &rig->outputs[output];
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    assert_int_equal(
        cupola_reference_warp(compared->plan, output, compared->atlas, compared->border, image),
        CUPOLA_OK);
    return image;
}
