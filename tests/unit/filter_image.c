/* Images that the warp in C makes with filters: constants, ramps, random texels. */
#include "cupola/reference.h"

#include <stdlib.h>

#include "plan_pixels.h"

static const struct cupola_filter filters[] = {
    {.method = CUPOLA_ANTIALIASING_TEXTURE},
    {.method = CUPOLA_ANTIALIASING_TEXTURE, .samples = 9},
    {.method = CUPOLA_ANTIALIASING_NONE},
    {.method = CUPOLA_ANTIALIASING_CONE},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 13, .pattern = CUPOLA_PATTERN_BLUE_NOISE},
    {.method = CUPOLA_ANTIALIASING_CONE, .turned = true},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE, .samples = 16},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT},
};

enum { FILTERS = sizeof filters / sizeof filters[0], SIZE = 128 };

static float *new_atlas(const cupola_plan *plan)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    float *atlas = malloc(4 * sizeof *atlas * (size_t)report->atlas_width_px *
                          (size_t)report->atlas_height_px);
    assert_non_null(atlas);
    return atlas;
}

static cupola_plan *new_plan(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, SIZE);
    rig.screen.radius_m = 1.0;
    rig.eye_m[1] = 0.2;
    rig.eye_m[2] = -0.1;
    return plan_of(&rig, NULL);
}

static void color_constant(const double direction[3], float rgba[4], void *user)
{
    (void)direction;
    for (int c = 0; c < 4; c++)
        rgba[c] = *(const float *)user;
}

/* The rim, too, mixes with a border of the same colour. */
static void what_is_the_same_everywhere_stays_so_to_the_last_bit(void **state)
{
    (void)state;
    static float image[4 * SIZE * SIZE];
    cupola_plan *plan = new_plan();
    float *atlas = new_atlas(plan);
    for (int level = 0; level <= 255; level += 17) {
        float value = (float)level / 255.0f;
        const float border[4] = {value, value, value, value};
        assert_int_equal(cupola_reference_views(plan, color_constant, &value, atlas), CUPOLA_OK);
        for (int i = 0; i < FILTERS; i++) {
            assert_int_equal(cupola_reference_filter(plan, 0, &filters[i], atlas, border, image),
                             CUPOLA_OK);
            for (int k = 0; k < 4 * SIZE * SIZE; k++)
                check_near(image[k], value, 0.0);
        }
    }
    free(atlas);
    cupola_plan_destroy(&plan);
}

static void color_ramp(const double direction[3], float rgba[4], void *user)
{
    (void)user;
    for (int c = 0; c < 3; c++)
        rgba[c] = (float)direction[c];
    rgba[3] = 1.0f;
}

struct ramp_error {
    double bias; /* of the mean over all pixels, in pixels' widths */
    double worst;
};

/*
 * Error of a picture of a ramp in x, in widths of a pixel: at r < 0.8, where a pixel's width bends
 * little.
 */
static struct ramp_error ramp_error(const cupola_plan *plan, const float *image, double shift_px)
{
    struct ramp_error error = {0.0, 0.0};
    double mean[2] = {0.0, 0.0};
    int pixels = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            struct cupola_ray ray;
            cupola_dome_ray(cupola_plan_dome(plan), 0, NULL, x + 0.5 + shift_px, y + 0.5, &ray);
            if (hypot(x + 0.5 - SIZE / 2.0, y + 0.5 - SIZE / 2.0) > 0.4 * SIZE)
                continue;
            const float *pixel = image + 4 * (y * SIZE + x);
            double width = sqrt(ray.solid_angle_sr);
            for (int c = 0; c < 2; c++) {
                double off = ((double)pixel[c] - ray.direction[c]) / width;
                mean[c] += off;
                error.worst = fmax(error.worst, fabs(off));
            }
            pixels++;
        }
    error.bias = hypot(mean[0], mean[1]) / pixels;
    return error;
}

/* Single pixels of the method none are half a texel off: their mean is nearly not. */
static void a_ramp_stays_where_it_is(void **state)
{
    (void)state;
    static float image[4 * SIZE * SIZE];
    cupola_plan *plan = new_plan();
    float *atlas = new_atlas(plan);
    assert_int_equal(cupola_reference_views(plan, color_ramp, NULL, atlas), CUPOLA_OK);
    for (int i = 0; i < FILTERS; i++) {
        bool nearest = filters[i].method == CUPOLA_ANTIALIASING_NONE;
        assert_int_equal(cupola_reference_filter(plan, 0, &filters[i], atlas, NULL, image),
                         CUPOLA_OK);
        struct ramp_error error = ramp_error(plan, image, 0.0);
        check_at_most(error.bias, nearest ? 0.02 : 0.002);
        check_at_most(error.worst, nearest ? 0.75 : 0.02);
        check_at_least(ramp_error(plan, image, 0.03).bias, 0.015); /* the control */
    }
    free(atlas);
    cupola_plan_destroy(&plan);
}

static float *random_atlas(const cupola_plan *plan)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    float *atlas = new_atlas(plan);
    uint64_t seed = 531;
    for (int k = 0; k < 4 * report->atlas_width_px * report->atlas_height_px; k++)
        atlas[k] = (float)random_between(&seed, 0.0, 1.0);
    return atlas;
}

/*
 * One channel round a place by weights of each texel that follow from its distance: a hat of half
 * width 1; for nine texels the mean of two such half a texel off; for the nearest a box.
 */
