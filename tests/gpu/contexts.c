/* Whoever has no fitting context, or has lost it, is told so; nothing aborts. */
#include <epoxy/egl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "message.h"
#include "rig_random.h"

enum { SIZE = 64, EXIT_SKIPPED = 77 };

/* Without a context, first of all: nothing of the GL has been touched yet. */
static void without_a_context_nothing_is_made(void **state)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    cupola_gl *gl = NULL;
    cupola_theatre *theatre = NULL;
    cupola_points *points = NULL;
    float pixel[4] = {0};
    (void)state;
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(dome, NULL, &plan, NULL), CUPOLA_OK);
    check_refused_saying(cupola_gl_create(plan, NULL, &gl, &error), CUPOLA_ERROR_CONTEXT, &error,
                         "no GL context");
    check_refused_saying(cupola_theatre_create(dome, &theatre, &error), CUPOLA_ERROR_CONTEXT,
                         &error, "no GL context");
    check_refused_saying(cupola_points_create(dome, 0, &points, &error), CUPOLA_ERROR_CONTEXT,
                         &error, "no GL context");
    check_refused_saying(cupola_gl_capture(NULL, 1, 1, pixel, &error), CUPOLA_ERROR_CONTEXT, &error,
                         "no GL context");
    assert_int_equal(cupola_gl_create(plan, NULL, &gl, NULL), CUPOLA_ERROR_CONTEXT);
    assert_null(gl);
    assert_null(theatre);
    assert_null(points);
    cupola_gl_destroy(&gl);
    cupola_gl_destroy(NULL);
    cupola_theatre_destroy(&theatre);
    cupola_theatre_destroy(NULL);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
}

/* Makes a context of whatever version the driver gives and tries to use it; an exit status. */
static int try_context(EGLenum api, EGLint renderable, const char *word)
{
    const EGLint config_wish[] = {EGL_RENDERABLE_TYPE, renderable, EGL_SURFACE_TYPE, 0, EGL_NONE};
    const EGLint es2[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE}, any[] = {EGL_NONE};
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    struct cupola_error error = {CUPOLA_OK, ""};
    EGLConfig config = NULL;
    EGLint configs = 0;
    cupola_dome *dome = NULL;
    cupola_theatre *theatre = NULL;
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL) || !eglBindAPI(api))
        return EXIT_SKIPPED;
    eglChooseConfig(display, config_wish, &config, 1, &configs);
    EGLContext context = eglCreateContext(display, configs > 0 ? config : EGL_NO_CONFIG_KHR,
                                          EGL_NO_CONTEXT, api == EGL_OPENGL_API ? any : es2);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) ||
        epoxy_gl_version() >= (api == EGL_OPENGL_API ? 33 : 30))
        return EXIT_SKIPPED;
    if (cupola_dome_create(&rig, &dome, NULL) < 0)
        return EXIT_FAILURE;
    int status = cupola_theatre_create(dome, &theatre, &error);
    printf("  %s\n", error.message);
    fflush(stdout);
    cupola_dome_destroy(&dome);
    return status == CUPOLA_ERROR_CONTEXT && strstr(error.message, word) &&
                   strstr(error.message, "allowed: OpenGL 3.3 or OpenGL ES 3.0") && !theatre
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
}

/* In a process of its own: a process has one GL, and the version is asked for by environment. */
static void check_in_child(EGLenum api, EGLint renderable, const char *word)
{
    int outcome = 0;
    fflush(stdout);
    pid_t child = fork();
    assert_int_not_equal(child, -1);
    if (child == 0) {
        setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
        setenv("MESA_GLES_VERSION_OVERRIDE", "2.0", 1);
        _exit(try_context(api, renderable, word));
    }
    assert_int_equal(waitpid(child, &outcome, 0), child);
    assert_true(WIFEXITED(outcome));
    if (WEXITSTATUS(outcome) == EXIT_SKIPPED)
        print_message("no such context can be had here\n");
    else
        assert_int_equal(WEXITSTATUS(outcome), EXIT_SUCCESS);
}

/* The exit status of a child that finds no EGL driver; EXIT_SUCCESS if it has found one. */
static int status_without_driver(const char *required)
{
    int outcome = 0;
    fflush(stdout);
    pid_t child = fork();
    assert_int_not_equal(child, -1);
    if (child == 0) {
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
        setenv("CUPOLA_GPU_REQUIRED", required, 1);
        context_open();
        _exit(EXIT_SUCCESS);
    }
    assert_int_equal(waitpid(child, &outcome, 0), child);
    assert_true(WIFEXITED(outcome));
    return WEXITSTATUS(outcome);
}

