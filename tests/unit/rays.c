/* Points and rays: the invariants of a dome, and the conventions of aim, tilt and flip. */
#include "oracle.h"

static const double centre[3] = {0.0, 0.0, 0.0};

static struct cupola_ray ray_at(const cupola_dome *dome, const double eye[3], double x, double y)
{
    struct cupola_ray ray;
    if (cupola_dome_ray(dome, 0, eye, x, y, &ray) < 0)
        fail_msg("no ray at %g, %g", x, y);
    return ray;
}

/* A place within the circle, up to `most` of its radius from its centre. */
static void random_place(uint64_t *seed, const struct cupola_output *output, double most,
                         double place[2])
{
    double r = sqrt(random_between(seed, 0.0, most * most)), theta = random_between(seed, -pi, pi);
    place[0] = output->circle.center_x_px + output->circle.radius_px * r * cos(theta);
    place[1] = output->circle.center_y_px + output->circle.radius_px * r * sin(theta);
}

static double oracle_error(const cupola_dome *dome, const struct cupola_rig *rig,
                           const double place[2])
{
    struct cupola_ray ray = ray_at(dome, NULL, place[0], place[1]);
    struct oracle_ray expected = oracle_ray_at(rig, rig->eye_m, place[0], place[1]);
    double error = 0.0;
    for (int i = 0; i < 3; i++) {
        error = fmax(error, fabs(ray.direction[i] - (double)expected.direction[i]));
        error = fmax(error, fabs(ray.lens_direction[i] - (double)expected.lens_ray[i]));
        error =
            fmax(error, fabs(ray.point_m[i] - (double)expected.point[i]) / rig->screen.radius_m);
    }
    return error;
}

static void points_and_rays_are_those_of_the_oracle(void **state)
{
    (void)state;
    uint64_t seed = 21;
    for (int i = 0; i < 300; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        cupola_dome *dome = dome_of(&rig);
        for (int j = 0; j < 20; j++) {
            double place[2];
            random_place(&seed, &rig.outputs[0], 1.2, place);
            /* Some roundings, times at most 6 for the lens and 5 for the distance of the eye. */
            check_at_most(oracle_error(dome, &rig, place), 1e-13);
        }
        cupola_dome_destroy(&dome);
    }
}

static void a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 22;
    struct cupola_rig right = random_rig(&seed, 0.8);
    double place[2];
    random_place(&seed, &right.outputs[0], 0.9, place);
    for (int i = 0; i < 6; i++) {
        struct cupola_rig wrong = right;
        double *members[6] = {&wrong.outputs[0].aim.yaw_rad,  &wrong.outputs[0].aim.pitch_rad,
                              &wrong.outputs[0].aim.roll_rad, &wrong.tilt_rad,
                              &wrong.outputs[0].lens.fov_rad, &wrong.outputs[0].circle.center_x_px};
        *members[i] += i < 5 ? -radians(0.1) : 1.0;
        cupola_dome *dome = dome_of(&wrong);
        check_at_least(oracle_error(dome, &right, place), 1e-5);
        cupola_dome_destroy(&dome);
    }
}

static void a_ray_leads_from_the_eye_to_a_point_on_the_screen(void **state)
{
    (void)state;
    uint64_t seed = 23;
    for (int i = 0; i < 300; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        cupola_dome *dome = dome_of(&rig);
        double place[2], eye_to_point[3], seen[3], length = 0.0, radius = 0.0;
        random_place(&seed, &rig.outputs[0], 1.0, place);
        struct cupola_ray ray = ray_at(dome, NULL, place[0], place[1]);
        for (int j = 0; j < 3; j++) {
            radius += ray.point_m[j] * ray.point_m[j];
            length += ray.direction[j] * ray.direction[j];
            eye_to_point[j] = ray.point_m[j] - rig.eye_m[j];
        }
        check_near(sqrt(radius) / rig.screen.radius_m, 1.0, 1e-14);
        check_near(length, 1.0, 1e-15 * 4.0);
        cupola_dome_to_camera(dome, eye_to_point, seen);
        for (int j = 0; j < 3; j++)
            check_near(ray.direction[j] * ray.distance_m, seen[j], 1e-14 * rig.screen.radius_m);
        cupola_dome_destroy(&dome);
    }
}

