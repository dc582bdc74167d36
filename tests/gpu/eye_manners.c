/*
 * What moving the eye does and leaves alone: eyes that are refused change nothing, a gl does not
 * depend on the plan that it was made from, moving makes no GL call, and the warp that follows
 * leaves a host its state, whatever that was.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cupola/overlay.h"
#include "interposed.h"
#include "left_house.h"
#include "message.h"

enum { STAGES = CUPOLA_TABLE_TILES + 1 };

static const double first_eye_m[3] = {0.0, 0.0, 0.0}, other_eye_m[3] = {0.05, -0.04, 0.03};

static int open_moving(void **state)
{
    open_house(state);
    guest_house_release(&house);
    guest_house_build_moving(&house);
    state_reset();
    return 0;
}

static void make(const struct cupola_gl_params *params)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    check_ok(guest_gl_create(&house, params, &error), "create", &error);
}

static void move_to(const double eye_m[3])
{
    struct cupola_error error = {CUPOLA_OK, ""};
    check_ok(cupola_gl_set_eye(house.gl, eye_m, &error), "set_eye", &error);
}

/* With views as they are. */
static float *warped(void)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    check_ok(guest_warp(&house, -1, &error), "warp", &error);
    return guest_picture(&house);
}

static bool differ(const float *a, const float *b)
{
    return memcmp(a, b, 4 * sizeof *a * GUEST_SIZE * GUEST_SIZE) != 0;
}

static struct cupola_error refusal(const double eye_m[3], int expected)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_gl_set_eye(house.gl, eye_m, &error), expected);
    assert_int_equal(error.status, expected);
    assert_int_equal(cupola_gl_set_eye(house.gl, eye_m, NULL), expected);
    return error;
}

static int failures_told;

static void listen(int level, int id, const char *text, void *user)
{
    (void)user;
    (void)level;
    failures_told += id == CUPOLA_LOG_CALL_FAILED && strstr(text, "cupola_gl_set_eye");
}

static void an_eye_that_is_refused_changes_nothing(void **state)
{
    const struct cupola_gl_params params = {.log = {.write = listen}};
    const double outside[3] = {0.125, 0.0, 0.0}, nowhere[3] = {0.0, (double)NAN, 0.0};
    const double endless[3] = {0.0, 0.0, (double)INFINITY};
    (void)state;
    make(&params);
    check_at_least(guest_views(&house, NULL), 2);
    move_to(other_eye_m);
    float *before = warped();
    failures_told = 0;
    struct cupola_error error = refusal(outside, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, 0.125);
    check_message(&error, GUEST_HEAD_RADIUS_M);
    error = refusal(nowhere, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, (double)NAN);
    refusal(endless, CUPOLA_ERROR_ARGUMENT);
    refusal(NULL, CUPOLA_ERROR_ARGUMENT);
    check_at_least(cupola_gl_frame_begin(house.gl, NULL, NULL), 2);
    assert_int_equal(cupola_gl_view_begin(house.gl, 0, NULL, NULL), CUPOLA_OK);
    error = refusal(first_eye_m, CUPOLA_ERROR_ORDER);
    assert_non_null(strstr(error.message, "view"));
    assert_int_equal(cupola_gl_view_end(house.gl, NULL), CUPOLA_OK);
    assert_int_equal(failures_told, 10);
    assert_int_equal(cupola_gl_set_eye(NULL, first_eye_m, &error), CUPOLA_ERROR_ARGUMENT);
    check_at_least(guest_views(&house, NULL), 2);
    float *after = warped();
    assert_false(differ(before, after));
    move_to(first_eye_m); /* the control */
    float *moved = warped();
    assert_true(differ(before, moved));
    free(moved);
    free(after);
    free(before);
    cupola_gl_destroy(&house.gl);
}

static void without_a_head_radius_the_eye_stays(void **state)
{
    struct guest_house resting;
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    guest_house_build(&resting);
    check_ok(guest_gl_create(&resting, NULL, &error), "create", &error);
    const double *eye_m = cupola_dome_rig(resting.dome)->eye_m;
    assert_int_equal(cupola_gl_set_eye(resting.gl, eye_m, &error), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_eye(resting.gl, other_eye_m, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "head radius"));
    guest_house_release(&resting);
}

