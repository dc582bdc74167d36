/*
 * Every wrong option and every failure of the demo: one line on stderr that names the thing and
 * what is allowed, the right exit status, and no file left behind.
 */
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "process.h"

enum { FAILED = 1, USAGE = 2 };

struct wrong {
    const char *command;
    const char *thing;   /* what the line must name */
    const char *allowed; /* and what it must say of what is allowed */
};

static struct process process;

static void check_wrong(const struct wrong *wrong, int status, const char *setting)
{
    int files = process_count_files();
    size_t length;

    process_run(&process, wrong->command, setting);
    length = strlen(process.err);
    if (process.status != status || strncmp(process.err, "cupola-demo: ", 13) != 0 ||
        strchr(process.err, '\n') != process.err + length - 1 ||
        !strstr(process.err, wrong->thing) || !strstr(process.err, wrong->allowed)) {
        print_error("cupola-demo %s\nexit status %d, expected %d; expected '%s' and '%s' in:\n%s",
                    wrong->command, process.status, status, wrong->thing, wrong->allowed,
                    process.err);
        fail();
    }
    assert_string_equal(process.out, "");
    assert_int_equal(process_count_files(), files);
}

static void check_all(const struct wrong *wrongs, size_t count, int status)
{
    for (size_t i = 0; i < count; i++)
        check_wrong(&wrongs[i], status, NULL);
}

#define CHECK_ALL(wrongs, status) check_all(wrongs, sizeof(wrongs) / sizeof *(wrongs), status)

static void wrong_options_are_usage_errors(void **state)
{
    static const struct wrong wrongs[] = {
        {"--bogus", "'--bogus'", "--help"},      {"-x", "'-x'", "--help"},
        {"--fov", "--fov", "needs a value"},     {"--flat=1", "--flat=1", "no value"},
        {"a.obj b.obj", "'b.obj'", "one MODEL"},
    };
    (void)state;
    CHECK_ALL(wrongs, USAGE);
}

static void a_wrong_number_names_option_value_and_range(void **state)
{
    static const struct wrong wrongs[] = {
        {"--fov abc", "--fov: 'abc'", "above 0 and up to 360"},
        {"--fov 90x", "--fov: '90x'", "above 0 and up to 360"},
        {"--fov 9,5", "--fov: '9,5'", "above 0 and up to 360"},
        {"--fov nan", "--fov: 'nan'", "above 0 and up to 360"},
        {"--fov inf", "--fov: 'inf'", "above 0 and up to 360"},
        {"--fov 1e999", "--fov: '1e999'", "above 0 and up to 360"},
        {"--fov 0x10", "--fov: '0x10'", "above 0 and up to 360"},
        {"--fov 0", "--fov: '0'", "above 0 and up to 360"},
        {"--fov 360.1", "--fov: '360.1'", "above 0 and up to 360"},
        {"--tilt 181", "--tilt: '181'", "-180 to 180"},
        {"--cap 0", "--cap: '0'", "above 0 and up to 180"},
        {"--radius -1", "--radius: '-1'", "above 0 and up to 1000"},
        {"--density 0", "--density: '0'", "0.0625 to 16"},
        {"--view-size 0", "--view-size: '0'", "1 to 16382"},
        {"--view-size 16384", "--view-size: '16384'", "1 to 16382"},
        {"--guard 1.5", "--guard: '1.5'", "1 to 256"},
        {"--eye-circle 0", "--eye-circle: '0'", "above 0 and up to 1000"},
        {"--msaa 0", "--msaa: '0'", "1 to 64"},
        {"--scene forest --triangles 999", "--triangles: '999'", "1000 to 50000000"},
        {"--scene forest --triangles 1e6", "--triangles: '1e6'", "1000 to 50000000"},
        {"--scene forest --seed -1", "--seed: '-1'", "0 to 1000000"},
        {"--msaa 4x", "--msaa: '4x'", "1 to 64"},
        {"--views 0", "--views: '0'", "auto or a whole number, 1 to 8"},
        {"--views many", "--views: 'many'", "auto or a whole number, 1 to 8"},
        {"--frames 0", "--frames: '0'", "1 to 1000000"},
        {"--frames 99999999999999999999", "--frames", "1 to 1000000"},
        {"--monitor -1", "--monitor: '-1'", "0 to 63"},
        {"--swap-interval x", "--swap-interval: 'x'", "0 to 60"},
        {"--size 10", "--size: '10'", "WxH"},
        {"--size 0x10", "--size: '0x10'", "1 to 32768"},
        {"--size 10x99999", "--size: '10x99999'", "1 to 32768"},
        {"--size 1.5x2", "--size: '1.5x2'", "whole numbers"},
    };
    (void)state;
    CHECK_ALL(wrongs, USAGE);
}

