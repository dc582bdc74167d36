/*
 * What each pixel of an output is multiplied by: whatever is shown, in linear light and before the
 * encoding; against the warp in C, multiplied here.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "group.h"
#include "light_fixture.h"
#include "rig_random.h"

enum { PIXELS = LIGHT_WIDTH * LIGHT_HEIGHT };

static const double bar_float = 1e-5, bar_bytes = 0.55 / 255.0;

/* Ramps from 0 to 2, as half floats hold them; black columns. Alpha, which must not count, is 9. */
static void ramp(float gain[4 * PIXELS])
{
    for (int k = 0; k < PIXELS; k++) {
        int x = k % LIGHT_WIDTH, y = k / LIGHT_WIDTH;
        gain[4 * k] = x % 16 == 5 ? 0.0f : (float)(2 * x) / 128.0f;
        gain[4 * k + 1] = (float)(2 * y) / 128.0f;
        gain[4 * k + 2] = (float)(x % 3) / 2.0f;
        gain[4 * k + 3] = 9.0f;
    }
}

static GLuint gain_texture(GLint format, int width, int height, const float *gain)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA,
                 format == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT, gain);
    glBindTexture(GL_TEXTURE_2D, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return texture;
}

static GLuint ramp_texture(void)
{
    static float gain[4 * PIXELS];
    ramp(gain);
    return gain_texture(GL_RGBA32F, LIGHT_WIDTH, LIGHT_HEIGHT, gain);
}

static void set_gain(const struct light_theatre *theatre, GLuint texture)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_gl_set_gain(theatre->fixture.gl, 0, texture, &error) < 0)
        fail_msg("%s", error.message);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* In the numbers of a target, which may hold no more than 1. */
static float *expected_of(const struct light_theatre *theatre, bool encoded, bool floats)
{
    static float gain[4 * PIXELS];
    float *image = light_expected(theatre);
    ramp(gain);
    for (int i = 0; i < 4 * PIXELS; i++)
        image[i] *= i % 4 == 3 ? 1.0f : gain[i];
    if (encoded)
        light_encode(image, PIXELS);
    for (int i = 0; i < 4 * PIXELS && !floats; i++)
        image[i] = image[i] > 1.0f ? 1.0f : image[i];
    return image;
}

static void check_gain(enum light_kind kind, enum cupola_encoding encoding, GLenum format)
{
    const struct cupola_gl_params params = {.encoding = encoding};
    struct light_theatre theatre;
    bool floats = format != GL_RGBA8;
    double bar = floats ? bar_float : bar_bytes;
    GLuint texture = ramp_texture();
    light_make(kind, &params, &theatre);
    float *before = light_shown(&theatre, format, NULL);
    set_gain(&theatre, texture);
    float *with = light_shown(&theatre, format, NULL);
    set_gain(&theatre, 0);
    float *after = light_shown(&theatre, format, NULL);
    float *expected = expected_of(&theatre, encoding == CUPOLA_ENCODING_SRGB, floats);
    assert_true(before && with && after);
    double error = light_difference(with, expected);
    printf("%s, encoding %d, 0x%x: within %.2g\n", light_name(kind), (int)encoding, format, error);
    check_at_most(error, bar);
    memmove(expected, expected + 4, (4 * PIXELS - 4) * sizeof *expected);
    check_at_least(light_difference(with, expected), 10.0 * bar); /* a pixel beside */
    check_at_least(light_difference(before, with), 0.1);
    assert_memory_equal(before, after, 4 * PIXELS * sizeof *before);
    light_release(&theatre);
    glDeleteTextures(1, &texture);
    free(before);
    free(with);
    free(after);
    free(expected);
}

static void all_that_is_shown_is_multiplied(void **state)
{
    (void)state;
    for (int kind = 0; kind < LIGHT_KINDS; kind++)
        for (int encoding = 0; encoding < 2; encoding++) {
            bool floats = light_float_format() && encoding == kind % 2;
            if (light_exists((enum light_kind)kind))
                check_gain((enum light_kind)kind, (enum cupola_encoding)encoding,
                           floats ? light_float_format() : GL_RGBA8);
        }
}

