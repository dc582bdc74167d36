/*
 * What holds for every filter: a scene of one colour stays that colour in all of 8 bits, no
 * border of views shows, and noise is only noise.
 */
#include <stdlib.h>
#include <string.h>

#include "filter_cases.h"
#include "group.h"
#include "rig_random.h"
#include "worse.h"

/* A 180 degree circle that the frame does not cut, and an eye off the axis. */
static struct cupola_rig filtered_rig(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 96);
    rig.outputs[0].width_px = 101;
    rig.eye_m[0] = 0.1;
    rig.eye_m[2] = -0.05;
    return rig;
}

static void clear_views(const struct fixture *fixture, const float color[4])
{
    struct cupola_frame frame = {.depth = {0}};
    memcpy(frame.clear_color, color, sizeof frame.clear_color);
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
}

/* Into 8 bits; freed by the caller. */
static unsigned char *warp_bytes(const struct fixture *fixture)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    unsigned char *bytes = malloc(4 * (size_t)size->width_px * (size_t)size->height_px);
    GLuint texture = 0, framebuffer = 0;
    assert_non_null(bytes);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size->width_px, size->height_px, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, NULL);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    struct cupola_target target = {framebuffer, 0, 0};
    assert_int_equal(cupola_gl_warp(fixture->gl, 0, NULL, &target, NULL), CUPOLA_OK);
    glReadPixels(0, 0, size->width_px, size->height_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    return bytes;
}

/* The border colour is the scene's, so the rim is, too. */
static int bytes_unlike(const struct fixture *fixture, const int wished[4])
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    unsigned char *bytes = warp_bytes(fixture);
    int unlike = 0;
    for (int i = 0; i < 4 * size->width_px * size->height_px; i++)
        unlike += bytes[i] != wished[i % 4];
    free(bytes);
    return unlike;
}

static void a_scene_of_one_color_stays_that_color(void **state)
{
    (void)state;
    static const int wished[4] = {201, 77, 2, 254};
    float color[4];
    struct cupola_rig rig = filtered_rig();
    struct fixture fixture;
    for (int c = 0; c < 4; c++)
        color[c] = (float)wished[c] / 255.0f;
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int i = 0; i < FILTERS; i++)
        for (int s = 0; s < 2; s++) {
            struct cupola_gl_params params = {.filter = filters[i], .table = filter_stages[s]};
            memcpy(params.border, color, sizeof color);
            fixture_replace_gl(&fixture, &params);
            clear_views(&fixture, color);
            check_at_most(bytes_unlike(&fixture, wished), 0);
        }
    float other[4] = {color[0], color[1] + 1.0f / 255.0f, color[2], color[3]};
    clear_views(&fixture, other);
    check_at_least(bytes_unlike(&fixture, wished), 1000);
    fixture_release(&fixture);
}

static double brightest(const struct fixture *fixture)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *image = fixture_warp(fixture, 0);
    double most = 0.0;
    for (int i = 0; i < 4 * size->width_px * size->height_px; i++)
        most = worse_of(most, (double)image[i]);
    free(image);
    return most;
}

static void no_ray_leaves_a_view(void **state)
{
    (void)state;
    static const float gray[4] = {0.5f, 0.5f, 0.5f, 0.5f};
    struct cupola_rig rig = filtered_rig();
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int i = 0; i < FILTERS; i++)
        for (int s = 0; s < 2; s++) {
            struct cupola_gl_params params = {
                .format = CUPOLA_FORMAT_RGBA32F, .filter = filters[i], .table = filter_stages[s]};
            fixture_replace_gl(&fixture, &params);
            clear_views(&fixture, gray);
            spoil_beyond_views(&fixture, 0);
            check_at_most(brightest(&fixture), 0.50001);
            spoil_beyond_views(&fixture, 5);
            check_at_least(brightest(&fixture), 1.0);
        }
    fixture_release(&fixture);
}

static void noise_is_of_one_step_and_has_no_mean(void **state)
{
    (void)state;
    static const float color[4] = {0.3f, 100.25f / 255.0f, 0.0f, 1.0f};
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 100.0, 128);
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int s = 0; s < 2; s++) {
        struct cupola_gl_params params = {
            .format = CUPOLA_FORMAT_RGBA16F, .table = filter_stages[s], .dither_bits = 8};
        memcpy(params.border, color, sizeof color);
        fixture_replace_gl(&fixture, &params);
        clear_views(&fixture, color);
        unsigned char *bytes = warp_bytes(&fixture);
        double sum[4] = {0.0}, least[4] = {255, 255, 255, 255}, most[4] = {0.0};
        for (int i = 0; i < 4 * 128 * 128; i++) {
            sum[i % 4] += bytes[i];
            least[i % 4] = fmin(least[i % 4], bytes[i]);
            most[i % 4] = fmax(most[i % 4], bytes[i]);
        }
        free(bytes);
        /* Of 16384 pixels the mean is known to 0.005 steps; halves hold 0.39 to 1/32 of a step. */
        for (int c = 0; c < 2; c++)
            check_at_most(fabs(sum[c] / 16384.0 - 255.0 * (double)color[c]), 0.06);
        assert_true(least[1] == 99.0 && most[1] == 101.0);
        assert_true(most[2] == 0.0 && least[3] == 255.0);
    }
    fixture_release(&fixture);
}

static void params_that_cannot_be_are_refused(void **state)
{
    (void)state;
    static const struct {
        struct cupola_gl_params params;
        const char *word;
    } wrongs[] = {
        {{.dither_bits = 10}, "dither_bits is 10; allowed: 8"},
        {{.filter = {.method = (enum cupola_antialiasing)9}}, "9; allowed"},
        {{.filter = {.method = CUPOLA_ANTIALIASING_CONE, .samples = 65}}, "65; allowed: 1 to 64"},
        {{.filter = {.samples = 5}}, "5; allowed: 4 or 9"},
    };
    struct cupola_rig rig = filtered_rig();
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    for (size_t i = 0; i < sizeof wrongs / sizeof wrongs[0]; i++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        cupola_gl *gl = NULL;
        assert_int_equal(cupola_gl_create(fixture.plan, &wrongs[i].params, &gl, &error),
                         CUPOLA_ERROR_ARGUMENT);
        assert_null(gl);
        if (!strstr(error.message, wrongs[i].word))
            fail_msg("'%s' does not say '%s'", error.message, wrongs[i].word);
    }
    fixture_release(&fixture);
}

/* Nine texels reach further than one guards; of pictures nobody has to. */
static void nine_texels_want_a_guard_band_of_two(void **state)
{
    (void)state;
    struct cupola_gl_params params = {.filter = {.samples = 9}};
    struct cupola_plan_params wish = {.guard_px = 1};
    struct cupola_rig rig = filtered_rig();
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture;
    cupola_gl *gl = NULL;
    fixture_make(&rig, &wish, NULL, &fixture);
    assert_int_equal(cupola_gl_create(fixture.plan, &params, &gl, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "the plan's guard band is 1; allowed: 2 or more"));
    params.sources = 1u << CUPOLA_SOURCE_CUBE;
    assert_int_equal(cupola_gl_create(fixture.plan, &params, &gl, &error), CUPOLA_OK);
    cupola_gl_destroy(&gl);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_of_one_color_stays_that_color),
        cmocka_unit_test(no_ray_leaves_a_view),
        cmocka_unit_test(noise_is_of_one_step_and_has_no_mean),
        cmocka_unit_test(params_that_cannot_be_are_refused),
        cmocka_unit_test(nine_texels_want_a_guard_band_of_two),
    };
    return run_gpu_group("filters", tests);
}