static void a_vector_has_all_its_components(void **state)
{
    static const struct wrong wrongs[] = {
        {"--camera 1,2", "--camera: '1,2'", "X,Y,Z"},
        {"--camera 1,2,3,4", "--camera: '1,2,3,4'", "X,Y,Z"},
        {"--look 1,,3", "--look: '1,,3'", "X,Y,Z"},
        {"--up 1,2,nan", "--up: '1,2,nan'", "X,Y,Z"},
        {"--viewer 1,2,3m", "--viewer: '1,2,3m'", "X,Y,Z"},
        {"--projector ,,", "--projector: ',,'", "X,Y,Z"},
        {"--projector-aim 1,2", "--projector-aim: '1,2'", "YAW,PITCH,ROLL"},
        {"--lens-k 1,2,3,4,5", "--lens-k: '1,2,3,4,5'", "K1,K3,K5,K7, 1 to 4"},
        {"--lens-k 1,", "--lens-k: '1,'", "K1,K3,K5,K7, 1 to 4"},
        {"--circle 1,2", "--circle: '1,2'", "CX,CY,R"},
        {"--circle 1,2,0", "--circle", "above 0"},
        {"--cursor 1", "--cursor: '1'", "YAW,PITCH"},
        {"--cursor 1,2,3", "--cursor: '1,2,3'", "YAW,PITCH"},
        {"--cursor 1,nan", "--cursor: '1,nan'", "-360 to 360"},
        {"--label N", "--label: 'N'", "TEXT@YAW,PITCH[,HEIGHT]"},
        {"--label @1,2", "--label: '@1,2'", "1 to 100 characters"},
        {"--label N@", "--label: ''", "YAW,PITCH[,HEIGHT]"},
        {"--label N@1", "--label: '1'", "YAW,PITCH[,HEIGHT]"},
        {"--label N@1,2,0", "'N@1,2,0'", "above 0 and up to 90"},
        {"--label N@1,2,91", "'N@1,2,91'", "above 0 and up to 90"},
    };
    (void)state;
    CHECK_ALL(wrongs, USAGE);
}

static void an_unknown_name_is_answered_with_the_known_ones(void **state)
{
    static const struct wrong wrongs[] = {
        {"--scene moon", "--scene: 'moon'", "cube, directions, screen, forest"},
        {"--shading moon", "--shading: 'moon'", "flat, lambert, heavy"},
        {"--preset moon", "--preset: 'moon'", "visionstation, domemaster, truncated-16x10"},
        {"--lens moon", "--lens: 'moon'",
         "angular, hemispheric, equisolid, stereographic, polynomial, table"},
        {"--flip z", "--flip: 'z'", "x, y, xy"},
        {"--layout moon", "--layout: 'moon'", "asymmetric, rotated"},
        {"--view-format moon", "--view-format: 'moon'", "rgba8, rgba16f, rgba32f, srgb8"},
        {"--depth moon", "--depth: 'moon'", "forward, reversed"},
        {"--aa moon", "--aa: 'moon'", "texture, none, cone, adaptive, footprint"},
        {"--aa cone --samples 65", "--samples: '65'", "1 to 64"},
        {"--samples 5", "--samples", "4 or 9"},
        {"--aa none --samples 4", "--aa none", "--samples 1"},
        {"--aa cone --pattern moon", "--pattern: 'moon'", "regular, rotated-grid, blue-noise"},
        {"--aa footprint --turned 3", "--turned", "--aa cone"},
        {"--aa cone --perspective", "--aa", "allowed"},
        {"--dither --output a.pfm", "--dither", "allowed"},
        {"--table moon", "--table: 'moon'", "none, angles, sines, coordinates, tiles"},
        {"--preview moon", "--preview: 'moon'", "eye, outside"},
        {"--output moon.jpg", "--output: 'moon.jpg'", "FILE.png or FILE.pfm"},
        {"--output png", "--output: 'png'", "FILE.png or FILE.pfm"},
    };
    (void)state;
    CHECK_ALL(wrongs, USAGE);
}

