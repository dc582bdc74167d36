/* The rays of a pixel: how many, where to and what they weigh, over random theatres. */
#include "cupola/antialiasing.h"

#include <stdlib.h>

#include "message.h"
#include "plan_pixels.h"

static const struct cupola_filter filters[] = {
    {.method = CUPOLA_ANTIALIASING_TEXTURE},
    {.method = CUPOLA_ANTIALIASING_NONE},
    {.method = CUPOLA_ANTIALIASING_CONE},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 7, .pattern = CUPOLA_PATTERN_ROTATED_GRID},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 16, .pattern = CUPOLA_PATTERN_BLUE_NOISE},
    {.method = CUPOLA_ANTIALIASING_CONE, .turned = true, .seed = 3},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE, .samples = 12, .turned = true},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT, .samples = 64},
};

enum { FILTERS = sizeof filters / sizeof filters[0] };

static int rays_at(const struct cupola_filter *filter, const cupola_plan *plan, int x, int y,
                   struct cupola_pixel_ray *rays)
{
    struct cupola_error error;
    int count = cupola_filter_rays(filter, plan, 0, x, y, rays, &error);
    if (count < 0)
        fail_msg("%s", error.message);
    return count;
}

/* Runs a visitor with every filter over random plans. */
struct visit {
    const struct cupola_filter *filter;
    int count; /* of what the visitor counts */
    double slip, worst, sum;
};

static void visit_plans(plan_visitor visitor, int plans, uint64_t seed, struct visit *visit)
{
    for (int i = 0; i < plans; i++) {
        struct cupola_rig rig;
        struct cupola_plan_params params;
        random_plan_case(&seed, &rig, &params);
        cupola_plan *plan = plan_of(&rig, &params);
        visit_pixels(plan, visitor, visit);
        cupola_plan_destroy(&plan);
    }
}

/* Places in the image, of which few are lit. */
static void check_sums(const cupola_plan *plan, int x, int y)
{
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    struct cupola_ray center;
    int lit = cupola_dome_ray(cupola_plan_dome(plan), 0, NULL, x + 0.5, y + 0.5, &center);
    for (int i = 0; i < FILTERS; i++) {
        double weights = 0.0;
        int count = rays_at(&filters[i], plan, x, y, rays);
        assert_int_equal(count > 0, lit);
        for (int k = 0; k < count; k++) {
            const double *v = rays[k].direction;
            weights += rays[k].weight;
            check_near(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 1.0, 1e-14);
            if (rays[k].x_px == 0.0 && rays[k].y_px == 0.0)
                check_near(angle_between(v, center.direction), 0.0, 1e-7);
        }
        if (count > 0)
            check_near(weights, 1.0, 1e-14);
    }
}

static void lit_pixels_have_rays_whose_weights_sum_to_1_and_others_none(void **state)
{
    (void)state;
    uint64_t seed = 511;
    for (int i = 0; i < 6; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.3);
        cupola_plan *plan = plan_of(&rig, NULL);
        for (int k = 0; k < 1000; k++)
            check_sums(plan, random_int(&seed, 0, rig.outputs[0].width_px - 1),
                       random_int(&seed, 0, rig.outputs[0].height_px - 1));
        cupola_plan_destroy(&plan);
    }
}

/* The solid angle of a texel, by the cosine of its angle to the view's axis. */
static double texel_solid_angle(const struct cupola_view *view, const double direction[3])
{
    double cosine = 0.0;
    for (int i = 0; i < 3; i++)
        cosine -= view->rotation[6 + i] * direction[i];
    double area = (view->right - view->left) * (view->top - view->bottom);
    return area / view->rect.width / view->rect.height * cosine * cosine * cosine;
}

/* Nearer to the rim changes are those of half a pixel inside. Every 5th pixel will do. */
static int counts(const cupola_plan *plan, const struct plan_pixel *pixel)
{
    const struct cupola_output *output = &cupola_dome_rig(cupola_plan_dome(plan))->outputs[0];
    double r_px = hypot(pixel->x + 0.5 - output->circle.center_x_px,
                        pixel->y + 0.5 - output->circle.center_y_px);
    return (pixel->x + 2 * pixel->y) % 5 == 0 && r_px < output->circle.radius_px - 0.5;
}

static void compare_adaptive(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    struct visit *visit = user;
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    if (!counts(plan, pixel))
        return;
    double texels =
        visit->slip * pixel->ray.solid_angle_sr /
            texel_solid_angle(cupola_plan_view(plan, pixel->view), pixel->ray.direction) -
        1e-3;
    if (fabs(texels - rint(texels)) < 1e-6)
        return;
    int wished = (int)fmin(fmax(ceil(texels), 1.0), visit->filter->samples);
    int count = rays_at(visit->filter, plan, pixel->x, pixel->y, rays);
    visit->worst = fmax(visit->worst, abs(count - wished));
    visit->count++;
}

