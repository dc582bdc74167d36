/* Views: every ray falls to exactly one, well inside of its rectangle, and all are needed. */
#include "plan_pixels.h"

struct tally {
    int guard_px;
    double shift_px;            /* a deliberate error of the texel */
    double least_margin_px;     /* of pixels that are lit in whole */
    double least_rim_margin_px; /* of those that an edge cuts */
    double worst_selection;     /* how much a selector not chosen was ahead, at most */
    double worst_texel;         /* distance from the oracle's */
    int pixels[CUPOLA_VIEWS_MAX];
};

static double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Distance from a texel to the nearest edge of its view's rectangle. */
static double margin(const struct cupola_rect *rect, const double texel[2])
{
    return fmin(fmin(texel[0] - rect->x, rect->x + rect->width - texel[0]),
                fmin(texel[1] - rect->y, rect->y + rect->height - texel[1]));
}

/* Design section 5: d = 1 / c, the point (a d, b d) and its place in the base rectangle. */
static void oracle_texel(const struct cupola_view *view, const double v[3], double texel[2])
{
    double d = -1.0 / dot3(view->rotation + 6, v);
    texel[0] = view->rect.x + (dot3(view->rotation, v) * d - view->left) /
                                  (view->right - view->left) * view->rect.width;
    texel[1] = view->rect.y + (dot3(view->rotation + 3, v) * d - view->bottom) /
                                  (view->top - view->bottom) * view->rect.height;
}

static void tally_pixel(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    struct tally *tally = user;
    const struct cupola_view *chosen = cupola_plan_view(plan, pixel->view);
    double texel[2], shifted[2] = {pixel->texel[0] + tally->shift_px, pixel->texel[1]};
    oracle_texel(chosen, pixel->ray.direction, texel);
    tally->worst_texel =
        fmax(tally->worst_texel, hypot(texel[0] - pixel->texel[0], texel[1] - pixel->texel[1]));
    double *least =
        pixel->ray.coverage >= 1.0 ? &tally->least_margin_px : &tally->least_rim_margin_px;
    *least = fmin(*least, margin(&chosen->rect, shifted));
    double best = dot3(chosen->selector, pixel->ray.direction);
    for (int i = 0; i < cupola_plan_view_count(plan); i++)
        tally->worst_selection =
            fmax(tally->worst_selection,
                 dot3(cupola_plan_view(plan, i)->selector, pixel->ray.direction) - best);
    tally->pixels[pixel->view]++;
}

static struct tally tally_plan(const cupola_plan *plan, double shift_px)
{
    struct tally tally;
    memset(&tally, 0, sizeof tally);
    tally.shift_px = shift_px;
    tally.least_margin_px = 1e9;
    tally.least_rim_margin_px = 1e9;
    visit_pixels(plan, tally_pixel, &tally);
    return tally;
}

/*
 * The facts of one plan. A texel is computed from a few products: its rounding is some 1e-12, and
 * the rectangle is fitted to the same rays. A pixel that the rim cuts shows a place on the rim or
 * within less than a pixel of it: a polygon of a corner per pixel, in place of the rim, lacks some
 * 1/(8 rho) px there, so that 1/50 texel of the guard band is forgiven; a bilinear tap needs 1/2.
 */
static void check_views(const cupola_plan *plan, int guard_px)
{
    struct tally tally = tally_plan(plan, 0.0);
    check_at_least(tally.least_margin_px, guard_px - 1e-6);
    check_at_least(tally.least_rim_margin_px, guard_px - 0.02);
    check_at_most(tally.worst_selection, 0.0);
    check_at_most(tally.worst_texel, 1e-6);
    for (int i = 0; i < cupola_plan_view_count(plan); i++)
        check_at_least(tally.pixels[i], 1);
}