static void options_that_contradict_each_other_are_refused(void **state)
{
    static const struct wrong wrongs[] = {
        {"--density 1 --view-size 100", "--density and --view-size", "one of them"},
        {"--scene cube a.obj", "--scene and a MODEL", "one of them"},
        {"--flat --shading heavy", "--flat and --shading", "one of them"},
        {"--scene screen --shading flat", "--shading", "--scene cube or --scene forest"},
        {"--shading flat --show a.png --as cube", "--shading", "with a MODEL"},
        {"--triangles 2000", "--triangles and --seed", "--scene forest"},
        {"--seed 1 a.obj", "--triangles and --seed", "--scene forest"},
        {"--perspective --views-only", "--views-only", "one of"},
        {"--perspective --label N@1,2", "--label and --cursor", "--preview"},
        {"--views-only --cursor 1,2", "--label and --cursor", "--preview"},
        {"--preview eye --perspective", "--perspective", "one of"},
        {"--eye-circle 0.2 --head-radius 0.1", "--eye-circle", "up to that radius"},
        {"--fov 90 --perspective --head-radius 0.1", "--head-radius", "without them"},
        {"--fov 140 --perspective --mask stencil", "--mask", "--perspective has none"},
        {"--goal vertices --fov 140 --perspective", "--goal", "--perspective has none"},
        {"--show a.png --as domemaster --mask none", "--mask", "without them"},
        {"--stats --size 64x64", "--stats: '--size' looks like an option", "./--size"},
        {"--output --x.png", "--output: '--x.png' looks like an option", "./--x.png"},
        {"--eye-circle 0.1 --frames 2 --output x.png", "'x.png'", "%05d"},
        {"--lens angular --lens-k 1,0,0,0", "--lens-k", "--lens polynomial"},
        {"--lens polynomial", "--lens polynomial", "--lens-k"},
        {"--lens-k 0,0", "--lens-k: all numbers are 0", "at least one"},
        {"--show-output 1", "--show-output: 1", "0 to 0"},
        {"--show-output 8", "--show-output: '8'", "0 to 7"},
        {"--lens table", "--lens table", "--lens-table"},
        {"--lens angular --lens-table x.csv", "--lens-table", "--lens table"},
        {"--perspective", "--perspective: a fov of 180", "up to 170"},
        {"--perspective --fov 170.5", "--perspective: a fov of 170.5", "up to 170"},
        {"--headless --fullscreen", "--fullscreen", "--headless"},
        {"--output x.png --monitor 0", "--monitor", "--output"},
        {"--look 0,0,0", "--look: 0,0,0", "another point"},
        {"--up 0,0,0", "--up: 0,0,0", "a direction"},
        {"--up 0,0,2", "--up: 0,0,2", "beside"},
        {"--look 0,5,0", "--up: 0,1,0", "beside"},
    };
    (void)state;
    CHECK_ALL(wrongs, USAGE);
}

static void a_file_has_one_purpose(void **state)
{
    static const struct wrong wrongs[] = {
        {"--headless --stats clash.obj clash.obj", "MODEL and --stats", "files of their own"},
        {"--output x.png --stats ./clash.obj clash.obj", "./clash.obj", "files of their own"},
        {"--output x.png --stats link.obj clash.obj", "link.obj", "files of their own"},
        {"--headless --rig clash.rig --stats clash.rig", "--rig and --stats", "own"},
        {"--lens-table clash.csv --save-rig clash.csv", "--lens-table and --save-rig", "own"},
        {"--output clash.png --stats clash.png", "--stats and --output", "own"},
        {"--save-rig clash.png --output ./clash.png", "--save-rig and --output", "own"},
        {"--headless --save-rig clash --stats clash", "--save-rig and --stats", "own"},
        {"--headless --save-rig clash --stats clash.bak", "--stats", "own"},
        {"--headless --stats dome.png", "--stats and --output", "own"},
    };

    (void)state;
    process_write_file("clash.obj", "v 0 0 -1\n");
    process_write_file("clash.rig", "tilt_deg = 0;\n");
    process_write_file("clash.csv", "0,0\n90,1\n");
    assert_int_equal(link("clash.obj", "link.obj"), 0);
    CHECK_ALL(wrongs, USAGE);
    assert_true(process_file_is("clash.obj", "v 0 0 -1\n"));
    assert_true(process_file_is("clash.rig", "tilt_deg = 0;\n"));
    assert_true(process_file_is("clash.csv", "0,0\n90,1\n"));

    /* The exception: a rig may be changed in place. */
    process_run(&process, "--size 32x32 --output x.png --rig clash.rig --save-rig clash.rig", NULL);
    assert_int_equal(process.status, 0);
    assert_true(process_file_is("clash.rig.bak", "tilt_deg = 0;\n"));
}