/* E = L: a plain fisheye, whatever the screen. */
static void with_the_eye_in_the_lens_the_screen_does_not_matter(void **state)
{
    (void)state;
    uint64_t seed = 24;
    for (int i = 0; i < 100; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        rig.tilt_rad = 0.0;
        cupola_dome *dome = dome_of(&rig);
        double place[2];
        random_place(&seed, &rig.outputs[0], 1.0, place);
        struct cupola_ray ray = ray_at(dome, rig.outputs[0].position_m, place[0], place[1]);
        check_at_most(angle_between(ray.direction, ray.lens_direction), 1e-14);
        cupola_dome_destroy(&dome);
    }
}

static void an_eye_and_a_lens_near_the_centre_make_the_textbook_lens(void **state)
{
    (void)state;
    uint64_t seed = 25;
    for (int i = 0; i < 100; i++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 100);
        double off = i % 2 ? 0.0 : 1e-9;
        rig.outputs[0].lens = random_any_lens(&seed);
        random_in_ball(&seed, off, rig.eye_m);
        random_in_ball(&seed, off, rig.outputs[0].position_m);
        cupola_dome *dome = dome_of(&rig);
        double place[2];
        random_place(&seed, &cupola_dome_rig(dome)->outputs[0], 1.0, place);
        double x = (place[0] - 50.0) / 50.0, y = (place[1] - 50.0) / 50.0;
        double angle = cupola_lens_angle(&rig.outputs[0].lens, hypot(x, y));
        double expected[3] = {sin(angle) * x / hypot(x, y), sin(angle) * y / hypot(x, y),
                              -cos(angle)};
        struct cupola_ray ray = ray_at(dome, NULL, place[0], place[1]);
        /* An offset of 1e-9 R turns a ray by 2e-9 at most. */
        check_at_most(angle_between(ray.direction, expected), 1e-14 + 2.0 * off);
        cupola_dome_destroy(&dome);
    }
}

static void a_point_of_the_screen_does_not_depend_on_the_eye(void **state)
{
    (void)state;
    uint64_t seed = 26;
    for (int i = 0; i < 100; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        cupola_dome *dome = dome_of(&rig);
        double place[2], eye[3];
        random_place(&seed, &rig.outputs[0], 1.0, place);
        random_in_ball(&seed, 0.99 * rig.screen.radius_m, eye);
        struct cupola_ray one = ray_at(dome, NULL, place[0], place[1]);
        struct cupola_ray other = ray_at(dome, eye, place[0], place[1]);
        for (int j = 0; j < 3; j++) {
            check_near(one.point_m[j], other.point_m[j], 0.0);
            check_near(one.lens_direction[j], other.lens_direction[j], 0.0);
        }
        check_near(one.coverage, other.coverage, 0.0);
        cupola_dome_destroy(&dome);
    }
}

/* The ray of one place of a plain angular 180 degree rig of 200 x 200 px, lightly changed. */
static void check_direction(const struct cupola_rig *rig, double x_px, double y_px, double x,
                            double y, double z)
{
    cupola_dome *dome = dome_of(rig);
    struct cupola_ray ray = ray_at(dome, centre, x_px, y_px);
    check_near(ray.direction[0], x, 1e-15);
    check_near(ray.direction[1], y, 1e-15);
    check_near(ray.direction[2], z, 1e-15);
    cupola_dome_destroy(&dome);
}

