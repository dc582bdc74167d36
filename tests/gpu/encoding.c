/*
 * The target's encoding: whatever is shown, the warp computes in linear light and encodes last.
 * Against the warp in C and the formulas of IEC 61966-2-1, into floats and into 8 bits.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "group.h"
#include "light_fixture.h"
#include "painted.h"
#include "rig_random.h"

enum { PIXELS = LIGHT_WIDTH * LIGHT_HEIGHT };

/* Rounding of floats, and of 8 bits by half a step; by a whole where the GL itself encodes. */
static const double bar_float = 1e-5, bar_bytes = 0.55 / 255.0, bar_always = 1.05 / 255.0;

static float *shown(enum light_kind kind, enum cupola_encoding encoding, GLenum format,
                    struct cupola_error *error)
{
    const struct cupola_gl_params params = {.encoding = encoding};
    struct light_theatre theatre;
    light_make(kind, &params, &theatre);
    float *image = light_shown(&theatre, format, error);
    light_release(&theatre);
    return image;
}

static float *expected_of(enum light_kind kind)
{
    struct light_theatre theatre;
    light_make(kind, NULL, &theatre);
    float *image = light_expected(&theatre);
    light_release(&theatre);
    return image;
}

static void check_format(enum light_kind kind, GLenum format, double bar)
{
    float *linear = shown(kind, CUPOLA_ENCODING_LINEAR, format, NULL);
    float *encoded = shown(kind, CUPOLA_ENCODING_SRGB, format, NULL);
    float *expected = expected_of(kind);
    assert_non_null(linear);
    assert_non_null(encoded);
    double off_linear = light_difference(linear, expected);
    light_encode(expected, PIXELS);
    double off_encoded = light_difference(encoded, expected);
    printf("%s, 0x%x: linear within %.2g, encoded within %.2g\n", light_name(kind), format,
           off_linear, off_encoded);
    check_at_most(off_linear, bar);
    check_at_most(off_encoded, bar);
    check_at_least(light_difference(encoded, linear), 0.2);
    free(linear);
    free(encoded);
    free(expected);
}

static void what_is_shown_is_encoded_last(void **state)
{
    (void)state;
    for (int kind = 0; kind < LIGHT_KINDS; kind++) {
        if (!light_exists((enum light_kind)kind))
            continue;
        check_format((enum light_kind)kind, GL_RGBA8, bar_bytes);
        if (light_float_format())
            check_format((enum light_kind)kind, light_float_format(), bar_float);
    }
}

/* A power of 2.2, and an encoding before the border is mixed in. */
static void another_curve_or_order_is_caught(void **state)
{
    (void)state;
    float *encoded = shown(LIGHT_TEXTURES, CUPOLA_ENCODING_SRGB, GL_RGBA8, NULL);
    float *power = expected_of(LIGHT_TEXTURES);
    struct light_theatre theatre;
    light_make(LIGHT_TEXTURES, NULL, &theatre);
    const struct cupola_plan_report *report = cupola_plan_report(theatre.fixture.plan);
    light_encode(theatre.texels, report->atlas_width_px * report->atlas_height_px);
    float *early = malloc(4 * sizeof *early * PIXELS);
    float border[4];
    assert_non_null(early);
    memcpy(border, light_border, sizeof border);
    light_encode(border, 1);
    cupola_reference_warp(theatre.fixture.plan, 0, theatre.texels, border, early);
    for (int i = 0; i < 4 * PIXELS; i++)
        if (i % 4 != 3)
            power[i] = (float)pow((double)power[i], 1.0 / 2.2);
    printf("2.2: %.3g, early: %.3g\n", light_difference(encoded, power),
           light_difference(encoded, early));
    check_at_least(light_difference(encoded, power), 2.0 * bar_bytes);
    check_at_least(light_difference(encoded, early), 2.0 * bar_bytes);
    light_release(&theatre);
    free(encoded);
    free(power);
    free(early);
}

static bool gl_always_encodes(void)
{
    return !context_has(33, NULL, 1000, "GL_EXT_sRGB_write_control");
}

/* Where the GL encodes by itself, Cupola does not, and linear light cannot be had. */
static void the_target_s_format_does_not_matter(void **state)
{
    (void)state;
    bool always = gl_always_encodes();
    for (int kind = 0; kind < LIGHT_KINDS; kind++) {
        enum light_kind k = (enum light_kind)kind;
        struct cupola_error error = {CUPOLA_OK, ""};
        if (!light_exists(k))
            continue;
        float *plain = shown(k, CUPOLA_ENCODING_SRGB, GL_RGBA8, &error);
        float *srgb = shown(k, CUPOLA_ENCODING_SRGB, GL_SRGB8_ALPHA8, &error);
        assert_non_null(plain);
        assert_non_null(srgb);
        check_at_most(light_difference(plain, srgb), always ? bar_always : 0.0);
        free(plain);
        free(srgb);
        plain = shown(k, CUPOLA_ENCODING_LINEAR, GL_RGBA8, &error);
        srgb = shown(k, CUPOLA_ENCODING_LINEAR, GL_SRGB8_ALPHA8, &error);
        if (always) {
            assert_null(srgb);
            assert_int_equal(error.status, CUPOLA_ERROR_GL);
            assert_non_null(strstr(error.message, "allowed: another format, or the encoding sRGB"));
        } else {
            check_at_most(light_difference(plain, srgb), 0.0);
        }
        free(plain);
        free(srgb);
    }
}

