/*
 * Views of sRGB and of half floats with every filter: what is mixed is light, not codes. The views
 * are texels in black and white by turns, whose mean is half of the light.
 */
#include <stdio.h>
#include <stdlib.h>

#include "filter_cases.h"
#include "group.h"
#include "rig_random.h"
#include "srgb.h"

enum { SIDE = 96 };

/* Both formats take whole numbers exactly. */
static void fill_checker(const struct fixture *fixture, enum cupola_format format)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    int width = report->atlas_width_px, height = report->atlas_height_px;
    bool bytes = format == CUPOLA_FORMAT_SRGB8;
    size_t size = 4 * (size_t)width * (size_t)height;
    float *floats = malloc(size * sizeof *floats);
    unsigned char *codes = malloc(size);
    assert_non_null(floats);
    assert_non_null(codes);
    for (int i = 0; i < 4 * width * height; i++) {
        bool white = (i / 4 % width + i / 4 / width) % 2;
        floats[i] = white ? 1.0f : 0.0f;
        codes[i] = white ? 255 : 0;
    }
    glBindTexture(GL_TEXTURE_2D, cupola_gl_atlas(fixture->gl));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA,
                    bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, bytes ? (void *)codes : (void *)floats);
    glBindTexture(GL_TEXTURE_2D, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    free(floats);
    free(codes);
}

/* Freed by the caller. */
static float *image_of(struct fixture *fixture, enum cupola_format format, int number,
                       enum cupola_encoding encoding)
{
    struct cupola_gl_params params = {.format = format,
                                      .filter = filters[number],
                                      .table = filter_stages[number % 2],
                                      .encoding = encoding};
    fixture_replace_gl(fixture, &params);
    fill_checker(fixture, format);
    return fixture_warp(fixture, 0);
}

/*
 * Of what was encoded and the reference's light once that is, too. `early`: as if codes had been
 * mixed, which in black and white are the light's numbers.
 */
static int pixels_unlike(const struct fixture *fixture, int number, const float *encoded,
                         bool early)
{
    static float expected[4 * SIDE * SIDE];
    float *atlas = fixture_atlas(fixture);
    int unlike = 0;
    assert_int_equal(
        cupola_reference_filter(fixture->plan, 0, &filters[number], atlas, NULL, expected),
        CUPOLA_OK);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double light = (double)expected[4 * i + 1];
        double wish = early ? light : light_encoded(light);
        unlike += !(fabs((double)encoded[4 * i + 1] - wish) <= 0.02);
    }
    free(atlas);
    return unlike;
}

/* Over all pixels that are lit in full. */
static double mean_of(const struct fixture *fixture, const float *image)
{
    double sum = 0.0;
    int pixels = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct cupola_ray ray;
        cupola_dome_ray(fixture->dome, 0, NULL, i % SIDE + 0.5, i / SIDE + 0.5, &ray);
        if (ray.coverage < 1.0)
            continue;
        sum += (double)image[4 * i + 1];
        pixels++;
    }
    return sum / pixels;
}

/* Decodes in place what was encoded. */
static void decode(float *image)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        image[4 * i + 1] = (float)light_decoded((double)image[4 * i + 1]);
}

/*
 * As in filter_reference.c some pixels may be on the other side of a step, and where it is all but
 * dark the curve is steep: 12.92 times what weights of 8 bits err by.
 */
static const int tolerated = 10 + SIDE * SIDE / 100;

static void check_filter(struct fixture *fixture, enum cupola_format format, int number)
{
    const struct cupola_filter *filter = &filters[number];
    float *image = image_of(fixture, format, number, CUPOLA_ENCODING_SRGB);
    check_at_most(pixels_unlike(fixture, number, image, false), tolerated);
    /* Of nearest texels, black and white, codes are light. */
    if (filter->method != CUPOLA_ANTIALIASING_NONE)
        check_at_least(pixels_unlike(fixture, number, image, true), SIDE * SIDE / 4);
    double codes = mean_of(fixture, image);
    decode(image);
    double mean = mean_of(fixture, image), code = 255.0 * light_encoded(mean);
    printf("%s: the mean is %.1f, in light; of codes %.1f\n", filter_text(filter), code,
           255.0 * codes);
    check_near(mean, 0.5, 0.01);
    check_near(code, 188.0, 1.5);
    /* The middle of a cross of nine texels is half, wherever it is. */
    if (filter->samples == 9)
        check_near(255.0 * codes, 188.0, 1.5);
    free(image);
}

static void light_is_mixed_and_not_codes(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIDE);
    struct fixture fixture;
    rig.eye_m[1] = 0.2;
    rig.screen.radius_m = 1.0;
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int i = 0; i < FILTERS; i++)
        check_filter(&fixture, CUPOLA_FORMAT_SRGB8, i);
    for (int i = 1; i < FILTERS && context_has_floats(); i += 2)
        check_filter(&fixture, CUPOLA_FORMAT_RGBA16F, i);
    fixture_release(&fixture);
}

/* Texels that are no light: the mean of codes, and what it would be taken for. */
static void a_mean_of_codes_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIDE);
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int i = 0; i < FILTERS; i += 3) {
        float *image = image_of(&fixture, CUPOLA_FORMAT_SRGB8, i, CUPOLA_ENCODING_LINEAR);
        check_near(mean_of(&fixture, image), 0.5, 0.01);
        check_at_least(pixels_unlike(&fixture, i, image, false), SIDE * SIDE / 4);
        decode(image); /* as if those were the codes */
        check_at_most(255.0 * light_encoded(mean_of(&fixture, image)), 180.0);
        free(image);
    }
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_is_mixed_and_not_codes),
        cmocka_unit_test(a_mean_of_codes_is_caught),
    };
    return run_gpu_group("filter_light", tests);
}
