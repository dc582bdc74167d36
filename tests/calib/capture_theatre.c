/*
 * From end to end on a simulated theatre: patterns, photographs with noise, vignetting and ambient
 * light, marks, and the rig solved from them; judged by where the viewer sees things.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cupola/dome.h>
#include <cupola/rig_file.h>

#include "capture/command.h"
#include "capture/simulate.h"
#include "capture_fixture.h"
#include "check.h"
#include "marks.h"
#include "option_values.h"
#include "solve/solve.h"

static const double PI = 3.14159265358979323846;

/* What stands there: nothing is where a first guess would put it. */
static const struct cupola_rig truth = {
    .screen = {.radius_m = 1.6, .cap_rad = 1.6},
    .eye_m = {0.1, -0.1, 0.45},
    .tilt_rad = 0.35,
    .output_count = 1,
    .outputs = {{.width_px = 512,
                 .height_px = 448,
                 .circle = {256, 224, 250},
                 .lens = {.model = CUPOLA_LENS_EQUISOLID, .fov_rad = 2.97},
                 .position_m = {-0.12, -0.5, 0.2},
                 .aim = {-0.07, 0.3, 0.05}}},
};

/* What somebody would write down who has set it up. */
static void write_rigs(void)
{
    struct cupola_rig start = truth;

    capture_write_rig("true.cfg", &truth);
    start.outputs[0].position_m[0] = 0;
    start.outputs[0].position_m[1] = -0.4;
    start.outputs[0].position_m[2] = 0;
    start.outputs[0].aim = (struct cupola_aim){.pitch_rad = 0.2};
    capture_write_rig("start.cfg", &start);
}

static void run(const char *line)
{
    char message[MESSAGE_SIZE];

    if (capture_run(line, message) != 0)
        fail_msg("%s: %s", line, message);
}