static void check_rects(const cupola_plan *plan)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    for (int i = 0; i < cupola_plan_view_count(plan); i++) {
        const struct cupola_rect *a = &cupola_plan_view(plan, i)->rect;
        check_at_least(a->x, 0);
        check_at_least(a->y, 0);
        check_at_most(a->x + a->width, report->atlas_width_px);
        check_at_most(a->y + a->height, report->atlas_height_px);
        for (int j = 0; j < i; j++) {
            const struct cupola_rect *b = &cupola_plan_view(plan, j)->rect;
            assert_true(a->x >= b->x + b->width || b->x >= a->x + a->width ||
                        a->y >= b->y + b->height || b->y >= a->y + a->height);
        }
    }
}

static void check_rotations(const cupola_plan *plan)
{
    const double *first = cupola_plan_view(plan, 0)->rotation;
    for (int k = 0; k < cupola_plan_view_count(plan); k++) {
        const struct cupola_view *view = cupola_plan_view(plan, k);
        const double *m = view->rotation;
        double cross[3] = {m[1] * m[5] - m[2] * m[4], m[2] * m[3] - m[0] * m[5],
                           m[0] * m[4] - m[1] * m[3]};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                check_near(dot3(m + 3 * i, m + 3 * j), i == j ? 1.0 : 0.0, 1e-14);
            check_near(cross[i], m[6 + i], 1e-14); /* right x up = backward */
        }
        if (cupola_plan_report(plan)->layout == CUPOLA_LAYOUT_ASYMMETRIC)
            assert_memory_equal(m, first, sizeof view->rotation);
        assert_true(view->left < view->right && view->bottom < view->top);
    }
}

static void every_ray_falls_to_one_view_and_inside_its_guard_band(void **state)
{
    (void)state;
    uint64_t seed = 71;
    int layouts[3] = {0, 0, 0};
    for (int i = 0; i < 18; i++) {
        struct cupola_rig rig;
        struct cupola_plan_params params;
        random_plan_case(&seed, &rig, &params);
        cupola_plan *plan = plan_of(&rig, &params);
        check_views(plan, params.guard_px ? params.guard_px : 2);
        check_rects(plan);
        check_rotations(plan);
        layouts[cupola_plan_report(plan)->layout]++;
        if (params.layout != CUPOLA_LAYOUT_AUTO)
            assert_int_equal(cupola_plan_report(plan)->layout, params.layout);
        cupola_plan_destroy(&plan);
    }
    check_at_least(layouts[CUPOLA_LAYOUT_ASYMMETRIC], 5);
    check_at_least(layouts[CUPOLA_LAYOUT_ROTATED], 5);
}

/* Lenses and fields of view of the paper's theatres, with every number of views. */
static void the_same_holds_for_every_number_of_views(void **state)
{
    (void)state;
    static const struct {
        double fov_deg;
        enum cupola_layout layout;
        int least;
    } cases[] = {{90.0, CUPOLA_LAYOUT_ASYMMETRIC, 1}, {150.0, CUPOLA_LAYOUT_ASYMMETRIC, 1},
                 {90.0, CUPOLA_LAYOUT_ROTATED, 1},    {180.0, CUPOLA_LAYOUT_ROTATED, 3},
                 {220.0, CUPOLA_LAYOUT_ROTATED, 4},   {360.0, CUPOLA_LAYOUT_ROTATED, 6}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (int views = cases[i].least; views <= CUPOLA_VIEWS_MAX; views++) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, cases[i].fov_deg, 101);
            struct cupola_plan_params params = {.layout = cases[i].layout, .views = views};
            cupola_plan *plan = plan_of(&rig, &params);
            check_views(plan, 2);
            check_rects(plan);
            check_rotations(plan);
            cupola_plan_destroy(&plan);
        }
    }
}

