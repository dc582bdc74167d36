/*
 * Pictures that are the mean of many frames: whatever ends the demo, the same command goes on to
 * the same picture, bit for bit; and what the mean is of.
 */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

enum { FAILED = 1, USAGE = 2, INTERRUPTED = 3, SIDE = 48, BYTES_MAX = 65536 };

#define STILL "--scene directions --size 48x48 --reference 1500 --output "

static struct process process;

struct bytes {
    size_t count;
    char at[BYTES_MAX];
};

static void read_bytes(const char *path, struct bytes *bytes)
{
    FILE *file = fopen(path, "rb");

    assert_non_null(file);
    bytes->count = fread(bytes->at, 1, BYTES_MAX, file);
    assert_true(bytes->count > 0 && bytes->count < BYTES_MAX);
    fclose(file);
}

static bool are_alike(const char *path, const char *other)
{
    static struct bytes bytes[2];

    read_bytes(path, &bytes[0]);
    read_bytes(other, &bytes[1]);
    return bytes[0].count == bytes[1].count &&
           memcmp(bytes[0].at, bytes[1].at, bytes[0].count) == 0;
}

static bool is_there(const char *path)
{
    return access(path, F_OK) == 0;
}

/* The state is replaced about once a second: kills before, between and in the middle of it. */
static void a_killed_run_goes_on_to_the_same_picture(void **state)
{
    (void)state;
    uint64_t seed = 6101;
    int kills = 0;

    demo_run(&process, STILL "whole.pfm");
    for (int round = 0; round < 2; round++) {
        int most_ms = round ? 300 : 10;
        for (int i = 0; i < 2; i++) {
            int ms = 1 + (int)random_between(&seed, 0, most_ms);
            process_run_until(&process, STILL "killed.pfm", "killed.pfm.part", ms, SIGKILL);
            kills += process.status == -1;
            assert_true(is_there("killed.pfm.part") || is_there("killed.pfm"));
        }
        process_run(&process, STILL "killed.pfm", NULL);
        assert_int_equal(process.status, 0);
        assert_true(are_alike("whole.pfm", "killed.pfm"));
        assert_false(is_there("killed.pfm.part"));
        assert_false(is_there("killed.pfm.part.tmp"));
        unlink("killed.pfm");
    }
    check_at_least(kills, 2);
    demo_run(&process, "--scene directions --size 48x48 --reference 1501 --output other.pfm");
    assert_false(are_alike("whole.pfm", "other.pfm")); /* the control: one frame more is seen */
}

static void check_refused(const char *command, const char *why)
{
    process_run(&process, command, NULL);
    assert_int_equal(process.status, FAILED);
    assert_non_null(strstr(process.err, why));
    assert_non_null(strstr(process.err, "part.pfm.part"));
    assert_true(is_there("part.pfm.part"));
}

/* Where the number of frames stands in a state. */
enum { FRAMES_AT = 24 + 4 + 4 + 1024 + 8 + 8 };

/* Doing it again undoes it. */
static void change_byte(const char *path, long at, int whence)
{
    FILE *file = fopen(path, "r+b");

    assert_non_null(file);
    assert_int_equal(fseek(file, at, whence), 0);
    int byte = fgetc(file);
    assert_int_equal(fseek(file, at, whence), 0);
    fputc(byte ^ 16, file);
    fclose(file);
}

static void an_interruption_keeps_every_frame(void **state)
{
    (void)state;
    static const int signals[] = {SIGINT, SIGTERM};

    for (int i = 0; i < 2; i++) {
        unlink("part.pfm.part");
        process_run_until(&process, STILL "part.pfm", "part.pfm.part", 30, signals[i]);
        assert_int_equal(process.status, INTERRUPTED);
        assert_non_null(strstr(process.err, "interrupted after "));
        assert_non_null(strstr(process.err, "part.pfm.part"));
        assert_null(strstr(process.err, "after 1 of")); /* the state that there was before */
        assert_true(is_there("part.pfm.part"));
        assert_false(is_there("part.pfm"));
    }
    change_byte("part.pfm.part", FRAMES_AT, SEEK_SET);
    check_refused(STILL "part.pfm", "damaged");
    change_byte("part.pfm.part", FRAMES_AT, SEEK_SET);
    process_run(&process, STILL "part.pfm", NULL);
    assert_int_equal(process.status, 0);
    assert_non_null(strstr(process.err, "goes on after "));
    assert_true(are_alike("whole.pfm", "part.pfm"));
}

