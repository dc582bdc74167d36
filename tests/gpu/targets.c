/* What is no target, image or spectator is refused, and neither pixels nor GL errors come of it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "rig_random.h"

enum { SIZE = 32 };

static struct fixture fixture;
static cupola_theatre *theatre;
static GLuint image, good_framebuffer, good_texture;

static GLuint texture_of(GLenum format)
{
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, SIZE, SIZE, 0, GL_RGBA,
                 format == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return texture;
}

static int setup(void **state)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, SIZE);
    (void)state;
    context_open();
    fixture_make(&rig, NULL, NULL, &fixture);
    if (cupola_theatre_create(fixture.dome, &theatre, NULL) < 0)
        return -1;
    image = texture_of(GL_RGBA8);
    good_texture = texture_of(GL_RGBA8);
    glGenFramebuffers(1, &good_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, good_texture, 0);
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClear(GL_COLOR_BUFFER_BIT);
    return glGetError() != GL_NO_ERROR;
}

static int teardown(void **state)
{
    (void)state;
    cupola_theatre_destroy(&theatre);
    fixture_release(&fixture);
    glDeleteTextures(1, &image);
    glDeleteTextures(1, &good_texture);
    glDeleteFramebuffers(1, &good_framebuffer);
    context_close();
    return 0;
}

static void check_refused(int status, int expected, const struct cupola_error *error,
                          const char *word)
{
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(status, expected);
    assert_int_equal(error->status, expected);
    if (!strstr(error->message, word))
        fail_msg("'%s' does not say '%s'", error->message, word);
}

/* The host's own framebuffer stayed bound and as it was cleared. */
static void check_untouched(void)
{
    GLint bound = 0;
    float pixels[4 * SIZE * SIZE];
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    assert_int_equal(bound, good_framebuffer);
    context_read_pixels(SIZE, SIZE, pixels);
    for (int i = 0; i < 4 * SIZE * SIZE; i++)
        check_near(pixels[i], 0.2 * (i % 4 + 1), 1e-6);
}

static void check_target(GLuint framebuffer, const char *word)
{
    const struct cupola_target target = {.framebuffer = framebuffer};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_spectator spectator;
    float pixels[4 * SIZE * SIZE] = {0.5f};
    cupola_spectator_at_eye(fixture.dome, &spectator);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    check_refused(cupola_gl_warp(fixture.gl, 0, NULL, &target, &error), CUPOLA_ERROR_GL, &error,
                  word);
    check_refused(cupola_theatre_draw(theatre, &image, &spectator, SIZE, SIZE, &target, &error),
                  CUPOLA_ERROR_GL, &error, word);
    check_refused(cupola_gl_capture(&target, SIZE, SIZE, pixels, &error), CUPOLA_ERROR_GL, &error,
                  word);
    check_near(pixels[0], 0.5, 0.0);
    check_untouched();
}

static void framebuffer_that_does_not_exist_is_no_target(void **state)
{
    GLuint only_generated = 0;
    (void)state;
    check_target(54321, "54321");
    glGenFramebuffers(1, &only_generated);
    check_target(only_generated, "framebuffer");
    glDeleteFramebuffers(1, &only_generated);
}

static void framebuffer_without_attachments_is_no_target(void **state)
{
    GLuint empty = 0;
    (void)state;
    glGenFramebuffers(1, &empty);
    glBindFramebuffer(GL_FRAMEBUFFER, empty);
    check_target(empty, "not complete");
    glDeleteFramebuffers(1, &empty);
}

static void what_cannot_be_read_is_not_captured(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    float pixels[4 * SIZE * SIZE] = {0.5f};
    GLuint framebuffer = 0, color = 0;
    struct cupola_target target;
    (void)state;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &color);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, SIZE, SIZE);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    target = (struct cupola_target){.framebuffer = framebuffer};
    check_refused(cupola_gl_capture(&target, SIZE, SIZE, pixels, &error), CUPOLA_ERROR_GL, &error,
                  "cannot read");
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    glReadBuffer(GL_NONE);
    target.framebuffer = good_framebuffer;
    check_refused(cupola_gl_capture(&target, SIZE, SIZE, pixels, &error), CUPOLA_ERROR_GL, &error,
                  "cannot read");
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    check_near(pixels[0], 0.5, 0.0);
    check_refused(cupola_gl_capture(&target, 0, SIZE, pixels, &error), CUPOLA_ERROR_ARGUMENT,
                  &error, "0 x 32");
    check_refused(cupola_gl_capture(&target, SIZE, 32769, pixels, &error), CUPOLA_ERROR_ARGUMENT,
                  &error, "32769");
    check_refused(cupola_gl_capture(&target, SIZE, SIZE, NULL, &error), CUPOLA_ERROR_ARGUMENT,
                  &error, "rgba is NULL");
    assert_int_equal(cupola_gl_capture(&target, SIZE, SIZE, pixels, &error), CUPOLA_OK);
    check_near(pixels[1], 0.4, 1e-6);
    check_untouched();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &color);
}

