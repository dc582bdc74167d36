/* Overlays in encoded targets: numbers are mixed in a format of numbers, light in one of light. */
#include "overlay_canvas.h"
#include "srgb.h"

enum { SIDE = 64 };

static const float colour[4] = {0.5f, 0.1f, 1.0f, 0.5f};

static void make_plain(enum cupola_encoding encoding, struct fixture *fixture)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, SIDE);
    make_for_overlays(&rig, encoding, fixture);
}

/* The bytes in the middle of the image as they stand in the target. */
static void read_bytes(const struct canvas *canvas, unsigned char bytes[4])
{
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target.framebuffer);
    glReadPixels(CORNER_X + SIDE / 2, CORNER_Y + SIDE / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* Whether what is put into the target as bytes is read from it as the same: no GL need do so. */
static bool bytes_come_back(const struct canvas *canvas)
{
    static const unsigned char wish[4] = {188, 99, 7, 128};
    unsigned char bytes[4];
    glBindTexture(GL_TEXTURE_2D, canvas->texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, CORNER_X + SIDE / 2, CORNER_Y + SIDE / 2, 1, 1, GL_RGBA,
                    GL_UNSIGNED_BYTE, wish);
    glBindTexture(GL_TEXTURE_2D, 0);
    read_bytes(canvas, bytes);
    return memcmp(bytes, wish, sizeof wish) == 0;
}

static void check_mixed_as(GLenum format, double (*mixed)(double light))
{
    static const float black[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    const struct cupola_overlay disc = {.kind = CUPOLA_OVERLAY_DISC,
                                        .direction = {0.0, 0.0, -1.0},
                                        .width_rad = radians(20.0),
                                        .color = colour};
    unsigned char bytes[4];
    struct fixture fixture;
    make_plain(CUPOLA_ENCODING_SRGB, &fixture);
    struct canvas canvas = canvas_make(&fixture, format);
    bool readable = bytes_come_back(&canvas);
    if (readable) {
        canvas_fill(&canvas, black);
        canvas_lay(&fixture, &canvas, &disc, 1);
        read_bytes(&canvas, bytes);
        for (int c = 0; c < 3; c++)
            check_near(bytes[c], 255.0 * mixed((double)colour[c]), 1.5);
    }
    if (!context_is_es())
        assert_false(glIsEnabled(GL_FRAMEBUFFER_SRGB));
    canvas_release(&canvas);
    fixture_release(&fixture);
    if (!readable)
        skip();
}

static double mixed_as_numbers(double light)
{
    return 0.5 * light_encoded(light);
}

static double mixed_as_light(double light)
{
    return light_encoded(0.5 * light);
}

static void numbers_are_mixed_in_a_format_of_numbers(void **state)
{
    (void)state;
    check_mixed_as(GL_RGBA8, mixed_as_numbers);
    check_at_least(255.0 * (mixed_as_light(0.5) - mixed_as_numbers(0.5)), 20.0); /* they differ */
}

static void light_is_mixed_in_a_format_of_light(void **state)
{
    (void)state;
    check_mixed_as(GL_SRGB8_ALPHA8, mixed_as_light);
}

/* The number of a light beside what the alpha covers, over black. */
static double glow_expected(double light, double alpha)
{
    if (light <= alpha)
        return alpha > 0.0 ? alpha * light_encoded(light / alpha) : 0.0;
    return alpha + (1.0 - alpha / light) * light_encoded(light);
}

/* What shows of a picture of one texel. */
static double glow_shown(const struct fixture *fixture, const struct canvas *canvas, int light,
                         int alpha)
{
    static const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    const float texel[4] = {(float)light / 255.0f, (float)light / 255.0f, (float)light / 255.0f,
                            (float)alpha / 255.0f};
    GLuint texture = overlay_texture(texel, 1, 1);
    const struct cupola_overlay overlay = {
        .direction = {0.0, 0.0, -1.0}, .width_rad = radians(40.0), .texture = texture};
    canvas_fill(canvas, black);
    canvas_lay(fixture, canvas, &overlay, 1);
    float *image = canvas_read(canvas);
    double shown = (double)image[4 * (SIDE / 2 * SIDE + SIDE / 2)];
    free(image);
    glDeleteTextures(1, &texture);
    return shown;
}

/* No alpha, however small, lets it jump: not at 0, not where the alpha covers all of the light. */
static void light_without_alpha_shines(void **state)
{
    enum { LIGHT = 128 };
    static const int alphas[] = {0, 1, 2, 5, 20, 60, 100, 126, 127, 128, 129, 130, 200, 255};
    double before = 0.0;
    struct fixture fixture;
    (void)state;
    make_plain(CUPOLA_ENCODING_SRGB, &fixture);
    struct canvas canvas = canvas_make(&fixture, 0);
    for (int i = 0; i < (int)(sizeof alphas / sizeof *alphas); i++) {
        double shown = glow_shown(&fixture, &canvas, LIGHT, alphas[i]);
        check_near(shown, glow_expected(LIGHT / 255.0, alphas[i] / 255.0), 1.5 / 255.0);
        if (i > 0 && alphas[i] - alphas[i - 1] <= 2)
            check_near(shown, before, 3.5 / 255.0);
        before = shown;
    }
    check_near(glow_shown(&fixture, &canvas, 0, 0), 0.0, 0.0);
    canvas_release(&canvas);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_mixed_in_a_format_of_numbers),
        cmocka_unit_test(light_is_mixed_in_a_format_of_light),
        cmocka_unit_test(light_without_alpha_shines),
    };
    return run_gpu_group("overlay_encoding", tests);
}
