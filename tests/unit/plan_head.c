/* Eyes that move: one plan serves a sphere round the eye, and only base rectangles follow. */
#include "message.h"
#include "plan_pixels.h"

struct worst {
    double least, margin;
};

static void look(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    struct worst *worst = user;
    const struct cupola_rect *rect = &cupola_plan_view(plan, pixel->view)->rect;
    double x = pixel->texel[0] - rect->x, y = pixel->texel[1] - rect->y;
    worst->least = fmin(worst->least, smaller_singular_value(pixel->jacobian));
    worst->margin = fmin(worst->margin, fmin(fmin(x, rect->width - x), fmin(y, rect->height - y)));
}

/* visit_pixels asks for the eye of the plan's dome, which is the one that was set. */
static struct worst worst_of(const cupola_plan *plan)
{
    struct worst worst = {1e9, 1e9};
    visit_pixels(plan, look, &worst);
    return worst;
}

static struct cupola_rig theatre(int index)
{
    static const enum cupola_lens_model models[] = {CUPOLA_LENS_ANGULAR, CUPOLA_LENS_HEMISPHERIC,
                                                    CUPOLA_LENS_EQUISOLID, CUPOLA_LENS_ANGULAR};
    static const double fovs[] = {140.0, 170.0, 180.0, 180.0};
    struct cupola_rig rig = plain_rig(models[index], fovs[index], 150);
    rig.screen.radius_m = 2.0;
    rig.eye_m[0] = index % 2 ? 0.2 * rig.screen.radius_m : 0.0;
    rig.eye_m[2] = index > 1 ? -0.15 * rig.screen.radius_m : 0.0;
    rig.outputs[0].position_m[1] = index == 2 ? 0.3 * rig.screen.radius_m : 0.0;
    if (index == 3) {
        rig.screen.cap_rad = radians(80.0);
        rig.outputs[0].height_px = 110;
    }
    return rig;
}

static cupola_plan *moving_plan(const struct cupola_rig *rig, double radius_m)
{
    struct cupola_plan_params params = {.head_radius_m = radius_m};
    return plan_of(rig, &params);
}

static void no_eye_in_the_sphere_loses_a_texel_or_leaves_the_guard_band(void **state)
{
    (void)state;
    uint64_t seed = 95;
    for (int i = 0; i < 4; i++) {
        struct cupola_rig rig = theatre(i);
        double radius_m = (i % 2 ? 0.15 : 0.08) * rig.screen.radius_m;
        cupola_plan *plan = moving_plan(&rig, radius_m);
        struct cupola_view before[CUPOLA_VIEWS_MAX];
        int views = cupola_plan_view_count(plan);
        for (int v = 0; v < views; v++)
            before[v] = *cupola_plan_view(plan, v);
        for (int n = 0; n < 12; n++) {
            double eye[3], apart[3];
            random_in_ball(&seed, 1.0, apart);
            double length = sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
            for (int k = 0; k < 3; k++)
                eye[k] = rig.eye_m[k] + radius_m * apart[k] / (n % 2 ? length : 1.0);
            assert_int_equal(cupola_plan_set_eye(plan, eye, NULL), CUPOLA_OK);
            struct worst worst = worst_of(plan);
            check_at_least(worst.least, 1.0 - 1e-3);
            check_at_least(worst.margin, 2.0 - 0.02);
        }
        for (int v = 0; v < views; v++) {
            const struct cupola_view *after = cupola_plan_view(plan, v);
            assert_memory_equal(after->rotation, before[v].rotation, sizeof after->rotation);
            assert_memory_equal(after->selector, before[v].selector, sizeof after->selector);
            assert_memory_equal(&after->rect, &before[v].rect, sizeof after->rect);
            check_near(after->right - after->left, before[v].right - before[v].left, 1e-12);
        }
        cupola_plan_destroy(&plan);
    }
}

