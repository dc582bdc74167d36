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
#include "reference_error.h"
#include "rig_random.h"

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
    const struct compared reference = {plan, atlas, border}, own = {fixture->plan, atlas, border};
    float *expected = reference_image(&reference, 0);
    struct image_error error = image_error_of(&own, 0, shown, expected);
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