static int draw(const GLuint *images, const struct cupola_spectator *spectator, int width,
                int height, struct cupola_error *error)
{
    const struct cupola_target target = {.framebuffer = good_framebuffer};
    return cupola_theatre_draw(theatre, images, spectator, width, height, &target, error);
}

/* The host's framebuffer with a second texture, of 5, 6, 7, 8 everywhere. */
static GLuint attach_second(void)
{
    static const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    static const GLfloat color[4] = {5, 6, 7, 8};
    GLuint second = texture_of(GL_RGBA32F);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, second, 0);
    glDrawBuffers(2, both);
    glClearBufferfv(GL_COLOR, 1, color);
    return second;
}

static void release_second(GLuint second)
{
    const GLenum first = GL_COLOR_ATTACHMENT0;
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
    glDrawBuffers(1, &first);
    glDeleteTextures(1, &second);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void check_second(GLuint second)
{
    float *pixels = texture_read(second, SIZE, SIZE);
    for (int i = 0; i < 4 * SIZE * SIZE; i++)
        check_near(pixels[i], 5 + i % 4, 0.0);
    free(pixels);
}

/* Draw buffer 0 is the target: of the others nothing is written, whatever masks the host has. */
static void further_draw_buffers_keep_what_they_have(void **state)
{
    const struct cupola_target target = {.framebuffer = good_framebuffer};
    struct cupola_spectator spectator;
    float pixels[4 * SIZE * SIZE];
    GLint mask[4];
    (void)state;
    if (!context_has_floats() || !context_has(33, NULL, 32, "GL_OES_draw_buffers_indexed"))
        skip();
    GLuint second = attach_second();
    cupola_spectator_at_eye(fixture.dome, &spectator);
    glColorMaski(1, GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, &target, NULL), CUPOLA_OK);
    check_second(second);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    context_read_pixels(SIZE, SIZE, pixels);
    check_near(pixels[1], 0.0, 0.0); /* the border's black: it has been drawn */
    assert_int_equal(draw(&image, &spectator, SIZE, SIZE, NULL), CUPOLA_OK);
    check_second(second);
    glGetIntegeri_v(GL_COLOR_WRITEMASK, 1, mask);
    assert_true(mask[0] && !mask[1] && mask[2] && !mask[3]);
    glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    release_second(second);
    check_untouched();
}

static void what_is_sampled_is_no_target(void **state)
{
    struct cupola_target target = {.framebuffer = good_framebuffer};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_spectator spectator;
    struct cupola_gl_view view;
    unsigned int points = 0, own[2] = {cupola_gl_atlas(fixture.gl), 0};
    (void)state;
    cupola_spectator_at_eye(fixture.dome, &spectator);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    check_refused(draw(&good_texture, &spectator, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT,
                  &error, "color attachment 0");
    assert_int_equal(cupola_gl_points(fixture.gl, 0, &points, NULL), CUPOLA_OK);
    own[1] = points; /* it is the warp's table, too; without float targets it is no attachment */
    for (int i = 0; i < (context_has_floats() ? 2 : 1); i++) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, own[i], 0);
        check_refused(cupola_gl_warp(fixture.gl, 0, NULL, &target, &error), CUPOLA_ERROR_ARGUMENT,
                      &error, "color attachment 2");
        check_refused(draw(&own[i], &spectator, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                      "color attachment 2");
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, 0, 0);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, &view, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    target.framebuffer = view.framebuffer;
    check_refused(cupola_gl_warp(fixture.gl, 0, NULL, &target, &error), CUPOLA_ERROR_ARGUMENT,
                  &error, "color attachment 0");
    check_untouched();
}

