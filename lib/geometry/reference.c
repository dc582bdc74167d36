/* The whole warp in plain C, pixel by pixel; the shaders are compared with it. */
#include "cupola/reference.h"

#include <math.h>
#include <string.h>

#include "bilinear.h"
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

/* One pixel. Nothing is taken from cupola_dome_ray but the same steps in the same order. */
static void warp_pixel(const cupola_plan *plan, int output, const float *atlas,
                       const float border[4], double x_px, double y_px, float color[4])
{
    const cupola_dome *dome = &plan->dome;
    const struct projector *projector = &dome->projectors[output];
    double place[2], base[2], texel[2], sampled[4];
    struct varying lens, point, ray;
    circle_place(projector, x_px, y_px, place);
    lens_ray(projector, place, &lens);
    screen_point(projector, &lens, &point);
    eye_ray(dome, dome->rig.eye_m, &point, &ray);
    double coverage = pixel_coverage(projector, x_px, y_px, &point);
    memcpy(color, border, 4 * sizeof *color);
    int view = view_select(plan->views, plan->view_count, ray.at);
    if (!(coverage > 0) || !view_hit(&plan->views[view], ray.at, base))
        return;
    view_texel(&plan->views[view], base, texel);
    sample_bilinear(&plan->report, atlas, texel, sampled);
    for (int c = 0; c < 4; c++)
        color[c] = (float)((double)border[c] + coverage * (sampled[c] - (double)border[c]));
}

int cupola_reference_warp(const cupola_plan *plan, int output, const float *atlas,
                          const float border[4], float *image)
{
    static const float black[4] = {0, 0, 0, 0};
    if (!plan || !atlas || !image || output < 0 || output >= plan->dome.rig.output_count)
        return CUPOLA_ERROR_ARGUMENT;
    const struct cupola_output *size = &plan->dome.rig.outputs[output];
    for (int y = 0; y < size->height_px; y++)
        for (int x = 0; x < size->width_px; x++)
            warp_pixel(plan, output, atlas, border ? border : black, x + 0.5, y + 0.5,
                       image + 4 * ((size_t)y * (size_t)size->width_px + (size_t)x));
    return CUPOLA_OK;
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