static double hat(double distance)
{
    return fmax(1.0 - fabs(distance), 0.0);
}

static double texel_weight(const struct cupola_filter *filter, double distance)
{
    if (filter->method == CUPOLA_ANTIALIASING_NONE)
        return distance >= -0.5 && distance < 0.5;
    if (filter->method == CUPOLA_ANTIALIASING_TEXTURE && filter->samples == 9)
        return 0.5 * (hat(distance - 0.5) + hat(distance + 0.5));
    return hat(distance);
}

static double weighed(const struct cupola_filter *filter, const cupola_plan *plan,
                      const float *atlas, const double texel[2])
{
    int width = cupola_plan_report(plan)->atlas_width_px;
    double sum = 0.0;
    for (int j = (int)texel[1] - 3; j <= (int)texel[1] + 3; j++)
        for (int i = (int)texel[0] - 3; i <= (int)texel[0] + 3; i++) {
            double weight =
                texel_weight(filter, texel[0] - i - 0.5) * texel_weight(filter, texel[1] - j - 0.5);
            if (weight > 0.0)
                sum += weight * (double)atlas[4 * (j * width + i)];
        }
    return sum;
}

/* What the public rays and the plan say of a pixel, put together here. */
static double expected_at(const struct cupola_filter *filter, const cupola_plan *plan,
                          const float *atlas, int x, int y, double slip)
{
    struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX];
    int count = cupola_filter_rays(filter, plan, 0, x, y, rays, NULL);
    double sum = 0.0;
    for (int k = 0; k < count; k++) {
        double texel[2];
        int view = cupola_plan_select(plan, rays[k].direction);
        texel_of(plan, view, rays[k].direction, texel);
        texel[0] += slip;
        sum += rays[k].weight * weighed(filter, plan, atlas, texel);
    }
    return sum;
}

/* A direction of unit length rounds otherwise than a ray: texels off by 1e-12, and nearest ones by
 * a whole one, once in a while. */
static void the_image_is_that_of_the_rays(void **state)
{
    (void)state;
    static float image[4 * SIZE * SIZE];
    cupola_plan *plan = new_plan();
    float *atlas = random_atlas(plan);
    for (int i = 0; i < FILTERS; i++) {
        double worst = 0.0, slipped = 0.0;
        assert_int_equal(cupola_reference_filter(plan, 0, &filters[i], atlas, NULL, image),
                         CUPOLA_OK);
        for (int y = 0; y < SIZE; y++)
            for (int x = (y * 3) % 5; x < SIZE; x += 5) {
                struct cupola_ray ray;
                cupola_dome_ray(cupola_plan_dome(plan), 0, NULL, x + 0.5, y + 0.5, &ray);
                double shown = (double)image[4 * (y * SIZE + x)];
                double expected = expected_at(&filters[i], plan, atlas, x, y, 0.0);
                double wrong = expected_at(&filters[i], plan, atlas, x, y, 0.01);
                worst = fmax(worst, fabs(shown - ray.coverage * expected));
                slipped = fmax(slipped, fabs(shown - ray.coverage * wrong));
            }
        check_at_most(worst, 1e-6);
        check_at_least(slipped, 0.004); /* the control */
    }
    free(atlas);
    cupola_plan_destroy(&plan);
}

static void no_filter_is_the_plain_warp(void **state)
{
    (void)state;
    static float plain[4 * SIZE * SIZE], filtered[4 * SIZE * SIZE];
    cupola_plan *plan = new_plan();
    float *atlas = random_atlas(plan);
    assert_int_equal(cupola_reference_warp(plan, 0, atlas, NULL, plain), CUPOLA_OK);
    assert_int_equal(cupola_reference_filter(plan, 0, NULL, atlas, NULL, filtered), CUPOLA_OK);
    assert_memory_equal(plain, filtered, sizeof plain);
    assert_int_equal(cupola_reference_filter(plan, 0, &filters[0], atlas, NULL, filtered),
                     CUPOLA_OK);
    assert_memory_equal(plain, filtered, sizeof plain);
    free(atlas);
    cupola_plan_destroy(&plan);
}

static void an_impossible_filter_leaves_the_image_alone(void **state)
{
    (void)state;
    static float image[4 * SIZE * SIZE];
    const struct cupola_filter wrong = {.method = CUPOLA_ANTIALIASING_CONE, .samples = 65};
    cupola_plan *plan = new_plan();
    float *atlas = random_atlas(plan);
    image[0] = 7.0f;
    assert_int_equal(cupola_reference_filter(plan, 0, &wrong, atlas, NULL, image),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_filter(plan, 1, NULL, atlas, NULL, image),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_filter(NULL, 0, NULL, atlas, NULL, image),
                     CUPOLA_ERROR_ARGUMENT);
    check_near(image[0], 7.0, 0.0);
    free(atlas);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_the_same_everywhere_stays_so_to_the_last_bit),
        cmocka_unit_test(a_ramp_stays_where_it_is),
        cmocka_unit_test(the_image_is_that_of_the_rays),
        cmocka_unit_test(no_filter_is_the_plain_warp),
        cmocka_unit_test(an_impossible_filter_leaves_the_image_alone),
    };
    return cmocka_run_group_tests_name("filter_image", tests, NULL, NULL);
}