/* The mean colour of a picture of black and white squares, of 8 bits, in 255 steps. */
static double mean_shown(enum cupola_source_kind kind, GLenum format, enum cupola_encoding encoding)
{
    enum { SIDE = 512, SMALL = 32 };
    static unsigned char squares[SIDE * 2 * SIDE][4];
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, SMALL);
    struct cupola_source source = {.kind = kind, .mipmaps = true};
    struct cupola_gl_params params = {.encoding = encoding, .sources = 1u << (unsigned int)kind};
    int width = painted_width(&source, SIDE);
    GLenum target = kind == CUPOLA_SOURCE_CUBE ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    struct fixture fixture;
    float pixel[4 * SMALL * SMALL];
    GLuint texture = 0;
    struct cupola_target place = {0, 0, 0};
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < width; i++)
            memset(squares[j * width + i], (i + j) % 2 ? 255 : 0, 4);
    fixture_make(&rig, NULL, &params, &fixture);
    glGenTextures(1, &source.texture);
    glBindTexture(target, source.texture);
    for (int face = 0; face < painted_faces(&source); face++)
        glTexImage2D(kind == CUPOLA_SOURCE_CUBE ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face
                                                : target,
                     0, (GLint)format, width, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, squares);
    glGenerateMipmap(target);
    glBindTexture(target, 0);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SMALL, SMALL, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenFramebuffers(1, &place.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, place.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    assert_int_equal(cupola_gl_warp(fixture.gl, 0, &source, &place, NULL), CUPOLA_OK);
    context_read_pixels(SMALL, SMALL, pixel);
    glDeleteFramebuffers(1, &place.framebuffer);
    glDeleteTextures(1, &texture);
    glDeleteTextures(1, &source.texture);
    fixture_release(&fixture);
    return 255.0 * (double)pixel[4 * (SMALL / 2 * SMALL + SMALL / 2) + 1];
}

/* Half of the light is 188 of 255; whoever takes codes for light gets their mean, 128. */
static void squares_are_mixed_in_linear_light(void **state)
{
    (void)state;
    double half = 255.0 * light_encoded(0.5);
    for (int i = CUPOLA_SOURCE_DOMEMASTER; i <= CUPOLA_SOURCE_CUBE; i++) {
        enum cupola_source_kind kind = (enum cupola_source_kind)i;
        double mixed = mean_shown(kind, GL_SRGB8_ALPHA8, CUPOLA_ENCODING_SRGB);
        double codes = mean_shown(kind, GL_RGBA8, CUPOLA_ENCODING_LINEAR);
        printf("%s: %.0f, codes %.0f\n", cupola_source_name(i), mixed, codes);
        check_near(mixed, half, 1.0);
        check_near(mixed, 188.0, 1.0);
        check_near(codes, 127.5, 1.0);
    }
}

static void light_that_is_no_light_is_clamped_below(void **state)
{
    (void)state;
    struct light_theatre theatre;
    const struct cupola_gl_params params = {.encoding = CUPOLA_ENCODING_SRGB};
    if (!light_float_format())
        return;
    light_make(LIGHT_ATLAS, &params, &theatre);
    const struct cupola_plan_report *report = cupola_plan_report(theatre.fixture.plan);
    for (int i = 0; i < 4 * report->atlas_width_px * report->atlas_height_px; i++)
        theatre.texels[i] = 8.0f * theatre.texels[i] - 2.0f;
    glBindTexture(GL_TEXTURE_2D, cupola_gl_atlas(theatre.fixture.gl));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, report->atlas_width_px, report->atlas_height_px,
                    GL_RGBA, GL_FLOAT, theatre.texels);
    glBindTexture(GL_TEXTURE_2D, 0);
    float *image = light_shown(&theatre, light_float_format(), NULL);
    float *expected = light_expected(&theatre), most = 0.0f, least = 1.0f;
    light_encode(expected, PIXELS);
    for (int i = 0; i < 4 * PIXELS; i++) {
        most = i % 4 != 3 && image[i] > most ? image[i] : most;
        least = i % 4 != 3 && image[i] < least ? image[i] : least;
    }
    check_near(least, 0.0, 0.0);
    check_at_least(most, 2.0);
    check_at_most(light_difference(image, expected), 12.0 * bar_float);
    free(image);
    free(expected);
    light_release(&theatre);
}

static void an_encoding_that_is_none_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 16);
    const struct cupola_gl_params params = {.encoding = (enum cupola_encoding)2};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture;
    cupola_gl *none = NULL;
    fixture_make(&rig, NULL, NULL, &fixture);
    assert_int_equal(cupola_gl_create(fixture.plan, &params, &none, &error), CUPOLA_ERROR_ARGUMENT);
    assert_null(none);
    assert_non_null(strstr(error.message, "encoding is 2; allowed: 0 to 1"));
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_shown_is_encoded_last),
        cmocka_unit_test(another_curve_or_order_is_caught),
        cmocka_unit_test(the_target_s_format_does_not_matter),
        cmocka_unit_test(squares_are_mixed_in_linear_light),
        cmocka_unit_test(light_that_is_no_light_is_clamped_below),
        cmocka_unit_test(an_encoding_that_is_none_is_refused),
    };
    return run_gpu_group("encoding", tests);
}
