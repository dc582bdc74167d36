/* What of a picture moves with the viewer and what does not, where text is, and the preview. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/points.h>

#include "check.h"
#include "stage_fixture.h"
#include "tool/dome_text.h"

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

/* Where the ink of one label is, seen by the viewer: right and up of its direction, radians. */
struct ink {
    double sum, across, up, across_low, across_high, up_low, up_high;
};

static struct ink measure(const unsigned char *image, const cupola_dome *dome,
                          const double direction[3])
{
    double flat = hypot(direction[0], direction[2]);
    const double right[3] = {-direction[2] / flat, 0, direction[0] / flat};
    const double up[3] = {right[1] * direction[2] - right[2] * direction[1],
                          right[2] * direction[0] - right[0] * direction[2],
                          right[0] * direction[1] - right[1] * direction[0]};
    struct ink ink = {0, 0, 0, 9, -9, 9, -9};
    struct cupola_ray ray;

    for (int k = 0; k < SIZE * HEIGHT; k++) {
        double light = stage_light(image[4 * k]), x = 0, y = 0;
        if (!(light > 0) ||
            cupola_dome_ray(dome, 0, NULL, k % SIZE + 0.5, k / SIZE + 0.5, &ray) != 1)
            continue;
        for (int i = 0; i < 3; i++) {
            x += right[i] * ray.direction[i];
            y += up[i] * ray.direction[i];
        }
        light *= ray.solid_angle_sr;
        ink.sum += light;
        ink.across += light * x;
        ink.up += light * y;
        ink.across_low = fmin(ink.across_low, x);
        ink.across_high = fmax(ink.across_high, x);
        ink.up_low = fmin(ink.up_low, y);
        ink.up_high = fmax(ink.up_high, y);
    }
    ink.across /= ink.sum;
    ink.up /= ink.sum;
    return ink;
}

/* Draws one label alone. */
static unsigned char *draw_label(const struct cupola_rig *rig, const cupola_dome *dome,
                                 const struct dome_label *label)
{
    char message[MESSAGE_SIZE];
    struct dome_text *text = dome_text_create(message);
    cupola_points *points = NULL;
    struct target target;
    unsigned char *image = malloc((size_t)SIZE * HEIGHT * 4);

    if (!text || !target_create(&target, SIZE, HEIGHT, TARGET_SRGB, message, MESSAGE_SIZE))
        fail_msg("%s", message);
    assert_non_null(image);
    assert_int_equal(cupola_points_create(dome, 0, &points, NULL), CUPOLA_OK);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, SIZE, HEIGHT);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_FRAMEBUFFER_SRGB);
    dome_text_draw(text, rig, 0, cupola_points_texture(points), label);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glReadPixels(0, 0, SIZE, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    cupola_points_destroy(&points);
    target_destroy(&target);
    dome_text_destroy(text);
    return image;
}

static void check_label(uint64_t seed)
{
    struct cupola_rig rig;
    cupola_dome *dome = NULL;
    struct cupola_ray ray;
    struct dome_label label = {.unit_rad = 0.008, .ink = {1, 1, 1}};
    double per_px, x, y;
    unsigned char *image;
    struct ink ink;

    stage_random_rig(&seed, SIZE, &rig);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    x = rig.outputs[0].circle.center_x_px + random_between(&seed, -70, 70);
    y = rig.outputs[0].circle.center_y_px + random_between(&seed, -70, 70);
    assert_int_equal(cupola_dome_ray(dome, 0, NULL, x, y, &ray), 1);
    memcpy(label.direction, ray.direction, sizeof label.direction);
    per_px = sqrt(ray.solid_angle_sr);
    /* As high as wide in ink: its middle is the direction. */
    label.text = "H";
    dome_label_anchor(&label, 0, 0);
    image = draw_label(&rig, dome, &label);
    ink = measure(image, dome, label.direction);
    check_near(ink.across, 0, 0.5 * label.unit_rad + 0.5 * per_px);
    check_near(ink.up, 0, 0.5 * label.unit_rad + 0.5 * per_px);
    check_near(ink.up_high - ink.up_low, 7 * label.unit_rad, 0.6 * label.unit_rad + 2.5 * per_px);
    free(image);
    /* Upright and not mirrored: an L has its weight at the left and below. */
    label.text = "L";
    dome_label_anchor(&label, 0, 0);
    image = draw_label(&rig, dome, &label);
    ink = measure(image, dome, label.direction);
    check_at_most(ink.across - 0.5 * (ink.across_low + ink.across_high), -0.5 * label.unit_rad);
    check_at_most(ink.up - 0.5 * (ink.up_low + ink.up_high), -0.5 * label.unit_rad);
    free(image);
    /* Beside its direction on the side that was wished. */
    dome_label_anchor(&label, 1, -1);
    image = draw_label(&rig, dome, &label);
    ink = measure(image, dome, label.direction);
    check_at_least(ink.across_low, 0);
    check_at_most(ink.up_high, 0);
    free(image);
    cupola_dome_destroy(&dome);
}

static void labels_are_upright_at_their_direction(void **state)
{
    (void)state;
    for (uint64_t seed = 20; seed < 30; seed++) {
        print_message("seed %d\n", (int)seed);
        check_label(seed);
    }
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
    assert_true(stage_pixel(&fixture.tool, SIZE + 100, HEIGHT, 50 + 20.5, 30.5, pixel));
    check_near(pixel[0], 20.5, 1e-9);
    check_near(pixel[1], HEIGHT - 30.5, 1e-9);
    assert_false(stage_pixel(&fixture.tool, SIZE + 100, HEIGHT, 40, 30.5, pixel));
    free(frame);
    free(image);
    stage_fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_about_the_dome_stays_where_it_is_for_every_viewer),
        cmocka_unit_test(nothing_is_lit_outside_of_lens_and_screen),
        cmocka_unit_test(labels_are_upright_at_their_direction),
        cmocka_unit_test(the_preview_shows_a_straight_grid_where_the_theatre_is_the_rig),
        cmocka_unit_test(a_window_of_the_images_size_shows_its_pixels),
    };

    return cmocka_run_group_tests_name("calib-stage_scenes", tests, stage_context_open,
                                       stage_context_close);
}