static void other_settings_and_damage_are_refused(void **state)
{
    (void)state;
    unlink("part.pfm");
    process_run_until(&process, STILL "part.pfm", "part.pfm.part", 30, SIGTERM);
    assert_int_equal(process.status, INTERRUPTED);
    check_refused("--scene directions --size 48x48 --reference 1499 --output part.pfm",
                  "another command line");
    check_refused("--scene directions --size 48x48 --fov 170 --reference 1500 --output part.pfm",
                  "another command line");
    change_byte("part.pfm.part", -7, SEEK_END);
    check_refused(STILL "part.pfm", "damaged");
    assert_int_equal(truncate("part.pfm.part", 3000), 0);
    check_refused(STILL "part.pfm", "damaged");
    process_write_file("part.pfm.part", "something else");
    check_refused(STILL "part.pfm", "is no state");
    unlink("part.pfm.part");
    demo_run(&process, STILL "part.pfm");
    assert_true(are_alike("whole.pfm", "part.pfm"));
}

/* What a file holds that the command line names is a setting, too. */
static void another_rig_of_the_same_name_is_refused(void **state)
{
    (void)state;
    static const char command[] =
        "--scene directions --rig r.cfg --size 48x48 --reference 1500 --output part.pfm";
    demo_run(&process, "--scene directions --fov 150 --save-rig r.cfg --output r.pfm");
    process_run_until(&process, command, "part.pfm.part", 20, SIGINT);
    assert_int_equal(process.status, INTERRUPTED);
    demo_run(&process, "--scene directions --fov 160 --save-rig r.cfg --output r.pfm");
    check_refused(command, "files that are read");
    unlink("part.pfm.part");
}

/* So is what a model's file names. */
static void another_material_is_refused(void **state)
{
    (void)state;
    static const char command[] = "--flat --camera 0,0,0 --size 48x48 --reference 1500 "
                                  "--output part.pfm wall.obj";
    process_write_file("wall.obj", "mtllib wall.mtl\nusemtl wall\nv -3 -3 -2\nv 3 -3 -2\n"
                                   "v 3 3 -2\nv -3 3 -2\nf 1 2 3 4\n");
    process_write_file("wall.mtl", "newmtl wall\nKd 1 0 0\n");
    process_run_until(&process, command, "part.pfm.part", 20, SIGINT);
    assert_int_equal(process.status, INTERRUPTED);
    process_write_file("wall.mtl", "newmtl wall\nKd 0 1 0\n");
    check_refused(command, "files that are read");
    process_write_file("wall.mtl", "newmtl wall\nKd 1 0 0\n");
    process_run(&process, command, NULL);
    assert_int_equal(process.status, 0);
    assert_non_null(strstr(process.err, "goes on after "));
}

#define FILM "--scene directions --eye-circle 0.2 --size 40x40 --frames 3 --reference 400 --output "

static void a_killed_film_goes_on_with_its_picture(void **state)
{
    (void)state;
    demo_run(&process, FILM "whole-%d.png");
    process_run_until(&process, FILM "film-%d.png", "film-1.png", 20, SIGKILL);
    assert_int_equal(process.status, -1);
    assert_true(is_there("film-%d.png.part"));
    assert_false(is_there("film-2.png"));
    process_run_until(&process, FILM "film-%d.png", "film-1.png", 40, SIGTERM);
    process_run(&process, FILM "film-%d.png", NULL);
    assert_int_equal(process.status, 0);
    assert_true(are_alike("whole-0.png", "film-0.png"));
    assert_true(are_alike("whole-1.png", "film-1.png"));
    assert_true(are_alike("whole-2.png", "film-2.png"));
    assert_false(are_alike("whole-1.png", "film-2.png")); /* the eye has moved */
    assert_false(is_there("film-%d.png.part"));
}

/* ---- what the mean is of ---- */

static double compared(const char *command, const char *other, double *largest)
{
    struct picture a = demo_run_pfm(&process, command), b = demo_run_pfm(&process, other);
    double mean = picture_mean_difference(&a, &b, largest);

    cupola_image_free(&a.rgba);
    cupola_image_free(&b.rgba);
    return mean;
}