/* The same eyes with the plan of an eye that rests: the test can tell. */
static void a_plan_for_an_eye_at_rest_does_not_serve_another(void **state)
{
    (void)state;
    struct cupola_rig rig = theatre(0);
    cupola_plan *rest = plan_of(&rig, NULL);
    cupola_dome *moved;
    rig.eye_m[0] += 0.1 * rig.screen.radius_m;
    moved = dome_of(&rig);
    double least = 1e9;
    for (int j = 0; j < 150; j++)
        for (int i = 0; i < 150; i++) {
            struct cupola_ray ray;
            double jacobian[4], texel[2];
            if (cupola_dome_ray(moved, 0, NULL, i + 0.5, j + 0.5, &ray) <= 0)
                continue;
            int view = cupola_plan_select(rest, ray.direction);
            texel_of(rest, view, ray.direction, texel);
            texel_change(rest, view, ray.direction, ray.direction_dx, &jacobian[0], &jacobian[2]);
            texel_change(rest, view, ray.direction, ray.direction_dy, &jacobian[1], &jacobian[3]);
            least = fmin(least, smaller_singular_value(jacobian));
        }
    check_at_most(least, 0.97);
    cupola_dome_destroy(&moved);
    cupola_plan_destroy(&rest);
}

static void the_sphere_costs_little_more_than_its_middle(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 512);
    cupola_plan *rest = plan_of(&rig, NULL), *moving = moving_plan(&rig, 0.02);
    double ratio = cupola_plan_report(moving)->texels_masked_per_pixel /
                   cupola_plan_report(rest)->texels_masked_per_pixel;
    print_message("a sphere of 0.02 m costs %.4f\n", ratio);
    check_at_most(ratio, 1.08);
    cupola_plan_destroy(&rest);
    cupola_plan_destroy(&moving);
}

static void cameras_stand_where_the_eye_was_set(void **state)
{
    (void)state;
    struct cupola_rig rig = theatre(0);
    cupola_plan *plan = moving_plan(&rig, 0.1);
    struct cupola_camera before, after;
    const double eye[3] = {0.0, 0.0, 0.05};
    assert_int_equal(cupola_plan_camera(plan, 0, NULL, &before, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_set_eye(plan, eye, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_camera(plan, 0, NULL, &after, NULL), CUPOLA_OK);
    check_near(cupola_dome_rig(cupola_plan_dome(plan))->eye_m[2], 0.05, 0.0);
    /* -R e by the view's backward axis */
    check_near((double)after.view[14] - (double)before.view[14],
               -0.05 * cupola_plan_view(plan, 0)->rotation[8], 1e-6);
    cupola_plan_destroy(&plan);
}

static void an_eye_outside_of_the_sphere_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    struct cupola_rig rig = theatre(0);
    const double radii[] = {0.0, 0.1};
    for (int i = 0; i < 2; i++) {
        cupola_plan *plan = moving_plan(&rig, radii[i]);
        struct cupola_view before = *cupola_plan_view(plan, 0);
        struct cupola_error error = {CUPOLA_OK, ""};
        const double outside[3] = {0.125, 0.0, 0.0}, nowhere[3] = {(double)NAN, 0.0, 0.0};
        assert_int_equal(cupola_plan_set_eye(plan, outside, &error), CUPOLA_ERROR_ARGUMENT);
        check_message(&error, 0.125);
        assert_int_equal(cupola_plan_set_eye(plan, nowhere, &error), CUPOLA_ERROR_ARGUMENT);
        assert_int_equal(cupola_plan_set_eye(plan, NULL, &error), CUPOLA_ERROR_ARGUMENT);
        assert_int_equal(cupola_plan_set_eye(NULL, outside, &error), CUPOLA_ERROR_ARGUMENT);
        assert_memory_equal(cupola_plan_view(plan, 0), &before, sizeof before);
        assert_int_equal(cupola_plan_set_eye(plan, rig.eye_m, &error), CUPOLA_OK);
        cupola_plan_destroy(&plan);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_eye_in_the_sphere_loses_a_texel_or_leaves_the_guard_band),
        cmocka_unit_test(a_plan_for_an_eye_at_rest_does_not_serve_another),
        cmocka_unit_test(the_sphere_costs_little_more_than_its_middle),
        cmocka_unit_test(cameras_stand_where_the_eye_was_set),
        cmocka_unit_test(an_eye_outside_of_the_sphere_is_refused_and_changes_nothing),
    };
    return cmocka_run_group_tests_name("plan_head", tests, NULL, NULL);
}
