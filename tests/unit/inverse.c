/* The way back: from a direction to the pixel that shows it. */
#include "oracle.h"

/* How far from a place the inverse of its own ray lands; -1 where it says that nothing is lit. */
static double return_error_px(const cupola_dome *dome, const cupola_dome *back,
                              const double place[2], double length)
{
    struct cupola_ray ray;
    double direction[3], pixel[2];
    if (cupola_dome_ray(dome, 0, NULL, place[0], place[1], &ray) < 0)
        fail_msg("no ray at %g, %g", place[0], place[1]);
    for (int i = 0; i < 3; i++)
        direction[i] = ray.direction[i] * length;
    if (cupola_dome_pixel(back, 0, NULL, direction, pixel) != 1)
        return -1.0;
    return hypot(pixel[0] - place[0], pixel[1] - place[1]);
}

static int inside(const struct cupola_output *output, const double place[2], double margin_px)
{
    double r = hypot(place[0] - output->circle.center_x_px, place[1] - output->circle.center_y_px);
    return r <= output->circle.radius_px - margin_px && place[0] >= margin_px &&
           place[1] >= margin_px && place[0] <= output->width_px - margin_px &&
           place[1] <= output->height_px - margin_px;
}

static void a_direction_returns_to_the_pixel_that_it_came_from(void **state)
{
    (void)state;
    uint64_t seed = 31;
    int tried = 0;
    for (int i = 0; i < 300; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        cupola_dome *dome = dome_of(&rig);
        for (int j = 0; j < 30; j++) {
            double place[2] = {random_between(&seed, 0.0, rig.outputs[0].width_px),
                               random_between(&seed, 0.0, rig.outputs[0].height_px)};
            if (!inside(&rig.outputs[0], place, 1e-6))
                continue;
            double length = pow(10.0, random_between(&seed, -3.0, 3.0));
            double error = return_error_px(dome, dome, place, length);
            check_at_least(error, 0.0);
            check_at_most(error, 1e-7);
            tried++;
        }
        cupola_dome_destroy(&dome);
    }
    check_at_least(tried, 3000);
}

/* The curve is vertical at this rim: the radius there is well known, though its angle is not. */
static void the_singular_rim_of_a_hemispheric_lens_returns_too(void **state)
{
    (void)state;
    uint64_t seed = 32;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 1000);
    cupola_dome *dome = dome_of(&rig);
    for (int i = 0; i < 1000; i++) {
        double theta = random_between(&seed, -pi, pi);
        double r = 500.0 * (1.0 - pow(10.0, random_between(&seed, -9.0, -1.0)));
        double place[2] = {500.0 + r * cos(theta), 500.0 + r * sin(theta)};
        double error = return_error_px(dome, dome, place, 1.0);
        check_at_least(error, 0.0);
        check_at_most(error, 1e-7);
    }
    cupola_dome_destroy(&dome);
}

static void a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_does_not_return(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 200);
    const double place[2] = {130.0, 60.0};
    cupola_dome *right = dome_of(&rig);
    rig.tilt_rad = radians(0.1);
    cupola_dome *tilted = dome_of(&rig);
    rig.tilt_rad = 0.0;
    rig.outputs[0].circle = (struct cupola_circle){101.0, 100.0, 100.0};
    cupola_dome *moved = dome_of(&rig);
    check_at_least(return_error_px(right, tilted, place, 1.0), 0.05);
    check_near(return_error_px(right, moved, place, 1.0), 1.0, 1e-9);
    cupola_dome_destroy(&right);
    cupola_dome_destroy(&tilted);
    cupola_dome_destroy(&moved);
}

static void check_unlit(const struct cupola_rig *rig, double x, double y, double z)
{
    cupola_dome *dome = dome_of(rig);
    double direction[3] = {x, y, z}, pixel[2] = {-7.0, -8.0};
    assert_int_equal(cupola_dome_pixel(dome, 0, NULL, direction, pixel), 0);
    check_near(pixel[0], -7.0, 0.0);
    check_near(pixel[1], -8.0, 0.0);
    cupola_dome_destroy(&dome);
}

