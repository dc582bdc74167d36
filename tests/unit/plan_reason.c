/* The sentence of a plan's report: what was asked for, what was minimised, what it costs. */
#include "message.h"
#include "plan_pixels.h"

static const struct cupola_plan_params nothing_asked;

/* The sentence must hold `words`, and not `others` unless that is NULL. */
static void check_reason(double fov_deg, const struct cupola_plan_params *params, const char *words,
                         const char *others)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fov_deg, 128);
    cupola_plan *plan = plan_of(&rig, params);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    char cost[40], family[CUPOLA_FAMILY_MAX + 3];
    snprintf(cost, sizeof cost, " %.3g texels a pixel: ", report->cost);
    snprintf(family, sizeof family, "(%s)", report->family);
    if (!strstr(report->reason, words) || (others && strstr(report->reason, others)))
        fail_msg("\"%s\" instead of \"%s\"", report->reason, words);
    assert_non_null(strstr(report->reason, cost));
    assert_non_null(strstr(report->reason, family));
    assert_non_null(strstr(report->reason, "off a view's axis")); /* it is whole */
    assert_int_equal(report->reason[0] - '0', report->views);
    cupola_plan_destroy(&plan);
}

static void what_is_least_is_said_only_of_what_was_chosen(void **state)
{
    (void)state;
    struct cupola_plan_params wishes = nothing_asked;
    check_reason(140.0, &wishes, " cost least, ", "asked");
    wishes.views = 3;
    check_reason(140.0, &wishes, ", their number as asked, cost least, ", NULL);
    wishes.layout = CUPOLA_LAYOUT_ASYMMETRIC;
    check_reason(140.0, &wishes, "3 asymmetric views (1x3), as asked, cost ", "least");
    wishes.views = 0;
    check_reason(140.0, &wishes, ", layout as asked, number usual, cost ", "least");
    wishes.layout = CUPOLA_LAYOUT_ROTATED;
    check_reason(140.0, &wishes, " rotated views (", "asymmetric");
    check_reason(140.0, &wishes, ", rotated as asked, cost least, ", NULL);
}

static void masks_are_named_where_there_are_masks(void **state)
{
    (void)state;
    struct cupola_plan_params wishes = nothing_asked;
    check_reason(140.0, &wishes, " shaded under a mask, of ", "all there are");
    wishes.unmasked = true;
    check_reason(140.0, &wishes, " shaded, all there are;", "mask");
}

static void objects_are_named_where_they_have_a_price(void **state)
{
    (void)state;
    struct cupola_plan_params wishes = nothing_asked;
    check_reason(140.0, &wishes, "shaded", "objects");
    wishes.goal = CUPOLA_GOAL_VERTICES;
    check_reason(140.0, &wishes, " of all objects drawn, ", NULL);
    wishes.layout = CUPOLA_LAYOUT_ASYMMETRIC; /* the longest sentence */
    check_reason(150.0, &wishes, " of all objects drawn, ", NULL);
}

static void one_view_costs_and_one_degree_is_seen(void **state)
{
    (void)state;
    struct cupola_plan_params wishes = {.layout = CUPOLA_LAYOUT_ROTATED, .views = 1};
    check_reason(1.0, &wishes, "1 rotated view (1), as asked, costs ", "views (");
    check_reason(1.0, &wishes, "sees 1 degree, ", NULL);
    check_reason(2.0, &wishes, "sees 2 degrees, ", NULL);
    wishes.layout = CUPOLA_LAYOUT_AUTO;
    check_reason(1.0, &wishes, " view (", "views (");
    check_reason(1.0, &wishes, ", its number as asked, costs least, ", NULL);
}

/* Rays between the samples by which a plan is made are farther off than those; it says how far. */
static void how_far_rays_are_off_is_within_what_is_said(void **state)
{
    struct cupola_plan_params wishes = {.head_radius_m = 0.425887};
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 294.604, 256);
    double off_deg = 0, limit_deg = 0;
    (void)state;
    cupola_plan *plan = plan_of(&rig, &wishes);
    const char *found = strstr(cupola_plan_report(plan)->reason, "rays are up to");
    assert_non_null(found);
    assert_int_equal(sscanf(found, "rays are up to %lf (of %lf)", &off_deg, &limit_deg), 2);
    check_at_least(off_deg, 80.5); /* else it says nothing here */
    check_at_most(off_deg, limit_deg);
    cupola_plan_destroy(&plan);
}

/* Two outputs that show the same: what is sampled never exceeds what masks leave. */
static void what_two_outputs_see_is_no_more_than_the_views(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 256);
    rig.outputs[1] = rig.outputs[0];
    rig.output_count = 2;
    cupola_plan *plan = plan_of(&rig, NULL);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    check_at_most(report->texels_sampled_per_pixel, report->texels_masked_per_pixel);
    check_at_most(report->texels_masked_per_pixel, report->texels_shaded_per_pixel);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_least_is_said_only_of_what_was_chosen),
        cmocka_unit_test(masks_are_named_where_there_are_masks),
        cmocka_unit_test(objects_are_named_where_they_have_a_price),
        cmocka_unit_test(one_view_costs_and_one_degree_is_seen),
        cmocka_unit_test(how_far_rays_are_off_is_within_what_is_said),
        cmocka_unit_test(what_two_outputs_see_is_no_more_than_the_views),
    };
    return cmocka_run_group_tests_name("plan_reason", tests, NULL, NULL);
}
