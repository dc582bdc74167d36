/*
 * A context that is lost: told once to the log, answered by every call from then on without a GL
 * call, and cleaned up. The context only pretends: what a lost one answers, garbage and
 * GL_CONTEXT_LOST, comes from functions in the place of the GL's.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"
#include "interposed.h"

static struct guest_house house;
static int told, failures;
static enum cupola_table stage; /* of the next one made; by turns, as they keep memory of theirs */
static char last_told[2048];

static void listen(int level, int id, const char *text, void *user)
{
    (void)user;
    assert_int_equal(level, CUPOLA_LOG_ERROR);
    told += id == CUPOLA_LOG_CONTEXT_LOST;
    failures += id == CUPOLA_LOG_CALL_FAILED;
    snprintf(last_told, sizeof last_told, "%s", text);
}

static int open_house(void **state)
{
    (void)state;
    context_open();
    guest_house_build_moving(&house);
    /* libepoxy ends the process where it first looks for a function in a context that is lost: what
     * garbage can make the library put "back" is found before. */
    if (context_has(33, NULL, 32, "GL_EXT_draw_buffers_indexed")) {
        glEnablei(GL_BLEND, 0);
        glDisablei(GL_BLEND, 0);
    }
    if (cupola_pass_way(NULL) > 0) {
        glEnablei(GL_SCISSOR_TEST, 1);
        glDisablei(GL_SCISSOR_TEST, 1);
    }
    return 0;
}

static int close_house(void **state)
{
    (void)state;
    guest_house_release(&house);
    context_close();
    return 0;
}

static bool context_can_tell(void)
{
    return context_has(45, "GL_KHR_robustness", 32, "GL_KHR_robustness") ||
           context_has(99, "GL_ARB_robustness", 99, "GL_EXT_robustness");
}

static int make_all(struct cupola_error *error)
{
    stage = stage == CUPOLA_TABLE_SINES ? CUPOLA_TABLE_TILES : CUPOLA_TABLE_SINES;
    const struct cupola_gl_params params = {
        .log = {.write = listen}, .samples = 2, .table = guest_moving_table(stage)};
    int status = guest_gl_create(&house, &params, error);
    return status == CUPOLA_OK ? cupola_theatre_create(house.dome, &house.theatre, error) : status;
}

