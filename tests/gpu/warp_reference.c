/*
 * The warp on the GPU against the warp in plain C, whole images from one and the same atlas: every
 * pixel, those at the rim and the cap's edge too, with a border colour that is not black.
 *
 * The atlas is noise, so a tap at a wrong place shows at once. What may differ:
 *   - the place, by the rounding of rays and of coordinates from 0 to 1 in an atlas of up to 1500
 *     texels: 0.001 texels, and so much of the noise's range;
 *   - the filter's weights: in floats for float formats, of 8 bits for RGBA8 on llvmpipe, and of 8
 *     bits for every format on most GPUs: 1/512 each way;
 *   - coverage at rim and cap, by 1e-4 (stages.c);
 *   - a ray on the border of two views falls to either.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "rig_random.h"
#include "worse.h"

static const double bar_float = 0.004, bar_bytes = 0.012, bar_edge = 1e-4;
static const float border[4] = {0.1f, 0.9f, 0.3f, 0.6f};

enum { RIGS = 12, FORMATS = 3 };

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 6001 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, 0.6);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    rig.outputs[0].lens = random_lens(&seed, model, radians(random_between(&seed, 90.0, 170.0)));
    rig.outputs[0].width_px = 200;
    rig.outputs[0].height_px = 125;
    rig.outputs[0].circle = (struct cupola_circle){100.0, 60.0, number % 2 ? 100.0 : 60.0};
    rig.outputs[0].aim.yaw_rad *= 0.2;
    rig.outputs[0].aim.pitch_rad *= 0.2;
    rig.screen.cap_rad = number % 3 == 0 ? 0.0 : radians(60.0);
    return rig;
}

static const float *texel_at(const struct cupola_plan_report *report, const float *atlas, int x,
                             int y)
{
    return atlas + 4 * (y * report->atlas_width_px + x);
}

/* One pixel by another view: bilinear, four texels that all lie in the view. */
static void color_by_view(const struct fixture *fixture, const float *atlas, int view,
                          const struct cupola_ray *ray, double color[4])
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    double texel[2] = {0.5, 0.5};
    cupola_plan_texel(fixture->plan, view, ray->direction, texel);
    int i = (int)floor(texel[0] - 0.5), j = (int)floor(texel[1] - 0.5);
    double u = texel[0] - 0.5 - i, v = texel[1] - 0.5 - j;
    const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, view)->rect;
    assert_true(i >= rect->x && j >= rect->y && i + 1 < rect->x + rect->width &&
                j + 1 < rect->y + rect->height);
    for (int c = 0; c < 4; c++) {
        double low = (1.0 - u) * (double)texel_at(report, atlas, i, j)[c] +
                     u * (double)texel_at(report, atlas, i + 1, j)[c];
        double high = (1.0 - u) * (double)texel_at(report, atlas, i, j + 1)[c] +
                      u * (double)texel_at(report, atlas, i + 1, j + 1)[c];
        double edge = (double)border[c];
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
static double error_by_equal_views(const struct fixture *fixture, const float *atlas,
                                   const float *shown, const struct cupola_ray *ray)
{
    double claims[CUPOLA_VIEWS_MAX] = {0.0}, best = (double)INFINITY;
    int own = cupola_plan_select(fixture->plan, ray->direction);
    int views = cupola_plan_view_count(fixture->plan);
    for (int v = 0; v < views; v++)
        for (int i = 0; i < 3; i++)
            claims[v] += cupola_plan_view(fixture->plan, v)->selector[i] * ray->direction[i];
    for (int v = 0; v < views; v++) {
        double color[4];
        if (v == own || claims[v] < claims[own] - 1e-6)
            continue;
        color_by_view(fixture, atlas, v, ray, color);
        best = fmin(best, color_error(shown, color));
    }
    return best;
}

struct image_error {
    double inside, edge; /* all of the pixel lit or none; a part of it */
    int edge_pixels, lit_pixels;
};

static struct image_error image_error_of(const struct fixture *fixture, const float *atlas,
                                         const float *shown, const float *expected)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    struct image_error error = {0.0, 0.0, 0, 0};
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            const float *pixel = shown + 4 * (j * size->width_px + i);
            const float *wish = expected + 4 * (j * size->width_px + i);
            const double color[4] = {(double)wish[0], (double)wish[1], (double)wish[2],
                                     (double)wish[3]};
            struct cupola_ray ray;
            cupola_dome_ray(fixture->dome, 0, NULL, i + 0.5, j + 0.5, &ray);
            bool edge = ray.coverage > 0.0 && ray.coverage < 0.9999;
            double off = color_error(pixel, color), *part = edge ? &error.edge : &error.inside;
            if (!(off <= *part) && ray.coverage > 0.0)
                off = fmin(off, error_by_equal_views(fixture, atlas, pixel, &ray));
            *part = worse_of(*part, off);
            error.edge_pixels += edge;
            error.lit_pixels += ray.coverage > 0.0;
        }
    return error;
}

