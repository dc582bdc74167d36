/* Depth: for each way that it may run, matrices and planes against what the distances say. */
#include "oracle.h"
#include "plan_pixels.h"

enum { MODES = 8 /* infinite, reversed, zero_to_one, each or not */ };

static struct cupola_depth mode_of(int mode, double near_distance, double far_distance)
{
    return (struct cupola_depth){near_distance, far_distance, mode & 1, mode & 2, mode & 4};
}

static struct cupola_camera camera_of(const cupola_plan *plan, int view,
                                      const struct cupola_depth *depth)
{
    struct cupola_camera camera;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_plan_camera(plan, view, depth, &camera, &error) != CUPOLA_OK)
        fail_msg("camera: %s", error.message);
    return camera;
}

/* The clip coordinates of a point that lies `distance` along a view's axis and beside it. */
static void clip_at(const cupola_plan *plan, int index, const struct cupola_camera *camera,
                    double distance, const double beside[2], double clip[4])
{
    const struct cupola_view *view = cupola_plan_view(plan, index);
    const double *eye = cupola_dome_rig(cupola_plan_dome(plan))->eye_m;
    double point[4] = {0, 0, 0, 1}, in_view[4];
    for (int i = 0; i < 3; i++)
        point[i] = eye[i] + distance * (beside[0] * view->rotation[i] +
                                        beside[1] * view->rotation[3 + i] - view->rotation[6 + i]);
    for (int step = 0; step < 2; step++) {
        const float *m = step ? camera->projection : camera->view;
        const double *from = step ? in_view : point;
        double to[4];
        for (int i = 0; i < 4; i++)
            to[i] = (double)m[i] * from[0] + (double)m[4 + i] * from[1] +
                    (double)m[8 + i] * from[2] + (double)m[12 + i] * from[3];
        memcpy(step ? clip : in_view, to, sizeof to);
    }
}

/* Depth is linear in 1 / distance, from one end of its range to the other: that is all there is. */
static double expected_depth(const struct cupola_depth *depth, double distance)
{
    double inverse_near = 1 / depth->near_distance;
    double inverse_far = depth->infinite ? 0 : 1 / depth->far_distance;
    double nearness = (1 / distance - inverse_far) / (inverse_near - inverse_far);
    double closeness_to_one = depth->reversed ? nearness : 1 - nearness;
    return depth->zero_to_one ? closeness_to_one : 2 * closeness_to_one - 1;
}

static cupola_plan *plan_of_mode(int mode, int extra)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, 48);
    rig.eye_m[0] = 0.125;
    rig.eye_m[2] = -0.25;
    struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ROTATED,
                                        .rotation_in_projection = (mode + extra) % 2};
    return plan_of(&rig, &params);
}

/* The largest difference of a plan's depths from those of `told`, in the unit of its range. */
static double depth_error(const cupola_plan *plan, const struct cupola_depth *depth,
                          const struct cupola_depth *told)
{
    static const double distances[] = {0.25, 0.3, 1, 4, 30, 199, 200};
    static const double beside[][2] = {{0, 0}, {0.3, -0.4}, {-0.7, 0.2}};
    double worst = 0;
    for (int view = 0; view < cupola_plan_view_count(plan); view++) {
        struct cupola_camera camera = camera_of(plan, view, depth);
        for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
            for (int k = 0; k < 3; k++) {
                double clip[4];
                clip_at(plan, view, &camera, distances[i], beside[k], clip);
                worst = fmax(worst, fabs(clip[3] - distances[i]) / distances[i]);
                worst = fmax(worst, fabs(clip[2] / clip[3] - expected_depth(told, distances[i])));
            }
        }
    }
    return worst;
}

/* Floats of 6e-8 in matrices whose numbers stand to each other as 1 m of displacement to 0.25 m. */
static void depth_runs_as_wished_in_all_eight_ways(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * MODES; i++) {
        cupola_plan *plan = plan_of_mode(i % MODES, i / MODES);
        struct cupola_depth depth = mode_of(i % MODES, 0.25, 200);
        check_at_most(depth_error(plan, &depth, &depth), 2e-6);
        cupola_plan_destroy(&plan);
    }
}

/* The control: each of the four numbers matters, by more than the tolerance. */
static void a_depth_that_runs_otherwise_is_caught(void **state)
{
    (void)state;
    for (int mode = 0; mode < MODES; mode++) {
        cupola_plan *plan = plan_of_mode(mode, 0);
        struct cupola_depth depth = mode_of(mode, 0.25, 200);
        for (int bit = 0; bit < 3; bit++) {
            struct cupola_depth wrong = mode_of(mode ^ 1 << bit, 0.25, 200);
            check_at_least(depth_error(plan, &depth, &wrong), 1e-3);
        }
        struct cupola_depth nearer = mode_of(mode, 0.2501, 200);
        check_at_least(depth_error(plan, &depth, &nearer), 1e-4);
        cupola_plan_destroy(&plan);
    }
}

/*
 * What lies infinitely far is at the far end exactly, not beyond: w is 0 there, and a direction's
 * clip z is that end times its clip w.
 */
