/*
 * Framebuffers that are complete and yet no targets: without a colour, or with one of integers. And
 * why a framebuffer cannot be read.
 */
#include <stdlib.h>
#include <string.h>

#include "cupola/overlay.h"
#include "cupola/theatre.h"
#include "group.h"
#include "oracle.h"
#include "rig_random.h"

enum { SIDE = 32 };

static void check_refused(int status, const struct cupola_error *error, const char *word)
{
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(status, CUPOLA_ERROR_GL);
    if (!strstr(error->message, word) || !strstr(error->message, "allowed: "))
        fail_msg("'%s' does not say '%s' and what is allowed", error->message, word);
}

/* A framebuffer of one renderbuffer. */
struct canvas {
    GLuint framebuffer, renderbuffer;
};

static struct canvas canvas_make(GLenum attachment, GLenum format, int samples)
{
    struct canvas canvas = {0, 0};
    glGenRenderbuffers(1, &canvas.renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, canvas.renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, SIDE, SIDE);
    glGenFramebuffers(1, &canvas.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, canvas.renderbuffer);
    return canvas;
}

static bool canvas_is_complete(void)
{
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

static void canvas_release(struct canvas *canvas)
{
    glDeleteFramebuffers(1, &canvas->framebuffer);
    glDeleteRenderbuffers(1, &canvas->renderbuffer);
}

static const char no_color[] = "no colour as its draw buffer 0";

static void check_no_target(const struct canvas *canvas, const char *word)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, SIDE);
    const struct cupola_gl_params params = {.overlays = true};
    const struct cupola_overlay disc = {
        .kind = CUPOLA_OVERLAY_DISC, .direction = {0.0, 0.0, -1.0}, .width_rad = 0.5};
    const struct cupola_target target = {.framebuffer = canvas->framebuffer};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_spectator spectator;
    cupola_theatre *theatre = NULL;
    struct fixture fixture;
    GLuint image = 0;
    fixture_make(&rig, NULL, &params, &fixture);
    assert_int_equal(cupola_theatre_create(fixture.dome, &theatre, NULL), CUPOLA_OK);
    cupola_spectator_at_eye(fixture.dome, &spectator);
    image = cupola_gl_atlas(fixture.gl);
    check_refused(cupola_gl_warp(fixture.gl, 0, NULL, &target, &error), &error, word);
    check_refused(cupola_gl_overlay(fixture.gl, 0, &disc, 1, &target, &error), &error, word);
    check_refused(cupola_theatre_draw(theatre, &image, &spectator, SIDE, SIDE, &target, &error),
                  &error, word);
    cupola_theatre_destroy(&theatre);
    fixture_release(&fixture);
}

static void check_unread(const struct canvas *canvas, const char *word)
{
    const struct cupola_target target = {.framebuffer = canvas->framebuffer};
    struct cupola_error error = {CUPOLA_OK, ""};
    static float pixels[4 * SIDE * SIDE];
    pixels[0] = 0.5f;
    check_refused(cupola_gl_capture(&target, SIDE, SIDE, pixels, &error), &error, word);
    check_near(pixels[0], 0.5, 0.0);
}

static void depth_alone_is_no_target(void **state)
{
    (void)state;
    struct canvas canvas = canvas_make(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, 0);
    const GLenum none = GL_NONE;
    if (canvas_is_complete()) { /* with a draw buffer that is not there */
        check_no_target(&canvas, no_color);
        check_unread(&canvas, "whose read buffer is no colour");
    }
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
    assert_true(canvas_is_complete());
    check_no_target(&canvas, no_color);
    check_unread(&canvas, "whose read buffer is no colour");
    canvas_release(&canvas);
}

static void integers_are_no_target(void **state)
{
    (void)state;
    static const GLenum formats[] = {GL_RGBA8UI, GL_RGBA32I, GL_R16UI};
    for (int i = 0; i < 3; i++) {
        struct canvas canvas = canvas_make(GL_COLOR_ATTACHMENT0, formats[i], 0);
        assert_true(canvas_is_complete());
        check_no_target(&canvas, "integers as its draw buffer 0");
        check_unread(&canvas, "whose colour is of integers");
        canvas_release(&canvas);
    }
}

static void several_samples_are_not_read(void **state)
{
    (void)state;
    struct canvas canvas = canvas_make(GL_COLOR_ATTACHMENT0, GL_RGBA8, 4);
    assert_true(canvas_is_complete());
    check_unread(&canvas, "which has several samples per pixel");
    canvas_release(&canvas);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_alone_is_no_target),
        cmocka_unit_test(integers_are_no_target),
        cmocka_unit_test(several_samples_are_not_read),
    };
    return run_gpu_group("target_colors", tests);
}