static int begin(void **state)
{
    if (capture_enter_directory(state) != 0)
        return -1;
    write_rigs();
    run("patterns --rig true.cfg --folder p");
    return 0;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

struct errors {
    double median_deg, worst_deg;
};

/* How far apart the viewer sees a pixel of both rigs, over all that is lit. */
static struct errors compare(const struct cupola_rig *found)
{
    cupola_dome *a = NULL, *b = NULL;
    double *sizes = malloc(512 * 448 * sizeof *sizes);
    struct errors errors;
    int count = 0;

    assert_int_equal(cupola_dome_create(&truth, &a, NULL), 0);
    assert_int_equal(cupola_dome_create(found, &b, NULL), 0);
    for (int j = 0; j < 448; j += 6) {
        for (int i = 0; i < 512; i += 6) {
            struct cupola_ray right, wrong;
            double chord = 0;
            if (cupola_dome_ray(a, 0, NULL, i + 0.5, j + 0.5, &right) != 1 ||
                cupola_dome_ray(b, 0, NULL, i + 0.5, j + 0.5, &wrong) != 1)
                continue;
            for (int k = 0; k < 3; k++)
                chord += pow(right.direction[k] - wrong.direction[k], 2);
            sizes[count++] = 2 * asin(0.5 * sqrt(chord)) * 180 / PI;
        }
    }
    assert_true(count > 3000);
    qsort(sizes, (size_t)count, sizeof *sizes, by_size);
    errors = (struct errors){sizes[count / 2], sizes[count - 1]};
    free(sizes);
    cupola_dome_destroy(&a);
    cupola_dome_destroy(&b);
    return errors;
}

/* The rig solved from a file of marks, from the rough start. */
static struct errors solve_marks(const char *path)
{
    char message[MESSAGE_SIZE];
    struct cupola_rig start;
    struct marks marks;
    struct solve_result result;
    struct solve_request request = {.start = &start, .marks = &marks};
    struct errors errors;

    assert_int_equal(cupola_rig_read("start.cfg", NULL, &start, NULL), 0);
    assert_true(marks_read(path, true, &marks, message));
    check_near(marks.count, 200, 40);
    if (!solve(&request, &result, message))
        fail_msg("%s", message);
    errors = compare(&result.rig);
    solve_result_free(&result);
    marks_free(&marks);
    return errors;
}

static void check_errors(struct errors errors, const char *what)
{
    print_message("%s: %.5f degrees median, %.5f worst\n", what, errors.median_deg,
                  errors.worst_deg);
    check_at_most(errors.median_deg, 0.05);
    check_at_most(errors.worst_deg, 0.2);
}

#define SPOILT " --noise 0.02 --vignetting 0.4 --ambient 0.15 --blur 0.8 --exposure 0.7"

static void test_a_fisheye_at_the_eye_makes_the_dome_right(void **state)
{
    struct errors errors;
#define FISHEYE " --camera angular:185 --camera-circle 200,150,165"
#define DECODE_FISHEYE                                                                             \
    "decode --rig start.cfg --patterns p --folder photos --marks 200 --output m.csv" FISHEYE

    (void)state;
    run("simulate --rig true.cfg --patterns p --folder photos --photo-size 400x300 "
        "--seed 1 --references refs.csv" FISHEYE SPOILT);
    run(DECODE_FISHEYE);
    check_errors(solve_marks("m.csv"), "fisheye at the eye");

    /* The control: a camera that is off by one degree is no longer within the bound. */
    run(DECODE_FISHEYE " --camera-aim 1,0,0");
    errors = solve_marks("m.csv");
    check_at_least(errors.median_deg, 0.2);

    /* References put that right. */
    run(DECODE_FISHEYE " --camera-aim 1,0,0 --camera-free aim --references refs.csv");
    check_errors(solve_marks("m.csv"), "fisheye at the eye, its aim unknown");

    /* The lens's own circle forgotten. */
    run("decode --rig start.cfg --patterns p --folder photos --marks 200 --output m.csv "
        "--camera angular:185");
    errors = solve_marks("m.csv");
    check_at_least(errors.worst_deg, 0.4);
}

static void test_an_ordinary_camera_anywhere_makes_the_dome_right(void **state)
{
    char message[MESSAGE_SIZE];
    struct errors errors;
    struct cupola_rig solved;
#define DECODE_ORDINARY                                                                            \
    "decode --rig start.cfg --folder ordinary --marks 200 --references refs.csv "                  \
    "--camera-position 0,0,1.2 --output m.csv --camera rectilinear:"

    (void)state;
    run("simulate --rig true.cfg --patterns p --folder ordinary --photo-size 400x300 --seed 2 "
        "--camera rectilinear:80 --camera-position 0.3,0.35,1.35 --camera-aim 6,-22,4 "
        "--format png16 --references refs.csv" SPOILT);
    run(DECODE_ORDINARY "80 --solved solved.cfg");
    check_errors(solve_marks("m.csv"), "ordinary camera");
    assert_int_equal(cupola_rig_read("solved.cfg", NULL, &solved, NULL), 0);
    check_errors(compare(&solved), "ordinary camera, its own projector");

    /* A rig that cannot be kept, its backup's name being a folder's: no marks either. */
    capture_write_rig("kept.cfg", &truth);
    assert_int_equal(mkdir("kept.cfg.bak", 0777), 0);
    assert_int_equal(unlink("m.csv"), 0);
    assert_int_equal(capture_run(DECODE_ORDINARY "80 --solved kept.cfg", message), 1);
    assert_non_null(strstr(message, "kept.cfg.bak: is a directory"));
    assert_int_not_equal(access("m.csv", F_OK), 0);

    /* The control: a field of view off by 2 degrees; and what becomes of it if it is free. */
    run(DECODE_ORDINARY "82");
    errors = solve_marks("m.csv");
    check_at_least(errors.median_deg, 0.1);
    run(DECODE_ORDINARY "82 --camera-free pose,fov");
    check_errors(solve_marks("m.csv"), "ordinary camera, its fov unknown");
}

static void test_a_panorama_at_a_known_place_makes_the_dome_right(void **state)
{
    (void)state;
    run("patterns --rig true.cfg --folder p6 --steps 6");
    run("simulate --rig true.cfg --patterns p6 --folder panorama --photo-size 520x260 --seed 3 "
        "--camera equirectangular --camera-position 0,0.1,0.2 --format pfm" SPOILT);
    run("decode --rig start.cfg --folder panorama --marks 200 --output m.csv "
        "--camera equirectangular --camera-position 0,0.1,0.2");
    check_errors(solve_marks("m.csv"), "panorama");
}

/* Two ways to the same light: the library's simulated theatre, drawn by the GL, and rays in C. */
static void test_rays_and_the_library_s_theatre_see_the_same(void **state)
{
    const struct series series = {.size_px = {512, 448}, .period_px = 64, .steps = 4};
    char message[MESSAGE_SIZE];
    struct camera camera;
    struct cupola_rig rig;
    struct simulation simulation = {
        .rig = &rig, .camera = &camera, .exposure = 1, .ambient = 0.2, .vignetting = 0.3};
    struct photo shown, photos[2];
    double off = 0;

    (void)state;
    assert_int_equal(cupola_rig_complete(&truth, &rig, NULL), 0);
    assert_true(camera_parse("--camera", "rectilinear:70", &camera, message));
    assert_true(camera_fit(&camera, 160, 120, NULL, message));
    camera_aim(&camera, rig.tilt_rad, &(struct cupola_aim){0.1, -0.2, 0.05});
    camera.position_m[2] = 0.9;
    assert_true(capture_picture(&series, 12, &shown, message));
    for (int i = 0; i < 2; i++) {
        struct simulator *simulator = i ? simulator_create_by_rays(&simulation, message)
                                        : simulator_create(&simulation, message);
        assert_non_null(simulator);
        if (!i && !simulator_uses_gl(simulator))
            print_message("no GL: rays are compared with rays\n");
        assert_true(simulator_take(simulator, &shown, &photos[i], message));
        simulator_destroy(simulator);
    }
    for (int i = 0; i < 160 * 120; i++)
        off += fabs((double)(photos[0].light[i] - photos[1].light[i])) / (160 * 120);
    print_message("theatre and rays differ by %.2g (mean)\n", off);
    check_at_most(off, 0.002);
    /* The control: as far apart as one pixel is from the next. */
    off = 0;
    for (int i = 1; i < 160 * 120; i++)
        off += fabs((double)(photos[0].light[i] - photos[1].light[i - 1])) / (160 * 120);
    check_at_least(off, 0.01);
    photo_free(&shown);
    photo_free(&photos[0]);
    photo_free(&photos[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rays_and_the_library_s_theatre_see_the_same),
        cmocka_unit_test(test_a_fisheye_at_the_eye_makes_the_dome_right),
        cmocka_unit_test(test_an_ordinary_camera_anywhere_makes_the_dome_right),
        cmocka_unit_test(test_a_panorama_at_a_known_place_makes_the_dome_right),
    };
    return cmocka_run_group_tests_name("calib capture_theatre", tests, begin,
                                       capture_leave_directory);
}
