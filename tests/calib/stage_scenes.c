/* What of a picture moves with the viewer and what does not, what is dark, and the preview. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "stage_fixture.h"

enum { SIZE = 512, HEIGHT = 3 * SIZE / 4 };

static const double RADIANS = 3.14159265358979323846 / 180;

static int count_different(const unsigned char *a, const unsigned char *b)
{
    int different = 0;

    for (int k = 0; k < SIZE * HEIGHT; k++)
        different += memcmp(a + 4 * k, b + 4 * k, 3) != 0;
    return different;
}

/* How many pixels of a pattern change when the viewer moves. */
static int changed_by_viewer(enum pattern pattern, enum about about)
{
    struct cupola_rig rig;
    struct stage_fixture fixture;
    unsigned char *first, *second;
    uint64_t seed = 11;
    int different;

    stage_random_rig(&seed, SIZE, &rig);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = pattern;
    fixture.tool.about = about;
    first = stage_fixture_image(&fixture);
    for (int i = 0; i < 3; i++)
        fixture.tool.rig.eye_m[i] *= -0.7;
    second = stage_fixture_image(&fixture);
    different = count_different(first, second);
    free(first);
    free(second);
    stage_fixture_release(&fixture);
    return different;
}

static void what_is_about_the_dome_stays_where_it_is_for_every_viewer(void **state)
{
    (void)state;
    for (int pattern = 0; pattern < PATTERN_COUNT; pattern++) {
        if (pattern != PATTERN_DOT)
            assert_int_equal(changed_by_viewer((enum pattern)pattern, ABOUT_DOME), 0);
        if (pattern != PATTERN_RIM)
            check_at_least(changed_by_viewer((enum pattern)pattern, ABOUT_VIEWER), 10);
    }
}

static void nothing_is_lit_outside_of_lens_and_screen(void **state)
{
    struct cupola_rig rig;
    struct stage_fixture fixture;
    cupola_dome *dome = NULL;
    struct cupola_ray ray;
    uint64_t seed = 3;
    int outside = 0;

    (void)state;
    stage_random_rig(&seed, SIZE, &rig);
    stage_fixture_make(&fixture, &rig);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    fixture.tool.shows_labels = fixture.tool.shows_legend = fixture.tool.text_on_dome = true;
    fixture.tool.group = GROUP_MARKS;
    fixture.tool.cross_px[0] = rig.outputs[0].circle.center_x_px;
    fixture.tool.cross_px[1] = 10;
    strcpy(fixture.tool.warning, "a warning");
    for (int pattern = 0; pattern < PATTERN_COUNT; pattern++) {
        unsigned char *image;
        fixture.tool.pattern = (enum pattern)pattern;
        image = stage_fixture_image(&fixture);
        for (int k = 0; k < SIZE * HEIGHT; k++) {
            if (cupola_dome_ray(dome, 0, NULL, k % SIZE + 0.5, k / SIZE + 0.5, &ray) == 1)
                continue;
            outside++;
            if (image[4 * k] || image[4 * k + 1] || image[4 * k + 2])
                fail_msg("pattern %d lights pixel (%d, %d)", pattern, k % SIZE, k / SIZE);
        }
        free(image);
    }
    check_at_least(outside, 1000);
    cupola_dome_destroy(&dome);
    stage_fixture_release(&fixture);
}

