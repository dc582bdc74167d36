/* The warp in plain C: what it shows is what the rays say, whatever the views are. */
#include "cupola/reference.h"

#include <stdlib.h>

#include "oracle.h"
#include "plan_pixels.h"

typedef void (*color_of)(const double direction[3], float rgba[4], void *user);

/* A dome image of a world that is a function of the ray; freed by the caller. */
static float *warp_output(const cupola_plan *plan, int index, color_of color, void *user,
                          const float border[4])
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    const struct cupola_output *output = &cupola_dome_rig(cupola_plan_dome(plan))->outputs[index];
    size_t texels = (size_t)report->atlas_width_px * (size_t)report->atlas_height_px;
    float *atlas = malloc(4 * texels * sizeof *atlas);
    float *image = malloc(4 * sizeof *image * (size_t)output->width_px * (size_t)output->height_px);
    assert_true(atlas && image);
    assert_int_equal(cupola_reference_views(plan, color, user, atlas), CUPOLA_OK);
    assert_int_equal(cupola_reference_warp(plan, index, atlas, border, image), CUPOLA_OK);
    free(atlas);
    return image;
}

static float *warp_of(const cupola_plan *plan, color_of color, void *user, const float border[4])
{
    return warp_output(plan, 0, color, user, border);
}

static void color_direction(const double direction[3], float rgba[4], void *user)
{
    (void)user;
    for (int i = 0; i < 3; i++)
        rgba[i] = (float)direction[i];
    rgba[3] = 1.0f;
}

/* Largest angle between the colour of a pixel and its ray by the oracle of another rig. */
static double output_error(const cupola_plan *plan, int index, const float *image,
                           const struct cupola_rig *oracle_rig)
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_output *output = &cupola_dome_rig(dome)->outputs[index];
    double worst = 0.0;
    for (int j = 0; j < output->height_px; j++) {
        for (int i = 0; i < output->width_px; i++) {
            struct cupola_ray ray;
            if (cupola_dome_ray(dome, index, NULL, i + 0.5, j + 0.5, &ray) != 1)
                continue;
            if ((i + j) % 3 && ray.coverage >= 1.0)
                continue; /* the oracle is slow: one in three, and all of the rim */
            const float *pixel = image + 4 * (j * output->width_px + i);
            double shown[3] = {(double)pixel[0], (double)pixel[1], (double)pixel[2]};
            if (ray.coverage < 0.01)
                continue; /* little is left of a colour that is mixed with a black border */
            struct oracle_ray oracle =
                oracle_ray_at(oracle_rig, oracle_rig->eye_m, i + 0.5, j + 0.5);
            double expected[3] = {(double)oracle.direction[0], (double)oracle.direction[1],
                                  (double)oracle.direction[2]};
            worst = fmax(worst, angle_between(shown, expected));
        }
    }
    return worst;
}

static double direction_error(const cupola_plan *plan, const float *image,
                              const struct cupola_rig *oracle_rig)
{
    return output_error(plan, 0, image, oracle_rig);
}

/*
 * Bilinear mixing of directions d rad apart errs by d^2 / 8; images of a hundred pixels have d up
 * to 0.04 where an eye off the axis comes near to the screen, so views are 1.5 times as dense here.
 * The bar is 0.01 degrees.
 */
static void the_color_of_a_direction_is_the_direction_of_the_ray(void **state)
{
    (void)state;
    uint64_t seed = 101;
    for (int i = 0; i < 8; i++) {
        struct cupola_rig rig;
        struct cupola_plan_params params;
        random_plan_case(&seed, &rig, &params);
        params.density = 1.5;
        cupola_plan *plan = plan_of(&rig, &params);
        float *image = warp_of(plan, color_direction, NULL, NULL);
        check_at_most(direction_error(plan, image, &rig), radians(0.01));
        free(image);
        cupola_plan_destroy(&plan);
    }
}

static void a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 102;
    struct cupola_rig rig = random_rig(&seed, 0.2), wrong = rig;
    cupola_plan *plan = plan_of(&rig, NULL);
    float *image = warp_of(plan, color_direction, NULL, NULL);
    check_at_most(direction_error(plan, image, &rig), radians(0.01));
    wrong.outputs[0].aim.pitch_rad += radians(0.1);
    check_at_least(direction_error(plan, image, &wrong), radians(0.05));
    wrong = rig;
    wrong.outputs[0].circle.center_y_px += 1.0;
    check_at_least(direction_error(plan, image, &wrong), radians(0.05));
    free(image);
    cupola_plan_destroy(&plan);
}

