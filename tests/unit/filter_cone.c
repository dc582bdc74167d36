/* The rays of a cone on the sphere: about the pixel's ray, round, and as wide as the pixel. */
#include "cupola/antialiasing.h"
#include "geometry/vector.h"
#include "plan_pixels.h"

struct spread {
    double across[2];  /* mean, in parts of the cone's radius */
    double xx, xy, yy; /* second moment, the same squared */
};

/* In the plane that touches the sphere at the pixel's ray; `radius` is that of the cone. */
static struct spread spread_of(const struct cupola_pixel_ray *rays, int count,
                               const struct cupola_ray *center, double radius)
{
    const double *n = center->direction;
    double helper[3] = {0.0, 0.0, 0.0}, x_axis[3], y_axis[3];
    helper[fabs(n[0]) < 0.6 ? 0 : 1] = 1.0;
    cross3(n, helper, x_axis);
    scale3(x_axis, 1.0 / length3(x_axis));
    cross3(n, x_axis, y_axis);
    struct spread sum = {0};
    for (int k = 0; k < count; k++) {
        double forward = dot3(rays[k].direction, n) * radius;
        double x = dot3(rays[k].direction, x_axis) / forward;
        double y = dot3(rays[k].direction, y_axis) / forward;
        sum.across[0] += rays[k].weight * x;
        sum.across[1] += rays[k].weight * y;
        sum.xx += rays[k].weight * x * x;
        sum.xy += rays[k].weight * x * y;
        sum.yy += rays[k].weight * y * y;
    }
    return sum;
}

struct seen {
    struct cupola_filter filter;
    double bias, width, roundness;
    int pixels;
};

static void look(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    struct seen *seen = user;
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    const struct cupola_output *output = &cupola_dome_rig(cupola_plan_dome(plan))->outputs[0];
    double r_px = hypot(pixel->x + 0.5 - output->circle.center_x_px,
                        pixel->y + 0.5 - output->circle.center_y_px);
    if ((pixel->x + 2 * pixel->y) % 7 || r_px > output->circle.radius_px - 1.5)
        return;
    int count = cupola_filter_rays(&seen->filter, plan, 0, pixel->x, pixel->y, rays, NULL);
    assert_int_equal(count, seen->filter.samples);
    /* A cap of solid angle O has the radius sqrt(O / pi), where it is small. */
    double radius = sqrt(pixel->ray.solid_angle_sr / pi);
    struct spread spread = spread_of(rays, count, &pixel->ray, radius);
    seen->bias = fmax(seen->bias, hypot(spread.across[0], spread.across[1]));
    seen->width = fmax(seen->width, fabs(spread.xx + spread.yy - 1.0 / 3.0));
    seen->roundness = fmax(seen->roundness, hypot(spread.xx - spread.yy, 2.0 * spread.xy));
    seen->pixels++;
}

/* Over random theatres. A table's lens may have bends where it was measured. */
static void look_at_plans(struct seen *seen)
{
    uint64_t seed = 521;
    for (int i = 0; i < 8; i++) {
        struct cupola_rig rig;
        struct cupola_plan_params params;
        random_plan_case(&seed, &rig, &params);
        cupola_plan *plan = plan_of(&rig, &params);
        visit_pixels(plan, look, seen);
        cupola_plan_destroy(&plan);
    }
    assert_true(seen->pixels > 3000);
}

/*
 * Of radii up to 0.1 rad, where the eye is near to the screen, the places' stretch by the tangent
 * and what v's length changes along the pixel are left: some percent of the radius.
 */
static void check_cone(enum cupola_pattern pattern, int samples, bool turned)
{
    struct seen seen = {.filter = {.method = CUPOLA_ANTIALIASING_CONE,
                                   .samples = samples,
                                   .pattern = pattern,
                                   .turned = turned}};
    look_at_plans(&seen);
    check_at_most(seen.bias, 0.02);
    check_at_most(seen.width, 0.01);
    check_at_most(seen.roundness, 0.01);
}

static void a_cone_is_round_and_as_wide_as_the_pixel(void **state)
{
    (void)state;
    check_cone(CUPOLA_PATTERN_REGULAR, 4, false);
    check_cone(CUPOLA_PATTERN_ROTATED_GRID, 16, true);
    check_cone(CUPOLA_PATTERN_BLUE_NOISE, 12, true);
}

/* The control: places that make no round cone; they are those of a pattern along the pixel. */
static void a_cone_that_is_not_round_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 160.0, 128);
    const struct cupola_plan_params params = {.density = 2.5};
    cupola_plan *plan = plan_of(&rig, &params);
    struct seen seen = {.filter = {.method = CUPOLA_ANTIALIASING_CONE, .samples = 4}};
    visit_pixels(plan, look, &seen);
    check_at_most(seen.roundness, 0.01);
    seen.filter.method = CUPOLA_ANTIALIASING_ADAPTIVE;
    visit_pixels(plan, look, &seen);
    check_at_least(seen.roundness, 0.3);
    cupola_plan_destroy(&plan);
}

/* An angle for each pixel from the seed, the same again, and another by another seed. */
static void turns_depend_on_pixel_and_seed_alone(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    struct cupola_pixel_ray first[CUPOLA_RAYS_MAX], again[CUPOLA_RAYS_MAX];
    struct cupola_filter filter = {.method = CUPOLA_ANTIALIASING_CONE, .turned = true, .seed = 5};
    int moved = 0;
    for (int x = 8; x < 56; x++) {
        assert_int_equal(cupola_filter_rays(&filter, plan, 0, x, 30, first, NULL), 4);
        assert_int_equal(cupola_filter_rays(&filter, plan, 0, x, 30, again, NULL), 4);
        check_near(first[0].x_px, again[0].x_px, 0.0);
        filter.seed = 6;
        assert_int_equal(cupola_filter_rays(&filter, plan, 0, x, 30, again, NULL), 4);
        moved += fabs(first[0].x_px - again[0].x_px) > 0.01;
        filter.seed = 5;
    }
    check_at_least(moved, 40);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cone_is_round_and_as_wide_as_the_pixel),
        cmocka_unit_test(a_cone_that_is_not_round_is_caught),
        cmocka_unit_test(turns_depend_on_pixel_and_seed_alone),
    };
    return cmocka_run_group_tests_name("filter_cone", tests, NULL, NULL);
}