static void positive_yaw_turns_left_pitch_up_and_roll_counter_clockwise(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 200);
    struct cupola_aim *aim = &rig.outputs[0].aim;
    check_direction(&rig, 100.0, 100.0, 0.0, 0.0, -1.0);
    *aim = (struct cupola_aim){.yaw_rad = 0.3};
    check_direction(&rig, 100.0, 100.0, -sin(0.3), 0.0, -cos(0.3));
    *aim = (struct cupola_aim){.pitch_rad = 0.3};
    check_direction(&rig, 100.0, 100.0, 0.0, sin(0.3), -cos(0.3));
    *aim = (struct cupola_aim){.roll_rad = 0.3};
    check_direction(&rig, 200.0, 100.0, cos(0.3), sin(0.3), 0.0);
    /* Roll first, then pitch, then yaw: the right rim rolls up, pitches back, yaws right. */
    *aim = (struct cupola_aim){pi / 2.0, pi / 2.0, pi / 2.0};
    check_direction(&rig, 200.0, 100.0, 1.0, 0.0, 0.0);
}

static void a_planetarium_has_its_front_at_the_bottom_of_the_image(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 200);
    rig.tilt_rad = pi / 2.0;
    check_direction(&rig, 100.0, 100.0, 0.0, 1.0, 0.0); /* the zenith in the middle */
    check_direction(&rig, 100.0, 0.0, 0.0, 0.0, -1.0);  /* the front at the bottom */
    check_direction(&rig, 200.0, 100.0, 1.0, 0.0, 0.0);
    rig.tilt_rad = 0.2; /* raised */
    check_direction(&rig, 100.0, 100.0, 0.0, sin(0.2), -cos(0.2));
}

static void flips_mirror_about_the_centre_of_the_circle(void **state)
{
    (void)state;
    uint64_t seed = 27;
    for (int i = 0; i < 100; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        rig.outputs[0].flip = CUPOLA_FLIP_NONE;
        cupola_dome *plain = dome_of(&rig);
        rig.outputs[0].flip = i % 3 + 1;
        cupola_dome *flipped = dome_of(&rig);
        double place[2], mirrored[2];
        random_place(&seed, &rig.outputs[0], 1.0, place);
        memcpy(mirrored, place, sizeof place);
        if (rig.outputs[0].flip & CUPOLA_FLIP_X)
            mirrored[0] = 2.0 * rig.outputs[0].circle.center_x_px - place[0];
        if (rig.outputs[0].flip & CUPOLA_FLIP_Y)
            mirrored[1] = 2.0 * rig.outputs[0].circle.center_y_px - place[1];
        struct cupola_ray one = ray_at(plain, NULL, mirrored[0], mirrored[1]);
        struct cupola_ray other = ray_at(flipped, NULL, place[0], place[1]);
        for (int j = 0; j < 3; j++) {
            double x = rig.outputs[0].flip & CUPOLA_FLIP_X ? -1.0 : 1.0;
            double y = rig.outputs[0].flip & CUPOLA_FLIP_Y ? -1.0 : 1.0;
            check_near(one.direction[j], other.direction[j], 1e-13);
            check_near(x * one.direction_dx[j], other.direction_dx[j], 1e-12);
            check_near(y * one.direction_dy[j], other.direction_dy[j], 1e-12);
        }
        cupola_dome_destroy(&plain);
        cupola_dome_destroy(&flipped);
    }
}

static void camera_and_dome_frame_differ_by_the_tilt(void **state)
{
    (void)state;
    uint64_t seed = 28;
    for (int i = 0; i < 20; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        cupola_dome *dome = dome_of(&rig);
        double w[3], v[3], c = cos(rig.tilt_rad), s = sin(rig.tilt_rad);
        random_in_ball(&seed, 1.0, w);
        cupola_dome_to_camera(dome, w, v);
        check_near(v[0], w[0], 0.0);
        check_near(v[1], c * w[1] - s * w[2], 1e-15);
        check_near(v[2], s * w[1] + c * w[2], 1e-15);
        cupola_dome_from_camera(dome, v, v); /* in place */
        for (int j = 0; j < 3; j++)
            check_near(v[j], w[j], 1e-15);
        cupola_dome_destroy(&dome);
    }
}