static void an_impossible_rig_names_the_option_to_blame(void **state)
{
    static const struct wrong wrongs[] = {
        {"--headless --viewer 0,0,2", "--viewer: eye is (0, 0, 2) m", "inside"},
        {"--headless --projector 0,1,0", "--projector: projector's position", "inside"},
        {"--headless --rig eye.rig --radius 0.5", "--radius: eye is (0, 0, 0.8) m", "inside"},
        {"--headless --circle -50,0,3", "--circle: image circle", "meets 0 to 1024"},
        {"--headless --lens hemispheric --fov 200", "--fov: lens", "180"},
        {"--headless --rig wide.rig --lens hemispheric", "--lens: lens", "180"},
        {"--headless --lens stereographic --fov 360", "--fov: lens", "360"},
        {"--headless --lens-k 1,-3 --viewer 0,0,0.5", "--lens-k: lens polynomial", "increas"},
        {"--headless --layout asymmetric", "asymmetric", "rotated"},
        {"--headless --views 1", "1", "rotated"},
    };
    (void)state;
    process_write_file("eye.rig", "eye_m = [0.0, 0.0, 0.8];\n");
    process_write_file("wide.rig", "outputs: ({lens: {fov_deg = 200.0;};});\n");
    CHECK_ALL(wrongs, FAILED);
}

static void a_broken_file_is_named_with_its_line(void **state)
{
    static const struct wrong wrongs[] = {
        {"--rig none.rig", "none.rig", "No such file"},
        {"--rig broken.rig", "broken.rig:2", ""},
        {"--rig unknown.rig", "unknown.rig:1", "moon"},
        {"--lens-table none.csv", "none.csv", "No such file"},
        {"--lens-table header.csv", "header.csv:1: the table ends", "allowed: 2 to 64 lines"},
        {"--lens-table text.csv", "text.csv:2: 'moon,1'", "two numbers"},
        {"--lens-table order.csv", "order.csv:4: '5,0.2' after '10,0.1'", "grow"},
        {"--lens-table range.csv", "range.csv:3: '190,1'", "0 to 180"},
        {"--lens-table first.csv", "first.csv:1: '0,1'", "allowed: in the first line 0,0"},
        {"--lens-table empty.obj", ": empty.obj: is empty", "allowed: 2 to 64 lines"},
        {"--lens-table .", ": .: Is a directory", "allowed: a file"},
        {"--headless none.obj", "none.obj", "No such file"},
        {"--headless broken.obj", "broken.obj", ""},
        {"--headless header.ply", "header.ply", "end_header"},
        {"--headless face.ply", "face.ply", "broken"},
        {"--headless empty.obj", "empty.obj", ""},
        {"--headless point.obj", "point.obj: has no triangle to draw", ""},
        {"--headless --flat line.obj", "line.obj: has no triangle to draw", ""},
        {"--headless text.csv", "text.csv", ""},
        {"--headless .", ".", ""},
    };
    (void)state;
    process_write_file("broken.rig", "tilt_deg = 0;\ntilt_deg = = 2;\n");
    process_write_file("unknown.rig", "moon = 1;\n");
    process_write_file("header.csv", "angle_deg,radius\n");
    process_write_file("text.csv", "angle_deg,radius\nmoon,1\n");
    process_write_file("order.csv", "0,0\n10,0.1\n\n5,0.2\n");
    process_write_file("range.csv", "# measured\n0,0\n190,1\n");
    process_write_file("broken.obj", "f 1 2 3\nthis is no model\n");
    /* Without a trial, assimp 5.2 never returns from the first and ends the process on the other.
     */
    process_write_file("header.ply", "ply\nformat ascii 1.0\nelement vertex 99\n");
    process_write_file("face.ply",
                       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                       "y\nproperty float z\nelement face 2\nproperty list uchar int "
                       "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1");
    process_write_file("empty.obj", "");
    process_write_file("first.csv", "0,1\n10,2\n");
    process_write_file("point.obj", "v 0 0 -1\nv 0 0 -1\nv 0 0 -1\nf 1 2 3\n");
    process_write_file("line.obj", "v 0.1 0.2 -1.3\nv 0.2 0.4 -2.6\nv 0.3 0.6 -3.9\nf 1 2 3\n");
    CHECK_ALL(wrongs, FAILED);
}

