/* --map density: numbers, colours, the scale; and what goes not together with it or --report. */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cupola/image_file.h>
#include <stb_image.h>

#include "check.h"
#include "demo_picture.h"

enum { USAGE = 2 };

static struct process process;
static const double quarter = 1.57079632679489661923;

/* The angular lens's closed form, h^2 sin(a) / a per square of the circle's radius. */
static double expected_sr(double x, double y, double side_px, double half_fov)
{
    double rho = side_px / 2.0, r = fmin(hypot(x - rho, y - rho) / rho, 1.0 - 0.5 / rho);
    double angle = half_fov * r;
    return half_fov * half_fov * (angle > 0.0 ? sin(angle) / angle : 1.0) / (rho * rho);
}

static void a_pfm_holds_the_solid_angles(void **state)
{
    struct picture map = demo_run_pfm(&process, "--map density --size 64x64");
    double worst = 0.0, worse = 0.0;

    (void)state;
    assert_int_equal(map.width, 64);
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++) {
            double value = (double)picture_pixel(&map, x, y)[0];
            if (!(value > 0.0))
                continue;
            worst = fmax(worst, fabs(value / expected_sr(x + 0.5, y + 0.5, 64, quarter) - 1));
            worse = fmax(worse, fabs(value / expected_sr(x + 0.5, y + 0.5, 64, 1.571) - 1));
        }
    check_at_most(worst, 1e-6);
    check_at_least(worse, 1e-4); /* the control */
    assert_true(picture_pixel(&map, 0, 0)[0] == 0.0f);
    cupola_image_free(&map.rgba);
}

struct shot {
    unsigned char *rgb; /* rows from the top down */
    int width, height;
};

static struct shot draw(const char *options)
{
    char command[300];
    struct shot shot = {0};
    int channels;

    snprintf(command, sizeof command, "--map density --output x.png %s", options);
    demo_run(&process, command);
    shot.rgb = stbi_load("x.png", &shot.width, &shot.height, &channels, 3);
    assert_non_null(shot.rgb);
    return shot;
}

static int light_at(const struct shot *shot, int x, int y)
{
    const unsigned char *pixel = shot->rgb + 3 * (y * shot->width + x);
    return pixel[0] + pixel[1] + pixel[2];
}

/* Letters of the scale: pixels as white as nothing else is. */
static int count_white(const struct shot *shot)
{
    int count = 0;
    for (int i = 0; i < shot->width * shot->height; i++)
        count += light_at(shot, i % shot->width, i / shot->width) == 3 * 255;
    return count;
}

static void coarse_is_light_and_a_scale_stands_in_it(void **state)
{
    static const int sides[] = {300, 512, 1024};
    (void)state;
    for (int i = 0; i < 3; i++) {
        char size[40];
        snprintf(size, sizeof size, "--size %dx%d", sides[i], sides[i]);
        struct shot shot = draw(size);
        int middle = sides[i] / 2, light = light_at(&shot, middle, middle);
        assert_int_equal(shot.width, sides[i]);
        assert_int_equal(light_at(&shot, 1, 1), 0); /* not lit */
        check_at_least(light, 600);
        for (int x = middle; x > 3; x--) { /* an angular lens is finer towards the rim */
            check_at_most(light_at(&shot, x - 1, middle), light + 100);
            light = light_at(&shot, x - 1, middle);
        }
        check_at_most(light, 200);
        check_at_least(count_white(&shot), 300);
        stbi_image_free(shot.rgb);
    }
}

static void a_small_picture_has_the_colors_alone(void **state)
{
    struct shot shot = draw("--size 100x100");
    (void)state;
    assert_int_equal(count_white(&shot), 0);
    check_at_least(light_at(&shot, 50, 50), 600);
    stbi_image_free(shot.rgb);
}

/* Equal everywhere: one colour, and numbers round the one that there is. */
static void a_constant_density_has_one_color(void **state)
{
    struct shot shot = draw("--size 100x100 --lens equisolid");
    (void)state;
    for (int i = 0; i < 100 * 100; i++)
        if (light_at(&shot, i % 100, i / 100) > 0)
            assert_memory_equal(shot.rgb + 3 * i, shot.rgb + 3 * (50 * 100 + 50), 3);
    stbi_image_free(shot.rgb);
}

static void each_output_has_its_own(void **state)
{
    (void)state;
    process_write_file("two.rig", "outputs: ({size_px = [64, 64];}, {size_px = [48, 40];});\n");
    struct picture map = demo_run_pfm(&process, "--rig two.rig --show-output 1 --map density");
    assert_int_equal(map.width, 48);
    assert_int_equal(map.height, 40);
    cupola_image_free(&map.rgba);
    process_run(&process, "--rig two.rig --map density --output x.pfm", NULL);
    assert_int_equal(process.status, 0);
    assert_non_null(strstr(process.err, "output 0 of the rig's 2"));
}

static void a_map_may_come_with_a_report_and_a_rig(void **state)
{
    (void)state;
    demo_run(&process, "--size 40x40 --map density --output x.png --report - --save-rig x.rig");
    assert_non_null(strstr(process.out, "\"advice\": \"views and projector match\""));
    assert_int_equal(access("x.png", R_OK), 0);
    assert_int_equal(access("x.rig", R_OK), 0);
}

