/* The whole warp in plain C, pixel by pixel; the shaders are compared with it. */
#include "cupola/reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bilinear.h"
#include "filter.h"
#include "plan.h"
#include "vector.h"
#include "views.h"

/* A texel; places beyond the atlas count as its edge, as GL_CLAMP_TO_EDGE has it. */
static const float *texel_at(const struct cupola_plan_report *report, const float *atlas, int x,
                             int y)
{
    int width = report->atlas_width_px, height = report->atlas_height_px;
    x = x < 0 ? 0 : x >= width ? width - 1 : x;
    y = y < 0 ? 0 : y >= height ? height - 1 : y;
    return atlas + 4 * ((size_t)y * (size_t)width + (size_t)x);
}

static void sample_nearest(const struct cupola_plan_report *report, const float *atlas,
                           const double texel[2], double color[4])
{
    const float *found = texel_at(report, atlas, (int)floor(texel[0]), (int)floor(texel[1]));
    for (int c = 0; c < 4; c++)
        color[c] = (double)found[c];
}

static void sample_bilinear(const struct cupola_plan_report *report, const float *atlas,
                            const double texel[2], double color[4])
{
    double x = texel[0] - 0.5, y = texel[1] - 0.5;
    int i = (int)floor(x), j = (int)floor(y);
    const float *corners[4] = {
        texel_at(report, atlas, i, j),
        texel_at(report, atlas, i + 1, j),
        texel_at(report, atlas, i, j + 1),
        texel_at(report, atlas, i + 1, j + 1),
    };
    bilinear_mix(corners, x - i, y - j, color);
}

/* Half a texel off each way: where the hit is a texel's middle, 1 2 1 in either direction. */
static void sample_nine(const struct cupola_plan_report *report, const float *atlas,
                        const double texel[2], double color[4])
{
    for (int c = 0; c < 4; c++)
        color[c] = 0;
    for (int k = 0; k < 4; k++) {
        double part[4];
        const double near[2] = {texel[0] + (k % 2 ? 0.5 : -0.5), texel[1] + (k / 2 ? 0.5 : -0.5)};
        sample_bilinear(report, atlas, near, part);
        for (int c = 0; c < 4; c++)
            color[c] += 0.25 * part[c];
    }
}

/* What a filter needs over all of an image: patterns by their number of places. */
struct filter_patterns {
    struct cupola_filter filter;
    struct pattern of[CUPOLA_RAYS_MAX + 1];
};

/* One ray: the view that it falls to, and there the texels round its hit. False: none. */
static bool sample_ray(const cupola_plan *plan, const struct cupola_filter *filter,
                       const float *atlas, const double ray[3], double color[4])
{
    double base[2], texel[2];
    int view = view_select(plan->views, plan->view_count, ray);
    if (!view_hit(&plan->views[view], ray, base))
        return false;
    view_texel(&plan->views[view], base, texel);
    if (filter->method == CUPOLA_ANTIALIASING_NONE)
        sample_nearest(&plan->report, atlas, texel, color);
    else if (filter->method == CUPOLA_ANTIALIASING_TEXTURE && filter->samples == 9)
        sample_nine(&plan->report, atlas, texel, color);
    else
        sample_bilinear(&plan->report, atlas, texel, color);
    return true;
}

/* One pixel. Nothing is taken from cupola_dome_ray but the same steps in the same order. */
static void warp_pixel(const cupola_plan *plan, int output, const struct filter_patterns *patterns,
                       const float *atlas, const float border[4], int x, int y, float color[4])
{
    struct filter_pixel pixel;
    struct filter_place places[CUPOLA_RAYS_MAX];
    double sum[4] = {0, 0, 0, 0}, weight = 0;
    memcpy(color, border, 4 * sizeof *color);
    filter_pixel_prepare(plan, output, x, y, &pixel);
    if (!(pixel.coverage > 0))
        return;
    const struct pattern *pattern = &patterns->of[filter_pattern_count(&patterns->filter, &pixel)];
    int count = filter_places(&patterns->filter, pattern, &pixel, places);
    for (int k = 0; k < count; k++) {
        double ray[3], sampled[4];
        filter_direction(&pixel, &places[k], ray);
        if (!sample_ray(plan, &patterns->filter, atlas, ray, sampled))
            continue;
        weight += places[k].weight;
        for (int c = 0; c < 4; c++)
            sum[c] += places[k].weight * sampled[c];
    }
    for (int c = 0; c < 4 && weight > 0; c++)
        color[c] =
            (float)((double)border[c] + pixel.coverage * (sum[c] / weight - (double)border[c]));
}

static void prepare_patterns(struct filter_patterns *patterns)
{
    const struct cupola_filter *filter = &patterns->filter;
    bool adaptive = filter->method == CUPOLA_ANTIALIASING_ADAPTIVE;
    if (adaptive || filter->method == CUPOLA_ANTIALIASING_CONE)
        for (int count = adaptive ? 1 : filter->samples; count <= filter->samples; count++)
            filter_pattern(filter, count, &patterns->of[count]);
}

int cupola_reference_filter(const cupola_plan *plan, int output, const struct cupola_filter *filter,
                            const float *atlas, const float border[4], float *image)
{
    static const float black[4] = {0, 0, 0, 0};
    struct cupola_filter complete;
    if (!plan || !atlas || !image || output < 0 || output >= plan->dome.rig.output_count)
        return CUPOLA_ERROR_ARGUMENT;
    if (filter_check(filter, &complete, NULL) != CUPOLA_OK)
        return CUPOLA_ERROR_ARGUMENT;
    struct filter_patterns *patterns = malloc(sizeof *patterns);
    if (!patterns)
        return CUPOLA_ERROR_MEMORY;
    patterns->filter = complete;
    prepare_patterns(patterns);
    const struct cupola_output *size = &plan->dome.rig.outputs[output];
    for (int y = 0; y < size->height_px; y++)
        for (int x = 0; x < size->width_px; x++)
            warp_pixel(plan, output, patterns, atlas, border ? border : black, x, y,
                       image + 4 * ((size_t)y * (size_t)size->width_px + (size_t)x));
    free(patterns);
    return CUPOLA_OK;
}

int cupola_reference_warp(const cupola_plan *plan, int output, const float *atlas,
                          const float border[4], float *image)
{
    return cupola_reference_filter(plan, output, NULL, atlas, border, image);
}

int cupola_reference_views(const cupola_plan *plan,
                           void (*color)(const double direction[3], float rgba[4], void *user),
                           void *user, float *atlas)
{
    if (!plan || !color || !atlas)
        return CUPOLA_ERROR_ARGUMENT;
    size_t width = (size_t)plan->report.atlas_width_px;
    memset(atlas, 0, 4 * sizeof *atlas * width * (size_t)plan->report.atlas_height_px);
    for (int v = 0; v < plan->view_count; v++) {
        const struct cupola_view *view = &plan->views[v];
        for (int y = 0; y < view->rect.height; y++)
            for (int x = 0; x < view->rect.width; x++) {
                double u = (x + 0.5) / view->rect.width, w = (y + 0.5) / view->rect.height;
                double direction[3] = {view->left + u * (view->right - view->left),
                                       view->bottom + w * (view->top - view->bottom), -1};
                scale3(direction, 1 / length3(direction));
                transform3_back(view->rotation, direction, direction);
                size_t row = (size_t)(view->rect.y + y), column = (size_t)(view->rect.x + x);
                color(direction, atlas + 4 * (row * width + column), user);
            }
    }
    return CUPOLA_OK;
}
