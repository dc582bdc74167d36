/* What the library tells a host that listens: each id where it belongs, and nothing in a frame. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"

enum { IDS = 500, LEVELS = 4 };

static struct guest_house house;

/* A listener's memory. */
struct heard {
    int levels[LEVELS], ids[IDS];
    char last[IDS][1200];
};

static struct heard heard;

static void listen(int level, int id, const char *text, void *user)
{
    struct heard *mine = user;
    assert_true(level >= 0 && level < LEVELS && id >= 0 && id < IDS);
    assert_int_equal(level, id / 100 - 1); /* ids come in hundreds by level */
    assert_null(strchr(text, '\n'));
    mine->levels[level]++;
    mine->ids[id]++;
    snprintf(mine->last[id], sizeof mine->last[id], "%s", text);
}

static int open_house(void **state)
{
    (void)state;
    context_open();
    guest_house_build(&house);
    return 0;
}

static int close_house(void **state)
{
    (void)state;
    guest_house_release(&house);
    context_close();
    return 0;
}

static struct cupola_gl_params listening(int most)
{
    heard = (struct heard){{0}, {0}, {""}};
    return (struct cupola_gl_params){.log = {listen, &heard, most}};
}

static void make(const struct cupola_gl_params *params)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (guest_gl_create(&house, params, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
}

static void check_told(int id, const char *word)
{
    if (heard.ids[id] == 0 || !strstr(heard.last[id], word))
        fail_msg("id %d, '%s', does not say '%s'", id, heard.last[id], word);
}

static void what_is_made_is_told(void **state)
{
    struct cupola_gl_params params = listening(CUPOLA_LOG_DEBUG);
    (void)state;
    make(&params);
    check_told(CUPOLA_LOG_CREATED, (const char *)glGetString(GL_RENDERER));
    check_told(CUPOLA_LOG_CREATED, (const char *)glGetString(GL_VERSION));
    check_told(CUPOLA_LOG_CREATED, "RGBA8");
    check_told(CUPOLA_LOG_CREATED, "table points");
    check_told(CUPOLA_LOG_FEATURES, "is used");
    check_told(CUPOLA_LOG_PROGRAM, "of output 0");
    check_told(CUPOLA_LOG_TEXTURE, "32 px");
    check_at_least(heard.ids[CUPOLA_LOG_PROGRAM], 4);
    check_at_least(heard.ids[CUPOLA_LOG_TEXTURE], 3);
    assert_int_equal(heard.levels[CUPOLA_LOG_ERROR], 0);
    assert_int_equal(heard.ids[CUPOLA_LOG_TABLE_ON_CPU],
                     context_is_es() && !context_has(33, NULL, 32, "GL_EXT_color_buffer_float"));
    cupola_gl_destroy(&house.gl);
    assert_int_equal(heard.ids[CUPOLA_LOG_DESTROYED], 1);
}

static void levels_above_the_highest_are_not_told(void **state)
{
    (void)state;
    for (int most = CUPOLA_LOG_ERROR; most <= CUPOLA_LOG_DEBUG; most++) {
        struct cupola_gl_params params = listening(most);
        make(&params);
        cupola_gl_warp(house.gl, 9, NULL, NULL, NULL);
        cupola_gl_destroy(&house.gl);
        for (int level = most + 1; level < LEVELS; level++)
            assert_int_equal(heard.levels[level], 0);
        assert_int_equal(heard.levels[CUPOLA_LOG_ERROR], 1);
        assert_int_equal(heard.levels[CUPOLA_LOG_INFO] > 0, most >= CUPOLA_LOG_INFO);
    }
}

static void failures_are_told_as_the_error_says(void **state)
{
    struct cupola_gl_params params = listening(CUPOLA_LOG_ERROR);
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned int points;
    (void)state;
    make(&params);
    assert_int_equal(cupola_gl_warp(house.gl, 7, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    check_told(CUPOLA_LOG_CALL_FAILED, error.message);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_warp: output is 7");
    cupola_gl_view_begin(house.gl, 0, NULL, NULL);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_view_begin: ");
    cupola_gl_view_end(house.gl, NULL);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_view_end: ");
    cupola_gl_points(house.gl, -1, &points, NULL);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_points: ");
    cupola_gl_set_gain(house.gl, 0, 4321, NULL);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_set_gain: ");
    cupola_gl_views_import(house.gl, NULL, NULL);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_views_import: ");
    cupola_gl_frame_begin(house.gl, &(struct cupola_frame){.depth = {.near_distance = -1}}, NULL);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_frame_begin: ");
    assert_int_equal(heard.ids[CUPOLA_LOG_CALL_FAILED], 7);
    cupola_gl_destroy(&house.gl);
}

static void creation_that_fails_is_told(void **state)
{
    struct cupola_gl_params params = listening(CUPOLA_LOG_ERROR);
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    params.format = (enum cupola_format)77;
    assert_int_equal(guest_gl_create(&house, &params, NULL), CUPOLA_ERROR_ARGUMENT);
    check_told(CUPOLA_LOG_CALL_FAILED, "cupola_gl_create: format is 77");
    for (int most = -1; most <= LEVELS; most += LEVELS + 1) {
        params = listening(most);
        assert_int_equal(guest_gl_create(&house, &params, &error), CUPOLA_ERROR_ARGUMENT);
        check_told(CUPOLA_LOG_CALL_FAILED, "highest level is");
        check_told(CUPOLA_LOG_CALL_FAILED, error.message);
    }
    assert_null(house.gl);
}

static void errors_of_the_hosts_that_are_dropped_are_told(void **state)
{
    struct cupola_gl_params params = listening(CUPOLA_LOG_WARNING);
    unsigned int points;
    (void)state;
    params.table = CUPOLA_TABLE_NONE;
    glEnable(0xffff);
    make(&params);
    assert_int_equal(heard.ids[CUPOLA_LOG_ERRORS_DROPPED], 1);
    check_told(CUPOLA_LOG_ERRORS_DROPPED, "0x500");
    glEnable(0xffff);
    assert_int_equal(cupola_gl_points(house.gl, 0, &points, NULL), CUPOLA_OK);
    assert_int_equal(heard.ids[CUPOLA_LOG_ERRORS_DROPPED], 2);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    cupola_gl_destroy(&house.gl);
}

static void views_that_nobody_drew_are_told_once_and_frames_never(void **state)
{
    struct cupola_gl_params params = listening(CUPOLA_LOG_DEBUG);
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    make(&params);
    for (int i = 0; i < 3; i++)
        assert_int_equal(guest_warp(&house, -1, NULL), CUPOLA_OK);
    assert_int_equal(heard.ids[CUPOLA_LOG_NOT_DRAWN], 1);
    heard = (struct heard){{0}, {0}, {""}};
    for (int i = 0; i < 5; i++)
        if (guest_frame(&house, &error) < 0)
            fail_msg("%s", error.message);
    for (int level = 0; level < LEVELS; level++)
        assert_int_equal(heard.levels[level], 0);
    cupola_gl_destroy(&house.gl);
    params = listening(CUPOLA_LOG_DEBUG);
    make(&params); /* the control: drawn first, nothing is told */
    assert_true(guest_frame(&house, NULL) >= 0);
    assert_int_equal(heard.ids[CUPOLA_LOG_NOT_DRAWN], 0);
    cupola_gl_destroy(&house.gl);
}

static void levels_have_names(void **state)
{
    static const char *const names[LEVELS] = {"error", "warning", "info", "debug"};
    (void)state;
    for (int level = 0; level < LEVELS; level++)
        assert_string_equal(cupola_log_level_name(level), names[level]);
    assert_null(cupola_log_level_name(-1));
    assert_null(cupola_log_level_name(LEVELS));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_made_is_told),
        cmocka_unit_test(levels_above_the_highest_are_not_told),
        cmocka_unit_test(failures_are_told_as_the_error_says),
        cmocka_unit_test(creation_that_fails_is_told),
        cmocka_unit_test(errors_of_the_hosts_that_are_dropped_are_told),
        cmocka_unit_test(views_that_nobody_drew_are_told_once_and_frames_never),
        cmocka_unit_test(levels_have_names),
    };
    return cmocka_run_group_tests_name("log", tests, open_house, close_house);
}
