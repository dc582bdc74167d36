/* Cameras, surfaces through places, and a camera of unknown pose: all without photographs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/projection.h>

#include "capture/pose.h"
#include "capture/surface_fit.h"
#include "check.h"
#include "option_values.h"

static const double PI = 3.14159265358979323846;

static struct camera make_camera(const char *text, int width, int height)
{
    char message[MESSAGE_SIZE];
    struct camera camera;

    if (!camera_parse("--camera", text, &camera, message) ||
        !camera_fit(&camera, width, height, NULL, message))
        fail_msg("%s", message);
    return camera;
}

static void test_places_and_rays_are_each_others_inverse(void **state)
{
    static const char *const lenses[] = {"rectilinear:75",   "equirectangular", "angular:180",
                                         "angular:230",      "hemispheric:160", "equisolid:190",
                                         "stereographic:200"};
    uint64_t seed = 1;

    (void)state;
    for (size_t n = 0; n < sizeof lenses / sizeof *lenses; n++) {
        struct camera camera = make_camera(lenses[n], 640, 320);
        const struct cupola_aim aim = {0.3, -0.4, 0.2};
        camera_aim(&camera, 0.35, &aim);
        camera.position_m[0] = 0.2;
        camera.position_m[2] = 0.9;
        for (int i = 0; i < 200; i++) {
            double place[2] = {random_between(&seed, 1, 639), random_between(&seed, 1, 319)};
            double ray[3], point[3], back[2] = {0};
            if (!camera_ray(&camera, place, ray))
                continue; /* beyond a fisheye's rim */
            for (int k = 0; k < 3; k++)
                point[k] = camera.position_m[k] + 3 * ray[k];
            assert_true(camera_place(&camera, point, back));
            check_near(hypot(back[0] - place[0], back[1] - place[1]), 0, 1e-6);
        }
    }
}

/* Written down by hand: where things are in pictures of cameras that look straight ahead. */
static void test_cameras_see_left_at_the_left_and_up_above(void **state)
{
    const double left_up[3] = {-1, 1, -1}; /* yaw 45 degrees, pitch atan(1 / sqrt 2) */
    struct camera camera = make_camera("rectilinear:90", 400, 400);
    double place[2], ray[3];
    struct cupola_aim aim = {0}, found;

    (void)state;
    assert_true(camera_place(&camera, (double[3]){-0.9, 0.9, -1}, place));
    check_near(place[0], 20, 1e-9);
    check_near(place[1], 380, 1e-9);
    camera = make_camera("equirectangular", 720, 360);
    assert_true(camera_place(&camera, left_up, place));
    check_near(place[0], 360 - 2 * 45, 1e-9);
    check_near(place[1], 180 + 2 * atan(sqrt(0.5)) * 180 / PI, 1e-9);
    camera = make_camera("angular:180", 400, 400);
    assert_true(camera_place(&camera, (double[3]){0, 1, -1}, place));
    check_near(place[0], 200, 1e-9);
    check_near(place[1], 300, 1e-9);
    /* Straight ahead of the viewer of a dome whose axis is raised by 30 degrees lies below it. */
    camera_aim(&camera, PI / 6, &aim);
    camera_ray(&camera, (double[2]){200, 200}, ray);
    check_near(ray[1], -0.5, 1e-12);
    check_near(ray[2], -sqrt(0.75), 1e-12);
    aim = (struct cupola_aim){0.5, 0.3, -0.7};
    camera_aim(&camera, PI / 6, &aim);
    camera_aim_of(&camera, PI / 6, &found);
    check_near(found.yaw_rad, 0.5, 1e-12);
    check_near(found.pitch_rad, 0.3, 1e-12);
    check_near(found.roll_rad, -0.7, 1e-12);
}

