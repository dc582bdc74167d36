/* Overlays: order, alpha and gain, what they leave alone, and what is refused. */
#include <math.h>

#include "overlay_canvas.h"

enum { SIDE = 96 };

static const float ground[4] = {0.2f, 0.4f, 0.6f, 0.5f};
static const float white[4] = {1.0f, 1.0f, 1.0f, 1.0f};

/* Rounding to bytes, twice. */
static const double bar = 1.5 / 255.0;

/* A disc of 20 degrees straight ahead, in the middle of the image. */
static struct cupola_overlay disc_of(const float color[4])
{
    return (struct cupola_overlay){.kind = CUPOLA_OVERLAY_DISC,
                                   .direction = {0.0, 0.0, -2.0},
                                   .width_rad = radians(20.0),
                                   .color = color};
}

static void make_plain(enum cupola_encoding encoding, struct fixture *fixture)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, SIDE);
    make_for_overlays(&rig, encoding, fixture);
}

static const float *pixel_at(const float *image, int x, int y)
{
    return image + 4 * (y * SIDE + x);
}

static void check_color(const float *pixel, double red, double green, double blue, double alpha)
{
    const double wish[4] = {red, green, blue, alpha};
    for (int c = 0; c < 4; c++)
        check_near(pixel[c], wish[c], bar);
}

static void the_last_one_lies_on_top(void **state)
{
    (void)state;
    struct fixture fixture;
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, 0);
    static const float red[4] = {1.0f, 0.0f, 0.0f, 1.0f}, blue[4] = {0.0f, 0.0f, 1.0f, 0.25f};
    const struct cupola_overlay both[2] = {disc_of(red), disc_of(blue)};
    canvas_fill(&canvas, ground);
    canvas_lay(&fixture, &canvas, both, 2);
    float *image = canvas_read(&canvas);
    check_color(pixel_at(image, SIDE / 2, SIDE / 2), 0.75, 0.0, 0.25, 1.0);
    free(image);
    canvas_fill(&canvas, ground); /* alpha of the target is mixed like the colours */
    canvas_lay(&fixture, &canvas, both + 1, 1);
    image = canvas_read(&canvas);
    check_color(pixel_at(image, SIDE / 2, SIDE / 2), 0.15, 0.3, 0.7, 0.625);
    free(image);
    canvas_fill(&canvas, ground); /* no colour is opaque white */
    const struct cupola_overlay plain = disc_of(NULL);
    canvas_lay(&fixture, &canvas, &plain, 1);
    image = canvas_read(&canvas);
    check_color(pixel_at(image, SIDE / 2, SIDE / 2), 1.0, 1.0, 1.0, 1.0);
    free(image);
    canvas_release(&canvas);
    fixture_release(&fixture);
}

/* Down to nothing at all: black without alpha is no colour that was left out. */
static void a_shadow_fades_out(void **state)
{
    (void)state;
    float color[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    struct fixture fixture;
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, 0);
    const struct cupola_overlay shadow = disc_of(color);
    for (int i = 4; i >= 0; i--) {
        color[3] = 0.1f * (float)i;
        double left = 1.0 - (double)color[3];
        canvas_fill(&canvas, ground);
        canvas_lay(&fixture, &canvas, &shadow, 1);
        float *image = canvas_read(&canvas);
        check_color(pixel_at(image, SIDE / 2, SIDE / 2), 0.2 * left, 0.4 * left, 0.6 * left,
                    0.5 * left + (double)color[3]);
        free(image);
    }
    canvas_release(&canvas);
    fixture_release(&fixture);
}

/* One of the largest there are, whose rim is beyond the lens. */
static void what_it_does_not_cover_keeps_its_bits(void **state)
{
    (void)state;
    struct fixture fixture;
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, 0);
    struct cupola_overlay large = disc_of(white);
    large.width_rad = radians(149.0);
    large.direction[0] = 2.0;
    canvas_fill(&canvas, ground);
    float *before = canvas_read(&canvas);
    canvas_lay(&fixture, &canvas, &large, 1);
    float *after = canvas_read(&canvas);
    float *whole = texture_read(canvas.texture, SIDE + CORNER_X + REST, SIDE + CORNER_Y + REST);
    int changed = 0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            bool beyond = hypot(i + 0.5 - 0.5 * SIDE, j + 0.5 - 0.5 * SIDE) > 0.5 * SIDE + 0.8;
            bool same = memcmp(pixel_at(before, i, j), pixel_at(after, i, j), 16) == 0;
            assert_true(same || !beyond);
            changed += !same;
        }
    check_at_least(changed, SIDE * SIDE / 4);
    for (int j = 0; j < SIDE + CORNER_Y + REST; j++)
        for (int i = 0; i < SIDE + CORNER_X + REST; i++) {
            int x = i - CORNER_X, y = j - CORNER_Y;
            if (x < 0 || y < 0 || x >= SIDE || y >= SIDE)
                check_near(whole[4 * (j * (SIDE + CORNER_X + REST) + i)], before[0], 0.0);
        }
    free(whole);
    free(after);
    free(before);
    canvas_release(&canvas);
    fixture_release(&fixture);
}

