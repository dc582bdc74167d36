/* Cameras: the matrices and planes that a host draws with put a ray where the warp looks for it. */
#include "oracle.h"
#include "plan_pixels.h"

static void times(const float m[16], const double v[4], double out[4])
{
    for (int i = 0; i < 4; i++) {
        out[i] = 0.0;
        for (int j = 0; j < 4; j++)
            out[i] += (double)m[4 * j + i] * v[j];
    }
}

static struct cupola_camera camera_of(const cupola_plan *plan, int view, double near_distance,
                                      double far_distance)
{
    struct cupola_camera camera;
    struct cupola_error error = {CUPOLA_OK, ""};
    const struct cupola_depth depth = {.near_distance = near_distance,
                                       .far_distance = far_distance};
    if (cupola_plan_camera(plan, view, &depth, &camera, &error) != CUPOLA_OK)
        fail_msg("camera: %s", error.message);
    return camera;
}

/* The scene's point that a ray of a plan's eye meets after `metres`; scene units. */
static void point_on_ray(const struct cupola_rig *rig, const double eye[3],
                         const double direction[3], double metres, double point[4])
{
    double c = cos(rig->tilt_rad), s = sin(rig->tilt_rad);
    double in_camera[3] = {eye[0], c * eye[1] - s * eye[2], s * eye[1] + c * eye[2]};
    for (int i = 0; i < 3; i++)
        point[i] = rig->units_per_metre * (in_camera[i] + metres * direction[i]);
    point[3] = 1.0;
}

static void clip_of(const struct cupola_camera *camera, const double point[4], double clip[4])
{
    double in_eye[4];
    times(camera->view, point, in_eye);
    times(camera->projection, in_eye, clip);
}

/* A direction through a random place of a view's base rectangle, host's camera frame. */
static void random_ray(uint64_t *seed, const struct cupola_view *view, double direction[3])
{
    double a = random_between(seed, view->left, view->right);
    double b = random_between(seed, view->bottom, view->top), length = sqrt(a * a + b * b + 1.0);
    for (int i = 0; i < 3; i++)
        direction[i] =
            (view->rotation[i] * a + view->rotation[3 + i] * b - view->rotation[6 + i]) / length;
}

/*
 * The largest distance, as a part of a view, between where a host draws a point on a ray and where
 * the warp looks for it. `wrong_eye` is where the host believes the eye to be.
 */
static double drawing_error(const cupola_plan *plan, uint64_t *seed, const double eye[3])
{
    const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(plan));
    double worst = 0.0, unit = rig->units_per_metre;
    for (int k = 0; k < cupola_plan_view_count(plan); k++) {
        const struct cupola_view *view = cupola_plan_view(plan, k);
        struct cupola_camera camera = camera_of(plan, k, 0.1 * unit, 100.0 * unit);
        for (int i = 0; i < 50; i++) {
            double direction[3], point[4], clip[4], texel[2];
            random_ray(seed, view, direction);
            texel_of(plan, k, direction, texel);
            point_on_ray(rig, eye, direction, random_between(seed, 0.5, 50.0), point);
            clip_of(&camera, point, clip);
            check_at_least(clip[3], 0.0);
            double x = 2.0 * (texel[0] - view->rect.x) / view->rect.width - 1.0;
            double y = 2.0 * (texel[1] - view->rect.y) / view->rect.height - 1.0;
            worst = fmax(worst, fabs(clip[0] / clip[3] - x));
            worst = fmax(worst, fabs(clip[1] / clip[3] - y));
        }
    }
    return worst;
}

static cupola_plan *random_plan(uint64_t *seed, bool rotation_in_projection)
{
    struct cupola_rig rig;
    struct cupola_plan_params params;
    random_plan_case(seed, &rig, &params);
    rig.outputs[0].width_px = 90;
    rig.outputs[0].height_px = 70;
    rig.outputs[0].circle = (struct cupola_circle){45.0, 33.0, 44.0};
    params.rotation_in_projection = rotation_in_projection;
    return plan_of(&rig, &params);
}

/*
 * Matrices are of floats, 6e-8: the translation of the eye is up to 0.3 R of at least 0.5 R to the
 * point, and a ray 80 degrees off the axis divides by 0.17 of its length.
 */
