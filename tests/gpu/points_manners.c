/*
 * The point table without views as a guest: hostile hosts, failures, lost contexts, nothing left
 * behind.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "host_objects.h"
#include "interposed.h"
#include "live_objects.h"
#include "message.h"
#include "table_bits.h"

enum { SIZE = 48, WIDER = 56, NAMES = 512, CALLS = 3 };

static cupola_dome *dome, *other; /* of another size, lens and cap */

static cupola_dome *dome_of(struct cupola_rig rig)
{
    cupola_dome *made = NULL;
    assert_int_equal(cupola_dome_create(&rig, &made, NULL), CUPOLA_OK);
    return made;
}

static int setup(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    (void)state;
    context_open();
    state_reset();
    objects_create();
    state_reset();
    dome = dome_of(rig);
    rig.outputs[0].width_px = WIDER;
    rig.outputs[0].lens.model = CUPOLA_LENS_EQUISOLID;
    rig.screen.cap_rad = radians(60.0);
    other = dome_of(rig);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    cupola_dome_destroy(&dome);
    cupola_dome_destroy(&other);
    objects_release();
    context_close();
    return 0;
}

static cupola_points *points_made(void)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_points *points = NULL;
    if (cupola_points_create(dome, 0, &points, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    return points;
}

static bool same_table(const float *a, const float *b, int width)
{
    return memcmp(a, b, 4 * sizeof *a * (size_t)(width * SIZE)) == 0;
}

/* Its table before, made by a calm host, is what it has now. */
static void check_table(const cupola_points *points, const float *expected, int width,
                        const char *what)
{
    float *now = table_bits(cupola_points_texture(points), width, SIZE);
    if (!same_table(now, expected, width))
        fail_msg("%s: another table", what);
    free(now);
}

static bool hostility_exists(const struct hostility *hostility)
{
    return context_has(hostility->gl, hostility->gl_extension, hostility->es,
                       hostility->es_extension);
}

/* One in a row: creation, a dome of another size, the end; how much of the state was not clean. */
static int call_in_hostile_state(int call, const struct hostility *hostility,
                                 cupola_points **points, const struct snapshot *clean)
{
    struct snapshot before, after;
    int status = CUPOLA_OK;
    state_reset();
    hostility->set();
    while (glGetError() != GL_NO_ERROR)
        ;
    snapshot_take(&before);
    if (call == 0)
        status = cupola_points_create(dome, 0, points, NULL);
    else if (call == 1)
        status = cupola_points_set_dome(*points, other, 0, NULL);
    else
        cupola_points_destroy(points);
    GLenum failure = glGetError();
    snapshot_take(&after);
    if (status != CUPOLA_OK || failure != GL_NO_ERROR)
        fail_msg("%s, call %d: status %d, error 0x%x", hostility->name, call, status, failure);
    assert_int_equal(snapshot_differences(&before, &after, true, hostility->name), 0);
    state_reset();
    return snapshot_differences(clean, &before, true, NULL);
}

static void hostile_hosts_keep_their_state_and_get_the_same_table(void **state)
{
    struct snapshot clean;
    cupola_points *points = points_made();
    float *first = table_bits(cupola_points_texture(points), SIZE, SIZE);
    assert_int_equal(cupola_points_set_dome(points, other, 0, NULL), CUPOLA_OK);
    float *second = table_bits(cupola_points_texture(points), WIDER, SIZE);
    cupola_points_destroy(&points);
    (void)state;
    state_reset();
    snapshot_take(&clean);
    int tried = 0;
    for (int i = 0; i < HOSTILITIES; i++) {
        if (!hostility_exists(&hostilities[i]))
            continue;
        for (int call = 0; call < CALLS; call++) {
            check_at_least(call_in_hostile_state(call, &hostilities[i], &points, &clean), 1);
            if (points)
                check_table(points, call == 0 ? first : second, call == 0 ? SIZE : WIDER,
                            hostilities[i].name);
        }
        tried++;
    }
    check_at_least(tried, context_is_es() ? 24 : 34);
    free(first);
    free(second);
}

static void what_cannot_be_is_refused_and_changes_nothing(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    int objects = live_objects(NAMES);
    cupola_points *points = points_made(), *none = NULL;
    unsigned int texture = cupola_points_texture(points);
    float *before = table_bits(texture, SIZE, SIZE);
    GLint largest = 0;
    (void)state;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    for (int output = -1; output < 2; output += 2) {
        check_refused_saying(cupola_points_create(dome, output, &none, &error),
                             CUPOLA_ERROR_ARGUMENT, &error, "allowed: 0 to 0");
        check_refused_saying(cupola_points_set_dome(points, other, output, &error),
                             CUPOLA_ERROR_ARGUMENT, &error, "allowed: 0 to 0");
    }
    check_refused_saying(cupola_points_create(NULL, 0, &none, &error), CUPOLA_ERROR_ARGUMENT,
                         &error, "dome is NULL");
    check_refused_saying(cupola_points_create(dome, 0, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
                         "points is NULL");
    check_refused_saying(cupola_points_set_dome(points, NULL, 0, &error), CUPOLA_ERROR_ARGUMENT,
                         &error, "dome is NULL");
    check_refused_saying(cupola_points_set_dome(NULL, dome, 0, &error), CUPOLA_ERROR_ARGUMENT,
                         &error, "points is NULL");
    assert_int_equal(cupola_points_set_dome(points, NULL, 0, NULL), CUPOLA_ERROR_ARGUMENT);
    if (largest < 32768) {
        struct cupola_rig rig = *cupola_dome_rig(dome);
        rig.outputs[0].width_px = 32768;
        cupola_dome *wide = dome_of(rig);
        check_refused_saying(cupola_points_create(wide, 0, &none, &error), CUPOLA_ERROR_ARGUMENT,
                             &error, "32768");
        check_refused_saying(cupola_points_set_dome(points, wide, 0, &error), CUPOLA_ERROR_ARGUMENT,
                             &error, "allowed by this GL");
        cupola_dome_destroy(&wide);
    }
    assert_null(none);
    assert_int_equal(cupola_points_texture(points), texture);
    check_table(points, before, SIZE, "refused");
    free(before);
    cupola_points_destroy(&points);
    cupola_points_destroy(&points);
    cupola_points_destroy(NULL);
    assert_int_equal(live_objects(NAMES), objects);
    assert_int_equal(cupola_points_texture(NULL), 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* The GL fails at the n-th thing that a dome of another size and lens needs. */
static void a_gl_that_fails_leaves_the_table_as_it_was(void **state)
{
    int failures = 0;
    cupola_points *points = points_made();
    unsigned int texture = cupola_points_texture(points);
    float *before = table_bits(texture, SIZE, SIZE);
    int objects = live_objects(NAMES);
    (void)state;
    for (;;) {
        struct cupola_error error = {CUPOLA_OK, ""};
        interposed_begin();
        interposed.to_go = failures + 1;
        int status = cupola_points_set_dome(points, other, 0, &error);
        bool reached = interposed.to_go == 0;
        int expected = interposed.out_of_memory ? CUPOLA_ERROR_MEMORY : CUPOLA_ERROR_GL;
        interposed_end();
        assert_int_equal(glGetError(), GL_NO_ERROR);
        if (!reached) {
            assert_int_equal(status, CUPOLA_OK);
            break;
        }
        check_refused_saying(status, expected, &error, "");
        assert_int_equal(cupola_points_texture(points), texture);
        assert_int_equal(live_objects(NAMES), objects);
        check_table(points, before, SIZE, error.message);
        failures++;
    }
    printf("  %d failures\n", failures);
    check_at_least(failures, context_has_floats() ? 8 : 2);
    assert_int_not_equal(cupola_points_texture(points), texture);
    free(before);
    cupola_points_destroy(&points);
}

static void a_context_that_is_lost_is_told_and_left_alone(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_points *none = NULL;
    (void)state;
    if (!context_has(45, "GL_KHR_robustness", 32, "GL_KHR_robustness") &&
        !context_has(99, "GL_ARB_robustness", 99, "GL_EXT_robustness"))
        skip();
    for (int n = 0; n < 4; n++) {
        interposed_begin();
        interposed.robust = true;
        cupola_points *points = points_made();
        interposed.lose_in = n * n * 7; /* at once, or in the middle of the call */
        interposed.lost = n == 0;
        int status = cupola_points_set_dome(points, other, 0, &error);
        if (status != CUPOLA_OK)
            check_refused_saying(status, CUPOLA_ERROR_LOST, &error, "lost");
        if (n == 0)
            check_refused_saying(cupola_points_create(dome, 0, &none, &error), CUPOLA_ERROR_LOST,
                                 &error, "lost");
        interposed.lost = true;
        check_refused_saying(cupola_points_set_dome(points, dome, 0, &error), CUPOLA_ERROR_LOST,
                             &error, "lost");
        int called = interposed.called;
        check_refused_saying(cupola_points_set_dome(points, dome, 0, &error), CUPOLA_ERROR_LOST,
                             &error, "lost");
        cupola_points_destroy(&points);
        assert_null(points);
        assert_int_equal(interposed.called, called);
        interposed_end();
    }
    assert_null(none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hostile_hosts_keep_their_state_and_get_the_same_table),
        cmocka_unit_test(what_cannot_be_is_refused_and_changes_nothing),
        cmocka_unit_test(a_gl_that_fails_leaves_the_table_as_it_was),
        cmocka_unit_test(a_context_that_is_lost_is_told_and_left_alone),
    };
    return cmocka_run_group_tests_name("points_manners", tests, setup, teardown);
}