/* What is attached beside the target is not blended into, whatever mask the host has for it. */
static void further_draw_buffers_keep_what_they_have(void **state)
{
    (void)state;
    static const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    struct fixture fixture;
    if (!context_has(33, NULL, 32, "GL_OES_draw_buffers_indexed"))
        skip();
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, GL_RGBA8),
                  beside = canvas_make(&fixture, GL_RGBA8);
    const struct cupola_overlay disc = disc_of(white);
    canvas_fill(&canvas, ground);
    canvas_fill(&beside, ground);
    float *before = canvas_read(&beside);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, beside.texture, 0);
    glDrawBuffers(2, both);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    canvas_lay(&fixture, &canvas, &disc, 1);
    float *after = canvas_read(&beside), *image = canvas_read(&canvas);
    assert_memory_equal(after, before, sizeof *after * canvas_values(&beside));
    check_color(pixel_at(image, SIDE / 2, SIDE / 2), 1.0, 1.0, 1.0, 1.0); /* it has been drawn */
    free(image);
    free(after);
    free(before);
    canvas_release(&beside);
    canvas_release(&canvas);
    fixture_release(&fixture);
}

/* Each pixel's gain is its own: the left half is dark. */
static void gain_holds_for_overlays(void **state)
{
    (void)state;
    struct fixture fixture;
    GLuint gain = 0;
    unsigned char *bytes = malloc(4 * SIDE * SIDE);
    assert_non_null(bytes);
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, 0);
    static const float brown[4] = {0.8f, 0.4f, 0.2f, 0.5f};
    const struct cupola_overlay disc = disc_of(brown);
    for (int i = 0; i < 4 * SIDE * SIDE; i++)
        bytes[i] = i / 4 % SIDE < SIDE / 2 ? 51 : 255;
    glGenTextures(1, &gain);
    glBindTexture(GL_TEXTURE_2D, gain);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glBindTexture(GL_TEXTURE_2D, 0);
    assert_int_equal(cupola_gl_set_gain(fixture.gl, 0, gain, NULL), CUPOLA_OK);
    for (int gained = 1; gained >= 0; gained--) {
        double dark = gained ? 0.2 : 1.0;
        canvas_fill(&canvas, (const float[4]){0.0f, 0.0f, 0.0f, 0.0f});
        canvas_lay(&fixture, &canvas, &disc, 1);
        float *image = canvas_read(&canvas);
        check_color(pixel_at(image, SIDE / 2 - 2, SIDE / 2), 0.4 * dark, 0.2 * dark, 0.1 * dark,
                    0.5);
        check_color(pixel_at(image, SIDE / 2 + 2, SIDE / 2), 0.4, 0.2, 0.1, 0.5);
        free(image);
        assert_int_equal(cupola_gl_set_gain(fixture.gl, 0, 0, NULL), CUPOLA_OK);
    }
    glDeleteTextures(1, &gain);
    free(bytes);
    canvas_release(&canvas);
    fixture_release(&fixture);
}

/* With one that is right in front of it, which must not be drawn. */
static void check_refused(const struct fixture *fixture, const struct canvas *canvas,
                          const struct cupola_overlay *bad, const char *word)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    const struct cupola_overlay both[2] = {disc_of(white), *bad};
    canvas_fill(canvas, ground);
    float *before = canvas_read(canvas);
    assert_int_equal(cupola_gl_overlay(fixture->gl, 0, both, 2, &canvas->target, &error),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
    if (!strstr(error.message, word) || strncmp(error.message, "overlay 1: ", 11) != 0 ||
        !strstr(error.message, "allowed"))
        fail_msg("'%s' does not say '%s'", error.message, word);
    float *after = canvas_read(canvas);
    assert_memory_equal(after, before, sizeof *after * canvas_values(canvas));
    free(after);
    free(before);
}

#define REFUSE(word, ...)                                                                          \
    do {                                                                                           \
        float color[4] = {1.0f, 1.0f, 1.0f, 1.0f};                                                 \
        struct cupola_overlay bad = disc_of(color);                                                \
        __VA_ARGS__;                                                                               \
        check_refused(&fixture, &canvas, &bad, word);                                              \
    } while (0)