static void a_host_draws_where_the_warp_looks(void **state)
{
    (void)state;
    uint64_t seed = 91;
    for (int i = 0; i < 16; i++) {
        cupola_plan *plan = random_plan(&seed, i % 2);
        const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(plan));
        check_at_most(drawing_error(plan, &seed, rig->eye_m), 1e-5);
        cupola_plan_destroy(&plan);
    }
}

static void an_eye_wrong_by_a_thousandth_of_a_metre_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 92;
    cupola_plan *plan = random_plan(&seed, true);
    const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(plan));
    double wrong[3] = {rig->eye_m[0] + 1e-3, rig->eye_m[1], rig->eye_m[2]};
    check_at_least(drawing_error(plan, &seed, wrong), 1e-4);
    cupola_plan_destroy(&plan);
}

/* GL's depth: -1 at the near and 1 at the far plane, along the view's axis. */
static void depth_runs_from_near_to_far(void **state)
{
    (void)state;
    uint64_t seed = 93;
    for (int i = 0; i < 10; i++) {
        cupola_plan *plan = random_plan(&seed, i % 2);
        const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(plan));
        double unit = rig->units_per_metre;
        for (int k = 0; k < cupola_plan_view_count(plan); k++) {
            const double *backward = cupola_plan_view(plan, k)->rotation + 6;
            struct cupola_camera camera = camera_of(plan, k, 0.5 * unit, 20.0 * unit);
            double ahead[3] = {-backward[0], -backward[1], -backward[2]}, point[4], clip[4];
            point_on_ray(rig, rig->eye_m, ahead, 0.5, point);
            clip_of(&camera, point, clip);
            check_near(clip[2] / clip[3], -1.0, 1e-4);
            point_on_ray(rig, rig->eye_m, ahead, 20.0, point);
            clip_of(&camera, point, clip);
            check_near(clip[2] / clip[3], 1.0, 1e-4);
        }
        cupola_plan_destroy(&plan);
    }
}

static void rotation_may_stand_in_the_projection_and_the_picture_is_the_same(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 190.0, 64);
    rig.eye_m[1] = 0.3;
    rig.tilt_rad = 0.4;
    struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ROTATED};
    cupola_plan *in_view = plan_of(&rig, &params);
    params.rotation_in_projection = true;
    cupola_plan *in_projection = plan_of(&rig, &params);
    for (int k = 0; k < cupola_plan_view_count(in_view); k++) {
        struct cupola_camera one = camera_of(in_view, k, 0.1, 10.0);
        struct cupola_camera two = camera_of(in_projection, k, 0.1, 10.0);
        /* Lighting in eye space: axes as the host's camera has them. */
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                check_near(two.view[4 * j + i], i == j ? 1.0 : 0.0, 0.0);
        }
        check_near(two.view[13], -0.3 * cos(0.4), 1e-7);
        check_near(two.view[14], -0.3 * sin(0.4), 1e-7);
        /* A frustum as GL knows it. */
        check_near(one.projection[3], 0.0, 0.0);
        check_near(one.projection[7], 0.0, 0.0);
        check_near(one.projection[11], -1.0, 0.0);
        check_near(one.projection[1], 0.0, 0.0);
        check_near(one.projection[4], 0.0, 0.0);
        for (int i = 0; i < 4; i++) {
            double point[4] = {0.0, 0.0, 0.0, 1.0}, clip[2][4];
            point[i] = 1.0;
            clip_of(&one, point, clip[0]);
            clip_of(&two, point, clip[1]);
            for (int j = 0; j < 4; j++)
                check_near(clip[0][j], clip[1][j], 1e-5);
        }
    }
    cupola_plan_destroy(&in_view);
    cupola_plan_destroy(&in_projection);
}

static double plane_value(const float plane[4], const double point[4])
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += (double)plane[i] * point[i];
    return sum;
}

/* Left, right, bottom, top, near, far: the inequality of clip space that each plane stands for. */
static double clip_value(int plane, const double clip[4])
{
    double value = clip[plane / 2];
    return plane % 2 ? clip[3] - value : clip[3] + value;
}

