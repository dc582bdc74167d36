/* Existing pictures in the demo: what is shown is what the scene itself looks like. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

enum { FAILED = 1, USAGE = 2, SIDE = 256 };

static struct process process;
static const double pi = 3.14159265358979323846;

/* A float picture whose pixels `color` gives by their places, 0 to 1. */
static void write_picture(const char *path, int width, int height,
                          void (*color)(double u, double v, float rgb[3]))
{
    float *rgba = test_calloc((size_t)width * (size_t)height, 4 * sizeof *rgba);

    for (int j = 0; j < height; j++)
        for (int i = 0; i < width; i++)
            color((i + 0.5) / width, (j + 0.5) / height, rgba + 4 * (j * width + i));
    assert_true(cupola_pfm_write(path, rgba, width, height, NULL) >= 0);
    test_free(rgba);
}

static void grey(double u, double v, float rgb[3])
{
    (void)u;
    (void)v;
    rgb[0] = rgb[1] = rgb[2] = 0.5f;
}

static void white(double u, double v, float rgb[3])
{
    (void)u;
    (void)v;
    rgb[0] = rgb[1] = rgb[2] = 1.0f;
}

/* The direction itself, as the scene of that name has it; its middle is ahead. */
static void directions(double u, double v, float rgb[3])
{
    double longitude = 2 * pi * (u - 0.5), latitude = pi * (v - 0.5);

    rgb[0] = (float)(cos(latitude) * sin(longitude));
    rgb[1] = (float)sin(latitude);
    rgb[2] = (float)(-cos(latitude) * cos(longitude));
}

static double difference_of(const char *shown, const char *scene, double *largest)
{
    struct picture is = demo_run_pfm(&process, shown);
    double mean = picture_mean_difference(&is, demo_picture_of(&process, scene), largest);

    cupola_image_free(&is.rgba);
    return mean;
}

static void check_same(const char *shown, const char *scene, double mean, double most)
{
    double largest, difference = difference_of(shown, scene, &largest);

    printf("%s: mean %.2g, at most %.2g\n", shown, difference, largest);
    check_at_most(difference, mean);
    check_at_most(largest, most);
}

static void check_other(const char *shown, const char *scene, double mean)
{
    double largest;
    check_at_least(difference_of(shown, scene, &largest), mean);
}

#define OFF_AXIS "--size 256x256 --fov 150 --viewer 0.2,0.1,0.2 --projector 0,-0.3,0 --tilt 25 "

static void a_domemaster_comes_out_as_it_was_made(void **state)
{
    (void)state;
    demo_run(&process, "--preset domemaster --size 256x256 --output dome.pfm");
    check_same("--preset domemaster --size 256x256 --show dome.pfm --as domemaster",
               "--preset domemaster --size 256x256", 1e-4, 1e-3);
    check_other("--preset domemaster --size 256x256 --show dome.pfm --as domemaster "
                "--picture-aim 0,0,1",
                "--preset domemaster --size 256x256", 1e-3);
}

/* 0.35 degrees between texels: 5e-6 between directions. */
static void an_equirectangular_picture_is_the_world_that_the_viewer_sees(void **state)
{
    (void)state;
    write_picture("world.pfm", 4 * SIDE, 2 * SIDE, directions);
    check_same(OFF_AXIS "--show world.pfm --as equirectangular", OFF_AXIS "--scene directions",
               1e-4, 2e-3);
    check_other(OFF_AXIS "--show world.pfm --as equirectangular --picture-aim 1,0,0",
                OFF_AXIS "--scene directions", 4e-3);
    check_other(OFF_AXIS "--show world.pfm --as equirectangular --picture-place screen",
                OFF_AXIS "--scene directions", 4e-3);
}

