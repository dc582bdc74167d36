/*
 * Formats of views: what is cleared and drawn into each is what the warp shows, by the C reference
 * of the decoded atlas; and parameters that are none are refused before anything is made.
 */
#include <stdio.h>
#include <stdlib.h>

#include "atlas_decode.h"
#include "group.h"
#include "rig_random.h"

enum { SIZE = 128, FORMATS = 4, NAMES = 1024 };

static const char *const names[FORMATS] = {"rgba8", "rgba16f", "rgba32f", "srgb8"};

static bool has_format(int format)
{
    return context_has_floats() || format == CUPOLA_FORMAT_RGBA8 || format == CUPOLA_FORMAT_SRGB8;
}

static void make(struct fixture *fixture, int format, int samples)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 170.0, SIZE);
    const struct cupola_gl_params params = {.format = (enum cupola_format)format,
                                            .samples = samples};
    rig.eye_m[1] = 0.3;
    fixture_make(&rig, NULL, &params, fixture);
}

static void each_format_warps_as_the_reference_has_it(void **state)
{
    (void)state;
    for (int format = 0; format < FORMATS; format++) {
        struct fixture fixture;
        if (!has_format(format))
            continue;
        make(&fixture, format, 1);
        fixture_paint(&fixture, PAINT_NOISE);
        struct warp_error error = warp_error_of(&fixture, (enum cupola_format)format);
        printf("%s: %.4f apart, %d of %d pixels at borders of views\n", names[format], error.worst,
               error.skipped, error.lit);
        check_at_least(error.lit, SIZE * SIZE / 2);
        check_at_most(error.skipped, SIZE);
        check_at_most(error.worst, bar_of_format((enum cupola_format)format));
        fixture_release(&fixture);
    }
}

/* The control: an atlas that is decoded though it should not be, and the other way round. */
static void a_format_that_is_mistaken_for_another_is_caught(void **state)
{
    static const enum cupola_format formats[2] = {CUPOLA_FORMAT_RGBA8, CUPOLA_FORMAT_SRGB8};
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct fixture fixture;
        make(&fixture, (int)formats[i], 1);
        fixture_paint(&fixture, PAINT_NOISE);
        check_at_least(warp_error_of(&fixture, formats[1 - i]).worst, 0.1);
        fixture_release(&fixture);
    }
}

/* All of view 0 as cleared, whatever the host's switch stands at; the switch stays. */
static void check_clear(const struct fixture *fixture, int format, bool switched)
{
    const struct cupola_frame frame = {.clear_color = {0.5f, 0.02f, 1.0f, 0.5f}};
    bool has_switch = context_has(33, NULL, 1000, "GL_EXT_sRGB_write_control");
    const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, 0)->rect;
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    assert_true(cupola_gl_frame_begin(fixture->gl, &frame, NULL) > 0);
    if (has_switch)
        (switched ? glEnable : glDisable)(GL_FRAMEBUFFER_SRGB);
    assert_int_equal(cupola_gl_view_begin(fixture->gl, 0, NULL, NULL), CUPOLA_OK);
    if (has_switch)
        assert_int_equal(glIsEnabled(GL_FRAMEBUFFER_SRGB), switched);
    assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    if (has_switch) {
        assert_int_equal(glIsEnabled(GL_FRAMEBUFFER_SRGB), switched);
        (context_is_es() ? glEnable : glDisable)(GL_FRAMEBUFFER_SRGB);
    }
    float *atlas = fixture_atlas(fixture);
    for (int y = 0; y < rect->height; y++)
        for (int x = 0; x < rect->width; x++)
            for (int c = 0; c < 4; c++) {
                double expected = (double)frame.clear_color[c];
                if (format == CUPOLA_FORMAT_SRGB8 && c < 3)
                    expected = srgb_encoded(expected);
                check_near(atlas[4 * ((rect->y + y) * width + rect->x + x) + c], expected,
                           0.6 / 255);
            }
    free(atlas);
}