static void the_mean_of_a_ramp_is_the_ramp(void **state)
{
    (void)state;
    double largest;

    compared("--scene directions --size 48x48 --reference 128", "--scene directions --size 48x48",
             &largest);
    printf("  at most %.4f\n", largest);
    check_at_most(largest, 6e-3); /* a pixel is 0.065 wide, and about a texel */
    compared("--scene directions --size 48x48 --reference 1", "--scene directions --size 48x48",
             &largest);
    check_at_least(largest, 2e-2);
}

/* Where pixels are much finer than anything in the scene, light comes out as it always is. */
static void colors_are_encoded_as_those_of_one_frame(void **state)
{
    (void)state;
    double largest, mean;

    mean = compared("--size 48x48 --flat --fov 4 --look 0.5,0.2,-1 --reference 8",
                    "--size 48x48 --flat --fov 4 --look 0.5,0.2,-1 --view-format srgb8", &largest);
    printf("  %.4f on average, %.4f at most\n", mean, largest);
    check_at_most(mean, 0.006);
}

/* The nearest texel, unless --aa says otherwise. */
static void views_are_sampled_without_a_filter(void **state)
{
    (void)state;
    double largest;

    compared("--size 48x48 --reference 2", "--size 48x48 --reference 2 --aa none", &largest);
    check_at_most(largest, 0);
    compared("--size 48x48 --reference 2", "--size 48x48 --reference 2 --aa texture", &largest);
    check_at_least(largest, 0.01);
}

static void write_grey(const char *path)
{
    enum { WIDTH = 32 };
    static float rgba[4 * WIDTH * WIDTH];

    for (int i = 0; i < 4 * WIDTH * WIDTH; i++)
        rgba[i] = 0.3f;
    assert_true(cupola_pfm_write(path, rgba, WIDTH, WIDTH, NULL) >= 0);
}

static void pictures_are_taken_too(void **state)
{
    (void)state;
    write_grey("grey.pfm");
    struct picture picture = demo_run_pfm(
        &process, "--show grey.pfm --as domemaster --fov 120 --size 48x48 --reference 500");

    for (int j = SIDE / 3; j < SIDE / 2; j++)
        for (int i = SIDE / 3; i < SIDE / 2; i++)
            check_near(picture_pixel(&picture, i, j)[0], 0.3f, 1e-7); /* a sum of floats: 1e-6 */
    cupola_image_free(&picture.rgba);
}

static void what_has_no_reference_is_refused(void **state)
{
    (void)state;
    static const char *const refused[] = {"--perspective",
                                          "--views-only",
                                          "--preview eye",
                                          "--stats s.json",
                                          "--goal auto",
                                          "--table points",
                                          "--table auto",
                                          "--guard 1",
                                          "--frames 2",
                                          "--fullscreen",
                                          "--reference 0",
                                          "--reference 1.5",
                                          "--reference -3",
                                          "--monitor 0",
                                          "--dither",
                                          "--samples 9",
                                          "--map density --output map.png"};
    int files = process_count_files();

    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        char command[200];
        snprintf(command, sizeof command, "--scene directions --reference 4 %s", refused[i]);
        process_run(&process, command, NULL);
        assert_int_equal(process.status, USAGE);
        assert_non_null(strstr(process.err, "allowed"));
        char name[20];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(refused[i], " "), refused[i]);
        assert_non_null(strstr(process.err, name));
    }
    process_run(&process, "--reference 4 --rig dome.png.part", NULL);
    assert_int_equal(process.status, USAGE);
    assert_int_equal(process_count_files(), files);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_killed_run_goes_on_to_the_same_picture),
        cmocka_unit_test(an_interruption_keeps_every_frame),
        cmocka_unit_test(other_settings_and_damage_are_refused),
        cmocka_unit_test(another_rig_of_the_same_name_is_refused),
        cmocka_unit_test(another_material_is_refused),
        cmocka_unit_test(a_killed_film_goes_on_with_its_picture),
        cmocka_unit_test(the_mean_of_a_ramp_is_the_ramp),
        cmocka_unit_test(colors_are_encoded_as_those_of_one_frame),
        cmocka_unit_test(views_are_sampled_without_a_filter),
        cmocka_unit_test(pictures_are_taken_too),
        cmocka_unit_test(what_has_no_reference_is_refused),
    };
    return cmocka_run_group_tests_name("reference", tests, process_enter_directory,
                                       process_leave_directory);
}
