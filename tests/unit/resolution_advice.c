/* The advice of a resolution, against plans that follow it. */
#include <stdio.h>

#include "resolution_of.h"

static const char matching[] = "views and projector match";

static void check_begins(const char *advice, const char *beginning)
{
    if (strncmp(advice, beginning, strlen(beginning)) != 0)
        fail_msg("the advice is: %s", advice);
}

static double least_of(const struct cupola_resolution *resolution)
{
    double least = HUGE_VAL;
    for (int v = 0; v < resolution->views; v++)
        least = fmin(least, resolution->view[v].least_texels_per_pixel.min);
    return least;
}

/* The size that a sentence names, and how many times finer (below 0: coarser) it says they are. */
static int size_in(const char *advice, double *times)
{
    char word[16] = "";
    int size = 0;
    if (sscanf(advice, "views are %lfx %15s than the projector can show: %d px would do", times,
               word, &size) != 3)
        fail_msg("the advice is: %s", advice);
    if (strcmp(word, "coarser") == 0)
        *times = -*times;
    else
        assert_string_equal(word, "finer");
    return size;
}

static void check_advice(const struct cupola_rig *rig, int size_px, double expected)
{
    struct cupola_plan_params params = {.views = 5, .layout = CUPOLA_LAYOUT_ROTATED};
    double times;
    params.view_size_px = size_px;
    cupola_plan *plan = plan_of_rig(rig, &params);
    struct cupola_resolution resolution = measured(plan, 0);
    cupola_plan_destroy(&plan);
    int size = size_in(resolution.advice, &times);
    check_near(times, expected, 0.01 * fabs(expected) + 0.006);
    params.view_size_px = size;
    plan = plan_of_rig(rig, &params);
    resolution = measured(plan, 0);
    check_begins(resolution.advice, matching);
    check_at_least(least_of(&resolution), 0.9999);
    cupola_plan_destroy(&plan);
    /* One less no longer has a texel for each pixel: the advice is no larger than needed. */
    params.view_size_px = size - 1;
    plan = plan_of_rig(rig, &params);
    resolution = measured(plan, 0);
    check_at_most(least_of(&resolution), 0.99999);
    cupola_plan_destroy(&plan);
}

static void advice_that_is_followed_makes_views_and_projector_match(void **state)
{
    (void)state;
    for (int model = 0; model <= CUPOLA_LENS_HEMISPHERIC; model++) {
        struct cupola_rig rig = plain_rig((enum cupola_lens_model)model, 170.0, 200);
        struct cupola_plan_params params = {
            .views = 5, .layout = CUPOLA_LAYOUT_ROTATED, .view_size_px = 1000};
        double times;
        cupola_plan *plan = plan_of_rig(&rig, &params);
        struct cupola_resolution resolution = measured(plan, 0);
        cupola_plan_destroy(&plan);
        int size = size_in(resolution.advice, &times);
        check_at_least(times, 1.0);
        check_advice(&rig, 1000, times);
        check_advice(&rig, 2 * size, 2.0);
        check_advice(&rig, size / 2, -2.0);
    }
}

static void plans_that_lose_nothing_match_whatever_the_lens(void **state)
{
    (void)state;
    static const double fovs[3] = {90.0, 180.0, 300.0};
    for (int i = 0; i < 12; i++) {
        enum cupola_lens_model model = (enum cupola_lens_model)(i % 4);
        if (model == CUPOLA_LENS_HEMISPHERIC && i / 4 == 2)
            continue;
        struct cupola_rig rig = plain_rig(model, fovs[i / 4], 300);
        struct cupola_plan_params params = {.density = 0.0};
        double times;
        cupola_plan *plan = plan_of_rig(&rig, NULL);
        struct cupola_resolution resolution = measured(plan, 0);
        if (least_of(&resolution) >= 0.95)
            assert_string_equal(resolution.advice, matching);
        else
            check_near(fovs[i / 4], 300.0, 0);
        check_begins(resolution.advice, matching);
        cupola_plan_destroy(&plan);
        params.density = 1.5;
        plan = plan_of_rig(&rig, &params);
        resolution = measured(plan, 0);
        size_in(resolution.advice, &times);
        check_near(times, 1.5, 0.02);
        cupola_plan_destroy(&plan);
    }
}

