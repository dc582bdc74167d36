/* Plans: defaults by the paper, layouts, parameters, and what the report says. */
#include "message.h"
#include "plan_pixels.h"

static struct cupola_plan_params layout_of(enum cupola_layout layout, int views)
{
    struct cupola_plan_params params;
    memset(&params, 0, sizeof params);
    params.layout = layout;
    params.views = views;
    return params;
}

static void check_asymmetric(double fov_deg, int views)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fov_deg, 128);
    struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_ASYMMETRIC, 0);
    cupola_plan *plan = plan_of(&rig, &params);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    if (cupola_plan_view_count(plan) != views)
        fail_msg("%g degrees: %d views: %s", fov_deg, cupola_plan_view_count(plan), report->reason);
    assert_int_equal(report->layout, CUPOLA_LAYOUT_ASYMMETRIC);
    assert_int_equal(report->views, views);
    assert_true(report->reason[0] != '\0');
    cupola_plan_destroy(&plan);
}

static void one_plane_has_two_views_up_to_90_degrees_three_up_to_140_four_beyond(void **state)
{
    (void)state;
    check_asymmetric(40.0, 2);
    check_asymmetric(90.0, 2);
    check_asymmetric(92.0, 3);
    check_asymmetric(140.0, 3);
    check_asymmetric(142.0, 4);
    check_asymmetric(159.0, 4);
}

static double cost_of(const struct cupola_rig *rig, enum cupola_layout layout, int views)
{
    struct cupola_plan_params params = layout_of(layout, views);
    cupola_plan *plan = plan_of(rig, &params);
    double cost = cupola_plan_report(plan)->cost;
    cupola_plan_destroy(&plan);
    return cost;
}

/* To 1 in 100: costs are compared on samples. */
static void auto_is_no_dearer_than_either_layout_with_any_number_of_views(void **state)
{
    (void)state;
    static const double fovs[] = {25.0, 60.0, 120.0};
    for (int i = 0; i < 3; i++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fovs[i], 256);
        double cost = cost_of(&rig, CUPOLA_LAYOUT_AUTO, 0);
        for (int views = 1; views <= CUPOLA_VIEWS_MAX; views++) {
            check_at_most(cost, 1.01 * cost_of(&rig, CUPOLA_LAYOUT_ASYMMETRIC, views));
            check_at_most(cost, 1.01 * cost_of(&rig, CUPOLA_LAYOUT_ROTATED, views));
        }
    }
}

/* Design section 5: an eye 0.3 R forward sees a 140 degree lens under 175. */
static void what_the_eye_sees_decides_and_not_the_lens(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 128);
    rig.eye_m[2] = -0.3;
    cupola_plan *plan = plan_of(&rig, NULL);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    double seen = 2.0 * atan2(sin(radians(70.0)), cos(radians(70.0)) - 0.3);
    /* The outermost pixels' middles are up to a pixel from the rim: 140 / 128 degrees and more. */
    check_near(report->seen_fov_rad, seen, radians(3.0));
    assert_int_equal(report->layout, CUPOLA_LAYOUT_ROTATED);
    cupola_plan_destroy(&plan);

    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_ASYMMETRIC, 3);
    assert_int_equal(plan_status(&rig, &params, &error), CUPOLA_ERROR_LAYOUT);
    assert_int_equal(error.status, CUPOLA_ERROR_LAYOUT);
    assert_non_null(strstr(error.message, "rotated"));
    assert_non_null(strstr(error.message, "80"));
}

static void the_seen_field_of_view_of_a_plain_rig_is_its_lens(void **state)
{
    (void)state;
    static const double fovs[] = {60.0, 90.0, 140.0, 180.0, 220.0};
    for (int i = 0; i < 5; i++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fovs[i], 256);
        cupola_plan *plan = plan_of(&rig, NULL);
        check_near(cupola_plan_report(plan)->seen_fov_rad, radians(fovs[i]),
                   radians(2.0 * fovs[i] / 256.0));
        cupola_plan_destroy(&plan);
    }
}

static void auto_reaches_every_theatre(void **state)
{
    (void)state;
    uint64_t seed = 61;
    for (int i = 0; i < 15; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        rig.outputs[0].width_px = 96;
        rig.outputs[0].height_px = 80;
        rig.outputs[0].circle = (struct cupola_circle){45.0, 42.0, 50.0};
        struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_AUTO, 0);
        params.density = 0.25; /* an eye near the screen magnifies: few texels are enough here */
        cupola_plan *plan = plan_of(&rig, &params);
        assert_int_not_equal(cupola_plan_report(plan)->layout, CUPOLA_LAYOUT_AUTO);
        cupola_plan_destroy(&plan);
    }
}