/* A gl is moved by itself: its plan is moved elsewhere and destroyed, to no effect. */
static void a_gl_has_a_plan_of_its_own(void **state)
{
    (void)state;
    for (int stage = 0; stage < STAGES; stage++) {
        const struct cupola_gl_params params = {.table =
                                                    guest_moving_table((enum cupola_table)stage)};
        struct guest_house own;
        struct cupola_error error = {CUPOLA_OK, ""};
        guest_house_build_moving(&own);
        make(&params);
        check_ok(guest_gl_create(&own, &params, &error), "create", &error);
        assert_int_equal(cupola_plan_set_eye(own.plan, first_eye_m, NULL), CUPOLA_OK);
        cupola_plan_destroy(&own.plan);
        check_at_least(guest_frame(&house, &error), 0);
        check_at_least(guest_frame(&own, &error), 0);
        float *expected = guest_picture(&house), *shown = guest_picture(&own);
        assert_false(differ(expected, shown));
        free(shown);
        free(expected);
        guest_house_release(&own);
        cupola_gl_destroy(&house.gl);
    }
}

/* All that is shown without views: pictures on the screen and far away, and what lies over them. */
static float *pictures_and_overlays(struct guest_house *shown, bool far)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    for (int i = 0; i < GUEST_PICTURES; i++) {
        shown->pictures[i].place = far ? CUPOLA_PLACE_INFINITY : CUPOLA_PLACE_SCREEN;
        check_ok(guest_warp(shown, i, &error), "warp", &error);
    }
    check_ok(guest_overlays(shown, &error), "overlays", &error);
    return guest_picture(shown);
}

/* Whether the pictures follow or stay, an overlay lies in its direction from the eye. */
static void pictures_and_overlays_follow(void **state)
{
    const struct cupola_gl_params params = {.overlays = true,
                                            .sources = 1u << CUPOLA_SOURCE_DOMEMASTER |
                                                       1u << CUPOLA_SOURCE_EQUIRECTANGULAR |
                                                       1u << CUPOLA_SOURCE_CUBE};
    (void)state;
    for (int far = 0; far < 2; far++) {
        struct guest_house rests;
        struct cupola_error error = {CUPOLA_OK, ""};
        guest_house_build(&rests);
        struct cupola_rig rig = *cupola_dome_rig(rests.dome);
        cupola_dome_destroy(&rests.dome);
        cupola_plan_destroy(&rests.plan);
        memcpy(rig.eye_m, other_eye_m, sizeof rig.eye_m);
        assert_int_equal(cupola_dome_create(&rig, &rests.dome, NULL), CUPOLA_OK);
        assert_int_equal(cupola_plan_create(rests.dome, NULL, &rests.plan, NULL), CUPOLA_OK);
        check_ok(guest_gl_create(&rests, &params, &error), "create", &error);
        make(&params);
        float *before = pictures_and_overlays(&house, far);
        move_to(other_eye_m);
        float *moved = pictures_and_overlays(&house, far);
        float *expected = pictures_and_overlays(&rests, far);
        assert_false(differ(expected, moved));
        assert_true(differ(before, moved)); /* the control */
        free(expected);
        free(moved);
        free(before);
        cupola_gl_destroy(&house.gl);
        guest_house_release(&rests);
    }
}

static void set_gain(GLuint gain)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    check_ok(cupola_gl_set_gain(house.gl, 0, gain, &error), "gain", &error);
}

/* Whether its programs were made before the move or after it, and with none in between. */
static void a_warp_with_gain_follows_too(void **state)
{
    (void)state;
    for (int stage = 0; stage < STAGES; stage++) {
        const struct cupola_gl_params params = {.table =
                                                    guest_moving_table((enum cupola_table)stage)};
        struct cupola_error error = {CUPOLA_OK, ""};
        make(&params);
        move_to(other_eye_m);
        check_ok(guest_views(&house, &error), "views", &error);
        set_gain(house.gain);
        float *expected = warped();
        cupola_gl_destroy(&house.gl);
        make(&params);
        set_gain(house.gain);
        check_ok(guest_views(&house, &error), "views", &error);
        float *before = warped();
        set_gain(0);
        move_to(other_eye_m);
        free(warped());
        set_gain(house.gain);
        float *shown = warped();
        assert_false(differ(expected, shown));
        assert_true(differ(before, shown)); /* the control */
        free(shown);
        free(before);
        free(expected);
        cupola_gl_destroy(&house.gl);
    }
}