/* How much of the eye's preview is as a grid seen directly. */
static double agreement(const unsigned char *frame, int width, int height)
{
    int lit = 0, lines = 0, dark = 0, ground = 0;
    double half = tan(0.8);

    for (int k = 0; k < width / 2 * height; k++) {
        int i = width / 2 + k % (width / 2), j = k / (width / 2);
        double x = ((k % (width / 2) + 0.5) / (width / 2) - 0.5) * 2 * half;
        double y = ((j + 0.5) / height - 0.5) * 2 * half;
        double up = atan2(y, hypot(1, x)) / RADIANS, left = atan2(-x, 1) / RADIANS;
        double light = stage_light(frame[4 * ((size_t)j * (size_t)width + (size_t)i) + 1]);
        double strong = fmin(fabs(remainder(up, 30)), fabs(remainder(left, 30)));
        double any = fmin(fabs(remainder(up, 10)), fabs(remainder(left, 10)) * cos(up * RADIANS));
        if (fabs(up) > 35 || fabs(left) > 35)
            continue;
        if (strong < 0.1 && fabs(up) > 5 && fabs(left) > 5) {
            lines++;
            lit += light > 0.25;
        } else if (any > 2) {
            ground++;
            dark += light < 0.02;
        }
    }
    check_at_least(lines, 200);
    check_at_least(ground, 2000);
    return 0.5 * lit / lines + 0.5 * dark / ground;
}

static void the_preview_shows_a_straight_grid_where_the_theatre_is_the_rig(void **state)
{
    const int width = 800, height = 400;
    struct cupola_rig rig = {
        .screen = {2, 110 * RADIANS}, .eye_m = {0.2, 0.1, 0.3}, .tilt_rad = 20 * RADIANS};
    struct stage_fixture fixture;
    unsigned char *frame;

    (void)state;
    rig.outputs[0].position_m[1] = -0.5;
    rig.outputs[0].lens.fov_rad = 200 * RADIANS;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_GRID;
    fixture.tool.about = ABOUT_VIEWER;
    fixture.tool.preview = PREVIEW_EYE;
    fixture.tool.theatre = rig;
    frame = stage_fixture_frame(&fixture, width, height);
    check_at_least(agreement(frame, width, height), 0.99);
    free(frame);
    /* The image is made for a projector that hangs 5 cm lower. */
    fixture.tool.rig.outputs[0].position_m[1] -= 0.05;
    frame = stage_fixture_frame(&fixture, width, height);
    check_at_most(agreement(frame, width, height), 0.9);
    free(frame);
    stage_fixture_release(&fixture);
}

/* The chosen one lights a corner; all else is the other one's, whose image has another size. */
static void the_preview_has_the_images_of_all_projectors(void **state)
{
    const int width = 800, height = 400;
    struct cupola_rig rig = {.screen = {2, 110 * RADIANS}, .output_count = 2};
    struct stage_fixture fixture;
    unsigned char *frame;

    (void)state;
    rig.outputs[0].lens.fov_rad = 30 * RADIANS;
    rig.outputs[0].aim.yaw_rad = 60 * RADIANS;
    rig.outputs[1].position_m[1] = -0.5;
    rig.outputs[1].lens.fov_rad = 200 * RADIANS;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.theatre = rig;
    assert_int_equal(cupola_output_resize(&fixture.tool.rig.outputs[1], 900, 800, NULL), CUPOLA_OK);
    fixture.tool.pattern = PATTERN_GRID;
    fixture.tool.about = ABOUT_VIEWER;
    fixture.tool.preview = PREVIEW_EYE;
    frame = stage_fixture_frame(&fixture, width, height);
    check_at_least(agreement(frame, width, height), 0.99);
    free(frame);
    fixture.tool.rig.outputs[1].position_m[1] -= 0.05;
    frame = stage_fixture_frame(&fixture, width, height);
    check_at_most(agreement(frame, width, height), 0.9);
    free(frame);
    stage_fixture_release(&fixture);
}