static void adaptive_has_a_ray_for_every_texel_that_the_pixel_covers(void **state)
{
    (void)state;
    static const struct cupola_filter filter = {.method = CUPOLA_ANTIALIASING_ADAPTIVE,
                                                .samples = 9};
    struct visit visit = {.filter = &filter, .slip = 1.0};
    visit_plans(compare_adaptive, 4, 512, &visit);
    check_near(visit.worst, 0.0, 0.0);
    check_at_least(visit.count, 5000);
    visit.slip = 1.01; /* the control */
    visit_plans(compare_adaptive, 1, 512, &visit);
    check_at_least(visit.worst, 1.0);
}

/* The most texels that a pixel's width covers, over directions. */
static double longest(const double jacobian[4])
{
    double most = 0.0;
    for (int i = 0; i < 1000; i++) {
        double c = cos(pi * i / 1000.0), s = sin(pi * i / 1000.0);
        most =
            fmax(most, hypot(jacobian[0] * c + jacobian[1] * s, jacobian[2] * c + jacobian[3] * s));
    }
    return most;
}

/* Mean square of the rays' distances from the middle, in texels. */
static double variance_of(const double jacobian[4], const struct cupola_pixel_ray *rays, int count)
{
    double variance = 0.0;
    for (int k = 0; k < count; k++) {
        double u = jacobian[0] * rays[k].x_px + jacobian[1] * rays[k].y_px;
        double v = jacobian[2] * rays[k].x_px + jacobian[3] * rays[k].y_px;
        variance += rays[k].weight * (u * u + v * v);
    }
    return variance;
}

static void compare_footprint(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    struct visit *visit = user;
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    if (!counts(plan, pixel))
        return;
    double texels = visit->slip * longest(pixel->jacobian);
    if (fabs(texels + 0.4 - rint(texels + 0.4)) < 1e-4)
        return;
    int wished = (int)fmin(fmax(ceil(texels + 0.4), 1.0), 8.0);
    int count = rays_at(visit->filter, plan, pixel->x, pixel->y, rays);
    visit->worst = fmax(visit->worst, abs(count - wished));
    if (count == wished && count > 1 && texels > 0.8) {
        double variance = fmax(texels * texels - 0.6, 1e-3) / 12.0;
        visit->worst =
            fmax(visit->worst, fabs(variance_of(pixel->jacobian, rays, count) / variance - 1.0));
    }
    visit->count++;
}

/* With the 0.6 of a texel's square that the taps blur by themselves, it is the box's variance. */
static void a_footprint_is_as_long_as_the_pixel_and_has_a_ray_for_every_texel(void **state)
{
    (void)state;
    static const struct cupola_filter filter = {.method = CUPOLA_ANTIALIASING_FOOTPRINT,
                                                .samples = 64};
    struct visit visit = {.filter = &filter, .slip = 1.0};
    visit_plans(compare_footprint, 3, 513, &visit);
    check_at_most(visit.worst, 1e-3);
    check_at_least(visit.count, 2000);
    visit.slip = 1.01; /* the control */
    visit_plans(compare_footprint, 1, 513, &visit);
    check_at_least(visit.worst, 0.01);
}

/* How far taps, half a texel each way, reach beyond their view's rectangle. */
static void check_taps(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    struct visit *visit = user;
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    if ((pixel->x + 2 * pixel->y) % 5 && pixel->ray.coverage >= 1.0)
        return;
    for (int i = 2; i < FILTERS; i++) {
        int count = rays_at(&filters[i], plan, pixel->x, pixel->y, rays);
        for (int k = 0; k < count; k++) {
            double texel[2];
            int view = cupola_plan_select(plan, rays[k].direction);
            texel_of(plan, view, rays[k].direction, texel);
            const struct cupola_rect *rect = &cupola_plan_view(plan, view)->rect;
            visit->worst = fmax(visit->worst, rect->x + 0.5 - texel[0]);
            visit->worst = fmax(visit->worst, rect->y + 0.5 - texel[1]);
            visit->worst = fmax(visit->worst, texel[0] - (rect->x + rect->width - 0.5));
            visit->worst = fmax(visit->worst, texel[1] - (rect->y + rect->height - 0.5));
            visit->count++;
        }
    }
}

static void no_tap_of_a_ray_leaves_its_view(void **state)
{
    (void)state;
    struct visit visit = {.worst = -9.0};
    visit_plans(check_taps, 3, 514, &visit);
    check_at_most(visit.worst, 0.0);
    check_at_least(visit.worst, -2.5); /* the control: 3 texels less would be too few */
    check_at_least(visit.count, 50000);
}

