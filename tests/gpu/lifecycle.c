/* From creation to destruction: calls at a wrong moment are refused, and make nothing. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "live_objects.h"
#include "message.h"
#include "rig_random.h"

enum { SIZE = 64, NAMES = 4096 };

static struct fixture small_fixture(enum cupola_table table)
{
    struct fixture fixture;
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    const struct cupola_gl_params params = {.table = table};
    fixture_make(&rig, NULL, &params, &fixture);
    return fixture;
}

static void release(struct fixture *fixture)
{
    fixture_release(fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static int open_context(void **state)
{
    (void)state;
    context_open();
    return 0;
}

static int close_context(void **state)
{
    (void)state;
    fixture_forget_programs();
    context_close();
    return 0;
}

static void views_come_after_frame_begin_and_one_at_a_time(void **state)
{
    struct fixture fixture = small_fixture(CUPOLA_TABLE_NONE);
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned int points = 0;
    (void)state;
    check_refused_saying(cupola_gl_view_begin(fixture.gl, 0, NULL, &error), CUPOLA_ERROR_ORDER,
                         &error, "before frame_begin");
    check_refused_saying(cupola_gl_view_end(fixture.gl, &error), CUPOLA_ERROR_ORDER, &error,
                         "outside");
    int views = cupola_gl_frame_begin(fixture.gl, NULL, NULL);
    check_at_least(views, 2);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, views, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, -1, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 1, NULL, NULL), CUPOLA_OK);
    check_refused_saying(cupola_gl_view_begin(fixture.gl, 0, NULL, &error), CUPOLA_ERROR_ORDER,
                         &error, "inside");
    check_refused_saying(cupola_gl_frame_begin(fixture.gl, NULL, &error), CUPOLA_ERROR_ORDER,
                         &error, "inside");
    check_refused_saying(cupola_gl_warp(fixture.gl, 0, NULL, NULL, &error), CUPOLA_ERROR_ORDER,
                         &error, "open");
    check_refused_saying(cupola_gl_points(fixture.gl, 0, &points, &error), CUPOLA_ERROR_ORDER,
                         &error, "open");
    check_refused_saying(cupola_gl_density(fixture.gl, 0, &points, &error), CUPOLA_ERROR_ORDER,
                         &error, "open");
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_ERROR_ORDER);
    check_refused_saying(cupola_gl_warp(fixture.gl, 1, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT,
                         &error, "output is 1");
    assert_int_equal(cupola_gl_points(fixture.gl, 0, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_density(fixture.gl, 0, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    check_refused_saying(cupola_gl_density(fixture.gl, 1, &points, &error), CUPOLA_ERROR_ARGUMENT,
                         &error, "output is 1");
    release(&fixture);
}

static void near_and_far_must_be_distances(void **state)
{
    static const double bad[][2] = {{-1, 10},         {5, 5},           {6, 5},
                                    {(double)NAN, 5}, {1, (double)NAN}, {1, HUGE_VAL}};
    struct fixture fixture = small_fixture(CUPOLA_TABLE_NONE);
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const struct cupola_frame frame = {
            .depth = {.near_distance = bad[i][0], .far_distance = bad[i][1]}};
        check_refused_saying(cupola_gl_frame_begin(fixture.gl, &frame, &error),
                             CUPOLA_ERROR_ARGUMENT, &error, "near");
    }
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_ERROR_ORDER);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    release(&fixture);
}

static void colours_must_be_finite_and_may_be_negative(void **state)
{
    static const float bad[] = {NAN, INFINITY, -INFINITY};
    struct fixture fixture = small_fixture(CUPOLA_TABLE_NONE);
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_gl *gl = NULL;
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct cupola_gl_params params = {.border = {0}};
        struct cupola_frame frame = {.clear_color = {0}};
        params.border[i + 1] = frame.clear_color[i + 1] = bad[i];
        const char *names[2][3] = {
            {"border[1] is ", "border[2] is ", "border[3] is "},
            {"clear_color[1] is ", "clear_color[2] is ", "clear_color[3] is "}};
        check_refused_saying(cupola_gl_create(fixture.plan, &params, &gl, &error),
                             CUPOLA_ERROR_ARGUMENT, &error, names[0][i]);
        check_refused_saying(cupola_gl_frame_begin(fixture.gl, &frame, &error),
                             CUPOLA_ERROR_ARGUMENT, &error, names[1][i]);
    }
    assert_null(gl);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_ERROR_ORDER);
    const struct cupola_gl_params below = {.border = {-1.0f, -2.0f, 0.0f, 1.0f}};
    const struct cupola_frame dark = {.clear_color = {-1.0f, 0.0f, 0.0f, 1.0f}};
    fixture_replace_gl(&fixture, &below);
    check_at_least(cupola_gl_frame_begin(fixture.gl, &dark, NULL), 1);
    release(&fixture);
}

/* Clears each view to a colour of its own, first to last or last to first, some of them twice. */
static float *painted_in_order(const struct fixture *fixture, bool backwards)
{
    int views = cupola_gl_frame_begin(fixture->gl, NULL, NULL);
    for (int i = 0; i < 2 * views; i++) {
        int index = backwards ? (2 * views - 1 - i) % views : i % views;
        assert_int_equal(cupola_gl_view_begin(fixture->gl, index, NULL, NULL), CUPOLA_OK);
        glClearColor(0.2f * (float)index, 0.5f, 0.1f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    return fixture_warp(fixture, 0);
}

static void views_come_in_any_order_and_the_warp_repeats(void **state)
{
    struct fixture fixture = small_fixture(CUPOLA_TABLE_POINTS);
    (void)state;
    float *forwards = painted_in_order(&fixture, false), *again = fixture_warp(&fixture, 0);
    float *backwards = painted_in_order(&fixture, true);
    size_t bytes = (size_t)(4 * SIZE * SIZE) * sizeof *forwards;
    assert_memory_equal(forwards, again, bytes);
    assert_memory_equal(forwards, backwards, bytes);
    check_near(forwards[4 * (SIZE / 2 * SIZE + SIZE / 2) + 1], 0.5, 0.003);
    free(forwards);
    free(again);
    free(backwards);
    release(&fixture);
}

static void atlas_beyond_the_largest_texture_is_refused(void **state)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 60.0, SIZE);
    struct cupola_plan_params params = {.views = 1, .max_texture_px = 32768};
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    cupola_gl *gl = NULL;
    GLint largest = 0;
    char number[16];
    (void)state;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    params.view_size_px = largest < 16384 ? largest : 16384; /* and its guard band */
    params.guard_px = 4;
    if (largest > params.view_size_px)
        skip();
    snprintf(number, sizeof number, "%d", largest);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(dome, &params, &plan, NULL), CUPOLA_OK);
    int objects = live_objects(NAMES);
    check_refused_saying(cupola_gl_create(plan, NULL, &gl, &error), CUPOLA_ERROR_ARGUMENT, &error,
                         number);
    assert_int_equal(cupola_gl_create(plan, NULL, &gl, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_null(gl);
    assert_int_equal(live_objects(NAMES), objects);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
}

static void wrong_parameters_make_nothing(void **state)
{
    struct fixture fixture = small_fixture(CUPOLA_TABLE_POINTS);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_params params = {.format = (enum cupola_format)7};
    cupola_gl *gl = NULL;
    int objects = live_objects(NAMES);
    (void)state;
    check_refused_saying(cupola_gl_create(fixture.plan, &params, &gl, &error),
                         CUPOLA_ERROR_ARGUMENT, &error, "format is 7");
    params = (struct cupola_gl_params){.table = (enum cupola_table)9};
    check_refused_saying(cupola_gl_create(fixture.plan, &params, &gl, &error),
                         CUPOLA_ERROR_ARGUMENT, &error, "9");
    assert_int_equal(cupola_gl_create(NULL, NULL, &gl, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_create(fixture.plan, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_null(gl);
    assert_int_equal(live_objects(NAMES), objects);
    release(&fixture);
}

static void formats_that_the_gl_lacks_are_refused_by_the_extension(void **state)
{
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA16F};
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_gl *gl = NULL;
    (void)state;
    if (context_has_floats())
        skip();
    struct fixture fixture = small_fixture(CUPOLA_TABLE_POINTS);
    int objects = live_objects(NAMES);
    check_refused_saying(cupola_gl_create(fixture.plan, &params, &gl, &error), CUPOLA_ERROR_GL,
                         &error, "GL_EXT_color_buffer_half_float");
    params.format = CUPOLA_FORMAT_RGBA32F;
    check_refused_saying(cupola_gl_create(fixture.plan, &params, &gl, &error), CUPOLA_ERROR_GL,
                         &error, "GL_EXT_color_buffer_float");
    assert_null(gl);
    assert_int_equal(live_objects(NAMES), objects);
    release(&fixture);
}

static void null_instead_of_a_handle_is_refused(void **state)
{
    const struct cupola_spectator somebody = {.fov_rad = 1.25};
    struct cupola_spectator spectator = somebody;
    struct fixture fixture = small_fixture(CUPOLA_TABLE_NONE);
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned int texture = 7;
    (void)state;
    check_refused_saying(cupola_gl_frame_begin(NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
                         "NULL");
    check_refused_saying(cupola_gl_view_begin(NULL, 0, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
                         "NULL");
    check_refused_saying(cupola_gl_view_end(NULL, &error), CUPOLA_ERROR_ARGUMENT, &error, "NULL");
    check_refused_saying(cupola_gl_warp(NULL, 0, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
                         "NULL");
    check_refused_saying(cupola_gl_points(NULL, 0, &texture, &error), CUPOLA_ERROR_ARGUMENT, &error,
                         "NULL");
    assert_int_equal(texture, 7);
    assert_int_equal(cupola_gl_atlas(NULL), 0);
    assert_int_equal(cupola_table_find(NULL), CUPOLA_ERROR_ARGUMENT);
    cupola_spectator_at_eye(NULL, &spectator);
    cupola_spectator_outside(NULL, &spectator);
    assert_memory_equal(&spectator, &somebody, sizeof somebody);
    cupola_spectator_at_eye(fixture.dome, NULL);
    cupola_spectator_outside(fixture.dome, NULL);
    release(&fixture);
}

static void destroying_inside_of_a_view_gives_the_target_back(void **state)
{
    struct fixture fixture = small_fixture(CUPOLA_TABLE_NONE);
    GLint viewport[4], framebuffer = -1;
    (void)state;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(1, 2, 3, 4);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
    release(&fixture);
    assert_null(fixture.gl);
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    assert_int_equal(framebuffer, 0);
    assert_int_equal(viewport[2], 3);
    assert_false(glIsEnabled(GL_SCISSOR_TEST));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_come_after_frame_begin_and_one_at_a_time),
        cmocka_unit_test(near_and_far_must_be_distances),
        cmocka_unit_test(colours_must_be_finite_and_may_be_negative),
        cmocka_unit_test(views_come_in_any_order_and_the_warp_repeats),
        cmocka_unit_test(atlas_beyond_the_largest_texture_is_refused),
        cmocka_unit_test(wrong_parameters_make_nothing),
        cmocka_unit_test(formats_that_the_gl_lacks_are_refused_by_the_extension),
        cmocka_unit_test(null_instead_of_a_handle_is_refused),
        cmocka_unit_test(destroying_inside_of_a_view_gives_the_target_back),
    };
    return cmocka_run_group_tests_name("lifecycle", tests, open_context, close_context);
}