/* Each has its own, of its own size. */
static void outputs_do_not_share_it(void **state)
{
    (void)state;
    enum { SIDE = 32 };
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIDE);
    const struct cupola_gl_params params = {.border = {0.2f, 0.4f, 0.6f, 0.8f}};
    const float half[4] = {0.5f, 0.5f, 0.5f, 1.0f}, black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    static float gain[4 * SIDE * SIDE];
    struct fixture fixture;
    float *images[2];
    rig.output_count = 2;
    rig.outputs[1] = rig.outputs[0];
    rig.outputs[1].height_px = SIDE / 2;
    fixture_make(&rig, NULL, &params, &fixture);
    for (int k = 0; k < 4 * SIDE * SIDE; k++)
        gain[k] = half[k % 4];
    GLuint texture = gain_texture(GL_RGBA32F, SIDE, SIDE / 2, gain);
    assert_int_equal(cupola_gl_set_gain(fixture.gl, 1, texture, NULL), CUPOLA_OK);
    for (int i = 0; i < 2; i++)
        images[i] = fixture_warp(&fixture, i);
    for (int c = 0; c < 4; c++) { /* the corner: border alone */
        check_near(images[0][c], params.border[c], 0.003);
        check_near(images[1][c], params.border[c] * half[c], 0.003);
    }
    free(images[1]);
    for (int k = 0; k < 4 * SIDE * SIDE; k++)
        gain[k] = black[k % 4];
    glBindTexture(GL_TEXTURE_2D, texture); /* what it holds may change from frame to frame */
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SIDE, SIDE / 2, GL_RGBA, GL_FLOAT, gain);
    glBindTexture(GL_TEXTURE_2D, 0);
    images[1] = fixture_warp(&fixture, 1);
    check_near(images[1][0], 0.0, 0.0);
    check_near(images[1][3], params.border[3], 0.003);
    free(images[0]);
    free(images[1]);
    glDeleteTextures(1, &texture);
    fixture_release(&fixture);
}

static void expect(cupola_gl *gl, int output, GLuint texture, const char *word)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_gl_set_gain(gl, output, texture, &error), CUPOLA_ERROR_ARGUMENT);
    if (!strstr(error.message, word))
        fail_msg("'%s' does not say '%s'", error.message, word);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void what_is_no_gain_is_refused(void **state)
{
    (void)state;
    struct light_theatre theatre;
    GLuint array = 0, texture = ramp_texture();
    GLuint small = gain_texture(GL_RGBA8, LIGHT_WIDTH, LIGHT_HEIGHT - 1, NULL);
    bool sizes_known = context_has(33, NULL, 31, NULL);
    light_make(LIGHT_TEXTURES, NULL, &theatre);
    glGenTextures(1, &array);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, LIGHT_WIDTH, LIGHT_HEIGHT, 1, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, NULL);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    set_gain(&theatre, texture);
    float *before = light_shown(&theatre, GL_RGBA8, NULL);
    expect(NULL, 0, texture, "gl is NULL");
    expect(theatre.fixture.gl, 1, texture, "output is 1; allowed: 0 to 0");
    expect(theatre.fixture.gl, -1, 0, "output is -1");
    expect(theatre.fixture.gl, 0, 4711, "gain of output 0 is texture 4711; allowed: ");
    expect(theatre.fixture.gl, 0, array, "allowed: the name of a GL_TEXTURE_2D");
    if (sizes_known)
        expect(theatre.fixture.gl, 0, small, "of 96 x 79 texels; allowed: 96 x 80");
    float *after = light_shown(&theatre, GL_RGBA8, NULL);
    assert_memory_equal(before, after, 4 * PIXELS * sizeof *before);
    glDeleteTextures(1, &array);
    glDeleteTextures(1, &small);
    glDeleteTextures(1, &texture);
    free(before);
    free(after);
    light_release(&theatre);
}

static void a_gain_that_is_deleted_or_drawn_into_is_refused(void **state)
{
    (void)state;
    struct light_theatre theatre;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_target target = {0, 0, 0};
    GLuint texture = gain_texture(GL_RGBA8, LIGHT_WIDTH, LIGHT_HEIGHT, NULL);
    light_make(LIGHT_DOMEMASTER, NULL, &theatre);
    set_gain(&theatre, texture);
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    assert_int_equal(cupola_gl_warp(theatre.fixture.gl, 0, &theatre.source, &target, &error),
                     CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "which is sampled, as its color attachment 0"));
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &texture);
    assert_null(light_shown(&theatre, GL_RGBA8, &error));
    assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "gain of output 0 is texture "));
    set_gain(&theatre, 0);
    float *shown = light_shown(&theatre, GL_RGBA8, &error);
    assert_non_null(shown);
    free(shown);
    light_release(&theatre);
}

static void a_gain_waits_for_the_end_of_a_view(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 16);
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    assert_true(cupola_gl_frame_begin(fixture.gl, NULL, NULL) > 0);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_gain(fixture.gl, 0, 0, NULL), CUPOLA_ERROR_ORDER);
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_gain(fixture.gl, 0, 0, NULL), CUPOLA_OK);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_that_is_shown_is_multiplied),
        cmocka_unit_test(outputs_do_not_share_it),
        cmocka_unit_test(what_is_no_gain_is_refused),
        cmocka_unit_test(a_gain_that_is_deleted_or_drawn_into_is_refused),
        cmocka_unit_test(a_gain_waits_for_the_end_of_a_view),
    };
    return run_gpu_group("gain", tests);
}
