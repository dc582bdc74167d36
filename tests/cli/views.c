/* The demo's wishes for its views: format, samples and the way of depth reach the picture. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

static struct process process;

/* Squares of half-width `half` at z = -distance: red in front of green in front of blue. */
static void write_squares(const char *name)
{
    static const struct {
        const char *color;
        double half, distance;
    } squares[3] = {{"red", 2, 5}, {"green", 7, 10}, {"blue", 100, 20}};
    FILE *file = fopen(name, "w");

    assert_non_null(file);
    process_write_file("colors.mtl", "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n"
                                     "newmtl blue\nKd 0 0 1\n");
    fputs("mtllib colors.mtl\n", file);
    for (int i = 0; i < 3; i++) {
        double half = squares[i].half, z = -squares[i].distance;
        fprintf(file, "v %g %g %g\nv %g %g %g\nv %g %g %g\nv %g %g %g\n", -half, -half - 0.1, z,
                half, -half, z, half + 0.1, half, z, -half, half + 0.2, z);
        fprintf(file, "usemtl %s\nf -4 -3 -2 -1\n", squares[i].color);
    }
    assert_int_equal(fclose(file), 0);
}

static struct picture run(const char *options)
{
    char command[256];

    write_squares("squares.obj");
    snprintf(command, sizeof command,
             "squares.obj --flat --camera 0,0,0 --fov 90 --size 128x128 --guard 4 %s", options);
    return demo_run_pfm(&process, command);
}

/* In the middle red, round it green, then blue. */
static void check_squares(const struct picture *picture, double tolerance)
{
    static const int places[3][2] = {{64, 64}, {64, 64 + 42}, {64 + 58, 64}};

    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            check_near(picture_pixel(picture, places[i][0], places[i][1])[c], i == c, tolerance);
}

static void reversed_depth_gives_the_same_picture(void **state)
{
    struct picture forward = run("--depth forward"), reversed = run("--depth reversed");

    (void)state;
    check_squares(&forward, 1e-6);
    check_squares(&reversed, 1e-6);
    check_at_most(picture_difference(&forward, &reversed), 1e-6);
    cupola_image_free(&forward.rgba);
    cupola_image_free(&reversed.rgba);
}

static void every_format_shows_the_same_colors(void **state)
{
    static const char *const options[] = {
        "--view-format rgba8",
        "--view-format srgb8",
        "--view-format rgba16f",
        "--view-format rgba32f",
        "--view-format srgb8 --msaa 2 --depth reversed",
    };

    (void)state;
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        struct picture picture = run(options[i]);
        check_squares(&picture, 1e-3);
        cupola_image_free(&picture.rgba);
    }
}

/* Texels whose red is neither all nor nothing; nothing filters what --views-only shows. */
static int texels_between(const char *options)
{
    struct picture picture = run(options);
    int between = 0;

    for (int i = 0; i < picture.width * picture.height; i++)
        between += picture.rgba[4 * i] > 0.01f && picture.rgba[4 * i] < 0.99f;
    cupola_image_free(&picture.rgba);
    return between;
}

static void samples_soften_edges_and_one_does_not(void **state)
{
    (void)state;
    assert_int_equal(texels_between("--views-only"), 0);
    assert_int_equal(texels_between("--views-only --msaa 1"), 0);
    check_at_least(texels_between("--views-only --msaa 4"), 20);
}

static void more_samples_than_the_gl_has_are_a_failure(void **state)
{
    (void)state;
    process_run(&process, "--headless --msaa 64", NULL);
    if (process.status == 0)
        skip(); /* a GL that has them */
    assert_int_equal(process.status, 1);
    assert_non_null(strstr(process.err, "samples is 64; allowed"));
}

static struct picture picture_read(const char *name)
{
    struct picture picture = {0};
    struct cupola_error error = {0};

    if (cupola_pfm_read(name, &picture.rgba, &picture.width, &picture.height, &error) < 0)
        fail_msg("%s", error.message);
    return picture;
}

/* Rays seen from a circle: each picture is that of a viewer who rests there. */
static void a_viewer_who_moves_sees_what_one_who_rests_there_does(void **state)
{
#define RAYS "--scene directions --fov 140 --size 96x96 --viewer 0.1,0,0 "
    static const char *const resting[4] = {"0.4,0,0", "0.1,0.3,0", "-0.2,0,0", "0.1,-0.3,0"};

    (void)state;
    int files = process_count_files();
    demo_run(&process, RAYS "--eye-circle 0.3 --table angles --frames 4 --output eye-%d.pfm");
    assert_int_equal(process_count_files(), files + 4);
    for (int i = 0; i < 4; i++) {
        char name[16], command[160];
        snprintf(name, sizeof name, "eye-%d.pfm", i);
        snprintf(command, sizeof command, RAYS "--viewer %s", resting[i]);
        struct picture moved = picture_read(name), rests = demo_run_pfm(&process, command);
        struct picture middle = demo_run_pfm(&process, RAYS);
        check_at_most(picture_difference(&moved, &rests), 5e-4);
        check_at_least(picture_difference(&moved, &middle), 0.05); /* the control */
        cupola_image_free(&moved.rgba);
        cupola_image_free(&rests.rgba);
        cupola_image_free(&middle.rgba);
    }
    files = process_count_files();
    demo_run(&process, "--size 16x16 --eye-circle 0.1 --head-radius 0.2 --output turn-%03d.png");
    assert_int_equal(process_count_files(), files + 120);
}

int main(void)
{
    const struct CMUnitTest views[] = {
        cmocka_unit_test(reversed_depth_gives_the_same_picture),
        cmocka_unit_test(every_format_shows_the_same_colors),
        cmocka_unit_test(samples_soften_edges_and_one_does_not),
        cmocka_unit_test(more_samples_than_the_gl_has_are_a_failure),
        cmocka_unit_test(a_viewer_who_moves_sees_what_one_who_rests_there_does),
    };
    return cmocka_run_group_tests(views, process_enter_directory, process_leave_directory);
}
