/* The theatre's picture is encoded after the light of all projectors has been added up. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "group.h"
#include "light_fixture.h"
#include "rig_random.h"
#include "state_snapshot.h"
#include "worse.h"

enum { SIDE = 16, PROJECTORS_MAX = 3 };

static const unsigned char codes[PROJECTORS_MAX] = {100, 120, 60};

/* Projectors in one place, each of which lights all that the spectator sees with one grey. */
struct show {
    struct fixture fixture;
    cupola_theatre *theatre;
    struct cupola_spectator spectator;
    GLuint images[PROJECTORS_MAX];
};

static void show_make(int projectors, struct show *show)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, SIDE);
    static unsigned char grey[SIDE * SIDE][4];
    rig.output_count = projectors;
    for (int i = 1; i < projectors; i++)
        rig.outputs[i] = rig.outputs[0];
    fixture_make(&rig, NULL, NULL, &show->fixture);
    assert_int_equal(cupola_theatre_create(show->fixture.dome, &show->theatre, NULL), CUPOLA_OK);
    cupola_spectator_at_eye(show->fixture.dome, &show->spectator);
    glGenTextures(projectors, show->images);
    for (int i = 0; i < projectors; i++) {
        memset(grey, codes[i], sizeof grey);
        glBindTexture(GL_TEXTURE_2D, show->images[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     grey);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

static void show_release(int projectors, struct show *show)
{
    cupola_theatre_destroy(&show->theatre);
    glDeleteTextures(projectors, show->images);
    fixture_release(&show->fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static double light_of(int projectors)
{
    double sum = 0.0;
    for (int i = 0; i < projectors; i++)
        sum += light_decoded(codes[i] / 255.0);
    return sum;
}

/*
 * The largest distance of red, green and blue from a number, over a picture that does not begin at
 * the target's corner; below 0 if it was refused. The host blends, and nothing of it is lost.
 */
static double drawn_error(const struct show *show, GLenum format, int width, int height,
                          double expected, struct cupola_error *error)
{
    struct cupola_target target = {0, 3, 2};
    struct snapshot before, after;
    GLuint color = 0;
    float *pixels = malloc(4 * sizeof *pixels * (size_t)(width + 3) * (size_t)(height + 2));
    double worst = 0.0;
    assert_non_null(pixels);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width + 3, height + 2);
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    snapshot_take(&before);
    int status = cupola_theatre_draw(show->theatre, show->images, &show->spectator, width, height,
                                     &target, error);
    snapshot_take(&after);
    assert_int_equal(snapshot_differences(&before, &after, true, "theatre_draw"), 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    context_read_pixels(width + 3, height + 2, pixels);
    for (int y = 0; y < height + 2; y++)
        for (int x = 0; x < width + 3; x++)
            for (int c = 0; c < 3; c++) {
                double wish = x < 3 || y < 2 ? 0.0 : expected;
                double shown = (double)pixels[4 * (y * (width + 3) + x) + c];
                worst = worse_of(worst, fabs(shown - wish));
            }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteRenderbuffers(1, &color);
    free(pixels);
    return status < 0 ? -1.0 : worst;
}

static bool gl_always_encodes(void)
{
    return !context_has(33, NULL, 1000, "GL_EXT_sRGB_write_control");
}

/*
 * A step: half of it is rounding; llvmpipe decodes sRGB texels within 1e-3. Where the sum itself
 * has 8 bits, half a step more for each projector.
 */
static double bar_of(int projectors)
{
    double steps = context_has_floats() || projectors == 1 ? 1.0 : 1.0 + 0.5 * projectors;
    return steps / 255.0;
}

static void light_is_added_up_before_it_is_encoded(void **state)
{
    (void)state;
    for (int projectors = 1; projectors <= PROJECTORS_MAX; projectors++) {
        struct show show;
        double light = light_of(projectors), code = light_encoded(light), sum_of_codes = 0.0;
        show_make(projectors, &show);
        show.spectator.encoding = CUPOLA_ENCODING_SRGB;
        for (int i = 0; i < projectors; i++)
            sum_of_codes += codes[i] / 255.0;
        double bytes = drawn_error(&show, GL_RGBA8, 40, 30, code, NULL);
        double again = drawn_error(&show, GL_RGBA8, 20, 50, code, NULL);
        double srgb = drawn_error(&show, GL_SRGB8_ALPHA8, 20, 50, code, NULL);
        printf("%d projectors: %.3f, within %.2g, sRGB format %.2g\n", projectors, code, bytes,
               srgb);
        check_at_least(bytes, 0.0);
        check_at_most(bytes, bar_of(projectors));
        check_at_least(again, 0.0);
        check_at_most(again, bar_of(projectors));
        check_at_least(srgb, 0.0);
        check_at_most(srgb, gl_always_encodes() ? (1.0 + projectors) / 255.0 : bar_of(projectors));
        if (projectors > 1)
            check_at_least(sum_of_codes - code, 0.2);
        if (context_has_floats())
            check_at_most(drawn_error(&show, GL_RGBA32F, 20, 50, code, NULL), 3e-3);
        show_release(projectors, &show);
    }
}

static void linear_light_stays_as_it_is(void **state)
{
    (void)state;
    for (int projectors = 1; projectors <= 2; projectors++) {
        struct show show;
        struct cupola_error error = {CUPOLA_OK, ""};
        show_make(projectors, &show);
        double off = drawn_error(&show, GL_RGBA8, 40, 30, light_of(projectors), NULL);
        check_at_least(off, 0.0);
        check_at_most(off, (0.1 + 0.5 * projectors) / 255.0);
        off = drawn_error(&show, GL_SRGB8_ALPHA8, 40, 30, light_of(projectors), &error);
        if (gl_always_encodes()) {
            check_near(off, -1.0, 0.0);
            assert_int_equal(error.status, CUPOLA_ERROR_GL);
            assert_non_null(strstr(error.message, "has an sRGB format"));
        } else {
            check_at_most(off, (0.1 + 0.5 * projectors) / 255.0);
        }
        show_release(projectors, &show);
    }
}

static void an_encoding_that_is_none_is_refused(void **state)
{
    (void)state;
    struct show show;
    struct cupola_error error = {CUPOLA_OK, ""};
    show_make(1, &show);
    show.spectator.encoding = (enum cupola_encoding)5;
    assert_int_equal(
        cupola_theatre_draw(show.theatre, show.images, &show.spectator, 8, 8, NULL, &error),
        CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "spectator's encoding is 5; allowed: 0 to 1"));
    show_release(1, &show);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_is_added_up_before_it_is_encoded),
        cmocka_unit_test(linear_light_stays_as_it_is),
        cmocka_unit_test(an_encoding_that_is_none_is_refused),
    };
    return run_gpu_group("theatre_encoding", tests);
}