static void test_impossible_cameras_are_refused(void **state)
{
    static const char *const texts[] = {
        "",          "rectilinear",       "rectilinear:180", "fish:180",
        "angular:0", "hemispheric:200",   "polynomial:90",   "table",
        "angular:x", "equirectangular:90"};
    char message[MESSAGE_SIZE];
    struct camera camera;

    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        message[0] = 0;
        assert_false(camera_parse("--camera", texts[i], &camera, message));
        assert_int_equal(strncmp(message, "--camera", 8), 0);
    }
    assert_true(camera_parse("--camera", "equirectangular", &camera, message));
    assert_false(camera_fit(&camera, 640, 480, NULL, message));
    assert_non_null(strstr(message, "twice as wide"));
}

static void test_surfaces_pass_over_wrong_places(void **state)
{
    enum { SIDE = 15, COUNT = SIDE * SIDE };
    struct surface_sample samples[COUNT];
    struct surface_fit fit;
    uint64_t seed = 4;
    double errors = 0;

    (void)state;
    for (int i = 0; i < COUNT; i++) {
        double x = (i % SIDE - 7) / 7.0, y = (i / SIDE - 7) / 7.0;
        samples[i] = (struct surface_sample){.at = {x, y}};
        samples[i].place[0] = 40 + 7 * x - y + 0.3 * x * x + random_between(&seed, -0.1, 0.1);
        samples[i].place[1] = 70 + x + 8 * y - 0.2 * x * y + random_between(&seed, -0.1, 0.1);
        if (i % 6 == 0)
            samples[i].place[0] += 8; /* a stripe off */
    }
    assert_true(surface_fit(samples, COUNT, &fit));
    for (int i = 0; i < COUNT; i++)
        errors += samples[i].left_out != (i % 6 == 0);
    check_at_most(errors, 0);
    check_near(fit.spread[0], 0.1 / sqrt(3), 0.01);
    check_near(fit.middle[0], 40, 4 * fit.sd[0]);
    check_near(fit.middle[1], 70, 4 * fit.sd[1]);
    check_at_most(fit.sd[0], 0.01);
    for (int i = 0; i < COUNT; i++)
        samples[i].at[1] = 0; /* all on one line */
    assert_false(surface_fit(samples, COUNT, &fit));
}

/* A camera of unknown pose that sees what a projector lights. */
enum { PATCHES = 150 };
struct scene {
    struct cupola_rig rig, start;
    struct camera camera, start_camera;
    struct patch list[PATCHES];
    struct patches patches;
    struct mark references[4];
    struct marks marks;
    struct pose_request request;
};

static void make_patches(struct scene *scene, uint64_t *seed, double noise_px)
{
    scene->patches = (struct patches){.list = scene->list};
    while (scene->patches.count < PATCHES) {
        struct patch *patch = &scene->list[scene->patches.count];
        double ray[3], point[3];
        patch->camera_px[0] = random_between(seed, 0, scene->camera.width);
        patch->camera_px[1] = random_between(seed, 0, scene->camera.height);
        camera_ray(&scene->camera, patch->camera_px, ray);
        if (!camera_meets_sphere(scene->camera.position_m, ray, scene->rig.screen.radius_m,
                                 point) ||
            cupola_output_pixel(&scene->rig.outputs[0], point, patch->projector_px, NULL) != 1)
            continue;
        for (int k = 0; k < 2; k++)
            patch->projector_px[k] += noise_px * random_between(seed, -1, 1);
        scene->patches.count++;
    }
}

static void make_references(struct scene *scene, int count)
{
    static const double places[4][2] = {{150, 130}, {420, 350}, {480, 100}, {130, 380}};

    scene->marks = (struct marks){.kind = MARKS_POINTS, .list = scene->references, .count = count};
    for (int i = 0; i < count; i++) {
        struct mark *mark = &scene->references[i];
        double ray[3];
        snprintf(mark->name, sizeof mark->name, "r%d", i);
        memcpy(mark->pixel_px, places[i], sizeof mark->pixel_px);
        camera_ray(&scene->camera, mark->pixel_px, ray);
        camera_meets_sphere(scene->camera.position_m, ray, scene->rig.screen.radius_m, mark->place);
    }
}