static void what_no_pixel_shows_has_no_pixel(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 100);
    check_unlit(&rig, sin(radians(70.5)), 0.0, -cos(radians(70.5))); /* beyond the lens */
    check_unlit(&rig, 0.0, 0.0, 1.0);
    rig.screen.cap_rad = radians(60.0);
    check_unlit(&rig, 0.0, sin(radians(61.0)), -cos(radians(61.0))); /* beyond the screen */
    rig.screen.cap_rad = 0.0;
    rig.outputs[0].height_px = 60;
    rig.outputs[0].circle = (struct cupola_circle){50.0, 30.0, 50.0};
    check_unlit(&rig, 0.0, sin(radians(45.0)), -cos(radians(45.0))); /* beyond the frame */
}

/* Two axes meet at one place; the pixel of the lens axis is the circle's centre, exactly. */
static void the_axis_returns_to_the_centre(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_STEREOGRAPHIC, 200.0, 101);
    cupola_dome *dome = dome_of(&rig);
    double direction[3] = {0.0, 0.0, -3.0}, pixel[2];
    assert_int_equal(cupola_dome_pixel(dome, 0, NULL, direction, pixel), 1);
    check_near(pixel[0], 50.5, 1e-12);
    check_near(pixel[1], 50.5, 1e-12);
    cupola_dome_destroy(&dome);
}

/* An eye of the caller's, and the same eye in the rig. */
static void the_eye_may_be_given_with_the_question(void **state)
{
    (void)state;
    uint64_t seed = 33;
    for (int i = 0; i < 50; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8), moved = rig;
        random_in_ball(&seed, 0.8 * rig.screen.radius_m, moved.eye_m);
        cupola_dome *dome = dome_of(&rig), *other = dome_of(&moved);
        double direction[3], one[2] = {0.0, 0.0}, two[2] = {0.0, 0.0};
        random_in_ball(&seed, 1.0, direction);
        assert_int_equal(cupola_dome_pixel(dome, 0, moved.eye_m, direction, one),
                         cupola_dome_pixel(other, 0, NULL, direction, two));
        check_near(one[0], two[0], 0.0);
        check_near(one[1], two[1], 0.0);
        cupola_dome_destroy(&dome);
        cupola_dome_destroy(&other);
    }
}

static void bad_questions_are_refused_and_change_nothing(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    cupola_dome *dome = dome_of(&rig);
    static const double ahead[3] = {0.0, 0.0, -1.0}, outside[3] = {0.0, 1.0, 0.0};
    static const double bad[4][3] = {{0.0, 0.0, 0.0},
                                     {(double)NAN, 0.0, -1.0},
                                     {0.0, (double)INFINITY, -1.0},
                                     {0.0, 0.0, (double)NAN}};
    double pixel[2] = {-7.0, -8.0};
    for (int i = 0; i < 4; i++)
        assert_int_equal(cupola_dome_pixel(dome, 0, NULL, bad[i], pixel), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_dome_pixel(dome, 0, outside, ahead, pixel), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_dome_pixel(dome, 1, NULL, ahead, pixel), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_dome_pixel(dome, -1, NULL, ahead, pixel), CUPOLA_ERROR_ARGUMENT);
    check_near(pixel[0], -7.0, 0.0);
    check_near(pixel[1], -8.0, 0.0);
    cupola_dome_destroy(&dome);
}

/* Lengths whose squares leave the range of a double are lengths all the same. */
static void any_length_of_a_direction_will_do(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    cupola_dome *dome = dome_of(&rig);
    static const double lengths[] = {1e-300, 1e-160, 1e160, 1e300};
    for (int i = 0; i < 4; i++) {
        double direction[3] = {0.0, 0.0, -lengths[i]}, pixel[2];
        assert_int_equal(cupola_dome_pixel(dome, 0, NULL, direction, pixel), 1);
        check_near(pixel[0], 32.0, 1e-12);
    }
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_direction_returns_to_the_pixel_that_it_came_from),
        cmocka_unit_test(the_singular_rim_of_a_hemispheric_lens_returns_too),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_does_not_return),
        cmocka_unit_test(what_no_pixel_shows_has_no_pixel),
        cmocka_unit_test(the_axis_returns_to_the_centre),
        cmocka_unit_test(the_eye_may_be_given_with_the_question),
        cmocka_unit_test(bad_questions_are_refused_and_change_nothing),
        cmocka_unit_test(any_length_of_a_direction_will_do),
    };
    return cmocka_run_group_tests_name("inverse", tests, NULL, NULL);
}