/* A host's camera that looks along the axis and a projector that aims elsewhere. */
static void one_plane_is_the_cameras_where_all_rays_are_within_80_degrees_of_it(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 100.0, 128);
        rig.outputs[0].aim.yaw_rad = radians(i ? 60.0 : 25.0); /* rays up to 110 or 75 degrees */
        struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_ASYMMETRIC, 3);
        cupola_plan *plan = plan_of(&rig, &params);
        const double *rotation = cupola_plan_view(plan, 0)->rotation;
        /* Backward axis: +Z, or away from the mean ray, which is the lens's axis by symmetry. */
        double yaw = i ? radians(60.0) : 0.0;
        check_near(rotation[6], sin(yaw), i ? 1e-3 : 0.0);
        check_near(rotation[7], 0.0, i ? 1e-3 : 0.0);
        check_near(rotation[8], cos(yaw), i ? 1e-3 : 0.0);
        if (i == 0) {
            for (int j = 0; j < 9; j++)
                check_near(rotation[j], j % 4 == 0 ? 1.0 : 0.0, 0.0);
        }
        cupola_plan_destroy(&plan);
    }
}

static void one_plane_is_refused_beyond_80_degrees_and_the_other_layout_named(void **state)
{
    (void)state;
    static const double fovs[] = {162.0, 180.0, 220.0, 360.0};
    for (int i = 0; i < 4; i++) {
        for (int views = 0; views <= CUPOLA_VIEWS_MAX; views += 4) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_EQUISOLID, fovs[i], 64);
            struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_ASYMMETRIC, views);
            struct cupola_error error = {CUPOLA_OK, ""};
            assert_int_equal(plan_status(&rig, &params, &error), CUPOLA_ERROR_LAYOUT);
            assert_non_null(strstr(error.message, "rotated"));
        }
    }
}

/* Half of a hemisphere has rays at 90 degrees from every axis that could serve it. */
static void too_few_rotated_views_are_refused(void **state)
{
    (void)state;
    static const struct {
        double fov_deg;
        int views;
    } cases[] = {{162.0, 1}, {180.0, 1}, {180.0, 2}, {220.0, 1}, {220.0, 2}, {360.0, 3}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, cases[i].fov_deg, 64);
        struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_ROTATED, cases[i].views);
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(plan_status(&rig, &params, &error), CUPOLA_ERROR_LAYOUT);
        assert_true(error.message[0] != '\0');
    }
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    for (int views = 3; views <= CUPOLA_VIEWS_MAX; views++) {
        struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_ROTATED, views);
        cupola_plan *plan = plan_of(&rig, &params);
        assert_int_equal(cupola_plan_view_count(plan), views);
        cupola_plan_destroy(&plan);
    }
}

static void every_number_of_views_is_given_where_it_is_possible(void **state)
{
    (void)state;
    for (int layout = CUPOLA_LAYOUT_ASYMMETRIC; layout <= CUPOLA_LAYOUT_ROTATED; layout++) {
        for (int views = 1; views <= CUPOLA_VIEWS_MAX; views++) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 120.0, 100);
            struct cupola_plan_params params = layout_of((enum cupola_layout)layout, views);
            cupola_plan *plan = plan_of(&rig, &params);
            assert_int_equal(cupola_plan_view_count(plan), views);
            assert_int_equal(cupola_plan_report(plan)->layout, layout);
            assert_non_null(cupola_plan_view(plan, views - 1));
            assert_null(cupola_plan_view(plan, views));
            assert_null(cupola_plan_view(plan, -1));
            cupola_plan_destroy(&plan);
        }
    }
}

#define REAL(member, value)                                                                        \
    {                                                                                              \
#member, offsetof(struct cupola_plan_params, member), 1, value                             \
    }
#define WHOLE(member, value)                                                                       \
    {                                                                                              \
#member, offsetof(struct cupola_plan_params, member), 0, value                             \
    }

static const struct {
    const char *member;
    size_t offset;
    int is_real;
    double value;
} bad_values[] = {
    WHOLE(views, -1),
    WHOLE(views, 9),
    REAL(density, -1.5),
    REAL(density, 0.0625 / 2),
    REAL(density, 16.5),
    REAL(density, (double)NAN),
    REAL(density, (double)INFINITY),
    WHOLE(view_size_px, -5),
    WHOLE(view_size_px, 16385),
    WHOLE(guard_px, -2),
    WHOLE(guard_px, 257),
    WHOLE(max_texture_px, 63),
    WHOLE(max_texture_px, 32769),
    WHOLE(max_texture_px, -64),
    WHOLE(goal, -1),
    WHOLE(goal, 2),
    REAL(cost.view, -1e-3),
    REAL(cost.texel_allocated, 2e6),
    REAL(cost.vertices, (double)NAN),
    REAL(head_radius_m, -0.25),
    REAL(head_radius_m, 2.5),
    REAL(head_radius_m, (double)NAN),
    WHOLE(layout, 3),
    WHOLE(layout, -1),
};

