/*
 * What the demo writes when nothing is wrong: every mode gives its picture, the options reach the
 * rig, the statistics are complete.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cupola/cupola.h>
#include <cupola/image_file.h>
#include <stb_image.h>

#include "check.h"
#include "demo_picture.h"

/* As a number of the language, for initialisers. */
#define RADIANS (3.14159265358979323846 / 180)

static struct process process;

static void run(const char *command)
{
    demo_run(&process, command);
}

static struct picture run_pfm(const char *command)
{
    return demo_run_pfm(&process, command);
}

static void without_a_display_it_writes_dome_png(void **state)
{
    int width = 0, height = 0, channels;
    unsigned char *bytes;

    (void)state;
    run("");
    assert_string_equal(process.out, "wrote dome.png\n");
    bytes = stbi_load("dome.png", &width, &height, &channels, 3);
    assert_non_null(bytes);
    assert_int_equal(width, 1024);
    assert_int_equal(height, 1024);
    /* Outside of the image circle it is black, in its middle it is not. */
    assert_int_equal(bytes[0] + bytes[1] + bytes[2], 0);
    assert_true(bytes[3 * (512 * 1024 + 300)] + bytes[3 * (512 * 1024 + 300) + 2] > 20);
    stbi_image_free(bytes);
}

static void a_scene_of_numbers_is_written_as_floats(void **state)
{
    (void)state;
    run("--headless --scene directions --size 64x64");
    assert_string_equal(process.out, "wrote dome.pfm\n");
    assert_int_equal(access("dome.pfm", F_OK), 0);
}

static void the_first_row_of_a_png_is_the_top(void **state)
{
    int width = 0, height = 0, channels;
    unsigned char *bytes;

    (void)state;
    run("--scene directions --size 64x64 --output x.png");
    assert_string_equal(process.out, "");
    bytes = stbi_load("x.png", &width, &height, &channels, 3);
    assert_non_null(bytes);
    assert_int_equal(width, 64);
    /* Upper right: x and y of the direction are positive; lower left: negative, so 0. */
    assert_true(bytes[3 * (16 * 64 + 48)] > 80);
    assert_true(bytes[3 * (16 * 64 + 48) + 1] > 80);
    assert_int_equal(bytes[3 * (48 * 64 + 16)] + bytes[3 * (48 * 64 + 16) + 1], 0);
    stbi_image_free(bytes);
}

/* A rig as text for the command line and as a value. */
struct command_rig {
    const char *command;
    struct cupola_rig rig;
};

/* The largest angle between what the demo shows and what geometry says, over all lit pixels. */
static double largest_angle_deg(const struct picture *picture, const struct cupola_rig *rig)
{
    cupola_dome *dome = NULL;
    double largest = 0;
    int lit = 0;

    assert_int_equal(cupola_dome_create(rig, &dome, NULL), CUPOLA_OK);
    for (int y = 0; y < picture->height; y++) {
        for (int x = 0; x < picture->width; x++) {
            const float *shown = picture_pixel(picture, x, y);
            struct cupola_ray ray;
            double cross[3], dot = 0;
            cupola_dome_ray(dome, 0, NULL, x + 0.5, y + 0.5, &ray);
            if (ray.coverage < 1)
                continue;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3, k = (i + 2) % 3;
                cross[i] =
                    ray.direction[j] * (double)shown[k] - ray.direction[k] * (double)shown[j];
                dot += ray.direction[i] * (double)shown[i];
            }
            largest = fmax(largest, atan2(hypot(hypot(cross[0], cross[1]), cross[2]), dot));
            lit++;
        }
    }
    cupola_dome_destroy(&dome);
    assert_true(lit > 100);
    return largest / RADIANS;
}