/* Points closer than 1e-4 of the scene to a plane may fall to either side in floats. */
static void planes_and_clip_space_agree_on_what_is_inside(void **state)
{
    (void)state;
    uint64_t seed = 94;
    int inside[6] = {0, 0, 0, 0, 0, 0}, outside[6] = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < 8; i++) {
        cupola_plan *plan = random_plan(&seed, i % 2);
        double unit = cupola_dome_rig(cupola_plan_dome(plan))->units_per_metre;
        for (int k = 0; k < cupola_plan_view_count(plan); k++) {
            struct cupola_camera camera = camera_of(plan, k, 2.0 * unit, 20.0 * unit);
            for (int j = 0; j < 200; j++) {
                double point[4], clip[4];
                random_in_ball(&seed, 40.0 * unit, point);
                point[3] = 1.0;
                clip_of(&camera, point, clip);
                for (int p = 0; p < 6; p++) {
                    double value = plane_value(camera.planes[p], point);
                    if (fabs(value) < 40.0 * unit * 1e-4)
                        continue;
                    assert_int_equal(value > 0.0, clip_value(p, clip) > 0.0);
                    value > 0.0 ? inside[p]++ : outside[p]++;
                }
            }
            for (int p = 0; p < 6; p++)
                check_near(hypot(hypot((double)camera.planes[p][0], (double)camera.planes[p][1]),
                                 (double)camera.planes[p][2]),
                           1.0, 1e-6);
        }
        cupola_plan_destroy(&plan);
    }
    for (int p = 0; p < 6; p++)
        check_at_least(inside[p] < outside[p] ? inside[p] : outside[p], 100);
}

/* Unit normals make a plane's value a distance: the near plane's from the eye is the near one. */
static void a_plane_measures_distances(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 190.0, 64);
    rig.eye_m[0] = 0.25;
    rig.units_per_metre = 10.0;
    cupola_plan *plan = plan_of(&rig, NULL);
    double eye[4] = {2.5, 0.0, 0.0, 1.0};
    for (int k = 0; k < cupola_plan_view_count(plan); k++) {
        struct cupola_camera camera = camera_of(plan, k, 0.5, 75.0);
        for (int p = 0; p < 4; p++)
            check_near(plane_value(camera.planes[p], eye), 0.0, 1e-5);
        check_near(plane_value(camera.planes[4], eye), -0.5, 1e-5);
        check_near(plane_value(camera.planes[5], eye), 75.0, 1e-3);
    }
    cupola_plan_destroy(&plan);
}

static void impossible_distances_are_refused_and_change_nothing(void **state)
{
    (void)state;
    static const struct cupola_depth bad[] = {
        {-1.0, 1.0, false, false, false},
        {1.0, 1.0, false, false, false},
        {2.0, 1.0, false, false, true},
        {2000.0, 0.0, false, true, true},
        {0.0, 0.1, false, true, false},
        {(double)NAN, 1.0, false, false, false},
        {1e-21, 1.0, false, false, false},
        {0.1, (double)NAN, false, false, false},
        {0.1, (double)INFINITY, false, true, true},
        {0.1, 1e21, false, true, true},
        {(double)INFINITY, 0.0, true, true, true},
        {1e21, 0.0, true, true, true},
        {-0.1, 0.0, true, false, true},
    };
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    struct cupola_camera camera, before;
    memset(&camera, 0x5a, sizeof camera);
    memcpy(&before, &camera, sizeof before);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(cupola_plan_camera(plan, 0, &bad[i], &camera, &error),
                         CUPOLA_ERROR_ARGUMENT);
        assert_non_null(strstr(error.message, "distance is "));
        assert_non_null(strstr(error.message, "allowed"));
    }
    assert_int_equal(cupola_plan_camera(plan, -1, NULL, &camera, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_camera(plan, cupola_plan_view_count(plan), NULL, &camera, NULL),
                     CUPOLA_ERROR_ARGUMENT);
    assert_memory_equal(&camera, &before, sizeof camera);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_host_draws_where_the_warp_looks),
        cmocka_unit_test(an_eye_wrong_by_a_thousandth_of_a_metre_is_caught),
        cmocka_unit_test(depth_runs_from_near_to_far),
        cmocka_unit_test(rotation_may_stand_in_the_projection_and_the_picture_is_the_same),
        cmocka_unit_test(planes_and_clip_space_agree_on_what_is_inside),
        cmocka_unit_test(a_plane_measures_distances),
        cmocka_unit_test(impossible_distances_are_refused_and_change_nothing),
    };
    return cmocka_run_group_tests_name("plan_camera", tests, NULL, NULL);
}
