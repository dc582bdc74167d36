/* Density: no pixel gets less than a texel in any direction, and the report tells the truth. */
#include "plan_pixels.h"

struct sums {
    double least;   /* texels per pixel along a line, over pixels and directions */
    double pixels;  /* in part where lit in part */
    double sampled; /* texels */
};

static void add_pixel(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    (void)plan;
    struct sums *sums = user;
    if (pixel->in_circle)
        sums->least = fmin(sums->least, smaller_singular_value(pixel->jacobian));
    sums->pixels += pixel->ray.coverage;
    sums->sampled += pixel->ray.coverage * area_factor(pixel->jacobian);
}

static struct sums sums_of(const cupola_plan *plan)
{
    struct sums sums = {1e9, 0.0, 0.0};
    visit_pixels(plan, add_pixel, &sums);
    return sums;
}

/*
 * Of the condition on singular values (design section 5) 1/1000 is forgiven: nobody sees a pixel
 * that gets 0.999 texels.
 */
static void no_pixel_gets_less_than_a_texel_in_any_direction(void **state)
{
    (void)state;
    uint64_t seed = 81;
    for (int i = 0; i < 12; i++) {
        struct cupola_rig rig;
        struct cupola_plan_params params;
        random_plan_case(&seed, &rig, &params);
        cupola_plan *plan = plan_of(&rig, &params);
        struct sums sums = sums_of(plan);
        double density = params.density > 0.0 ? params.density : 1.0;
        check_at_least(sums.least, density * (1.0 - 1e-3));
        /* Nor is it much more than was asked for: whole texels, of views some 30 across. */
        check_at_most(sums.least, density * 1.1);
        cupola_plan_destroy(&plan);
    }
}

/* The theatres for which design section 5 has measured what a layout costs. */
static void no_loss_holds_for_plain_lenses(void **state)
{
    (void)state;
    static const struct {
        enum cupola_lens_model model;
        double fov_deg;
    } cases[] = {{CUPOLA_LENS_ANGULAR, 90.0},      {CUPOLA_LENS_ANGULAR, 140.0},
                 {CUPOLA_LENS_ANGULAR, 180.0},     {CUPOLA_LENS_ANGULAR, 220.0},
                 {CUPOLA_LENS_HEMISPHERIC, 140.0}, {CUPOLA_LENS_HEMISPHERIC, 180.0},
                 {CUPOLA_LENS_EQUISOLID, 180.0},   {CUPOLA_LENS_STEREOGRAPHIC, 180.0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cupola_rig rig = plain_rig(cases[i].model, cases[i].fov_deg, 200);
        cupola_plan *plan = plan_of(&rig, NULL);
        struct sums sums = sums_of(plan);
        check_at_least(sums.least, 1.0 - 1e-3);
        check_at_most(sums.least, 1.05);
        check_near(cupola_plan_report(plan)->least_texels_per_pixel, sums.least, 0.01);
        cupola_plan_destroy(&plan);
    }
}

/* Too many pixels to look at each when a size is chosen: those between must not lose either. */
static void large_outputs_lose_nothing_either(void **state)
{
    (void)state;
    for (int layout = CUPOLA_LAYOUT_ASYMMETRIC; layout <= CUPOLA_LAYOUT_ROTATED; layout++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_STEREOGRAPHIC, 140.0, 1201);
        struct cupola_plan_params params = {.layout = (enum cupola_layout)layout};
        rig.eye_m[1] = 0.1;
        cupola_plan *plan = plan_of(&rig, &params);
        check_at_least(sums_of(plan).least, 1.0 - 1e-3);
        cupola_plan_destroy(&plan);
    }
}

static void the_report_is_what_counting_finds(void **state)
{
    (void)state;
    uint64_t seed = 82;
    for (int i = 0; i < 8; i++) {
        struct cupola_rig rig;
        struct cupola_plan_params params;
        random_plan_case(&seed, &rig, &params);
        cupola_plan *plan = plan_of(&rig, &params);
        const struct cupola_plan_report *report = cupola_plan_report(plan);
        struct sums sums = sums_of(plan);
        double shaded = 0.0;
        for (int j = 0; j < cupola_plan_view_count(plan); j++) {
            const struct cupola_rect *rect = &cupola_plan_view(plan, j)->rect;
            shaded += (double)rect->width * rect->height;
        }
        /* A rim that is a polygon of a corner per pixel lacks less than one pixel in all. */
        check_near(report->pixels, sums.pixels, 1.0);
        check_near(report->texels_shaded_per_pixel * report->pixels / shaded, 1.0, 1e-12);
        check_near(report->texels_allocated_per_pixel * report->pixels /
                       ((double)report->atlas_width_px * report->atlas_height_px),
                   1.0, 1e-12);
        /* An integral by one sample per pixel, of a density that grows towards the rim. */
        check_near(report->texels_sampled_per_pixel * sums.pixels / sums.sampled, 1.0, 0.02);
        check_near(report->least_texels_per_pixel / sums.least, 1.0, 0.01);
        assert_int_equal(report->views, cupola_plan_view_count(plan));
        cupola_plan_destroy(&plan);
    }
}

