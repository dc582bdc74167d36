/* From points to the image of one projector, within what it lights and beyond. */
#include <cupola/projection.h>

#include "oracle.h"

static void a_point_comes_back_to_the_pixel_that_lights_it(void **state)
{
    (void)state;
    uint64_t seed = 61;
    int tried = 0;
    double worst_px = 0, worst_shifted_px = 0;
    for (int i = 0; i < 200; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        cupola_dome *dome = dome_of(&rig);
        struct cupola_output shifted = rig.outputs[0];
        shifted.aim.yaw_rad += 1e-5;
        for (int j = 0; j < 30; j++) {
            double x = random_between(&seed, 0, rig.outputs[0].width_px), pixel[2];
            double y = random_between(&seed, 0, rig.outputs[0].height_px);
            struct cupola_ray ray;
            if (cupola_dome_ray(dome, 0, NULL, x, y, &ray) != 1 || ray.coverage < 1)
                continue;
            assert_int_equal(cupola_output_pixel(&rig.outputs[0], ray.point_m, pixel, NULL), 1);
            worst_px = fmax(worst_px, hypot(pixel[0] - x, pixel[1] - y));
            assert_true(cupola_output_pixel(&shifted, ray.point_m, pixel, NULL) >= 0);
            worst_shifted_px = fmax(worst_shifted_px, hypot(pixel[0] - x, pixel[1] - y));
            tried++;
        }
        cupola_dome_destroy(&dome);
    }
    check_at_least(tried, 2000);
    check_at_most(worst_px, 1e-6);
    check_at_least(worst_shifted_px, 1e-3); /* would catch an aim that is off by 1e-5 rad */
}

static struct cupola_output output_of(enum cupola_lens_model model, double fov_deg)
{
    struct cupola_output output = {.lens = {.model = model, .fov_rad = fov_deg * pi / 180}};
    if (model == CUPOLA_LENS_POLYNOMIAL)
        memcpy(output.lens.k, (double[]){1, -0.1, 0.01, 0}, sizeof output.lens.k);
    if (model == CUPOLA_LENS_TABLE) {
        output.lens.table_count = 3;
        output.lens.table[0] = (struct cupola_lens_sample){0.3, 0.25};
        output.lens.table[1] = (struct cupola_lens_sample){0.9, 0.7};
        output.lens.table[2] = (struct cupola_lens_sample){1.5, 1};
    }
    return output;
}

/* From the axis to just before the way straight back, whatever the lens. */
static void the_image_radius_grows_beyond_the_rim_without_a_step(void **state)
{
    (void)state;
    for (int model = 0; cupola_lens_model_name(model); model++) {
        struct cupola_output output = output_of((enum cupola_lens_model)model, 140);
        double last = 0;
        for (double angle = 0.001; angle < 3.1; angle += 0.001) {
            double point[3] = {sin(angle), 0, -cos(angle)}, pixel[2];
            int lit = cupola_output_pixel(&output, point, pixel, NULL);
            assert_int_equal(lit, angle <= 70 * pi / 180);
            double r = (pixel[0] - 512) / 512;
            check_near(pixel[1], 512, 1e-9);
            check_at_least(r - last, 1e-6);
            check_at_most(r - last, angle < 2.8 ? 0.05 : 10); /* stereographic: steep at the end */
            last = r;
        }
    }
}

static void closed_forms_go_on_as_they_are(void **state)
{
    (void)state;
    struct cupola_output output = output_of(CUPOLA_LENS_ANGULAR, 100);
    double point[3] = {0, sin(1.4), -cos(1.4)}, pixel[2];
    assert_int_equal(cupola_output_pixel(&output, point, pixel, NULL), 0);
    check_near(pixel[1], 512 + 512 * 1.4 / (50 * pi / 180), 1e-9);
    output = output_of(CUPOLA_LENS_HEMISPHERIC, 100);
    assert_int_equal(cupola_output_pixel(&output, point, pixel, NULL), 0);
    check_near(pixel[1], 512 + 512 * sin(1.4) / sin(50 * pi / 180), 1e-9);
}

static void nonsense_is_refused_and_nothing_written(void **state)
{
    (void)state;
    struct cupola_output output = {.position_m = {0.1, 0, 0}};
    struct cupola_error error;
    double pixel[2] = {7, 8}, there[3] = {0.1, 0, 0}, infinite[3] = {HUGE_VAL, 0, 0};
    assert_int_equal(cupola_output_pixel(&output, there, pixel, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "where the lens is"));
    assert_int_equal(cupola_output_pixel(&output, infinite, pixel, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_output_pixel(NULL, there, pixel, &error), CUPOLA_ERROR_ARGUMENT);
    output.lens.fov_rad = -1;
    assert_int_equal(cupola_output_pixel(&output, (double[3]){0, 0, -1}, pixel, &error),
                     CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "field of view"));
    check_near(pixel[0], 7, 0);
    check_near(pixel[1], 8, 0);
}

static void far_and_near_points_are_points_like_others(void **state)
{
    (void)state;
    struct cupola_output output = output_of(CUPOLA_LENS_EQUISOLID, 150);
    double wanted[2], pixel[2];
    int lit = cupola_output_pixel(&output, (double[3]){0.3, -0.4, -1}, wanted, NULL);
    static const double sizes[] = {1e-300, 1e-170, 1e-9, 1e9, 1e200, 1e307};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        double point[3] = {0.3 * sizes[i], -0.4 * sizes[i], -sizes[i]};
        assert_int_equal(cupola_output_pixel(&output, point, pixel, NULL), lit);
        check_near(pixel[0], wanted[0], 1e-9);
        check_near(pixel[1], wanted[1], 1e-9);
    }
}

static void many_points_are_as_good_as_each_alone(void **state)
{
    (void)state;
    struct cupola_output output = output_of(CUPOLA_LENS_EQUISOLID, 150);
    double points[3 * 20], pixels[2 * 20];
    int lit = 0;
    for (int i = 0; i < 20; i++) {
        double angle = 0.1 * i;
        memcpy(points + 3 * i, (double[3]){sin(angle), 0.1, -cos(angle)}, 3 * sizeof *points);
    }
    assert_in_range(cupola_output_pixels(&output, 20, points, pixels, NULL), 12, 14);
    for (int i = 0; i < 20; i++) {
        double pixel[2];
        lit += cupola_output_pixel(&output, points + 3 * i, pixel, NULL);
        assert_memory_equal(pixel, pixels + 2 * i, sizeof pixel);
    }
    assert_int_equal(cupola_output_pixels(&output, 20, points, pixels, NULL), lit);
    assert_int_equal(cupola_output_pixels(&output, 0, points, pixels, NULL), 0);
    assert_int_equal(cupola_output_pixels(&output, -1, points, pixels, NULL),
                     CUPOLA_ERROR_ARGUMENT);
    points[4] = nan("");
    assert_int_equal(cupola_output_pixels(&output, 20, points, pixels, NULL),
                     CUPOLA_ERROR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_point_comes_back_to_the_pixel_that_lights_it),
        cmocka_unit_test(the_image_radius_grows_beyond_the_rim_without_a_step),
        cmocka_unit_test(closed_forms_go_on_as_they_are),
        cmocka_unit_test(nonsense_is_refused_and_nothing_written),
        cmocka_unit_test(far_and_near_points_are_points_like_others),
        cmocka_unit_test(many_points_are_as_good_as_each_alone),
    };
    return cmocka_run_group_tests_name("projection", tests, NULL, NULL);
}