static void infinity_is_the_far_end_to_the_bit(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * MODES; i++) {
        cupola_plan *plan = plan_of_mode(i % MODES, i / MODES);
        struct cupola_depth depth = mode_of(i % MODES | 1, 0.1, 0);
        float far_end = depth.reversed ? (depth.zero_to_one ? 0.0f : -1.0f) : 1.0f;
        for (int view = 0; view < cupola_plan_view_count(plan); view++) {
            struct cupola_camera camera = camera_of(plan, view, &depth);
            for (int column = 0; column < 3; column++)
                check_near(camera.projection[4 * column + 2],
                           far_end * camera.projection[4 * column + 3], 0);
        }
        cupola_plan_destroy(&plan);
    }
}

/*
 * Reversed depth from 0 to 1 keeps apart what forward depth in floats and in 24 bits does not: two
 * surfaces a thousandth of their distance apart, at a million units with near at 0.1.
 */
static void reversed_infinite_depth_separates_far_surfaces(void **state)
{
    (void)state;
    cupola_plan *plan = plan_of_mode(0, 0);
    const double beside[2] = {0, 0};
    float depths[2][2];
    for (int reversed = 0; reversed < 2; reversed++) {
        struct cupola_depth depth = {.infinite = true, .zero_to_one = true, .reversed = reversed};
        struct cupola_camera camera = camera_of(plan, 0, &depth);
        for (int i = 0; i < 2; i++) {
            double clip[4];
            clip_at(plan, 0, &camera, i ? 1.001e6 : 1e6, beside, clip);
            depths[reversed][i] = (float)(clip[2] / clip[3]);
        }
    }
    assert_true(depths[1][0] > depths[1][1]);
    assert_true(fabsf(depths[0][1] - depths[0][0]) < 0x1p-24f);
    cupola_plan_destroy(&plan);
}

/* All eight ways see the same part of the scene, but for the far end of the infinite ones. */
static void planes_do_not_depend_on_how_depth_runs(void **state)
{
    (void)state;
    static const float everywhere[4] = {0, 0, 0, 1};
    for (int extra = 0; extra < 2; extra++) {
        cupola_plan *plan = plan_of_mode(0, extra);
        for (int view = 0; view < cupola_plan_view_count(plan); view++) {
            struct cupola_depth plain = mode_of(0, 0.25, 200);
            struct cupola_camera expected = camera_of(plan, view, &plain);
            for (int mode = 1; mode < MODES; mode++) {
                struct cupola_depth depth = mode_of(mode, 0.25, 200);
                struct cupola_camera camera = camera_of(plan, view, &depth);
                assert_memory_equal(camera.planes, expected.planes, 5 * sizeof camera.planes[0]);
                assert_memory_equal(camera.planes[5],
                                    depth.infinite ? everywhere : expected.planes[5],
                                    sizeof everywhere);
            }
        }
        cupola_plan_destroy(&plan);
    }
}

static void all_zero_is_from_a_tenth_to_a_thousand(void **state)
{
    (void)state;
    cupola_plan *plan = plan_of_mode(0, 0);
    const struct cupola_depth zero = {0}, written = {0.1, 1000, false, false, false};
    const struct cupola_depth infinite = {.infinite = true};
    const struct cupola_depth nonsense = {0.1, (double)NAN, true, false, false};
    struct cupola_camera expected = camera_of(plan, 0, &written);
    struct cupola_camera of_null = camera_of(plan, 0, NULL), of_zero = camera_of(plan, 0, &zero);
    assert_memory_equal(&of_null, &expected, sizeof expected);
    assert_memory_equal(&of_zero, &expected, sizeof expected);
    /* Where there is no far end, its distance is not even looked at. */
    expected = camera_of(plan, 0, &infinite);
    of_zero = camera_of(plan, 0, &nonsense);
    assert_memory_equal(&of_zero, &expected, sizeof expected);
    cupola_plan_destroy(&plan);
}

static void matrices_are_finite_at_the_ends_of_what_is_allowed(void **state)
{
    (void)state;
    static const double ends[][2] = {{1e-20, 1e20}, {1e-20, 2e-20}, {9e19, 1e20}, {1e-20, 1.1e-20}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        for (int mode = 0; mode < MODES; mode++) {
            cupola_plan *plan = plan_of_mode(mode, 0);
            struct cupola_depth depth = mode_of(mode, ends[i][0], ends[i][1]);
            if (i == 2)
                depth.near_distance = nextafter(depth.far_distance, 0);
            struct cupola_camera camera = camera_of(plan, 0, &depth);
            for (int k = 0; k < 16; k++)
                assert_true(isfinite(camera.projection[k]));
            assert_true(fabsf(camera.projection[14]) > 0);
            cupola_plan_destroy(&plan);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_runs_as_wished_in_all_eight_ways),
        cmocka_unit_test(a_depth_that_runs_otherwise_is_caught),
        cmocka_unit_test(infinity_is_the_far_end_to_the_bit),
        cmocka_unit_test(reversed_infinite_depth_separates_far_surfaces),
        cmocka_unit_test(planes_do_not_depend_on_how_depth_runs),
        cmocka_unit_test(all_zero_is_from_a_tenth_to_a_thousand),
        cmocka_unit_test(matrices_are_finite_at_the_ends_of_what_is_allowed),
    };
    return cmocka_run_group_tests_name("depth", tests, NULL, NULL);
}