static void make_scene(struct scene *scene, uint64_t seed, double noise_px, int references)
{
    struct cupola_aim aim = {random_between(&seed, -0.2, 0.2), random_between(&seed, -0.3, 0.1),
                             random_between(&seed, -0.2, 0.2)};

    memset(scene, 0, sizeof *scene);
    scene->rig = (struct cupola_rig){.screen = {.radius_m = 2.2, .cap_rad = PI / 2}};
    assert_int_equal(cupola_rig_complete(&scene->rig, &scene->rig, NULL), 0);
    for (int i = 0; i < 3; i++)
        scene->rig.outputs[0].position_m[i] = random_between(&seed, -0.6, 0.6);
    scene->rig.outputs[0].aim.pitch_rad = random_between(&seed, -0.3, 0.3);
    scene->start = scene->rig;
    memset(scene->start.outputs[0].position_m, 0, 3 * sizeof(double));
    scene->start.outputs[0].aim = (struct cupola_aim){0};
    scene->camera = make_camera("rectilinear:70", 600, 450);
    camera_aim(&scene->camera, 0, &aim);
    scene->camera.position_m[0] = random_between(&seed, -0.5, 0.5);
    scene->camera.position_m[1] = random_between(&seed, -0.5, 0.5);
    scene->camera.position_m[2] = random_between(&seed, 0.8, 2.6); /* before or behind the rim */
    scene->start_camera = make_camera("rectilinear:70", 600, 450);
    scene->start_camera.position_m[2] = 1.6;
    make_patches(scene, &seed, noise_px);
    make_references(scene, references);
    scene->request = (struct pose_request){.rig = &scene->start,
                                           .camera = &scene->start_camera,
                                           .free = POSE_POSITION | POSE_AIM,
                                           .patches = &scene->patches,
                                           .references = &scene->marks};
}

static double position_error(const struct scene *scene, const struct pose_result *result)
{
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        sum = fmax(sum, fabs(result->camera.position_m[i] - scene->camera.position_m[i]));
        sum =
            fmax(sum, fabs(result->projector.position_m[i] - scene->rig.outputs[0].position_m[i]));
    }
    return sum;
}

static void test_pose_and_projector_are_found_together(void **state)
{
    char message[MESSAGE_SIZE];
    struct scene scene;
    struct pose_result result;

    (void)state;
    for (uint64_t seed = 1; seed <= 12; seed++) {
        make_scene(&scene, seed, 0, 2 + (int)seed % 3);
        if (!pose_solve(&scene.request, &result, message))
            fail_msg("seed %d: %s", (int)seed, message);
        check_at_most(position_error(&scene, &result), 1e-5);
        pose_result_free(&result);
    }
}

static void test_wrong_places_are_left_out_and_a_wrong_fov_is_found(void **state)
{
    char message[MESSAGE_SIZE];
    struct scene scene;
    struct pose_result result;

    (void)state;
    make_scene(&scene, 5, 0.05, 4);
    for (int i = 0; i < PATCHES; i += 15)
        scene.list[i].projector_px[i % 2] += 8;
    scene.start_camera.fov_rad *= 1.06;
    scene.request.free |= POSE_FOV;
    if (!pose_solve(&scene.request, &result, message))
        fail_msg("%s", message);
    assert_int_equal(result.rejected_count, PATCHES / 15);
    for (int i = 0; i < PATCHES; i++)
        assert_int_equal(result.rejected[i], i % 15 == 0);
    check_near(result.camera.fov_rad, scene.camera.fov_rad, 2e-3);
    check_at_most(position_error(&scene, &result), 0.01);
    pose_result_free(&result);
}

