/*
 * Contexts of a compatibility profile, in which points have old ways: smooth ones are round, and by
 * the letter all are that where there are samples, unless they are sprites. Tiles are squares all
 * the same, and the host's ways are as they were.
 */
#include <epoxy/egl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "rig_random.h"

enum { EXIT_SKIPPED = 77, SIZE = 256, SAMPLES = 4, POINT_PX = 64 };

static GLuint single, multiple, resolved, drawn; /* framebuffers; the last is one of the first */

static bool open_compatible(void)
{
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    const EGLint compatible[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                 EGL_NONE};
    EGLConfig config = NULL;
    EGLint configs = 0;
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL) ||
        !eglBindAPI(EGL_OPENGL_API))
        return false;
    eglChooseConfig(display, wish, &config, 1, &configs);
    EGLContext context = eglCreateContext(display, configs > 0 ? config : EGL_NO_CONFIG_KHR,
                                          EGL_NO_CONTEXT, compatible);
    return context != EGL_NO_CONTEXT &&
           eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) &&
           epoxy_gl_version() >= 33;
}

static GLuint framebuffer_of(int samples)
{
    GLuint framebuffer, renderbuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, SIZE, SIZE);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return framebuffer;
}

static int open_targets(void **state)
{
    (void)state;
    single = framebuffer_of(0);
    multiple = framebuffer_of(SAMPLES);
    resolved = framebuffer_of(0);
    return 0;
}

static unsigned char *picture(void)
{
    unsigned char *pixels = malloc((size_t)4 * SIZE * SIZE);
    assert_non_null(pixels);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
    glBlitFramebuffer(0, 0, SIZE, SIZE, 0, 0, SIZE, SIZE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    return pixels;
}

static void set_points(bool smooth, bool sprite)
{
    (smooth ? glEnable : glDisable)(GL_POINT_SMOOTH);
    (sprite ? glEnable : glDisable)(GL_POINT_SPRITE);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 300);
}

static void clear(void)
{
    static const GLfloat red[4] = {1, 0, 0, 1};
    glBindFramebuffer(GL_FRAMEBUFFER, drawn);
    glDisable(GL_SCISSOR_TEST);
    glClearBufferfv(GL_COLOR, 0, red);
}

/* Pixels that are not red. */
static int pixels_changed(void)
{
    unsigned char *pixels = picture();
    int count = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        count += pixels[4 * i] < 128;
    free(pixels);
    return count;
}

/* The control: what these states do to a point of a host. */
static int pixels_of_a_point(bool smooth, bool sprite)
{
    set_points(smooth, sprite);
    clear();
    glViewport(0, 0, SIZE, SIZE);
    glPointSize(POINT_PX);
    glColor4f(0, 0, 1, 1);
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glEnd();
    return pixels_changed();
}

static void smooth_points_of_a_host_are_round(void **state)
{
    (void)state;
    drawn = single;
    assert_int_equal(pixels_of_a_point(false, true), POINT_PX * POINT_PX);
    check_at_most(pixels_of_a_point(true, false), 0.9 * POINT_PX * POINT_PX);
}

static void draw_views(cupola_gl *gl)
{
    const struct cupola_frame frame = {.clear_color = {0.2f, 0.6f, 0.9f, 1}};
    int views = cupola_gl_frame_begin(gl, &frame, NULL);
    for (int i = 0; i < views; i++) {
        assert_int_equal(cupola_gl_view_begin(gl, i, NULL, NULL), CUPOLA_OK);
        assert_int_equal(cupola_gl_view_end(gl, NULL), CUPOLA_OK);
    }
}

static unsigned char *warped(const cupola_plan *plan, enum cupola_table table, bool leaves_state)
{
    const struct cupola_gl_params params = {.table = table, .leaves_state = leaves_state};
    const struct cupola_target target = {.framebuffer = drawn};
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_gl *gl = NULL;
    if (cupola_gl_create(plan, &params, &gl, &error) < 0)
        fail_msg("%s", error.message);
    draw_views(gl);
    clear();
    assert_int_equal(cupola_gl_warp(gl, 0, NULL, &target, NULL), CUPOLA_OK);
    cupola_gl_destroy(&gl);
    return picture();
}

static int differing(const unsigned char *a, const unsigned char *b)
{
    int count = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        int most = 0;
        for (int k = 4 * i; k < 4 * i + 4; k++)
            most = abs(a[k] - b[k]) > most ? abs(a[k] - b[k]) : most;
        count += most > 8;
    }
    return count;
}

static void check_tiles(const cupola_plan *plan, GLuint target)
{
    drawn = target;
    unsigned char *plain = warped(plan, CUPOLA_TABLE_NONE, false);
    for (int way = 0; way < 8; way++) {
        bool smooth = way & 1, sprite = way & 2, leaves = way & 4;
        GLfloat fade_px = 0;
        set_points(smooth, sprite);
        unsigned char *tiles = warped(plan, CUPOLA_TABLE_TILES, leaves);
        assert_int_equal(differing(plain, tiles), 0);
        free(tiles);
        glGetFloatv(GL_POINT_FADE_THRESHOLD_SIZE, &fade_px);
        assert_int_equal(glIsEnabled(GL_POINT_SMOOTH), smooth && !leaves);
        assert_int_equal(glIsEnabled(GL_POINT_SPRITE), sprite || leaves);
        assert_int_equal((int)fade_px, leaves ? 1 : 300);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    free(plain);
}

static void tiles_are_square_whatever_points_a_host_has(void **state)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, SIZE);
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    (void)state;
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(dome, NULL, &plan, NULL), CUPOLA_OK);
    check_tiles(plan, single);
    check_tiles(plan, multiple);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smooth_points_of_a_host_are_round),
        cmocka_unit_test(tiles_are_square_whatever_points_a_host_has),
    };
    if (!open_compatible()) {
        fprintf(stderr, "skipped: no compatibility profile of OpenGL 3.3 can be had here\n");
        return EXIT_SKIPPED;
    }
    printf("renderer: %s, OpenGL %s\n", (const char *)glGetString(GL_RENDERER),
           (const char *)glGetString(GL_VERSION));
    return cmocka_run_group_tests_name("compatibility", tests, open_targets, NULL);
}