/* Rays of a rig that is wrong do not fit a plan that is right. */
static void a_plan_a_little_too_coarse_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 200);
    struct cupola_plan_params params = {.density = 0.99};
    cupola_plan *plan = plan_of(&rig, &params);
    check_at_most(sums_of(plan).least, 1.0 - 1e-3);
    cupola_plan_destroy(&plan);
}

static void density_two_is_four_times_the_texels(void **state)
{
    (void)state;
    for (int layout = CUPOLA_LAYOUT_ASYMMETRIC; layout <= CUPOLA_LAYOUT_ROTATED; layout++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_EQUISOLID, 130.0, 200);
        struct cupola_plan_params params = {.layout = (enum cupola_layout)layout, .density = 1.0};
        cupola_plan *one = plan_of(&rig, &params);
        params.density = 2.0;
        cupola_plan *two = plan_of(&rig, &params);
        check_near(sums_of(two).least / sums_of(one).least, 2.0, 0.05);
        /* Guard bands and rounding up to whole texels do not double. */
        check_near(cupola_plan_report(two)->texels_sampled_per_pixel /
                       cupola_plan_report(one)->texels_sampled_per_pixel,
                   4.0, 0.2);
        cupola_plan_destroy(&one);
        cupola_plan_destroy(&two);
    }
}

static void zero_density_is_no_loss(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 130.0, 100);
    struct cupola_plan_params params = {.density = 1.0};
    cupola_plan *given = plan_of(&rig, &params), *not_given = plan_of(&rig, NULL);
    for (int i = 0; i < cupola_plan_view_count(given); i++)
        assert_memory_equal(&cupola_plan_view(given, i)->rect,
                            &cupola_plan_view(not_given, i)->rect, sizeof(struct cupola_rect));
    cupola_plan_destroy(&given);
    cupola_plan_destroy(&not_given);
}

static void a_size_given_by_hand_is_the_longer_side_without_guard_band(void **state)
{
    (void)state;
    static const int sizes[] = {1, 7, 64, 333}, guards[] = {0, 1, 12, 2};
    for (int i = 0; i < 4; i++) {
        for (int layout = CUPOLA_LAYOUT_ASYMMETRIC; layout <= CUPOLA_LAYOUT_ROTATED; layout++) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 130.0, 80);
            struct cupola_plan_params params = {.layout = (enum cupola_layout)layout,
                                                .view_size_px = sizes[i],
                                                .guard_px = guards[i]};
            cupola_plan *plan = plan_of(&rig, &params);
            int guard = guards[i] ? guards[i] : 2;
            for (int j = 0; j < cupola_plan_view_count(plan); j++) {
                const struct cupola_rect *rect = &cupola_plan_view(plan, j)->rect;
                int longer = rect->width > rect->height ? rect->width : rect->height;
                assert_int_equal(longer - 2 * guard, sizes[i]);
                check_at_least(rect->width - 2 * guard, 1);
                check_at_least(rect->height - 2 * guard, 1);
            }
            check_near(cupola_plan_report(plan)->least_texels_per_pixel / sums_of(plan).least, 1.0,
                       0.01);
            cupola_plan_destroy(&plan);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pixel_gets_less_than_a_texel_in_any_direction),
        cmocka_unit_test(no_loss_holds_for_plain_lenses),
        cmocka_unit_test(large_outputs_lose_nothing_either),
        cmocka_unit_test(the_report_is_what_counting_finds),
        cmocka_unit_test(a_plan_a_little_too_coarse_is_caught),
        cmocka_unit_test(density_two_is_four_times_the_texels),
        cmocka_unit_test(zero_density_is_no_loss),
        cmocka_unit_test(a_size_given_by_hand_is_the_longer_side_without_guard_band),
    };
    return cmocka_run_group_tests_name("plan_density", tests, NULL, NULL);
}