/* Faces as anybody would make them: each seen upright from inside, posz ahead. */
static void six_views_of_a_room_are_a_cube(void **state)
{
    static const char *const faces[6] = {
        "posx.png --look 1,0,0",
        "negx.png --look -1,0,0",
        "posy.png --look 0,1,0 --up 0,0,1",
        "negy.png --look 0,-1,0 --up 0,0,-1",
        "posz.png --look 0,0,-1",
        "negz.png --look 0,0,1",
    };
    (void)state;
    for (int i = 0; i < 6; i++) {
        char command[200];
        snprintf(command, sizeof command, "--perspective --size 512x512 --fov 90 --output %s",
                 faces[i]);
        demo_run(&process, command);
    }
    check_same("--size 256x256 --fov 220 --show %s.png --as cube", "--size 256x256 --fov 220", 0.02,
               0.6); /* the texels of the faces are filtered twice */
    check_other("--size 256x256 --fov 220 --show %s.png --as cube --picture-aim 2,0,0",
                "--size 256x256 --fov 220", 0.03);
}

static double middle_of(const char *path)
{
    struct picture picture = {0};
    assert_true(cupola_pfm_read(path, &picture.rgba, &picture.width, &picture.height, NULL) >= 0);
    double seen = (double)picture_pixel(&picture, picture.width / 2, picture.height / 2)[0];
    cupola_image_free(&picture.rgba);
    return seen;
}

#define SEQUENCE "--size 8x8 --show frame-%04d.pfm --as domemaster "

/* Black and white by turns, finer than the image's pixels. */
static void squares(double u, double v, float rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = ((int)(u * SIDE) + (int)(v * SIDE)) % 2 ? 1.0f : 0.0f;
}

/* Half of white is 188 of 255 where bytes are colours, and the mean of floats, which are not. */
static void colours_are_mixed_in_linear_light(void **state)
{
    float *rgba = NULL;
    int width, height;
    (void)state;
    write_picture("squares.pfm", SIDE, SIDE, squares);
    assert_true(cupola_pfm_read("squares.pfm", &rgba, &width, &height, NULL) >= 0);
    assert_true(cupola_png_write("squares.png", rgba, width, height, NULL) >= 0);
    cupola_image_free(&rgba);
    demo_run(&process, "--size 8x8 --show squares.png --as domemaster --output half.pfm");
    check_near(middle_of("half.pfm"), 188 / 255.0, 1.5 / 255.0);
    demo_run(&process, "--size 8x8 --show squares.pfm --as domemaster --output half.pfm");
    check_near(middle_of("half.pfm"), 0.5, 1e-3);
}

/* The numbers are those of the pictures; without --frames all of them are shown. */
static void every_picture_of_a_sequence_becomes_a_file(void **state)
{
    (void)state;
    write_picture("frame-0001.pfm", 4, 4, grey);
    write_picture("frame-0002.pfm", 4, 4, white);
    int files = process_count_files();
    demo_run(&process, SEQUENCE "--output out-%03d.pfm");
    assert_int_equal(process_count_files(), files + 2);
    check_near(middle_of("out-001.pfm"), 0.5, 1e-6);
    check_near(middle_of("out-002.pfm"), 1.0, 1e-6);
    demo_run(&process, SEQUENCE "--output out-%03d.pfm --frames 3"); /* over what is there */
    assert_int_equal(process_count_files(), files + 3);
    check_near(middle_of("out-002.pfm"), 1.0, 1e-6);
    check_near(middle_of("out-003.pfm"), 0.5, 1e-6); /* from the start again */
    struct picture first = demo_run_pfm(&process, SEQUENCE);
    check_near((double)picture_pixel(&first, 4, 4)[0], 0.5, 1e-6);
    cupola_image_free(&first.rgba);
}

