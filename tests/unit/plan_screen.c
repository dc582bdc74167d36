/* Plans for screens that end within the image, and for images of a few pixels. */
#include <string.h>

#include <cupola/cupola.h>

#include "check.h"

static double radians(double degrees)
{
    return degrees * (3.14159265358979323846 / 180);
}

static cupola_plan *plan_of(const struct cupola_rig *rig, enum cupola_layout layout,
                            struct cupola_error *error)
{
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    struct cupola_plan_params params = {.layout = layout};
    assert_int_equal(cupola_dome_create(rig, &dome, error), CUPOLA_OK);
    cupola_plan_create(dome, &params, &plan, error);
    cupola_dome_destroy(&dome);
    return plan;
}

static struct cupola_rig capped(double cap_deg, int size_px)
{
    struct cupola_rig rig = {.screen.cap_rad = radians(cap_deg)};
    rig.outputs[0].width_px = rig.outputs[0].height_px = size_px;
    return rig;
}

static void the_smallest_screen_is_found_whatever_the_size(void **state)
{
    (void)state;
    const int sizes[] = {64, 200, 201, 317, 600, 1000};
    const double caps_deg[] = {0.8, 1, 1.5, 2, 3, 7};
    for (int s = 0; s < 6; s++)
        for (int c = 0; c < 6; c++)
            for (int turned = 0; turned < 2; turned++) {
                struct cupola_error error = {0};
                struct cupola_rig rig = capped(caps_deg[c], sizes[s]);
                rig.outputs[0].aim.yaw_rad = turned * radians(31.7);
                cupola_plan *plan = plan_of(&rig, CUPOLA_LAYOUT_AUTO, &error);
                if (!plan)
                    fail_msg("%d px, %g deg: %s", sizes[s], caps_deg[c], error.message);
                /* Angular, 180 degrees: a cap in the middle is a disc. Where it is a fraction of a
                 * pixel, the grid makes a polygon of a dozen corners of it. */
                double radius_px = caps_deg[c] / 90 * 0.5 * sizes[s];
                if (!turned)
                    check_near(cupola_plan_report(plan)->pixels,
                               3.14159265358979 * radius_px * radius_px,
                               0.02 * 3.2 * radius_px * radius_px);
                cupola_plan_destroy(&plan);
            }
}

static void what_the_cap_hides_does_not_count_against_a_layout(void **state)
{
    (void)state;
    const double caps_deg[] = {60, 66, 70, 78, 79.9};
    for (int c = 0; c < 5; c++) {
        struct cupola_error error = {0};
        struct cupola_rig rig = capped(caps_deg[c], 1024);
        cupola_plan *plan = plan_of(&rig, CUPOLA_LAYOUT_ASYMMETRIC, &error);
        if (!plan)
            fail_msg("%g deg: %s", caps_deg[c], error.message);
        check_near(cupola_plan_report(plan)->seen_fov_rad, radians(2 * caps_deg[c]), radians(1e-3));
        cupola_plan_destroy(&plan);
    }
    struct cupola_error error = {0};
    struct cupola_rig rig = capped(80.1, 1024);
    assert_null(plan_of(&rig, CUPOLA_LAYOUT_ASYMMETRIC, &error));
    assert_int_equal(error.status, CUPOLA_ERROR_LAYOUT);
}

static void an_image_may_be_a_pixel(void **state)
{
    (void)state;
    const int sizes[][2] = {{1, 1}, {2, 2}, {3, 1}, {1, 7}, {5, 4}, {40, 30}};
    const double fovs_deg[] = {30, 90, 180, 220, 360};
    for (int s = 0; s < 6; s++)
        for (int f = 0; f < 5; f++) {
            struct cupola_error error = {0};
            struct cupola_rig rig = {.outputs[0].lens.fov_rad = radians(fovs_deg[f])};
            rig.outputs[0].width_px = sizes[s][0];
            rig.outputs[0].height_px = sizes[s][1];
            cupola_plan *plan = plan_of(&rig, CUPOLA_LAYOUT_AUTO, &error);
            if (!plan)
                fail_msg("%d x %d, %g deg: %s", sizes[s][0], sizes[s][1], fovs_deg[f],
                         error.message);
            cupola_plan_destroy(&plan);
        }
}

static void a_screen_that_nothing_lights_is_refused(void **state)
{
    (void)state;
    struct cupola_error error = {0};
    struct cupola_rig rig = capped(10, 256);
    rig.outputs[0].aim.yaw_rad = radians(150);
    assert_null(plan_of(&rig, CUPOLA_LAYOUT_AUTO, &error));
    assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "no pixel"));
}

static void nothing_in_place_of_a_plan_or_a_dome_is_an_error_and_no_crash(void **state)
{
    (void)state;
    const double forward[3] = {0, 0, -1};
    double place[3] = {7, 7, 7};
    struct cupola_ray ray;
    struct cupola_camera camera;
    assert_null(cupola_dome_rig(NULL));
    assert_int_equal(cupola_dome_ray(NULL, 0, NULL, 1, 1, &ray), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_dome_pixel(NULL, 0, NULL, forward, place), CUPOLA_ERROR_ARGUMENT);
    cupola_dome_to_camera(NULL, forward, place);
    cupola_dome_from_camera(NULL, forward, place);
    check_near(place[0], 7, 0);
    assert_int_equal(cupola_plan_view_count(NULL), 0);
    assert_null(cupola_plan_view(NULL, 0));
    assert_null(cupola_plan_dome(NULL));
    assert_null(cupola_plan_report(NULL));
    assert_int_equal(cupola_plan_select(NULL, forward), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_texel(NULL, 0, forward, place), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_camera(NULL, 0, NULL, &camera, NULL), CUPOLA_ERROR_ARGUMENT);
    cupola_dome_destroy(NULL);
    cupola_plan_destroy(NULL);
}

static void an_output_of_impossible_size_is_not_resized(void **state)
{
    (void)state;
    struct cupola_output output = {.width_px = -5, .height_px = 10};
    struct cupola_output before = output;
    assert_int_equal(cupola_output_resize(&output, 100, 100, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_memory_equal(&output, &before, sizeof output);
}

static void a_polynomial_that_turns_back_is_refused_however_small_its_last_term(void **state)
{
    (void)state;
    const double last[] = {0, 1e-18, -1e-18, 1e-9};
    for (int i = 0; i < 4; i++) {
        struct cupola_lens lens = {.model = CUPOLA_LENS_POLYNOMIAL, .k = {1, -0.5, 0.1, last[i]}};
        assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_ERROR_ARGUMENT);
        lens.k[1] = -0.1;
        assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_OK);
    }
}

int main(void)
{
    const struct CMUnitTest plan_screen[] = {
        cmocka_unit_test(the_smallest_screen_is_found_whatever_the_size),
        cmocka_unit_test(what_the_cap_hides_does_not_count_against_a_layout),
        cmocka_unit_test(an_image_may_be_a_pixel),
        cmocka_unit_test(a_screen_that_nothing_lights_is_refused),
        cmocka_unit_test(nothing_in_place_of_a_plan_or_a_dome_is_an_error_and_no_crash),
        cmocka_unit_test(an_output_of_impossible_size_is_not_resized),
        cmocka_unit_test(a_polynomial_that_turns_back_is_refused_however_small_its_last_term),
    };
    return cmocka_run_group_tests(plan_screen, NULL, NULL);
}