static void moving_makes_no_gl_call(void **state)
{
    const struct cupola_gl_params params = {.table = CUPOLA_TABLE_TILES};
    (void)state;
    make(&params);
    interposed_begin();
    move_to(other_eye_m);
    int called = interposed.called;
    interposed_end();
    assert_int_equal(called, 1); /* by check_ok */
    cupola_gl_destroy(&house.gl);
}

/* The state in which a host finds itself after the warp that follows, and the picture. */
static void check_hosts(const struct cupola_gl_params *params, const float *expected)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    for (int which = -1; which <= HOSTILITIES; which++) {
        struct snapshot before, after;
        unsigned int map = 0;
        be_hostile(which);
        snapshot_take(&before);
        check_ok(guest_move(&house, &error), "set_eye", &error);
        check_ok(guest_warp(&house, -1, &error), "warp", &error);
        check_ok(cupola_gl_density(house.gl, 0, &map, &error), "density", &error);
        snapshot_take(&after);
        if (!params->leaves_state)
            assert_int_equal(snapshot_differences(&before, &after, true, "moved warp"), 0);
        state_reset();
        float *shown = guest_picture(&house);
        if (differ(expected, shown))
            fail_msg("another picture after '%s'", which < 0 ? "nothing"
                                                   : which == HOSTILITIES
                                                       ? "everything"
                                                       : hostilities[which].name);
        free(shown);
    }
}

static void what_follows_heeds_no_state_and_keeps_it(void **state)
{
    (void)state;
    for (int stage = 0; stage < STAGES; stage++) {
        struct cupola_gl_params params = {.table = guest_moving_table((enum cupola_table)stage)};
        struct cupola_error error = {CUPOLA_OK, ""};
        for (int leaves = 0; leaves < 2; leaves++) {
            params.leaves_state = leaves;
            make(&params);
            check_ok(guest_move(&house, &error), "set_eye", &error);
            check_ok(guest_views(&house, &error), "views", &error);
            state_reset();
            float *expected = warped();
            state_reset();
            check_hosts(&params, expected);
            free(expected);
            cupola_gl_destroy(&house.gl);
        }
    }
}

/* Where a GL cannot draw the tables that depend on the eye, it is said at once. */
static void tables_that_cannot_follow_are_refused(void **state)
{
    (void)state;
    for (int stage = 0; stage < STAGES; stage++) {
        const struct cupola_gl_params params = {.table = (enum cupola_table)stage};
        struct cupola_error error = {CUPOLA_OK, ""};
        int status = guest_gl_create(&house, &params, &error);
        if (guest_moving_table(params.table) == params.table) {
            check_ok(status, "create", &error);
        } else {
            assert_int_equal(status, CUPOLA_ERROR_GL);
            assert_non_null(strstr(error.message, cupola_table_name(stage)));
            check_message(&error, GUEST_HEAD_RADIUS_M);
        }
        cupola_gl_destroy(&house.gl);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_eye_that_is_refused_changes_nothing),
        cmocka_unit_test(without_a_head_radius_the_eye_stays),
        cmocka_unit_test(a_gl_has_a_plan_of_its_own),
        cmocka_unit_test(pictures_and_overlays_follow),
        cmocka_unit_test(a_warp_with_gain_follows_too),
        cmocka_unit_test(moving_makes_no_gl_call),
        cmocka_unit_test(what_follows_heeds_no_state_and_keeps_it),
        cmocka_unit_test(tables_that_cannot_follow_are_refused),
    };
    return cmocka_run_group_tests_name("eye_manners", tests, open_moving, close_house);
}