/* What came before the wrong picture is whole, and nothing else is there. */
static void a_sequence_ends_at_a_wrong_picture(void **state)
{
    (void)state;
    write_picture("film-0.pfm", 4, 4, grey);
    write_picture("film-1.pfm", 8, 8, grey);
    int files = process_count_files();
    process_run(&process, "--size 8x8 --show film-%d.pfm --as domemaster --output done-%d.pfm",
                NULL);
    assert_int_equal(process.status, FAILED);
    assert_non_null(strstr(process.err, "film-1.pfm is 8 x 8 px"));
    assert_int_equal(process_count_files(), files + 1);
    check_near(middle_of("done-0.pfm"), 0.5, 1e-6);
}

static void a_sequence_never_overwrites_its_pictures(void **state)
{
    static const char *const outputs[] = {"frame-%04d.pfm", "frame-%004d.pfm", "./frame-%04d.pfm",
                                          "link-%d.pfm", "frame-000%d.pfm"};
    (void)state;
    write_picture("frame-0001.pfm", 4, 4, grey);
    write_picture("frame-0002.pfm", 4, 4, white);
    assert_int_equal(symlink("frame-0001.pfm", "link-2.pfm"), 0);
    int files = process_count_files();
    for (size_t i = 0; i < sizeof outputs / sizeof *outputs; i++) {
        char command[200];
        snprintf(command, sizeof command, "%s --output %s", SEQUENCE, outputs[i]);
        process_run(&process, command, NULL);
        assert_true(process.status == USAGE || process.status == FAILED);
        assert_non_null(strstr(process.err, "of their own"));
        assert_int_equal(process_count_files(), files);
        check_near(middle_of("frame-0001.pfm"), 0.5, 0.0);
        check_near(middle_of("frame-0002.pfm"), 1.0, 0.0);
    }
    assert_int_equal(unlink("link-2.pfm"), 0);
}

/* By any option and any name: a link is the file that it leads to. */
static void no_picture_is_overwritten(void **state)
{
    static const char *const commands[] = {
        SEQUENCE "--output frame-0001.pfm",
        SEQUENCE "--output ./frame-0002.pfm",
        SEQUENCE "--output soft.pfm",
        SEQUENCE "--output hard.pfm",
        SEQUENCE "--output new.pfm --stats frame-0002.pfm",
        SEQUENCE "--output new.pfm --save-rig frame-0002.pfm",
        SEQUENCE "--output new.pfm --save-rig frame-0003.pfm", /* and its .bak */
        SEQUENCE "--output new-%d.pfm --save-rig hard.pfm",
        "--size 8x8 --show wall-%s.pfm --as cube --output wall-posz.pfm",
        "--size 8x8 --show wall-%s.pfm --as cube --stats wall-negy.pfm",
        "--size 8x8 --show frame-0001.pfm --as domemaster --output soft.pfm",
        SEQUENCE "--rig rig-2.pfm --output rig-%d.pfm",
        SEQUENCE "--stats - --output frame-0001.pfm",
    };
    static const char *const faces[] = {"posx", "negx", "posy", "negy", "posz", "negz"};
    char name[300];
    (void)state;
    write_picture("frame-0001.pfm", 4, 4, grey);
    write_picture("frame-0002.pfm", 4, 4, white);
    for (int i = 0; i < 6; i++) {
        snprintf(name, sizeof name, "wall-%s.pfm", faces[i]);
        write_picture(name, 4, 4, grey);
    }
    assert_int_equal(symlink("frame-0001.pfm", "soft.pfm"), 0);
    assert_int_equal(link("frame-0002.pfm", "hard.pfm"), 0);
    assert_int_equal(symlink("frame-0001.pfm", "frame-0003.pfm.bak"), 0);
    process_write_file("rig-2.pfm", "tilt_deg = 0.0;");
    int files = process_count_files();
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        snprintf(name, sizeof name, "--headless %s", commands[i]);
        process_run(&process, name, NULL);
        if (process.status == 0 || !strstr(process.err, "of their own"))
            fail_msg("'%s' ends with %d: %s", name, process.status, process.err);
        assert_int_equal(process_count_files(), files);
        check_near(middle_of("frame-0001.pfm"), 0.5, 0.0);
        check_near(middle_of("frame-0002.pfm"), 1.0, 0.0);
        check_near(middle_of("wall-posz.pfm"), 0.5, 0.0);
        check_near(middle_of("wall-negy.pfm"), 0.5, 0.0);
    }
    assert_int_equal(unlink("soft.pfm") | unlink("hard.pfm") | unlink("frame-0003.pfm.bak"), 0);
}