static void errors_that_were_pending_go_where_the_gl_is_asked_and_stay_elsewhere(void **state)
{
    const struct cupola_target target = {.framebuffer = good_framebuffer};
    float pixels[4 * SIZE * SIZE];
    struct cupola_gl_view view;
    (void)state;
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    glEnable(0xffff);
    assert_int_equal(cupola_gl_capture(&target, SIZE, SIZE, pixels, NULL), CUPOLA_OK);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glEnable(0xffff);
    fixture_replace_gl(&fixture, NULL);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glEnable(0xffff);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, &view, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, &target, NULL), CUPOLA_OK);
    assert_int_equal(glGetError(), GL_INVALID_ENUM);
    glBindFramebuffer(GL_FRAMEBUFFER, good_framebuffer);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void what_is_no_texture_is_no_image(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_spectator spectator;
    GLuint wrong = 54321, cube = 0, none = 0;
    (void)state;
    cupola_spectator_at_eye(fixture.dome, &spectator);
    glGenTextures(1, &cube);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube);
    check_refused(draw(&wrong, &spectator, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "54321");
    check_refused(draw(&none, &spectator, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "texture 0");
    check_refused(draw(&cube, &spectator, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "GL_TEXTURE_2D");
    check_untouched();
    glDeleteTextures(1, &cube);
}

static void spectators_that_cannot_be_are_refused(void **state)
{
    static const double fovs[] = {-0.1, 3.1416, 10, (double)NAN, HUGE_VAL};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_spectator good, bad;
    cupola_theatre *no_theatre = NULL;
    (void)state;
    cupola_spectator_at_eye(fixture.dome, &good);
    for (size_t i = 0; i < sizeof fovs / sizeof fovs[0]; i++) {
        bad = good;
        bad.fov_rad = fovs[i];
        check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                      "field of view");
    }
    bad = good;
    bad.position_m[2] = (double)NAN;
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "position_m[2]");
    bad = good;
    bad.rotation[7] = HUGE_VAL;
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "rotation[7]");
    bad = good;
    bad.rotation[4] += 2e-6;
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "rows 1 and 1");
    bad = good;
    bad.rotation[1] = 0.01;
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error, "rows");
    bad = good;
    bad.rotation[1] = 1e200;
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error, "rows");
    bad = good;
    for (int i = 0; i < 3; i++)
        bad.rotation[i] = -good.rotation[i];
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "determinant -1");
    bad = good;
    bad.ambient_rgb[2] = NAN;
    check_refused(draw(&image, &bad, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "ambient_rgb[2]");
    check_refused(draw(&image, NULL, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "spectator");
    check_refused(draw(NULL, &good, SIZE, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error, "images");
    check_refused(draw(&image, &good, 0, SIZE, &error), CUPOLA_ERROR_ARGUMENT, &error, "0 x 32");
    check_refused(draw(&image, &good, SIZE, 32769, &error), CUPOLA_ERROR_ARGUMENT, &error, "32769");
    check_refused(cupola_theatre_draw(NULL, &image, &good, SIZE, SIZE, NULL, &error),
                  CUPOLA_ERROR_ARGUMENT, &error, "theatre");
    check_refused(cupola_theatre_create(NULL, &no_theatre, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "dome");
    check_refused(cupola_theatre_create(fixture.dome, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
                  "theatre");
    check_untouched();
}

/* It lives only while it is in use, and cannot be used again. */
static void program_that_the_host_has_deleted_is_no_error(void **state)
{
    const struct cupola_target target = {.framebuffer = good_framebuffer};
    GLint in_use = -1;
    const GLuint program =
        context_program("void main() { gl_Position = vec4(0.0); }\n", "void main() {}\n");
    (void)state;
    glUseProgram(program);
    glDeleteProgram(program);
    assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, &target, NULL), CUPOLA_OK);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glGetIntegerv(GL_CURRENT_PROGRAM, &in_use);
    assert_int_equal(in_use, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(framebuffer_that_does_not_exist_is_no_target),
        cmocka_unit_test(framebuffer_without_attachments_is_no_target),
        cmocka_unit_test(what_cannot_be_read_is_not_captured),
        cmocka_unit_test(further_draw_buffers_keep_what_they_have),
        cmocka_unit_test(what_is_sampled_is_no_target),
        cmocka_unit_test(errors_that_were_pending_go_where_the_gl_is_asked_and_stay_elsewhere),
        cmocka_unit_test(what_is_no_texture_is_no_image),
        cmocka_unit_test(spectators_that_cannot_be_are_refused),
        cmocka_unit_test(program_that_the_host_has_deleted_is_no_error),
    };
    return cmocka_run_group_tests_name("targets", tests, setup, teardown);
}