/* The oracle knows the first output of a rig. */
static void check_outputs(const cupola_plan *plan, const struct cupola_rig *rig, bool moved)
{
    for (int output = 0; output < 2; output++) {
        struct cupola_rig oracle = *rig;
        oracle.outputs[0] = rig->outputs[output];
        float *image = warp_output(plan, output, color_direction, NULL, NULL);
        double error = output_error(plan, output, image, &oracle);
        if (moved)
            check_at_most(error, radians(0.01));
        else
            check_at_least(error, radians(0.1));
        free(image);
    }
}

static void a_plan_that_was_moved_shows_the_rays_of_the_moved_eye(void **state)
{
    (void)state;
    uint64_t seed = 104;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_EQUISOLID, 150.0, 90);
    double radius_m = rig.screen.radius_m = 3.0;
    rig.tilt_rad = 0.5;
    rig.output_count = 2;
    rig.outputs[1] = rig.outputs[0];
    rig.outputs[1].aim.yaw_rad = 0.6;
    rig.outputs[1].position_m[0] = 0.2 * radius_m;
    const struct cupola_plan_params params = {.density = 1.5, .head_radius_m = 0.2 * radius_m};
    cupola_plan *plan = plan_of(&rig, &params);
    rig = *cupola_dome_rig(cupola_plan_dome(plan)); /* complete */
    for (int i = 0; i < 3; i++) {
        random_in_ball(&seed, params.head_radius_m, rig.eye_m);
        check_outputs(plan, &rig, false); /* the control: the eye before */
        assert_int_equal(cupola_plan_set_eye(plan, rig.eye_m, NULL), CUPOLA_OK);
        check_outputs(plan, &rig, true);
    }
    cupola_plan_destroy(&plan);
}

/* A world painted on the screen, as an eye that stands somewhere sees it. */
struct painted_screen {
    const cupola_dome *dome;
    double eye_m[3];
    double radius_m;
};

/* D by the law of cosines in the triangle of centre, eye and D. */
static void color_point(const double direction[3], float rgba[4], void *user)
{
    const struct painted_screen *screen = user;
    double v[3], along = 0.0, square = 0.0;
    cupola_dome_from_camera(screen->dome, direction, v);
    for (int i = 0; i < 3; i++) {
        along += screen->eye_m[i] * v[i];
        square += screen->eye_m[i] * screen->eye_m[i];
    }
    double distance = sqrt(screen->radius_m * screen->radius_m - (square - along * along)) - along;
    for (int i = 0; i < 3; i++)
        rgba[i] = (float)((screen->eye_m[i] + distance * v[i]) / screen->radius_m);
    rgba[3] = 1.0f;
}

/* Largest distance, in radii of the screen, between a pixel's colour and the point it lights. */
static double painting_error(const struct cupola_rig *rig, double eye_shift_m)
{
    cupola_plan *plan = plan_of(rig, NULL);
    const cupola_dome *dome = cupola_plan_dome(plan);
    struct painted_screen screen = {
        dome, {rig->eye_m[0], rig->eye_m[1], rig->eye_m[2]}, rig->screen.radius_m};
    screen.eye_m[0] += eye_shift_m;
    float *image = warp_of(plan, color_point, &screen, NULL);
    double worst = 0.0;
    for (int j = 0; j < rig->outputs[0].height_px; j++) {
        for (int i = 0; i < rig->outputs[0].width_px; i++) {
            struct cupola_ray ray;
            if (cupola_dome_ray(dome, 0, NULL, i + 0.5, j + 0.5, &ray) != 1 || ray.coverage < 1.0)
                continue;
            const float *pixel = image + 4 * (j * rig->outputs[0].width_px + i);
            for (int k = 0; k < 3; k++)
                worst = fmax(worst, fabs((double)pixel[k] - ray.point_m[k] / screen.radius_m));
        }
    }
    free(image);
    cupola_plan_destroy(&plan);
    return worst;
}

/*
 * The points do not depend on the eye (a test of rays.c), so that every eye's picture is theirs.
 * Bilinear mixing cuts the sphere's corners: texels are at most a pixel apart, 0.02 rad here, so
 * (0.02)^2 / 8 in each of two directions and 1e-4 together; an eye halfway to the screen may see
 * that part of it twice as steeply.
 */
static void the_eye_may_move_the_world_on_the_screen_may_not(void **state)
{
    (void)state;
    uint64_t seed = 103;
    struct cupola_rig rig = random_rig(&seed, 0.3);
    rig.outputs[0].width_px = 160;
    rig.outputs[0].height_px = 120;
    rig.outputs[0].circle = (struct cupola_circle){80.0, 60.0, 80.0};
    rig.outputs[0].lens = random_lens(&seed, CUPOLA_LENS_ANGULAR, radians(160.0));
    for (int i = 0; i < 10; i++) {
        random_in_ball(&seed, 0.5 * rig.screen.radius_m, rig.eye_m);
        check_at_most(painting_error(&rig, 0.0), 4e-4);
    }
    check_at_least(painting_error(&rig, 0.01 * rig.screen.radius_m), 4e-3);
}