static void an_unwritable_output_is_a_failure(void **state)
{
    static const struct wrong wrongs[] = {
        {"--output none/x.png", "--output: none/x.png", "No such file"},
        {"--output folder.png", "--output: folder.png", "plain"},
        {"--output folder.png/x.pfm --stats none/x.json", "none/x.json", "No such file"},
        {"--output x.png --save-rig none/x.rig", "none/x.rig", "No such file"},
        {"--size 32x32 --output /proc/x.png", "/proc/x.png", ""},
        {"--size 32x32 --output x.png --stats /proc/x.json", "/proc/x.json", ""},
        {"--size 32x32 --output x.png --save-rig /proc/x.rig", "/proc/x.rig", ""},
    };
    (void)state;
    assert_int_equal(mkdir("folder.png", 0777), 0);
    CHECK_ALL(wrongs, FAILED);
}

static void a_long_path_leaves_room_for_the_reason(void **state)
{
    char command[1900] = "--headless ";
    struct wrong wrong = {command, "...", "end.obj: File name too long"};

    (void)state;
    memset(command + strlen(command), 'a', 1700);
    strcat(command, "end.obj");
    check_wrong(&wrong, FAILED, NULL);
}

static void a_file_that_may_not_grow_is_a_failure(void **state)
{
    static const struct wrong wrong = {"--size 64x64 --output large.pfm", "large.pfm",
                                       "File too large"};
    struct rlimit before, small;

    (void)state;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = (struct rlimit){4096, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    check_wrong(&wrong, FAILED, NULL);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
}

static void an_old_gl_is_named_with_what_is_needed(void **state)
{
    static const struct wrong wrong = {"--size 32x32 --output kept.png", "2.1", "3.3"};

    (void)state;
    process_write_file("kept.png", "a picture from yesterday");
    check_wrong(&wrong, FAILED, "MESA_GL_VERSION_OVERRIDE=2.1");
    assert_true(process_file_is("kept.png", "a picture from yesterday"));
}

static void a_failure_leaves_an_older_picture_alone(void **state)
{
    static const struct wrong wrong = {"--output kept.png none.obj", "none.obj", "No such file"};

    (void)state;
    process_write_file("kept.png", "a picture from yesterday");
    check_wrong(&wrong, FAILED, NULL);
    assert_true(process_file_is("kept.png", "a picture from yesterday"));
}

static void a_window_wish_without_a_display_is_a_failure(void **state)
{
    static const struct wrong wrong = {"--fullscreen", "display", "DISPLAY"};

    (void)state;
    check_wrong(&wrong, FAILED, NULL);
}

static void help_and_version_are_no_errors(void **state)
{
    (void)state;
    process_run(&process, "--help", NULL);
    assert_int_equal(process.status, 0);
    assert_non_null(strstr(process.out, "--projector-aim YAW,PITCH,ROLL"));
    assert_string_equal(process.err, "");
    process_run(&process, "-h", NULL);
    assert_int_equal(process.status, 0);
    assert_memory_equal(process.out, "Usage: ", 7);
    process_run(&process, "--version", NULL);
    assert_int_equal(process.status, 0);
    assert_non_null(strstr(process.out, "cupola-demo "));
}

int main(void)
{
    const struct CMUnitTest errors[] = {
        cmocka_unit_test(wrong_options_are_usage_errors),
        cmocka_unit_test(a_wrong_number_names_option_value_and_range),
        cmocka_unit_test(a_vector_has_all_its_components),
        cmocka_unit_test(an_unknown_name_is_answered_with_the_known_ones),
        cmocka_unit_test(options_that_contradict_each_other_are_refused),
        cmocka_unit_test(a_file_has_one_purpose),
        cmocka_unit_test(an_impossible_rig_names_the_option_to_blame),
        cmocka_unit_test(a_broken_file_is_named_with_its_line),
        cmocka_unit_test(an_unwritable_output_is_a_failure),
        cmocka_unit_test(a_long_path_leaves_room_for_the_reason),
        cmocka_unit_test(a_file_that_may_not_grow_is_a_failure),
        cmocka_unit_test(an_old_gl_is_named_with_what_is_needed),
        cmocka_unit_test(a_failure_leaves_an_older_picture_alone),
        cmocka_unit_test(a_window_wish_without_a_display_is_a_failure),
        cmocka_unit_test(help_and_version_are_no_errors),
    };
    return cmocka_run_group_tests(errors, process_enter_directory, process_leave_directory);
}