static void the_options_reach_the_rig(void **state)
{
    static const struct command_rig rigs[] = {
        {"--size 90x70", {.outputs = {{.width_px = 90, .height_px = 70}}}},
        {"--size 81x81 --lens hemispheric --fov 150 --tilt 30 --radius 2 --viewer 0.3,0.2,-0.4 "
         "--projector 0,-0.5,0.3",
         {.screen.radius_m = 2,
          .eye_m = {0.3, 0.2, -0.4},
          .tilt_rad = 30 * RADIANS,
          .outputs = {{.width_px = 81,
                       .height_px = 81,
                       .lens = {CUPOLA_LENS_HEMISPHERIC, 150 * RADIANS},
                       .position_m = {0, -0.5, 0.3}}}}},
        {"--size 100x60 --circle 40,20,55 --lens polynomial --lens-k 1,0.1,0,0 --fov 200 --flip xy "
         "--projector-aim 10,-20,30 --cap 80",
         {.screen.cap_rad = 80 * RADIANS,
          .outputs =
              {{.width_px = 100,
                .height_px = 60,
                .circle = {40, 20, 55},
                .flip = CUPOLA_FLIP_X | CUPOLA_FLIP_Y,
                .lens = {.model = CUPOLA_LENS_POLYNOMIAL, .fov_rad = 200 * RADIANS, .k = {1, 0.1}},
                .aim = {10 * RADIANS, -20 * RADIANS, 30 * RADIANS}}}}},
        {"--size 64x64 --lens table --lens-table lens.csv",
         {.outputs = {{.width_px = 64,
                       .height_px = 64,
                       .lens = {.model = CUPOLA_LENS_TABLE,
                                .table_count = 3,
                                .table = {{0, 0}, {40 * RADIANS, 0.4}, {85 * RADIANS, 0.8}}}}}}},
    };
    char command[1000];

    (void)state;
    process_write_file("lens.csv", "angle_deg,radius\r\n0, 0\r\n40, 0.4\r\n85, 0.8\r\n");
    for (size_t i = 0; i < sizeof rigs / sizeof *rigs; i++) {
        struct picture picture;
        snprintf(command, sizeof command, "--scene directions %s", rigs[i].command);
        picture = run_pfm(command);
        /* Texels are 2 degrees wide here, and between them directions are mixed in a line. */
        check_at_most(largest_angle_deg(&picture, &rigs[i].rig), 0.03);
        cupola_image_free(&picture.rgba);
    }
}

static void a_rig_wrong_by_a_tenth_of_a_degree_is_seen(void **state)
{
    const struct cupola_rig wrong = {
        .outputs = {{.width_px = 90, .height_px = 70, .lens.fov_rad = 179.8 * RADIANS}}};
    struct picture picture = run_pfm("--scene directions --size 90x70");

    (void)state;
    check_at_least(largest_angle_deg(&picture, &wrong), 0.05);
    cupola_image_free(&picture.rgba);
}

static void a_preset_has_its_own_tilt_and_the_default_none(void **state)
{
    static const struct {
        const char *command;
        int axis; /* the one that the middle of the picture shows */
        double sign;
    } cases[] = {
        {"--scene directions --size 65x65", 2, -1},
        {"--scene directions --size 65x65 --preset domemaster", 1, 1},
        {"--scene directions --size 65x65 --preset domemaster --tilt 0", 2, -1},
    };

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct picture picture = run_pfm(cases[i].command);
        check_near((double)picture_pixel(&picture, 32, 32)[cases[i].axis], cases[i].sign, 1e-3);
        cupola_image_free(&picture.rgba);
    }
}

static void all_table_stages_give_the_same_picture(void **state)
{
    static const char *const stages[] = {"none", "angles", "sines", "coordinates", "tiles"};
    struct picture points = run_pfm("--scene directions --size 96x96 --viewer 0.2,0.1,0.3");

    (void)state;
    for (size_t i = 0; i < sizeof stages / sizeof *stages; i++) {
        char command[200];
        struct picture picture;
        snprintf(command, sizeof command,
                 "--scene directions --size 96x96 --viewer 0.2,0.1,0.3 --table %s", stages[i]);
        picture = run_pfm(command);
        check_at_most(picture_difference(&points, &picture), 1e-3);
        cupola_image_free(&picture.rgba);
    }
    cupola_image_free(&points.rgba);
}