/* What the sentence says of the rim, texels per pixel; 0: nothing. */
static double rim_in(const char *advice)
{
    double rim = 0.0;
    const char *at = strstr(advice, "detail is lost: ");
    return at && sscanf(at, "detail is lost: %lf texels per pixel", &rim) == 1 ? rim : 0.0;
}

static void lenses_so_wide_that_the_rim_lacks_texels_are_told_so(void **state)
{
    (void)state;
    for (double fov = 270.0; fov <= 360.0; fov += 30.0) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fov, 150);
        struct cupola_plan_params params = {.density = 0.5};
        cupola_plan *plan = plan_of_rig(&rig, NULL);
        struct cupola_resolution resolution = measured(plan, 0);
        double least = least_of(&resolution);
        cupola_plan_destroy(&plan);
        check_near(rim_in(resolution.advice), least < 0.95 ? least : 0.0, 0.06 * least);
        assert_true(fov < 310.0 ? least > 0.8 : least < 0.8);
        /* Coarser: what is left is that of the size advised. */
        plan = plan_of_rig(&rig, &params);
        resolution = measured(plan, 0);
        cupola_plan_destroy(&plan);
        check_begins(resolution.advice, "views are 2x coarser");
        if (least < 0.9)
            check_near(rim_in(resolution.advice), least, 0.12 * least);
    }
}

/* What the sentence says of texels: those of another plan and those of this one. */
static bool texels_in(const char *advice, double *other, double *own)
{
    const char *at = strstr(advice, "; a plan that chooses each view's size takes ");
    return at &&
           sscanf(at, "; a plan that chooses each view's size takes %lf texels instead of %lf",
                  other, own) == 2;
}

static void sizes_that_waste_are_told_what_they_would_save(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 150);
    struct cupola_plan_params params = {.views = 5, .layout = CUPOLA_LAYOUT_ROTATED};
    double other, own;
    cupola_plan *plan = plan_of_rig(&rig, &params);
    struct cupola_resolution chosen = measured(plan, 0), given;
    cupola_plan_destroy(&plan);
    params.view_size_px = 500;
    plan = plan_of_rig(&rig, &params);
    given = measured(plan, 0);
    cupola_plan_destroy(&plan);
    assert_true(texels_in(given.advice, &other, &own));
    params.view_size_px = size_in(given.advice, &other);
    plan = plan_of_rig(&rig, &params);
    given = measured(plan, 0);
    cupola_plan_destroy(&plan);
    check_begins(given.advice, matching);
    assert_true(texels_in(given.advice, &other, &own));
    check_near(other, chosen.texels, 0.5);
    check_near(own, given.texels, 0.5);
    assert_false(texels_in(chosen.advice, &other, &own)); /* the control */
    params.view_size_px /= 3;
    plan = plan_of_rig(&rig, &params);
    given = measured(plan, 0);
    cupola_plan_destroy(&plan);
    assert_false(texels_in(given.advice, &other, &own)); /* coarser: it saves already */
}

static void heads_that_move_are_told_that_the_advice_is_for_this_eye(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 200);
    struct cupola_plan_params params = {.head_radius_m = 0.3};
    cupola_plan *plan = plan_of_rig(&rig, &params);
    struct cupola_resolution resolution = measured(plan, 0);
    assert_non_null(strstr(resolution.advice, "an eye that stayed here"));
    const double moved_m[3] = {0.0, 0.0, 0.3};
    struct cupola_resolution before = resolution;
    assert_int_equal(cupola_plan_set_eye(plan, moved_m, NULL), CUPOLA_OK);
    resolution = measured(plan, 0);
    check_at_least(fabs(resolution.pixels_per_degree.max / before.pixels_per_degree.max - 1), 0.05);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(advice_that_is_followed_makes_views_and_projector_match),
        cmocka_unit_test(plans_that_lose_nothing_match_whatever_the_lens),
        cmocka_unit_test(lenses_so_wide_that_the_rim_lacks_texels_are_told_so),
        cmocka_unit_test(sizes_that_waste_are_told_what_they_would_save),
        cmocka_unit_test(heads_that_move_are_told_that_the_advice_is_for_this_eye),
    };
    return cmocka_run_group_tests_name("resolution_advice", tests, NULL, NULL);
}