/* From the circle's middle, px; pixels whose rays are not balanced are counted. */
static double farthest_ray(const struct cupola_filter *filter, int *unbalanced)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 101);
    cupola_plan *plan = plan_of(&rig, NULL);
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    double farthest = 0.0;
    *unbalanced = 0;
    for (int y = 0; y < 101; y++)
        for (int x = 0; x < 101; x++) {
            int count = rays_at(filter, plan, x, y, rays);
            double r = hypot(x - 50.0, y - 50.0), onto = fmin(50.5 / r, 1.0), mean[2] = {0.0, 0.0};
            for (int k = 0; k < count && r > 0.0; k++) {
                farthest = fmax(farthest, hypot(onto * (x - 50.0) + rays[k].x_px,
                                                onto * (y - 50.0) + rays[k].y_px));
                mean[0] += rays[k].weight * rays[k].x_px;
                mean[1] += rays[k].weight * rays[k].y_px;
            }
            *unbalanced += hypot(mean[0], mean[1]) > 1e-9;
        }
    cupola_plan_destroy(&plan);
    return farthest;
}

static void no_ray_of_a_pixel_at_the_rim_leaves_the_image_circle(void **state)
{
    (void)state;
    for (int i = 2; i < FILTERS; i++) {
        int unbalanced;
        double farthest = farthest_ray(&filters[i], &unbalanced);
        check_at_most(farthest, 50.5 + 1e-9);
        check_at_least(farthest, 50.4);
        check_at_least(unbalanced, 50); /* the control: others would have left it */
        check_at_most(unbalanced, 400);
    }
}

static void names_and_numbers_belong_together(void **state)
{
    (void)state;
    static const char *const methods[] = {"texture", "none", "cone", "adaptive", "footprint"};
    static const char *const patterns[] = {"regular", "rotated-grid", "blue-noise"};
    for (int i = 0; i < 5; i++) {
        assert_string_equal(cupola_antialiasing_name(i), methods[i]);
        assert_int_equal(cupola_antialiasing_find(methods[i]), i);
    }
    for (int i = 0; i < 3; i++) {
        assert_string_equal(cupola_pattern_name(i), patterns[i]);
        assert_int_equal(cupola_pattern_find(patterns[i]), i);
    }
    assert_null(cupola_antialiasing_name(5));
    assert_null(cupola_pattern_name(-1));
    assert_int_equal(cupola_antialiasing_find("fxaa"), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_antialiasing_find(NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_pattern_find("cones"), CUPOLA_ERROR_ARGUMENT);
}

static void impossible_wishes_are_refused_by_name_and_value(void **state)
{
    (void)state;
    static const struct {
        struct cupola_filter filter;
        int output, x, y;
        double named;
    } cases[] = {
        {{.method = (enum cupola_antialiasing)5}, 0, 1, 1, 5},
        {{.method = CUPOLA_ANTIALIASING_CONE, .samples = 65}, 0, 1, 1, 65},
        {{.method = CUPOLA_ANTIALIASING_FOOTPRINT, .samples = -1}, 0, 1, 1, -1},
        {{.method = CUPOLA_ANTIALIASING_TEXTURE, .samples = 5}, 0, 1, 1, 5},
        {{.method = CUPOLA_ANTIALIASING_NONE, .samples = 2}, 0, 1, 1, 2},
        {{.pattern = (enum cupola_pattern)3}, 0, 1, 1, 3},
        {{.samples = 0}, 1, 1, 1, 1},
        {{.samples = 0}, 0, 16, 1, 16},
        {{.samples = 0}, 0, 1, -3, -3},
    };
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 16);
    cupola_plan *plan = plan_of(&rig, NULL);
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        rays[0].weight = 7.0;
        assert_int_equal(cupola_filter_rays(&cases[i].filter, plan, cases[i].output, cases[i].x,
                                            cases[i].y, rays, &error),
                         CUPOLA_ERROR_ARGUMENT);
        check_message(&error, cases[i].named);
        check_near(rays[0].weight, 7.0, 0.0);
    }
    assert_int_equal(cupola_filter_rays(NULL, NULL, 0, 0, 0, rays, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_filter_rays(NULL, plan, 0, 0, 0, NULL, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_filter_rays(NULL, plan, 0, 8, 8, rays, NULL), 1);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lit_pixels_have_rays_whose_weights_sum_to_1_and_others_none),
        cmocka_unit_test(adaptive_has_a_ray_for_every_texel_that_the_pixel_covers),
        cmocka_unit_test(a_footprint_is_as_long_as_the_pixel_and_has_a_ray_for_every_texel),
        cmocka_unit_test(no_tap_of_a_ray_leaves_its_view),
        cmocka_unit_test(no_ray_of_a_pixel_at_the_rim_leaves_the_image_circle),
        cmocka_unit_test(names_and_numbers_belong_together),
        cmocka_unit_test(impossible_wishes_are_refused_by_name_and_value),
    };
    return cmocka_run_group_tests_name("filter", tests, NULL, NULL);
}