static void beyond_the_rim_the_nearest_place_answers(void **state)
{
    (void)state;
    uint64_t seed = 29;
    for (int i = 0; i < 100; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        const struct cupola_circle *circle = &rig.outputs[0].circle;
        cupola_dome *dome = dome_of(&rig);
        double theta = random_between(&seed, -pi, pi), far = random_between(&seed, 1.05, 3.0);
        double c = circle->radius_px * cos(theta), s = circle->radius_px * sin(theta);
        struct cupola_ray rim, beyond;
        rim = ray_at(dome, NULL, circle->center_x_px + c, circle->center_y_px + s);
        int lit = cupola_dome_ray(dome, 0, NULL, circle->center_x_px + far * c,
                                  circle->center_y_px + far * s, &beyond);
        assert_int_equal(lit, beyond.coverage > 0.0);
        if ((far - 1.0) * circle->radius_px > 1.0)
            assert_int_equal(lit, 0);
        check_at_most(angle_between(rim.direction, beyond.direction), 1e-12);
        cupola_dome_destroy(&dome);
    }
}

static void bad_questions_are_refused_and_change_nothing(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    cupola_dome *dome = dome_of(&rig);
    static const double eyes[5][3] = {{1.0, 0.0, 0.0},
                                      {0.8, 0.8, 0.0},
                                      {(double)NAN, 0.0, 0.0},
                                      {0.0, 0.0, (double)INFINITY},
                                      {0.0, -7.0, 0.0}};
    static const double places[4][2] = {
        {(double)NAN, 3.0}, {3.0, (double)NAN}, {(double)INFINITY, 3.0}, {3.0, -(double)INFINITY}};
    struct cupola_ray ray, before;
    memset(&ray, 0x5a, sizeof ray);
    memcpy(&before, &ray, sizeof ray);
    for (int i = 0; i < 5; i++)
        assert_int_equal(cupola_dome_ray(dome, 0, eyes[i], 3.0, 3.0, &ray), CUPOLA_ERROR_ARGUMENT);
    for (int i = 0; i < 4; i++)
        assert_int_equal(cupola_dome_ray(dome, 0, NULL, places[i][0], places[i][1], &ray),
                         CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_dome_ray(dome, -1, NULL, 3.0, 3.0, &ray), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_dome_ray(dome, 1, NULL, 3.0, 3.0, &ray), CUPOLA_ERROR_ARGUMENT);
    assert_memory_equal(&ray, &before, sizeof ray);
    assert_int_equal(cupola_dome_ray(dome, 0, NULL, 1e300, -1e300, &ray), 0);
    cupola_dome_destroy(&dome);
}

static void an_impossible_rig_makes_no_dome(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 190.0, 64);
    cupola_dome *marker = dome_of(&(struct cupola_rig){0}), *dome = marker;
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_dome_create(&rig, &dome, &error), CUPOLA_ERROR_ARGUMENT);
    assert_true(dome == marker);
    assert_true(error.message[0] != '\0');
    check_near(cupola_dome_rig(marker)->outputs[0].width_px, 1024.0, 0.0);
    cupola_dome_destroy(&marker);
    assert_null(marker);
    cupola_dome_destroy(&marker);
    cupola_dome_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_and_rays_are_those_of_the_oracle),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(a_ray_leads_from_the_eye_to_a_point_on_the_screen),
        cmocka_unit_test(with_the_eye_in_the_lens_the_screen_does_not_matter),
        cmocka_unit_test(an_eye_and_a_lens_near_the_centre_make_the_textbook_lens),
        cmocka_unit_test(a_point_of_the_screen_does_not_depend_on_the_eye),
        cmocka_unit_test(positive_yaw_turns_left_pitch_up_and_roll_counter_clockwise),
        cmocka_unit_test(a_planetarium_has_its_front_at_the_bottom_of_the_image),
        cmocka_unit_test(flips_mirror_about_the_centre_of_the_circle),
        cmocka_unit_test(camera_and_dome_frame_differ_by_the_tilt),
        cmocka_unit_test(beyond_the_rim_the_nearest_place_answers),
        cmocka_unit_test(bad_questions_are_refused_and_change_nothing),
        cmocka_unit_test(an_impossible_rig_makes_no_dome),
    };
    return cmocka_run_group_tests_name("rays", tests, NULL, NULL);
}