static void a_window_of_the_images_size_shows_its_pixels(void **state)
{
    struct cupola_rig rig;
    struct stage_fixture fixture;
    unsigned char *image, *frame;
    double pixel[2];
    uint64_t seed = 4;

    (void)state;
    stage_random_rig(&seed, SIZE, &rig);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_RAMPS;
    frame = stage_fixture_frame(&fixture, SIZE, HEIGHT);
    image = stage_fixture_image(&fixture);
    assert_int_equal(count_different(frame, image), 0);
    free(frame);
    /* A wider one shows it in the middle, and the mouse finds it there. */
    frame = stage_fixture_frame(&fixture, SIZE + 100, HEIGHT);
    for (int k = 0; k < SIZE * HEIGHT; k++)
        assert_memory_equal(frame + 4 * (k / SIZE * (SIZE + 100) + k % SIZE + 50), image + 4 * k,
                            3);
    stage_pixel(&fixture.tool, SIZE + 100, HEIGHT, 50 + 20.5, 30.5, pixel);
    check_near(pixel[0], 20.5, 1e-9);
    check_near(pixel[1], HEIGHT - 30.5, 1e-9);
    stage_pixel(&fixture.tool, SIZE + 100, HEIGHT, 40, 30.5, pixel);
    check_near(pixel[0], -10, 1e-9);
    free(frame);
    free(image);
    stage_fixture_release(&fixture);
}

/* Sizes, lenses and text that nobody wants but somebody has. */
static void whatever_is_possible_is_drawn(void **state)
{
    static const struct cupola_rig rigs[] = {
        {.outputs = {{.width_px = 1, .height_px = 1}}},
        {.outputs = {{.width_px = 2000, .height_px = 3}}, .tilt_rad = 3},
        {.screen = {1e-6, 1e-3}, .outputs = {{.width_px = 64, .height_px = 64}}},
        {.screen = {1000, 3},
         .outputs = {{.width_px = 64, .height_px = 64, .lens = {.fov_rad = 6.28}}}},
        {.outputs = {{.width_px = 64, .height_px = 64, .circle = {32, 32, 1e-6}}}},
        {.outputs = {{.width_px = 64,
                      .height_px = 64,
                      .circle = {32, 32, 1e6},
                      .lens = {.fov_rad = 1e-6}}}},
        {.output_count = 2,
         .outputs = {{.width_px = 64, .height_px = 48}, {.width_px = 100, .height_px = 31}}},
    };
    static char name[MARK_NAME_MAX + 1] = "\xff %s \n a name";

    (void)state;
    for (size_t i = 0; i < sizeof rigs / sizeof *rigs; i++) {
        struct cupola_rig rig;
        struct stage_fixture fixture;
        struct mark mark = {.steered = true};
        assert_int_equal(cupola_rig_complete(&rigs[i], &rig, NULL), CUPOLA_OK);
        stage_fixture_make(&fixture, &rig);
        memcpy(mark.name, name, sizeof name);
        fixture.tool.marks = (struct marks){.list = &mark, .count = 1};
        fixture.tool.group = GROUP_MARKS;
        fixture.tool.output = rig.output_count - 1;
        fixture.tool.shows_labels = fixture.tool.shows_legend = true;
        memset(fixture.tool.warning, 'W', 700);
        for (int k = 0; k < 4 * PATTERN_COUNT; k++) {
            fixture.tool.pattern = (enum pattern)(k / 4);
            fixture.tool.about = (enum about)(k % 2);
            fixture.tool.text_on_dome = k % 4 > 1;
            fixture.tool.shows_help = k % 4 == 3;
            fixture.tool.preview = (enum preview)(k % PREVIEW_COUNT);
            free(stage_fixture_frame(&fixture, k % 3 == 0 ? 1 : 90, k % 5 == 0 ? 1 : 60));
        }
        fixture.tool.marks = (struct marks){0};
        stage_fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_about_the_dome_stays_where_it_is_for_every_viewer),
        cmocka_unit_test(nothing_is_lit_outside_of_lens_and_screen),
        cmocka_unit_test(the_preview_shows_a_straight_grid_where_the_theatre_is_the_rig),
        cmocka_unit_test(the_preview_has_the_images_of_all_projectors),
        cmocka_unit_test(a_window_of_the_images_size_shows_its_pixels),
        cmocka_unit_test(whatever_is_possible_is_drawn),
    };

    return cmocka_run_group_tests_name("calib-stage_scenes", tests, stage_context_open,
                                       stage_context_close);
}