/* Two texels: the rectangle may be up to one wider than its rays on either side. */
static void texels_wrong_by_two_leave_the_guard_band(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 101);
    cupola_plan *plan = plan_of(&rig, NULL);
    struct tally right = tally_plan(plan, 2.0), left = tally_plan(plan, -2.0);
    double least = fmin(right.least_rim_margin_px, left.least_rim_margin_px);
    check_at_most(least, 2.0 - 0.5);
    cupola_plan_destroy(&plan);
}

static void views_serve_all_outputs_together(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 100.0, 90);
    rig.output_count = 3;
    for (int i = 1; i < 3; i++) {
        rig.outputs[i] = rig.outputs[0];
        rig.outputs[i].aim.yaw_rad = i == 1 ? 1.0 : -1.3;
        rig.outputs[i].position_m[0] = i == 1 ? -0.4 : 0.5;
        rig.outputs[i].height_px = 61;
    }
    cupola_plan *plan = plan_of(&rig, NULL);
    check_views(plan, 2);
    check_rects(plan);
    cupola_plan_destroy(&plan);
}

/* Too many pixels to fit a plan to each: what falls between those that it looks at fits too. */
static void large_outputs_stay_inside_the_guard_band(void **state)
{
    (void)state;
    for (int layout = CUPOLA_LAYOUT_ASYMMETRIC; layout <= CUPOLA_LAYOUT_ROTATED; layout++) {
        double fov = layout == CUPOLA_LAYOUT_ASYMMETRIC ? 140.0 : 200.0;
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_EQUISOLID, fov, 1201);
        struct cupola_plan_params params = {.layout = (enum cupola_layout)layout, .guard_px = 1};
        rig.eye_m[0] = 0.05;
        cupola_plan *plan = plan_of(&rig, &params);
        struct tally tally = tally_plan(plan, 0.0);
        /* A bilinear tap needs half a texel of the one. */
        check_at_least(tally.least_margin_px, 0.5);
        check_at_least(tally.least_rim_margin_px, 0.5);
        cupola_plan_destroy(&plan);
    }
}

static void rays_behind_a_view_do_not_meet_it(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 100.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    double texel[2] = {-7.0, -8.0};
    static const double behind[3] = {0.1, 0.0, 1.0}, ahead[3] = {0.0, 0.0, -1.0};
    assert_int_equal(cupola_plan_texel(plan, 0, behind, texel), 0);
    assert_int_equal(cupola_plan_texel(plan, -1, ahead, texel), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_texel(plan, 99, ahead, texel), CUPOLA_ERROR_ARGUMENT);
    check_near(texel[0], -7.0, 0.0);
    check_near(texel[1], -8.0, 0.0);
    cupola_plan_destroy(&plan);
}

static void the_length_of_a_ray_does_not_matter(void **state)
{
    (void)state;
    uint64_t seed = 72;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 200.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    for (int i = 0; i < 1000; i++) {
        double one[3], two[3], a[2], b[2];
        random_in_ball(&seed, 1.0, one);
        if (angle_between(one, (double[3]){0.0, 0.0, -1.0}) > radians(99.0))
            continue;
        for (int j = 0; j < 3; j++)
            two[j] = one[j] * 1024.0;
        int view = cupola_plan_select(plan, one);
        assert_int_equal(cupola_plan_select(plan, two), view);
        texel_of(plan, view, one, a);
        texel_of(plan, view, two, b);
        check_near(a[0], b[0], 1e-10);
        check_near(a[1], b[1], 1e-10);
    }
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_ray_falls_to_one_view_and_inside_its_guard_band),
        cmocka_unit_test(the_same_holds_for_every_number_of_views),
        cmocka_unit_test(texels_wrong_by_two_leave_the_guard_band),
        cmocka_unit_test(views_serve_all_outputs_together),
        cmocka_unit_test(large_outputs_stay_inside_the_guard_band),
        cmocka_unit_test(rays_behind_a_view_do_not_meet_it),
        cmocka_unit_test(the_length_of_a_ray_does_not_matter),
    };
    return cmocka_run_group_tests_name("plan_views", tests, NULL, NULL);
}