static void what_does_not_go_together_is_a_usage_error(void **state)
{
    static const char *const wrongs[][2] = {
        {"--map density", "--output"},
        {"--map speed --output y.png", "density"},
        {"--map density --output y.jpg", "FILE.png"},
        {"--map density --output y-%05d.png", "--output"},
        {"--map density --output y.png a.obj", "draws no scene"},
        {"--map density --output y.png --scene cube", "draws no scene"},
        {"--map density --output y.png --stats -", "draws no scene"},
        {"--map density --output y.png --frames 3", "draws no scene"},
        {"--map density --output y.png --label a@0,0", "draws no scene"},
        {"--map density --output y.png --fullscreen", "draws no scene"},
        {"--map density --output y.png --density 2", "together with --report"},
        {"--map density --output y.png --table points", "--table belongs to the warp"},
        {"--map density --output y.png --table points --report -", "--table belongs"},
        {"--map density --output y.png --reference 4", "--preview and --map"},
        {"--map density --output y.png --perspective", "one of"},
        {"--map density --output y.png --rig y.png", "same file"},
        {"--map density --output y.png --report y.png", "same file"},
        {"--report y.json --frames 3", "draws nothing"},
        {"--report y.json --scene forest", "draws nothing"},
        {"--report y.json --preview eye", "draws nothing"},
        {"--report y.json --perspective --fov 90", "about the dome's views"},
        {"--report y.json --show a.png --as cube", "about the dome's views"},
        {"--report y.json --goal auto", "--goal fill"},
        {"--report - --stats - --output y.png", "stdout"},
        {"--report", "needs a value"},
    };
    int files = process_count_files();

    (void)state;
    for (size_t i = 0; i < sizeof wrongs / sizeof *wrongs; i++) {
        process_run(&process, wrongs[i][0], NULL);
        if (process.status != USAGE || !strstr(process.err, wrongs[i][1]))
            fail_msg("cupola-demo %s: status %d, %s", wrongs[i][0], process.status, process.err);
        assert_int_equal(process_count_files(), files);
        assert_string_equal(process.out, "");
    }
}

/* As --save-rig does: what the link leads to is written, and the link stays. */
static void links_are_followed(void **state)
{
    static const char *const options[] = {"--size 40x40 --report soft.json",
                                          "--size 40x40 --frames 1 --output x.png "
                                          "--stats soft.json"};
    struct stat file;

    (void)state;
    assert_int_equal(symlink("hard.json", "soft.json"), 0);
    for (int i = 0; i < 2; i++) {
        process_write_file("hard.json", "");
        demo_run(&process, options[i]);
        assert_int_equal(lstat("soft.json", &file), 0);
        assert_true(S_ISLNK(file.st_mode));
        assert_int_equal(stat("hard.json", &file), 0);
        check_at_least((double)file.st_size, 100);
    }
    assert_int_equal(unlink("hard.json"), 0);
    process_run(&process, "--size 40x40 --report soft.json", NULL);
    assert_int_equal(process.status, 1);
    assert_non_null(strstr(process.err, "leads nowhere"));
    assert_int_equal(unlink("soft.json"), 0);
}

/* A direction straight ahead has no sign. */
static void no_number_is_minus_zero(void **state)
{
    (void)state;
    demo_run(&process, "--size 41x41 --report -");
    assert_null(strstr(process.out, ": -0,"));
    assert_null(strstr(process.out, ": -0}"));
}

static void what_cannot_be_written_is_told(void **state)
{
    static const char *const wrongs[][2] = {
        {"--size 40x40 --report nowhere/y.json", "--report: nowhere/y.json"},
        {"--size 40x40 --map density --output nowhere/y.png", "--output: nowhere/y.png"},
        {"--size 40x40 --layout asymmetric --report -", "rotated"},
    };
    int files = process_count_files();

    (void)state;
    for (size_t i = 0; i < sizeof wrongs / sizeof *wrongs; i++) {
        process_run(&process, wrongs[i][0], NULL);
        assert_int_equal(process.status, 1);
        assert_non_null(strstr(process.err, wrongs[i][1]));
        assert_int_equal(process_count_files(), files);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pfm_holds_the_solid_angles),
        cmocka_unit_test(coarse_is_light_and_a_scale_stands_in_it),
        cmocka_unit_test(a_small_picture_has_the_colors_alone),
        cmocka_unit_test(a_constant_density_has_one_color),
        cmocka_unit_test(each_output_has_its_own),
        cmocka_unit_test(a_map_may_come_with_a_report_and_a_rig),
        cmocka_unit_test(what_does_not_go_together_is_a_usage_error),
        cmocka_unit_test(links_are_followed),
        cmocka_unit_test(no_number_is_minus_zero),
        cmocka_unit_test(what_cannot_be_written_is_told),
    };
    return cmocka_run_group_tests_name("cli-density_maps", tests, process_enter_directory,
                                       process_leave_directory);
}