static void every_impossible_wish_is_refused_by_name(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 100.0, 64);
    for (size_t i = 0; i < sizeof bad_values / sizeof bad_values[0]; i++) {
        struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_AUTO, 0);
        int whole = bad_values[i].is_real ? 0 : (int)bad_values[i].value;
        if (bad_values[i].is_real)
            memcpy((char *)&params + bad_values[i].offset, &bad_values[i].value, sizeof(double));
        else
            memcpy((char *)&params + bad_values[i].offset, &whole, sizeof whole);
        struct cupola_error error = {CUPOLA_OK, ""};
        if (plan_status(&rig, &params, &error) != CUPOLA_ERROR_ARGUMENT)
            fail_msg("accepted: %s = %g", bad_values[i].member, bad_values[i].value);
        check_message(&error, bad_values[i].value);
    }
}

static void an_atlas_that_would_be_too_large_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 256);
    struct cupola_plan_params params = layout_of(CUPOLA_LAYOUT_AUTO, 0);
    struct cupola_error error = {CUPOLA_OK, ""};
    params.max_texture_px = 128;
    assert_int_equal(plan_status(&rig, &params, &error), CUPOLA_ERROR_ARGUMENT);
    check_message(&error, 128);
    params.max_texture_px = 2048;
    cupola_plan *plan = plan_of(&rig, &params);
    check_at_most(cupola_plan_report(plan)->atlas_width_px, 2048);
    check_at_most(cupola_plan_report(plan)->atlas_height_px, 2048);
    cupola_plan_destroy(&plan);
    assert_null(plan);
    cupola_plan_destroy(&plan);
    cupola_plan_destroy(NULL);
}

/* A circle that meets the frame nowhere is refused by the rig; a screen behind the lens is here. */
static void a_theatre_without_a_lit_pixel_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 64);
    rig.outputs[0].aim.yaw_rad = pi;
    rig.screen.cap_rad = radians(60.0);
    struct cupola_error error = {CUPOLA_OK, ""};
    check_at_most(plan_status(&rig, NULL, &error), -1);
    assert_true(error.message[0] != '\0');
}

static void layouts_have_names_and_are_found_by_them(void **state)
{
    (void)state;
    static const char *names[] = {"auto", "asymmetric", "rotated"};
    for (int layout = 0; layout < 3; layout++) {
        assert_string_equal(cupola_layout_name(layout), names[layout]);
        assert_int_equal(cupola_layout_find(names[layout]), layout);
    }
    assert_null(cupola_layout_name(3));
    assert_null(cupola_layout_name(-1));
    assert_int_equal(cupola_layout_find("rotate"), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_layout_find(""), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_layout_find(NULL), CUPOLA_ERROR_ARGUMENT);
}

/* What the message allows is possible, and a degree more is not. */
static void a_lens_too_steep_for_any_layout_is_named(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_STEREOGRAPHIC, 358.0, 64);
    struct cupola_error error = {CUPOLA_OK, ""};
    int allowed = 0;
    assert_int_equal(plan_status(&rig, NULL, &error), CUPOLA_ERROR_LAYOUT);
    assert_non_null(strstr(error.message, "lens stereographic of output 0"));
    assert_non_null(strstr(error.message, "358 degrees"));
    const char *limit = strstr(error.message, "up to ");
    assert_non_null(limit);
    assert_int_equal(sscanf(limit, "up to %*f rad (%d degrees)", &allowed), 1);
    rig.outputs[0].lens.fov_rad = radians(allowed);
    assert_int_equal(plan_status(&rig, NULL, &error), CUPOLA_OK);
    rig.outputs[0].lens.fov_rad = radians(allowed + 1);
    assert_int_equal(plan_status(&rig, NULL, &error), CUPOLA_ERROR_LAYOUT);

    /* Of two outputs it is the steeper one. */
    rig.output_count = 2;
    rig.outputs[1] = rig.outputs[0];
    rig.outputs[1].lens.fov_rad = radians(359.0);
    assert_int_equal(plan_status(&rig, NULL, &error), CUPOLA_ERROR_LAYOUT);
    assert_non_null(strstr(error.message, "lens stereographic of output 1"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_plane_has_two_views_up_to_90_degrees_three_up_to_140_four_beyond),
        cmocka_unit_test(auto_is_no_dearer_than_either_layout_with_any_number_of_views),
        cmocka_unit_test(what_the_eye_sees_decides_and_not_the_lens),
        cmocka_unit_test(the_seen_field_of_view_of_a_plain_rig_is_its_lens),
        cmocka_unit_test(auto_reaches_every_theatre),
        cmocka_unit_test(one_plane_is_the_cameras_where_all_rays_are_within_80_degrees_of_it),
        cmocka_unit_test(one_plane_is_refused_beyond_80_degrees_and_the_other_layout_named),
        cmocka_unit_test(too_few_rotated_views_are_refused),
        cmocka_unit_test(a_lens_too_steep_for_any_layout_is_named),
        cmocka_unit_test(every_number_of_views_is_given_where_it_is_possible),
        cmocka_unit_test(every_impossible_wish_is_refused_by_name),
        cmocka_unit_test(an_atlas_that_would_be_too_large_is_refused),
        cmocka_unit_test(a_theatre_without_a_lit_pixel_is_refused),
        cmocka_unit_test(layouts_have_names_and_are_found_by_them),
    };
    return cmocka_run_group_tests_name("plan", tests, NULL, NULL);
}