struct wrong {
    const char *command;
    int status;
    const char *thing;
    const char *allowed;
};

static void wrong_pictures_are_one_line(void **state)
{
    static const struct wrong wrongs[] = {
        {"--show a.png", USAGE, "--as", "equirectangular"},
        {"--show a.png --as film", USAGE, "'film'", "domemaster, equirectangular, cube"},
        {"--as cube", USAGE, "--show", "allowed"},
        {"--frame-rate 25", USAGE, "--frame-rate", "--show"},
        {"--show a.png --as cube --frame-rate 0", USAGE, "--frame-rate", "above 0"},
        {"--show a.png --as domemaster --picture-fov 361", USAGE, "'361'", "360"},
        {"--show a.png --as equirectangular --picture-fov 90", USAGE, "--picture-fov",
         "domemaster"},
        {"--show a.png --as domemaster --picture-place up", USAGE, "'up'", "screen, infinity"},
        {"--show a.png --as domemaster --picture-aim 1,x", USAGE, "--picture-aim", "YAW"},
        {"--show a.png --as domemaster --perspective", USAGE, "--perspective", "--preview"},
        {"--show a.png --as domemaster --views-only", USAGE, "--views-only", "--preview"},
        {"--show a.png --as domemaster room.obj", USAGE, "MODEL", "one of them"},
        {"--show a.png --as domemaster --scene cube", USAGE, "--scene", "one of them"},
        {"--show wide.pfm --as domemaster --output wide.pfm", USAGE, "--show", "of their own"},
        {"--show gone.png --as domemaster", FAILED, "gone.png", "No such file"},
        {"--show gone.pfm --as domemaster", FAILED, "gone.pfm", "No such file"},
        {"--show . --as domemaster", FAILED, "--show: .", "Is a directory"},
        {"--show text.png --as domemaster", FAILED, "text.png", "PNG, JPEG, PFM"},
        {"--show wide.pfm --as domemaster", FAILED, "8 x 4", "as wide as high"},
        {"--show square.pfm --as equirectangular", FAILED, "4 x 4", "twice as wide"},
        {"--show square.pfm --as cube", FAILED, "square.pfm", "%s"},
        {"--show %s.pfm --as domemaster", FAILED, "%s.pfm", "%04d"},
        {"--show 5%.png --as domemaster", FAILED, "5%.png", "%04d"},
        {"--show %x.png --as domemaster", FAILED, "%x.png", "%04d"},
        {"--show %0999999999d.png --as domemaster", FAILED, "d.png", "%04d"},
        {"--show gone-%d.png --as domemaster", FAILED, "gone-%d.png", "number 1"},
        {"--show gone-%s.png --as cube", FAILED, "gone-posx.png", "No such file"},
        {"--show part-%s.pfm --as cube", FAILED, "part-negx.pfm", "No such file"},
        {"--show odd-%d.pfm --as domemaster --stats x.json --frames 2", FAILED, "odd-1.pfm",
         "of one size"},
        {"--show odd-%d.pfm --as domemaster --frames 2", USAGE, "dome.png", "%05d"},
        {"--show odd-%d.pfm --as domemaster --frames 2 --output x.png", USAGE, "'x.png'", "%05d"},
        {"--show square.pfm --as domemaster --output x-%d.png", USAGE, "'x-%d.png'", "without %"},
        {"--output x-%d.png", USAGE, "'x-%d.png'", "without %"},
        {"--output o-%s.png", USAGE, "'o-%s.png'", "without %, or with %05d"},
        {"--output o-%99d.png", USAGE, "'o-%99d.png'", "without %, or with %05d"},
        {"--output o-%5.3d.png", USAGE, "'o-%5.3d.png'", "without %, or with %05d"},
        {"--output o-%-5d.png", USAGE, "'o-%-5d.png'", "without %, or with %05d"},
        {"--output o%%.png", USAGE, "'o%%.png'", "without %, or with %05d"},
        {"--show odd-%d.pfm --as domemaster --output o-%s%d.png", USAGE, "%s", "%05d"},
        {"--show a.png --as cube --msaa 4", USAGE, "--msaa", "allowed"},
        {"--show a.png --as cube --view-format srgb8", USAGE, "--view-format", "allowed"},
        {"--show a.png --as cube --depth forward", USAGE, "--depth", "allowed"},
        {"--show a.png --as cube --views auto", USAGE, "--views", "allowed"},
        {"--show a.png --as cube --density 2", USAGE, "--density", "allowed"},
        {"--show a.png --as domemaster --frame-rate 25", USAGE, "--frame-rate", "%04d"},
        {"--show a.png --as domemaster --look 1,0,0", USAGE, "--look", "--picture-aim"},
        {"--show a.png --as domemaster --flat", USAGE, "--flat", "allowed"},
        {"--show odd-%d.pfm --as domemaster --stats - --output x-%d.png", USAGE, "--stats",
         "one of them"},
        {"--show odd-%d.pfm --as domemaster --output no/x-%d.png", FAILED, "no/x-0.png",
         "cannot be written"},
        {"--show gap-%02d.pfm --as domemaster --output x-%d.png", FAILED, "number 3",
         "without a gap"},
    };
    (void)state;
    write_picture("wide.pfm", 8, 4, grey);
    write_picture("square.pfm", 4, 4, grey);
    write_picture("part-posx.pfm", 4, 4, grey);
    write_picture("odd-0.pfm", 4, 4, grey);
    write_picture("odd-1.pfm", 8, 8, grey);
    write_picture("gap-01.pfm", 4, 4, grey);
    write_picture("gap-02.pfm", 4, 4, grey);
    write_picture("gap-05.pfm", 4, 4, grey);
    process_write_file("text.png", "no picture");
    for (size_t i = 0; i < sizeof wrongs / sizeof *wrongs; i++) {
        int files = process_count_files();
        char command[300];
        snprintf(command, sizeof command, "--headless %s", wrongs[i].command);
        process_run(&process, command, NULL);
        char *end = strchr(process.err, '\n');
        if (process.status != wrongs[i].status || !end || end[1] ||
            !strstr(process.err, wrongs[i].thing) || !strstr(process.err, wrongs[i].allowed)) {
            print_error("cupola-demo %s\nexit status %d, expected %d; expected '%s' and '%s' in:\n"
                        "%s",
                        command, process.status, wrongs[i].status, wrongs[i].thing,
                        wrongs[i].allowed, process.err);
            fail();
        }
        assert_int_equal(process_count_files(), files);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_domemaster_comes_out_as_it_was_made),
        cmocka_unit_test(an_equirectangular_picture_is_the_world_that_the_viewer_sees),
        cmocka_unit_test(six_views_of_a_room_are_a_cube),
        cmocka_unit_test(colours_are_mixed_in_linear_light),
        cmocka_unit_test(every_picture_of_a_sequence_becomes_a_file),
        cmocka_unit_test(a_sequence_ends_at_a_wrong_picture),
        cmocka_unit_test(a_sequence_never_overwrites_its_pictures),
        cmocka_unit_test(no_picture_is_overwritten),
        cmocka_unit_test(wrong_pictures_are_one_line),
    };
    return cmocka_run_group_tests_name("films", tests, process_enter_directory,
                                       process_leave_directory);
}