static void a_saved_rig_gives_the_same_picture(void **state)
{
    struct picture first = run_pfm("--scene screen --preset visionstation --size 80x60 --tilt 12.5 "
                                   "--viewer 0.1,0,0.2 --save-rig saved.rig");
    struct picture second = run_pfm("--scene screen --rig saved.rig");
    struct picture third = run_pfm("--scene screen --rig saved.rig --viewer 0,0,0");

    (void)state;
    check_at_most(picture_difference(&first, &second), 0);
    /* The point of the screen that a pixel lights does not depend on the eye. */
    check_at_most(picture_difference(&first, &third), 1e-3);
    cupola_image_free(&first.rgba);
    cupola_image_free(&second.rgba);
    cupola_image_free(&third.rgba);
}

static void check_saved(const char *command, const char *const *lines, int count)
{
    char text[16384], whole[400];
    FILE *file;

    snprintf(whole, sizeof whole, "--size 32x32 --output x.png --save-rig exact.rig %s", command);
    run(whole);
    file = fopen("exact.rig", "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    for (int i = 0; i < count; i++) {
        if (strstr(text, lines[i]))
            continue;
        print_error("%s: '%s' is not in\n%s", command, lines[i], text);
        fail();
    }
}

static void numbers_reach_a_saved_rig_as_they_were_typed(void **state)
{
    static const char *const angles[] = {"fov_deg = 120.7;",  "cap_deg = 33.3;",
                                         "tilt_deg = 12.1;",  "yaw_deg = 0.1;",
                                         "pitch_deg = -7.7;", "roll_deg = 30.0;"};
    static const char *const table[] = {"\"table\"", "fov_deg = 171.4;", "angle_deg = 30.0;",
                                        "angle_deg = 85.7;"};
    static const char *const polynomial[] = {"\"polynomial\"", "fov_deg = 180.0;",
                                             "k = [1.0, -0.1, 0.0, 0.0];"};

    (void)state;
    process_write_file("exact.csv", "30,1\n60,2\n85.7,3\n");
    check_saved("--fov 120.7 --cap 33.3 --tilt 12.1 --projector-aim 0.1,-7.7,30", angles, 6);
    check_saved("--lens-table exact.csv", table, 4);
    check_saved("--lens-k 1,-0.1", polynomial, 3);
}

static void of_several_outputs_the_chosen_one_is_shown(void **state)
{
    struct picture first, second, alone;

    (void)state;
    process_write_file("two.rig", "outputs: ({size_px = [64, 64];}, {size_px = [48, 48]; lens: "
                                  "{fov_deg = 90.0;};});\n");
    process_run(&process, "--scene directions --rig two.rig --output x.pfm", NULL);
    assert_int_equal(process.status, 0);
    assert_non_null(strstr(process.err, "output 0 of the rig's 2"));
    first = run_pfm("--scene directions --rig two.rig --show-output 0");
    second = run_pfm("--scene directions --rig two.rig --show-output 1 --fov 120");
    alone = run_pfm("--scene directions --size 48x48 --fov 120");
    assert_int_equal(first.width, 64);
    check_at_most(picture_difference(&second, &alone), 2e-3);
    cupola_image_free(&first.rgba);
    cupola_image_free(&second.rgba);
    cupola_image_free(&alone.rgba);
    run("--size 32x32 --rig two.rig --preview outside --output x.png");
}

static void perspective_spans_the_field_of_view(void **state)
{
    struct picture picture = run_pfm("--scene directions --perspective --fov 90 --size 80x60");
    const float *middle = picture_pixel(&picture, 40, 30), *side = picture_pixel(&picture, 10, 30);

    (void)state;
    /* The image circle has a radius of 30 px, and 45 degrees are at its rim. */
    check_near((double)(middle[0] / -middle[2]), 0.5 / 30, 1e-5);
    check_near((double)(side[0] / -side[2]), -29.5 / 30, 1e-5);
    check_near((double)(side[1] / -side[2]), 0.5 / 30, 1e-5);
    cupola_image_free(&picture.rgba);
}