static void color_white(const double direction[3], float rgba[4], void *user)
{
    (void)user;
    check_near(direction[0] * direction[0] + direction[1] * direction[1] +
                   direction[2] * direction[2],
               1.0, 1e-12);
    for (int i = 0; i < 4; i++)
        rgba[i] = 1.0f;
}

static void check_border(const struct cupola_rig *rig, const float border[4])
{
    static const float none[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    const float *expected = border ? border : none;
    cupola_plan *plan = plan_of(rig, NULL);
    float *image = warp_of(plan, color_white, NULL, border);
    const struct cupola_output *output = &cupola_dome_rig(cupola_plan_dome(plan))->outputs[0];
    int counts[3] = {0, 0, 0};
    for (int j = 0; j < output->height_px; j++) {
        for (int i = 0; i < output->width_px; i++) {
            struct cupola_ray ray;
            cupola_dome_ray(cupola_plan_dome(plan), 0, NULL, i + 0.5, j + 0.5, &ray);
            counts[ray.coverage <= 0.0 ? 0 : ray.coverage < 1.0 ? 1 : 2]++;
            for (int k = 0; k < 4; k++) {
                double edge = (double)expected[k];
                /* Mixed in floats. */
                check_near(image[4 * (j * output->width_px + i) + k],
                           edge + ray.coverage * (1.0 - edge), 1e-6);
            }
        }
    }
    for (int k = 0; k < 3; k++)
        check_at_least(counts[k], 100);
    free(image);
    cupola_plan_destroy(&plan);
}

static void the_rim_mixes_picture_and_border_by_coverage(void **state)
{
    (void)state;
    static const float border[4] = {0.2f, 0.4f, 0.6f, 0.8f};
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 101);
    check_border(&rig, border);
    check_border(&rig, NULL);
    rig.screen.cap_rad = radians(55.0);
    check_border(&rig, border);
}

struct call_count {
    int calls;
};

static void color_counted(const double direction[3], float rgba[4], void *user)
{
    (void)direction;
    ((struct call_count *)user)->calls++;
    for (int i = 0; i < 4; i++)
        rgba[i] = 1.0f;
}

static void every_texel_of_a_view_is_drawn_once_and_no_other(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 190.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    int width = report->atlas_width_px, height = report->atlas_height_px, expected = 0;
    float *atlas = malloc(4 * sizeof *atlas * (size_t)width * (size_t)height);
    assert_non_null(atlas);
    memset(atlas, 0x7f, 4 * sizeof *atlas * (size_t)width * (size_t)height);
    struct call_count count = {0};
    assert_int_equal(cupola_reference_views(plan, color_counted, &count, atlas), CUPOLA_OK);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            int inside = 0;
            for (int i = 0; i < cupola_plan_view_count(plan); i++) {
                const struct cupola_rect *rect = &cupola_plan_view(plan, i)->rect;
                inside += x >= rect->x && x < rect->x + rect->width && y >= rect->y &&
                          y < rect->y + rect->height;
            }
            expected += inside;
            for (int k = 0; k < 4; k++)
                check_near(atlas[4 * (y * width + x) + k], inside ? 1.0 : 0.0, 0.0);
        }
    }
    assert_int_equal(count.calls, expected);
    free(atlas);
    cupola_plan_destroy(&plan);
}

static void an_output_that_is_not_there_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 16);
    cupola_plan *plan = plan_of(&rig, NULL);
    static float atlas[4 * 256 * 256], image[4 * 16 * 16];
    memset(image, 0, sizeof image);
    assert_int_equal(cupola_reference_warp(plan, 1, atlas, NULL, image), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_warp(plan, -1, atlas, NULL, image), CUPOLA_ERROR_ARGUMENT);
    for (int i = 0; i < 4 * 16 * 16; i++)
        check_near(image[i], 0.0, 0.0);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_color_of_a_direction_is_the_direction_of_the_ray),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(a_plan_that_was_moved_shows_the_rays_of_the_moved_eye),
        cmocka_unit_test(the_eye_may_move_the_world_on_the_screen_may_not),
        cmocka_unit_test(the_rim_mixes_picture_and_border_by_coverage),
        cmocka_unit_test(every_texel_of_a_view_is_drawn_once_and_no_other),
        cmocka_unit_test(an_output_that_is_not_there_is_refused),
    };
    return cmocka_run_group_tests_name("reference", tests, NULL, NULL);
}