/* References off by half a pixel turn everything; the sd of the aims says by how much. */
static void test_errors_of_references_are_in_the_uncertainty(void **state)
{
    enum { TRIALS = 40 };
    char message[MESSAGE_SIZE];
    struct scene scene;
    double squares = 0, predicted = 0;
    uint64_t seed = 77;

    (void)state;
    for (int trial = 0; trial < TRIALS; trial++) {
        struct pose_result result;
        make_scene(&scene, 9, 0.03, 4);
        for (int i = 0; i < 8; i++) /* uniform, of standard deviation 1/2 */
            scene.references[i / 2].pixel_px[i % 2] += random_between(&seed, -0.866, 0.866);
        if (!pose_solve(&scene.request, &result, message))
            fail_msg("%s", message);
        squares += pow(result.projector.aim.pitch_rad - scene.rig.outputs[0].aim.pitch_rad, 2);
        predicted += pow(result.projector_aim_sd_rad, 2);
        pose_result_free(&result);
    }
    /* The largest of the three is predicted, and one of them looked at. */
    check_at_most(sqrt(squares / predicted), 1.3);
    check_at_least(sqrt(squares / predicted), 0.3);
    print_message("references off by 0.5 px: aims off by %.3f degrees, predicted %.3f\n",
                  sqrt(squares / TRIALS) * 180 / PI, sqrt(predicted / TRIALS) * 180 / PI);
}

static void test_what_fixes_no_direction_is_refused(void **state)
{
    char message[MESSAGE_SIZE];
    struct scene scene;
    struct pose_result result;

    (void)state;
    make_scene(&scene, 3, 0, 1);
    assert_false(pose_solve(&scene.request, &result, message));
    assert_non_null(strstr(message, "changes no photograph"));
    make_scene(&scene, 3, 0, 2);
    for (int k = 0; k < 3; k++)
        scene.references[1].place[k] = -scene.references[0].place[k];
    assert_false(pose_solve(&scene.request, &result, message));
    assert_non_null(strstr(message, "5 to 175 degrees"));
    make_scene(&scene, 3, 0, 2);
    scene.patches.count = 5;
    assert_false(pose_solve(&scene.request, &result, message));
    assert_non_null(strstr(message, "needs 12 marks"));
}

static void refuse_references(struct scene *scene, const char *reason)
{
    char message[MESSAGE_SIZE];
    struct pose_result result;

    assert_false(pose_solve(&scene->request, &result, message));
    if (!strstr(message, reason))
        fail_msg("'%s' does not say '%s'", message, reason);
    pose_result_free(&result);
}

static void swap_places(struct scene *scene, int a, int b)
{
    for (int k = 0; k < 3; k++) {
        double kept = scene->references[a].place[k];
        scene->references[a].place[k] = scene->references[b].place[k];
        scene->references[b].place[k] = kept;
    }
}

static void test_wrong_references_are_said_to_be_wrong(void **state)
{
    struct scene scene;

    (void)state;
    for (uint64_t seed = 1; seed <= 2; seed++) {
        make_scene(&scene, seed, 0.05, 4);
        for (int i = 0; i < 4; i++)
            scene.references[i].pixel_px[1] = 450 - scene.references[i].pixel_px[1];
        refuse_references(&scene, "--references do not fit the photographs: rms ");
        make_scene(&scene, seed, 0.05, 4);
        swap_places(&scene, 0, 1);
        refuse_references(&scene, "--references do not fit the photographs: rms ");
        make_scene(&scene, seed, 0.05, 4);
        scene.references[2].place[0] *= -1;
        refuse_references(&scene, "; without r2 the others fit to ");
        make_scene(&scene, seed, 0.05, 4);
        scene.references[1].pixel_px[0] = 5000;
        refuse_references(&scene, "r1 at (5000, 350) is not in the photograph");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_places_and_rays_are_each_others_inverse),
        cmocka_unit_test(test_cameras_see_left_at_the_left_and_up_above),
        cmocka_unit_test(test_impossible_cameras_are_refused),
        cmocka_unit_test(test_surfaces_pass_over_wrong_places),
        cmocka_unit_test(test_pose_and_projector_are_found_together),
        cmocka_unit_test(test_wrong_places_are_left_out_and_a_wrong_fov_is_found),
        cmocka_unit_test(test_errors_of_references_are_in_the_uncertainty),
        cmocka_unit_test(test_wrong_references_are_said_to_be_wrong),
        cmocka_unit_test(test_what_fixes_no_direction_is_refused),
    };
    return cmocka_run_group_tests_name("calib capture_camera", tests, NULL, NULL);
}