static void every_other_mode_gives_a_picture(void **state)
{
    static const char *const commands[] = {
        "--size 64x64 --preview eye",
        "--size 64x64 --preview outside",
        "--size 64x64 --views-only",
        "--size 64x64 --preset truncated-16x10",
        "--size 64x64 --views 6 --layout rotated --density 0.5",
        "--size 64x64 --fov 120 --layout asymmetric --view-size 100 --guard 4",
        "--size 64x64 --flat --camera 0.1,0.2,0.3 --look 1,0,0 --up 0,0,1 --frames 2",
    };

    (void)state;
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        struct picture picture = run_pfm(commands[i]);
        double sum = 0;
        for (int k = 0; k < picture.width * picture.height; k++)
            sum += (double)picture.rgba[4 * k + 1];
        check_at_least(sum / (picture.width * picture.height), 0.02);
        cupola_image_free(&picture.rgba);
    }
}

static void check_number(const char *json, const char *key, double low, double high)
{
    char name[60];
    const char *at;
    double number;

    snprintf(name, sizeof name, "\"%s\": ", key);
    at = strstr(json, name);
    assert_non_null(at);
    number = strtod(at + strlen(name), NULL);
    check_at_least(number, low);
    check_at_most(number, high);
}

static void check_stats(const char *json, int frames)
{
    static const char *const times[] = {"frame_ms", "views_ms", "tables_ms", "warp_ms"};
    static const char *const texels[] = {"texels_allocated_per_pixel", "texels_shaded_per_pixel",
                                         "texels_sampled_per_pixel"};
    char name[60];

    assert_memory_equal(json, "{\n", 2);
    assert_string_equal(json + strlen(json) - 3, "\n}\n");
    assert_non_null(strstr(json, "\"renderer\": \""));
    check_number(json, "frames", frames, frames);
    check_number(json, "views", 1, 8);
    check_number(json, "peak_rss_bytes", 1e6, 1e11);
    for (int i = 0; i < 3; i++)
        check_number(json, texels[i], 0.5, 100);
    for (int i = 0; i < 4; i++) {
        const char *at;
        snprintf(name, sizeof name, "\"%s\": {", times[i]);
        at = strstr(json, name);
        assert_non_null(at);
        check_number(at, "median", 1e-6, 1e5);
        check_number(at, "min", 1e-6, 1e5);
        check_number(at, "max", 1e-6, 1e5);
    }
}

static void statistics_are_one_json_object(void **state)
{
    char json[4096];
    FILE *file;

    (void)state;
    run("--scene directions --size 48x48 --frames 3 --stats - --output x.pfm");
    check_stats(process.out, 3);
    run("--size 48x48 --output x.png --stats x.json");
    file = fopen("x.json", "r");
    assert_non_null(file);
    json[fread(json, 1, sizeof json - 1, file)] = 0;
    fclose(file);
    check_stats(json, 10);
}

int main(void)
{
    const struct CMUnitTest pictures[] = {
        cmocka_unit_test(without_a_display_it_writes_dome_png),
        cmocka_unit_test(a_scene_of_numbers_is_written_as_floats),
        cmocka_unit_test(the_first_row_of_a_png_is_the_top),
        cmocka_unit_test(the_options_reach_the_rig),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_is_seen),
        cmocka_unit_test(a_preset_has_its_own_tilt_and_the_default_none),
        cmocka_unit_test(all_table_stages_give_the_same_picture),
        cmocka_unit_test(a_saved_rig_gives_the_same_picture),
        cmocka_unit_test(numbers_reach_a_saved_rig_as_they_were_typed),
        cmocka_unit_test(of_several_outputs_the_chosen_one_is_shown),
        cmocka_unit_test(perspective_spans_the_field_of_view),
        cmocka_unit_test(every_other_mode_gives_a_picture),
        cmocka_unit_test(statistics_are_one_json_object),
    };
    return cmocka_run_group_tests(pictures, process_enter_directory, process_leave_directory);
}