static void views_are_cleared_in_linear_light(void **state)
{
    (void)state;
    for (int format = 0; format < FORMATS; format++) {
        for (int samples = 1; samples <= 2 && has_format(format); samples++) {
            struct fixture fixture;
            if (samples > 1 && format != CUPOLA_FORMAT_SRGB8)
                continue;
            make(&fixture, format, samples);
            check_clear(&fixture, format, false);
            check_clear(&fixture, format, true);
            fixture_release(&fixture);
        }
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static int live_objects(void)
{
    int count = 0;
    for (GLuint name = 1; name < NAMES; name++)
        count += glIsTexture(name) + glIsFramebuffer(name) + glIsRenderbuffer(name);
    return count;
}

static void what_is_no_format_is_refused_and_makes_nothing(void **state)
{
    static const struct {
        struct cupola_gl_params params;
        const char *message;
    } bad[] = {
        {{.format = (enum cupola_format)4}, "format is 4; allowed: 0 to 3"},
        {{.format = (enum cupola_format) - 1}, "format is -1; allowed: 0 to 3"},
        {{.depth = (enum cupola_depth_format)5}, "depth format is 5; allowed: 0 to 4"},
        {{.depth = (enum cupola_depth_format) - 1}, "depth format is -1; allowed: 0 to 4"},
        {{.samples = -2}, "samples is -2; allowed by this GL for views of RGBA8 with depth 32F"},
        {{.samples = 999, .depth = CUPOLA_DEPTH_NONE}, "samples is 999; allowed by this GL"},
    };
    struct fixture fixture;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8, 1);
    int objects = live_objects();
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        cupola_gl *gl = NULL;
        assert_int_equal(cupola_gl_create(fixture.plan, &bad[i].params, &gl, &error),
                         CUPOLA_ERROR_ARGUMENT);
        assert_int_equal(cupola_gl_create(fixture.plan, &bad[i].params, &gl, NULL),
                         CUPOLA_ERROR_ARGUMENT);
        if (!strstr(error.message, bad[i].message))
            fail_msg("'%s' instead of '%s'", error.message, bad[i].message);
        assert_null(gl);
        assert_int_equal(live_objects(), objects);
    }
    fixture_release(&fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* A GL that has no memory for a renderbuffer: the functions that libepoxy found, replaced. */
static int storages_until_failure;
static bool out_of_memory;

static void fail_storage(GLenum target, GLenum format, GLsizei width, GLsizei height);
static void fail_samples(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                         GLsizei height);
static GLenum told_error(void);

static PFNGLRENDERBUFFERSTORAGEPROC real_storage;
static PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC real_samples;
static PFNGLGETERRORPROC real_error;

static void fail_storage(GLenum target, GLenum format, GLsizei width, GLsizei height)
{
    if (storages_until_failure-- > 0)
        real_storage(target, format, width, height);
    else
        out_of_memory = true;
}

static void fail_samples(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                         GLsizei height)
{
    if (storages_until_failure-- > 0)
        real_samples(target, samples, format, width, height);
    else
        out_of_memory = true;
}

static GLenum told_error(void)
{
    GLenum error = out_of_memory ? GL_OUT_OF_MEMORY : real_error();
    out_of_memory = false;
    return error;
}

static void replace_functions(void)
{
    real_storage = epoxy_glRenderbufferStorage;
    real_samples = epoxy_glRenderbufferStorageMultisample;
    real_error = epoxy_glGetError;
    epoxy_glRenderbufferStorage = fail_storage;
    epoxy_glRenderbufferStorageMultisample = fail_samples;
    epoxy_glGetError = told_error;
}

static void restore_functions(void)
{
    epoxy_glRenderbufferStorage = real_storage;
    epoxy_glRenderbufferStorageMultisample = real_samples;
    epoxy_glGetError = real_error;
}

static void no_memory_for_a_buffer_leaves_nothing_behind(void **state)
{
    struct fixture fixture;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8,
         1); /* both ways, so that libepoxy has found the functions */
    fixture_replace_gl(&fixture, &(struct cupola_gl_params){.samples = 2});
    int objects = live_objects();
    for (int samples = 1; samples <= 2; samples++) {
        for (int storages = 0; storages < samples; storages++) {
            const struct cupola_gl_params params = {.samples = samples};
            struct cupola_error error = {CUPOLA_OK, ""};
            cupola_gl *gl = NULL;
            storages_until_failure = storages;
            replace_functions();
            int status = cupola_gl_create(fixture.plan, &params, &gl, &error);
            restore_functions();
            assert_int_equal(status, CUPOLA_ERROR_MEMORY);
            assert_non_null(strstr(error.message, "buffer of"));
            assert_null(gl);
            assert_int_equal(live_objects(), objects);
        }
    }
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_format_warps_as_the_reference_has_it),
        cmocka_unit_test(a_format_that_is_mistaken_for_another_is_caught),
        cmocka_unit_test(views_are_cleared_in_linear_light),
        cmocka_unit_test(what_is_no_format_is_refused_and_makes_nothing),
        cmocka_unit_test(no_memory_for_a_buffer_leaves_nothing_behind),
    };
    return run_gpu_group("view_formats", tests);
}