/* All that can be called, each of which must find the context lost without asking the GL. */
static void check_all_lost(bool also_theatre)
{
    unsigned int points = 7;
    struct cupola_error error = {CUPOLA_OK, ""};
    int called = interposed.called, expected = failures + 14;
    struct cupola_view_image images[CUPOLA_VIEWS_MAX] = {{.texture = house.target_texture}};
    assert_int_equal(cupola_gl_frame_begin(house.gl, NULL, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_view_begin(house.gl, 0, NULL, NULL), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_view_end(house.gl, NULL), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_pass_begin(house.gl, NULL, NULL, NULL), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_pass_end(house.gl, NULL), CUPOLA_ERROR_LOST);
    assert_int_equal(guest_warp(&house, -1, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(guest_warp(&house, 0, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_points(house.gl, 0, &points, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_density(house.gl, 0, &points, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_set_gain(house.gl, 0, 0, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(guest_views(&house, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(guest_overlays(&house, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(cupola_gl_views_import(house.gl, images, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(guest_move(&house, &error), CUPOLA_ERROR_LOST);
    assert_int_equal(points, 7);
    assert_int_equal(error.status, CUPOLA_ERROR_LOST);
    assert_non_null(strstr(error.message, "lost"));
    assert_int_equal(failures, expected);
    if (also_theatre)
        assert_int_equal(guest_theatre(&house, NULL), CUPOLA_ERROR_LOST);
    assert_int_equal(interposed.called, called);
}

static void destroy_all(void)
{
    int called = interposed.called;
    cupola_gl_destroy(&house.gl);
    cupola_theatre_destroy(&house.theatre);
    assert_null(house.gl);
    assert_null(house.theatre);
    assert_int_equal(interposed.called, called); /* another context may be current by now */
}

/* All that is done in frames. */
static int work(struct cupola_error *error)
{
    unsigned int points = 0;
    int status = guest_frame(&house, error);
    if (status >= 0)
        status = cupola_gl_points(house.gl, 0, &points, error);
    if (status >= 0)
        status = cupola_gl_density(house.gl, 0, &points, error);
    return status < 0 ? status : guest_theatre(&house, error);
}

/* The context goes at the n-th call; whether that was reached. */
static bool lose_in_work(int n)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    interposed_begin();
    interposed.robust = true;
    told = failures = 0;
    if (make_all(&error) != CUPOLA_OK || work(&error) < 0)
        fail_msg("%s", error.message);
    interposed.lose_in = n;
    int status = work(&error);
    bool reached = interposed.lost;
    if (status < 0 && status != CUPOLA_ERROR_LOST)
        fail_msg("lost in call %d: status %d, %s", n, status, error.message);
    assert_true(status >= 0 || reached);
    if (reached) {
        /* At the latest the next call sees it. */
        assert_int_equal(guest_warp(&house, -1, NULL), CUPOLA_ERROR_LOST);
        assert_int_equal(guest_theatre(&house, NULL), CUPOLA_ERROR_LOST);
        assert_int_equal(told, 1);
        check_all_lost(true);
        assert_int_equal(told, 1);
    }
    if (reached)
        destroy_all();
    interposed_end();
    cupola_gl_destroy(&house.gl);
    cupola_theatre_destroy(&house.theatre);
    return reached;
}

static void a_context_lost_in_a_frame_is_told_and_left_alone(void **state)
{
    int tried = 0, n = 1;
    (void)state;
    if (!context_can_tell())
        skip();
    for (; lose_in_work(n); n += 1 + n / 8)
        tried++;
    printf("  lost at %d moments of a frame of %d GL calls at most\n", tried, n);
    check_at_least(tried, 25);
}

static void a_context_lost_in_creation_is_that(void **state)
{
    int tried = 0;
    (void)state;
    if (!context_can_tell())
        skip();
    for (int n = 1;; n += 1 + n / 8) {
        struct cupola_error error = {CUPOLA_OK, ""};
        house.gl = NULL;
        interposed_begin();
        interposed.robust = true;
        interposed.lose_in = n;
        int status = make_all(&error);
        bool reached = interposed.lost;
        interposed.lose_in = 0;
        if (reached && status == CUPOLA_OK) /* by the last calls of all */
            status = guest_theatre(&house, &error);
        interposed_end();
        if (reached && status != CUPOLA_ERROR_LOST)
            fail_msg("lost in call %d: status %d, %s", n, status, error.message);
        cupola_gl_destroy(&house.gl);
        cupola_theatre_destroy(&house.theatre);
        if (!reached)
            break;
        tried++;
    }
    check_at_least(tried, 25);
}

static void a_view_that_was_open_is_closed(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    if (!context_can_tell())
        skip();
    for (int end = 0; end < 5; end++) {
        interposed_begin();
        interposed.robust = true;
        bool pass = end > 2; /* in place of a view */
        interposed.versionless = end == 2;
        told = failures = 0;
        assert_int_equal(make_all(&error), CUPOLA_OK);
        check_at_least(cupola_gl_frame_begin(house.gl, NULL, NULL), 1);
        pass = pass && house.one_pass;
        assert_int_equal(pass ? cupola_gl_pass_begin(house.gl, NULL, NULL, NULL)
                              : cupola_gl_view_begin(house.gl, 0, NULL, NULL),
                         CUPOLA_OK);
        interposed.lost = true;
        if (end && end != 3) {
            assert_int_equal(pass ? cupola_gl_pass_end(house.gl, &error)
                                  : cupola_gl_view_end(house.gl, &error),
                             CUPOLA_ERROR_LOST);
            check_all_lost(false);
        }
        cupola_gl_destroy(&house.gl); /* with the view open, or without */
        assert_int_equal(told, 1);
        cupola_theatre_destroy(&house.theatre);
        interposed_end();
    }
}

/* Of a context that does not say that it may be lost nothing is asked. */
static void contexts_that_cannot_be_lost_are_not_asked(void **state)
{
    GLint strategy = GL_NO_RESET_NOTIFICATION;
    (void)state;
    if (context_can_tell())
        glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    if (strategy == GL_LOSE_CONTEXT_ON_RESET)
        skip();
    for (int robust = 0; robust < 2; robust++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        interposed_begin();
        interposed.robust = robust;
        assert_int_equal(make_all(&error), CUPOLA_OK);
        interposed.resets_asked = 0;
        assert_int_equal(guest_warp(&house, 0, NULL), CUPOLA_OK);
        assert_int_equal(interposed.resets_asked, robust && context_can_tell());
        interposed_end();
        cupola_gl_destroy(&house.gl);
        cupola_theatre_destroy(&house.theatre);
    }
}

static void a_fresh_context_works(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    close_house(state);
    open_house(state);
    if (make_all(&error) != CUPOLA_OK || work(&error) < 0)
        fail_msg("%s", error.message);
    cupola_gl_destroy(&house.gl);
    cupola_theatre_destroy(&house.theatre);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_context_lost_in_a_frame_is_told_and_left_alone),
        cmocka_unit_test(a_context_lost_in_creation_is_that),
        cmocka_unit_test(a_view_that_was_open_is_closed),
        cmocka_unit_test(contexts_that_cannot_be_lost_are_not_asked),
        cmocka_unit_test(a_fresh_context_works),
    };
    return cmocka_run_group_tests_name("lost_context", tests, open_house, close_house);
}
