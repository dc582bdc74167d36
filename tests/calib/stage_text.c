/* Text on the dome and over the window. */
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

/* What is drawn of a text that stands beside its direction on this side, measured from another. */
static struct ink ink_of(const struct cupola_rig *rig, const cupola_dome *dome,
                         struct dome_label *label, int across, int up, const double from[3])
{
    unsigned char *image;
    struct ink ink;

    dome_label_anchor(label, across, up);
    image = draw_label(rig, dome, label);
    ink = measure(image, dome, from);
    free(image);
    return ink;
}

static void check_label(uint64_t seed)
{
    struct cupola_rig rig;
    cupola_dome *dome = NULL;
    struct cupola_ray ray;
    struct dome_label label = {.unit_rad = 0.008, .ink = {1, 1, 1}};
    double tolerance, off[3], x, y;
    struct ink ink;

    stage_random_rig(&seed, SIZE, &rig);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    x = rig.outputs[0].circle.center_x_px + random_between(&seed, -70, 70);
    y = rig.outputs[0].circle.center_y_px + random_between(&seed, -70, 70);
    assert_int_equal(cupola_dome_ray(dome, 0, NULL, x, y, &ray), 1);
    memcpy(label.direction, ray.direction, sizeof label.direction);
    for (int i = 0; i < 3; i++)
        off[i] = ray.direction[i] + 4 * ray.direction_dx[i];
    tolerance = 0.5 * label.unit_rad + 0.5 * sqrt(ray.solid_angle_sr);
    /* As high as wide in ink: its middle is the direction, and not what is four pixels off it. */
    label.text = "H";
    ink = ink_of(&rig, dome, &label, 0, 0, ray.direction);
    check_near(ink.across, 0, tolerance);
    check_near(ink.up, 0, tolerance);
    check_near(ink.up_high - ink.up_low, 7 * label.unit_rad, 5 * tolerance);
    ink = ink_of(&rig, dome, &label, 0, 0, off);
    check_at_least(hypot(ink.across, ink.up), tolerance);
    /* Upright and not mirrored: an L has its weight at the left and below. */
    label.text = "L";
    ink = ink_of(&rig, dome, &label, 0, 0, ray.direction);
    check_at_most(ink.across - 0.5 * (ink.across_low + ink.across_high), -0.5 * label.unit_rad);
    check_at_most(ink.up - 0.5 * (ink.up_low + ink.up_high), -0.5 * label.unit_rad);
    /* Beside its direction on the side that was wished. */
    ink = ink_of(&rig, dome, &label, 1, -1, ray.direction);
    check_at_least(ink.across_low, 0);
    check_at_most(ink.up_high, 0);
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

static int count_red(const unsigned char *bytes, int pixels)
{
    int red = 0;

    for (int k = 0; k < pixels; k++)
        red += bytes[4 * k] > 150 && bytes[4 * k + 1] < 120 && bytes[4 * k + 2] < 120;
    return red;
}

static void warnings_are_red_plain_and_on_the_dome(void **state)
{
    struct cupola_rig rig = {.eye_m = {0, 0.1, 0.2}};
    struct stage_fixture fixture;

    (void)state;
    rig.outputs[0].width_px = SIZE;
    rig.outputs[0].height_px = HEIGHT;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_DOT;
    for (int on_dome = 0; on_dome < 2; on_dome++) {
        unsigned char *frame, *image;
        fixture.tool.text_on_dome = on_dome != 0;
        strcpy(fixture.tool.warning, "cap: 400 degrees are not allowed; allowed: up to 180");
        frame = stage_fixture_frame(&fixture, 640, 480);
        image = stage_fixture_image(&fixture);
        check_at_least(count_red(frame, 640 * 480), 200);
        /* Plain text is the window's: the projector throws it only if it lies on the dome. */
        if (on_dome)
            check_at_least(count_red(image, SIZE * HEIGHT), 200);
        else
            assert_int_equal(count_red(image, SIZE * HEIGHT), 0);
        free(frame);
        free(image);
        fixture.tool.warning[0] = 0;
        frame = stage_fixture_frame(&fixture, 640, 480);
        assert_int_equal(count_red(frame, 640 * 480), 0);
        free(frame);
    }
    stage_fixture_release(&fixture);
}

/* A planetarium has nothing below the horizon, where others have their legend. */
static void the_legend_is_where_the_dome_is(void **state)
{
    struct cupola_rig rig = {
        .screen = {5, 90 * RADIANS}, .eye_m = {0, 0, -0.5}, .tilt_rad = 90 * RADIANS};
    struct stage_fixture fixture;
    struct cupola_ray ray;
    cupola_dome *dome = NULL;
    unsigned char *image;
    int letters = 0, cut = 0;

    (void)state;
    rig.outputs[0].width_px = rig.outputs[0].height_px = SIZE;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_DOT;
    fixture.tool.shows_legend = fixture.tool.text_on_dome = true;
    image = stage_fixture_image(&fixture);
    for (int k = 0; k < SIZE * SIZE; k++) {
        if (image[4 * k] < 100)
            continue;
        letters++;
        for (int i = 0; i < 4; i++) {
            double x = k % SIZE + 0.5 + (i == 0 ? -5 : i == 1 ? 5 : 0);
            double y = k / SIZE + 0.5 + (i == 2 ? -5 : i == 3 ? 5 : 0);
            cut += cupola_dome_ray(dome, 0, NULL, x, y, &ray) != 1;
        }
    }
    check_at_least(letters, 500);
    assert_int_equal(cut, 0);
    free(image);
    cupola_dome_destroy(&dome);
    stage_fixture_release(&fixture);
}

static int difference(const unsigned char *a, const unsigned char *b, int pixel)
{
    int most = 0;

    for (int i = 0; i < 3; i++) {
        int apart = abs(a[4 * pixel + i] - b[4 * pixel + i]);
        most = apart > most ? apart : most;
    }
    return most;
}

/* Two images between the outermost letters, what a panel makes bright, of each column. */
static int most_between_letters(const unsigned char *letters, const unsigned char *without,
                                const unsigned char *a, const unsigned char *b, int width,
                                int height)
{
    int most = 0;

    for (int x = 0; x < width; x++) {
        int first = height, last = -1;
        for (int y = 0; y < height; y++)
            if (difference(letters, without, y * width + x) > 150) {
                first = y < first ? y : first;
                last = y;
            }
        for (int y = first; y <= last; y++) {
            int apart = difference(a, b, y * width + x);
            most = apart > most ? apart : most;
        }
    }
    return most;
}

/* The legend over a dark pattern and over a bright one: under it they make no difference. */
static void check_nothing_shines_through(struct stage_fixture *fixture, bool on_dome)
{
    unsigned char *images[4]; /* dark and not, with the legend and without */
    int width = on_dome ? 480 : 640, height = on_dome ? 800 : 480;

    fixture->tool.text_on_dome = on_dome;
    for (int i = 0; i < 4; i++) {
        fixture->tool.shows_legend = i < 2;
        fixture->tool.shows_labels = true;
        /* Plain, the legend tells the pattern: there it is a dot that is larger or not. */
        fixture->tool.pattern = on_dome && i % 2 ? PATTERN_MERIDIANS : PATTERN_DOT;
        fixture->tool.dot_size_rad = (!on_dome && i % 2 ? 170 : 1) * RADIANS;
        images[i] =
            on_dome ? stage_fixture_image(fixture) : stage_fixture_frame(fixture, width, height);
    }
    check_at_most(most_between_letters(images[0], images[2], images[0], images[1], width, height),
                  40);
    check_at_least(most_between_letters(images[0], images[2], images[2], images[3], width, height),
                   150);
    for (int i = 0; i < 4; i++)
        free(images[i]);
}

/* As much of a warning is seen above a long notice as without one. */
static void a_warning_stands_above_a_notice(void **state)
{
    struct cupola_rig rig = {0};
    struct stage_fixture fixture;
    int red[2];

    (void)state;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_DOT;
    strcpy(fixture.tool.warning, "cap: 400 degrees are not allowed; allowed: up to 180");
    for (int on_dome = 0; on_dome < 2; on_dome++) {
        fixture.tool.text_on_dome = on_dome != 0;
        for (int noticed = 0; noticed < 2; noticed++) {
            unsigned char *frame;
            memset(fixture.tool.notice, 0, sizeof fixture.tool.notice);
            for (int i = 0; noticed && i < 20; i++)
                strcat(fixture.tool.notice, "some words ");
            frame = stage_fixture_frame(&fixture, 640, 640);
            red[noticed] = count_red(frame, 640 * 640);
            free(frame);
        }
        check_at_least(red[0], 200);
        check_near(red[1], red[0], on_dome ? 0.2 * red[0] : 0);
    }
    stage_fixture_release(&fixture);
}

static void nothing_shines_through_a_panel(void **state)
{
    struct cupola_rig rig = {.eye_m = {0, 0.05, 0.25}};
    struct stage_fixture fixture;

    (void)state;
    rig.outputs[0].width_px = 480;
    rig.outputs[0].height_px = 800;
    rig.outputs[0].position_m[1] = -0.3;
    rig.outputs[0].aim.pitch_rad = 15 * RADIANS;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.group = GROUP_AIM;
    fixture.tool.dot_yaw_rad = 60 * RADIANS; /* out of the way */
    check_nothing_shines_through(&fixture, true);
    stage_fixture_release(&fixture);
    /* Nearly all of the image is within the circle, and under the plain legend, too. */
    rig.outputs[0].width_px = 640;
    rig.outputs[0].height_px = 480;
    rig.outputs[0].circle = (struct cupola_circle){320, 240, 400};
    stage_fixture_make(&fixture, &rig);
    check_nothing_shines_through(&fixture, false);
    stage_fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(labels_are_upright_at_their_direction),
        cmocka_unit_test(warnings_are_red_plain_and_on_the_dome),
        cmocka_unit_test(the_legend_is_where_the_dome_is),
        cmocka_unit_test(a_warning_stands_above_a_notice),
        cmocka_unit_test(nothing_shines_through_a_panel),
    };

    return cmocka_run_group_tests_name("calib-stage_text", tests, stage_context_open,
                                       stage_context_close);
}