static float *reference_of(const struct fixture *fixture, const cupola_plan *plan,
                           const float *atlas)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    assert_int_equal(cupola_reference_warp(plan, 0, atlas, border, image), CUPOLA_OK);
    return image;
}

static void set_format(struct fixture *fixture, int number, int format)
{
    struct cupola_gl_params params = {.format = (enum cupola_format)format,
                                      .table = (enum cupola_table)(number / 2 % 6)};
    memcpy(params.border, border, sizeof params.border);
    fixture_replace_gl(fixture, &params);
    fixture_paint(fixture, PAINT_NOISE);
}

static struct image_error error_of_warp(const struct fixture *fixture, const cupola_plan *plan)
{
    float *atlas = fixture_atlas(fixture);
    float *shown = fixture_warp(fixture, 0);
    float *expected = reference_of(fixture, plan, atlas);
    struct image_error error = image_error_of(fixture, atlas, shown, expected);
    free(expected);
    free(shown);
    free(atlas);
    return error;
}

static void the_image_is_that_of_the_reference(void **state)
{
    (void)state;
    static const char *const names[FORMATS] = {"rgba8", "rgba16f", "rgba32f"};
    double inside[FORMATS] = {0.0}, edge[FORMATS] = {0.0};
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(number);
        struct fixture fixture;
        fixture_make(&rig, NULL, NULL, &fixture);
        for (int format = 0; format < FORMATS; format++) {
            set_format(&fixture, number, format);
            struct image_error error = error_of_warp(&fixture, fixture.plan);
            double bar = format == CUPOLA_FORMAT_RGBA8 ? bar_bytes : bar_float;
            check_at_least(error.lit_pixels, 2000);
            check_at_least(error.edge_pixels, 200);
            check_at_most(error.inside, bar);
            check_at_most(error.edge, bar + bar_edge);
            inside[format] = fmax(inside[format], error.inside);
            edge[format] = fmax(edge[format], error.edge);
        }
        fixture_release(&fixture);
    }
    for (int format = 0; format < FORMATS; format++)
        printf("%s: at most %.2g apart, at the edge %.2g\n", names[format], inside[format],
               edge[format]);
}

static void a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(0), turned = rig, shifted = rig;
    struct fixture fixture;
    turned.outputs[0].aim.pitch_rad += radians(0.1);
    shifted.outputs[0].circle.center_x_px += 1.0;
    const struct cupola_rig *const wrongs[2] = {&turned, &shifted};
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int format = 0; format < FORMATS; format++) {
        double bar = format == CUPOLA_FORMAT_RGBA8 ? bar_bytes : bar_float;
        set_format(&fixture, 0, format);
        for (int i = 0; i < 2; i++) {
            cupola_plan *plan = fixture_wrong_plan(&fixture, wrongs[i]);
            struct image_error error = error_of_warp(&fixture, plan);
            check_at_least(error.inside, 2.0 * bar);
            check_at_least(error.edge, 2.0 * (bar + bar_edge));
            cupola_plan_destroy(&plan);
        }
    }
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_image_is_that_of_the_reference),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught),
    };
    return run_gpu_group("warp_reference", tests);
}