static void fields_outside_of_their_range_are_refused(void **state)
{
    (void)state;
    struct fixture fixture;
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, 0);
    GLuint cube = 0;
    glGenTextures(1, &cube);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube);
    REFUSE("kind is 3", bad.kind = (enum cupola_overlay_kind)3);
    REFUSE("direction is (0, 0, 0)", bad.direction[2] = 0.0);
    REFUSE("direction is (0, nan, -2)", bad.direction[1] = (double)NAN);
    REFUSE("direction is (inf", bad.direction[0] = (double)INFINITY);
    REFUSE("width is 0 rad", bad.width_rad = 0.0);
    REFUSE("width is nan", bad.width_rad = (double)NAN);
    REFUSE("width is 2.7 rad", bad.width_rad = 2.7);
    REFUSE("height is -1 rad", bad.height_rad = -1.0);
    REFUSE("height is 2.7 rad", bad.height_rad = 2.7);
    REFUSE("roll is 7 rad", bad.roll_rad = 7.0);
    REFUSE("roll is nan", bad.roll_rad = (double)NAN);
    REFUSE("color[1] is nan", color[1] = NAN);
    REFUSE("color[2] is -1", color[2] = -1.0f);
    REFUSE("color[3] is 1.5", color[3] = 1.5f);
    REFUSE("texture is 0", bad.kind = CUPOLA_OVERLAY_PICTURE);
    REFUSE("texture is 4711", bad.kind = CUPOLA_OVERLAY_PICTURE; bad.texture = 4711);
    REFUSE("GL_TEXTURE_2D", bad.kind = CUPOLA_OVERLAY_PICTURE; bad.texture = cube);
    glDeleteTextures(1, &cube);
    canvas_release(&canvas);
    fixture_release(&fixture);
}

static void check_call(int status, int expected, const struct cupola_error *error, const char *word)
{
    assert_int_equal(status, expected);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    if (!strstr(error->message, word))
        fail_msg("'%s' does not say '%s'", error->message, word);
}

static void calls_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    struct fixture fixture;
    struct cupola_error error = {CUPOLA_OK, ""};
    const struct cupola_gl_params without = {.sources = 1u << CUPOLA_SOURCE_DOMEMASTER};
    make_plain(CUPOLA_ENCODING_LINEAR, &fixture);
    struct canvas canvas = canvas_make(&fixture, GL_RGBA8);
    struct cupola_overlay disc = disc_of(white), picture = disc;
    struct cupola_target none = {.framebuffer = 54321};
    picture.kind = CUPOLA_OVERLAY_PICTURE;
    picture.texture = canvas.texture;
    check_call(cupola_gl_overlay(NULL, 0, &disc, 1, &canvas.target, &error), CUPOLA_ERROR_ARGUMENT,
               &error, "gl is NULL");
    check_call(cupola_gl_overlay(fixture.gl, 1, &disc, 1, &canvas.target, &error),
               CUPOLA_ERROR_ARGUMENT, &error, "output is 1");
    check_call(cupola_gl_overlay(fixture.gl, 0, NULL, 1, &canvas.target, &error),
               CUPOLA_ERROR_ARGUMENT, &error, "overlays is NULL");
    check_call(cupola_gl_overlay(fixture.gl, 0, &disc, -1, &canvas.target, &error),
               CUPOLA_ERROR_ARGUMENT, &error, "is -1");
    check_call(cupola_gl_overlay(fixture.gl, 0, &picture, 1, &canvas.target, &error),
               CUPOLA_ERROR_ARGUMENT, &error, "color attachment 0");
    check_call(cupola_gl_overlay(fixture.gl, 0, &disc, 1, &none, &error), CUPOLA_ERROR_GL, &error,
               "54321");
    assert_int_equal(cupola_gl_overlay(fixture.gl, 0, NULL, 0, &canvas.target, NULL), CUPOLA_OK);
    fixture_replace_gl(&fixture, &without);
    check_call(cupola_gl_overlay(fixture.gl, 0, &disc, 1, &canvas.target, &error),
               CUPOLA_ERROR_ARGUMENT, &error, "without overlays");
    canvas_release(&canvas);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_last_one_lies_on_top),
        cmocka_unit_test(a_shadow_fades_out),
        cmocka_unit_test(what_it_does_not_cover_keeps_its_bits),
        cmocka_unit_test(further_draw_buffers_keep_what_they_have),
        cmocka_unit_test(gain_holds_for_overlays),
        cmocka_unit_test(fields_outside_of_their_range_are_refused),
        cmocka_unit_test(calls_that_make_no_sense_are_refused),
    };
    return run_gpu_group("overlay_manners", tests);
}