static void machine_without_gl_skips_unless_a_gpu_is_required(void **state)
{
    (void)state;
    int status = status_without_driver("0");
    if (status == EXIT_SUCCESS)
        skip();
    assert_int_equal(status, EXIT_SKIPPED);
    assert_int_equal(status_without_driver("1"), EXIT_FAILURE);
}

static void context_that_is_too_old_is_refused_by_its_version(void **state)
{
    (void)state;
    check_in_child(EGL_OPENGL_API, EGL_OPENGL_BIT, "OpenGL 2.1");
}

static void context_of_opengl_es_2_is_refused_by_its_version(void **state)
{
    (void)state;
    check_in_child(EGL_OPENGL_ES_API, EGL_OPENGL_ES2_BIT, "OpenGL ES 2.0");
}

/* A host that has lost its context, and then frees what it had. */
static void without_a_current_context_calls_are_refused_and_memory_is_freed(void **state)
{
    struct fixture fixture, open;
    struct cupola_error error = {CUPOLA_OK, ""};
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    struct cupola_spectator spectator;
    cupola_theatre *theatre = NULL;
    cupola_points *alone = NULL;
    unsigned int points = 0;
    float pixel[4];
    (void)state;
    context_open();
    EGLDisplay display = eglGetCurrentDisplay();
    EGLContext context = eglGetCurrentContext();
    const struct cupola_plan_params moving = {.head_radius_m = 0.1};
    const double eye_m[3] = {0.0, 0.05, 0.0};
    fixture_make(&rig, &moving, NULL, &fixture);
    fixture_make(&rig, NULL, NULL, &open);
    assert_int_equal(cupola_theatre_create(fixture.dome, &theatre, NULL), CUPOLA_OK);
    assert_int_equal(cupola_points_create(fixture.dome, 0, &alone, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_points(fixture.gl, 0, &points, NULL), CUPOLA_OK);
    cupola_spectator_at_eye(fixture.dome, &spectator);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    check_at_least(cupola_gl_frame_begin(open.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_view_begin(open.gl, 0, NULL, NULL), CUPOLA_OK);
    assert_true(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    assert_int_equal(cupola_gl_set_eye(fixture.gl, eye_m, &error), CUPOLA_OK); /* needs none */
    check_refused_saying(cupola_gl_view_begin(fixture.gl, 0, NULL, &error), CUPOLA_ERROR_CONTEXT,
                         &error, "no GL context");
    assert_int_equal(cupola_gl_view_end(open.gl, &error), CUPOLA_ERROR_CONTEXT);
    assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, NULL, &error), CUPOLA_ERROR_CONTEXT);
    assert_int_equal(cupola_gl_points(fixture.gl, 0, &points, &error), CUPOLA_ERROR_CONTEXT);
    assert_int_equal(cupola_gl_capture(NULL, 1, 1, pixel, &error), CUPOLA_ERROR_CONTEXT);
    assert_int_equal(cupola_theatre_draw(theatre, &points, &spectator, SIZE, SIZE, NULL, &error),
                     CUPOLA_ERROR_CONTEXT);
    check_refused_saying(cupola_points_set_dome(alone, fixture.dome, 0, &error),
                         CUPOLA_ERROR_CONTEXT, &error, "no GL context");
    fixture_release(&open);
    fixture_release(&fixture);
    cupola_points_destroy(&alone);
    assert_null(alone);
    cupola_theatre_destroy(&theatre);
    assert_null(theatre);
    assert_true(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    assert_int_equal(glGetError(), GL_NO_ERROR);
    context_close();
}

int main(void)
{
    /* In this order: once a context was there, a child could not have one of another kind. */
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(machine_without_gl_skips_unless_a_gpu_is_required),
        cmocka_unit_test(context_that_is_too_old_is_refused_by_its_version),
        cmocka_unit_test(context_of_opengl_es_2_is_refused_by_its_version),
        cmocka_unit_test(without_a_context_nothing_is_made),
        cmocka_unit_test(without_a_current_context_calls_are_refused_and_memory_is_freed),
    };
    return cmocka_run_group_tests_name("contexts", tests, NULL, NULL);
}
