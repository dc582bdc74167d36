/*
 * Debug groups and labels: a debugger sees every phase by its name, what the host draws into a view
 * inside of the view's, and a stack of groups that is as it was after each call.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"

enum { EVENTS_MAX = 200, NAME_MAX_CHARS = 80, GROUPS_MAX = 1024 };

/* What a debugger heard: "NAME" where a group begins, "/NAME" where it ends. */
static char events[EVENTS_MAX][NAME_MAX_CHARS];
static int event_count;
static struct guest_house house;

static void hear(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                 const GLchar *message, const void *user)
{
    (void)id;
    (void)severity;
    (void)length;
    (void)user;
    bool ends = type == GL_DEBUG_TYPE_POP_GROUP, begins = type == GL_DEBUG_TYPE_PUSH_GROUP;
    if ((!ends && !begins) || event_count >= EVENTS_MAX)
        return;
    if (source != GL_DEBUG_SOURCE_THIRD_PARTY && source != GL_DEBUG_SOURCE_APPLICATION)
        return;
    snprintf(events[event_count++], NAME_MAX_CHARS, "%s%s", ends ? "/" : "", message);
}

static bool debug_is_core(void)
{
    return context_has(43, "GL_KHR_debug", 32, NULL);
}

static bool debug_is_there(void)
{
    return context_has(43, "GL_KHR_debug", 32, "GL_KHR_debug");
}

static void push(const char *name)
{
    if (debug_is_core())
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    else
        glPushDebugGroupKHR(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

static void pop(void)
{
    if (debug_is_core())
        glPopDebugGroup();
    else
        glPopDebugGroupKHR();
}

static int depth(void)
{
    GLint groups = 0;
    glGetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &groups);
    return groups;
}

static int open_house(void **state)
{
    (void)state;
    context_open();
    guest_house_build(&house);
    if (!debug_is_there())
        return 0;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    if (debug_is_core())
        glDebugMessageCallback(hear, NULL);
    else
        glDebugMessageCallbackKHR(hear, NULL);
    return 0;
}

static int close_house(void **state)
{
    (void)state;
    guest_house_release(&house);
    context_close();
    return 0;
}

static void make_all(bool leaves_state)
{
    const struct cupola_gl_params params = {.table = CUPOLA_TABLE_SINES,
                                            .leaves_state = leaves_state};
    struct cupola_error error = {CUPOLA_OK, ""};
    if (guest_gl_create(&house, &params, &error) != CUPOLA_OK ||
        cupola_theatre_create(house.dome, &house.theatre, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
}

static void work(void)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned int points = 0;
    if (guest_frame(&house, &error) < 0 || cupola_gl_points(house.gl, 0, &points, &error) < 0 ||
        cupola_gl_set_gain(house.gl, 0, house.gain, &error) < 0 ||
        guest_theatre(&house, &error) < 0)
        fail_msg("%s", error.message);
    free(guest_picture(&house));
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void destroy_all(void)
{
    cupola_gl_destroy(&house.gl);
    cupola_theatre_destroy(&house.theatre);
}

/* Each end is that of the group that began last. */
static int check_nesting(void)
{
    const char *open[GROUPS_MAX];
    int count = 0, deepest = 0;
    for (int i = 0; i < event_count; i++) {
        if (events[i][0] != '/') {
            open[count++] = events[i];
            deepest = count > deepest ? count : deepest;
            continue;
        }
        check_at_least(count, 1);
        assert_string_equal(open[--count], events[i] + 1);
    }
    assert_int_equal(count, 0);
    return deepest;
}

static bool heard(const char *name)
{
    for (int i = 0; i < event_count; i++)
        if (strcmp(events[i], name) == 0)
            return true;
    return false;
}

static void every_phase_is_a_group(void **state)
{
    static const char *const names[] = {
        "Cupola create",
        "Cupola table sines of output 0",
        "Cupola view 0",
        "Cupola view 1",
        "Cupola warp of output 0",
        "Cupola overlays of output 0",
        "Cupola points of output 0",
        "Cupola table points of output 0",
        "Cupola gain of output 0",
        "Cupola theatre",
        "Cupola capture",
    };
    (void)state;
    if (!debug_is_there())
        skip();
    event_count = 0;
    make_all(false);
    work();
    destroy_all();
    printf("  %d groups\n", event_count / 2);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (!heard(names[i]))
            fail_msg("no group '%s'", names[i]);
    assert_int_equal(heard("Cupola pass"), cupola_pass_way(NULL) > 0);
    assert_int_equal(check_nesting(), 2);
    assert_int_equal(depth(), 1);
}

/* In the warp's own. */
static void a_table_that_follows_the_eye_is_a_group(void **state)
{
    static const char *const expected[] = {
        "Cupola warp of output 0", "Cupola table sines of output 0",
        "/Cupola table sines of output 0", "/Cupola warp of output 0"};
    const struct cupola_gl_params params = {.table = CUPOLA_TABLE_SINES};
    struct guest_house moving;
    (void)state;
    if (!debug_is_there() || !context_has_floats())
        skip();
    guest_house_build_moving(&moving);
    assert_int_equal(guest_gl_create(&moving, &params, NULL), CUPOLA_OK);
    event_count = 0;
    assert_int_equal(guest_move(&moving, NULL), CUPOLA_OK);
    assert_int_equal(event_count, 0);
    assert_int_equal(guest_warp(&moving, -1, NULL), CUPOLA_OK);
    assert_int_equal(guest_warp(&moving, -1, NULL), CUPOLA_OK);
    assert_int_equal(event_count, 6);
    for (int i = 0; i < 4; i++)
        assert_string_equal(events[i], expected[i]);
    guest_house_release(&moving);
}

static void what_the_host_draws_is_in_the_views_group(void **state)
{
    static const char *const expected[] = {"Cupola view 0", "ship", "/ship", "/Cupola view 0"};
    (void)state;
    if (!debug_is_there())
        skip();
    make_all(false);
    event_count = 0;
    check_at_least(cupola_gl_frame_begin(house.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_view_begin(house.gl, 0, NULL, NULL), CUPOLA_OK);
    push("ship");
    pop();
    assert_int_equal(cupola_gl_view_end(house.gl, NULL), CUPOLA_OK);
    assert_int_equal(event_count, 4);
    for (int i = 0; i < 4; i++)
        assert_string_equal(events[i], expected[i]);
    /* Destroyed in a view: that ends, too. */
    assert_int_equal(cupola_gl_view_begin(house.gl, 1, NULL, NULL), CUPOLA_OK);
    destroy_all();
    assert_int_equal(depth(), 1);
    check_nesting();
}

/* At each depth, up to a stack that has no room. */
static void a_full_stack_is_left_alone(void **state)
{
    GLint most = 0;
    (void)state;
    if (!debug_is_there())
        skip();
    glGetIntegerv(GL_MAX_DEBUG_GROUP_STACK_DEPTH, &most);
    check_at_most(most, GROUPS_MAX);
    while (depth() < most - 2)
        push("host");
    for (int room = 2; room >= 0; room--) {
        event_count = 0;
        make_all(false);
        work();
        destroy_all();
        assert_int_equal(depth(), most - room);
        assert_int_equal(event_count > 0 ? check_nesting() : 0, room);
        if (room > 0)
            push("host");
    }
    push("one too many"); /* the control: it is full */
    assert_int_equal(glGetError(), GL_STACK_OVERFLOW);
    while (depth() > 1)
        pop();
}

static void frames_that_leave_the_state_have_none_unless_debugged(void **state)
{
    GLint flags = 0;
    (void)state;
    if (!debug_is_core() || context_is_es())
        skip();
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    make_all(true);
    event_count = 0;
    assert_int_equal(guest_warp(&house, 0, NULL), CUPOLA_OK);
    assert_int_equal(event_count, flags & GL_CONTEXT_FLAG_DEBUG_BIT ? 2 : 0);
    destroy_all();
}

static void objects_have_labels(void **state)
{
    char label[NAME_MAX_CHARS] = "";
    (void)state;
    if (!debug_is_there())
        skip();
    make_all(false);
    if (debug_is_core())
        glGetObjectLabel(GL_TEXTURE, cupola_gl_atlas(house.gl), sizeof label, NULL, label);
    else
        glGetObjectLabelKHR(GL_TEXTURE, cupola_gl_atlas(house.gl), sizeof label, NULL, label);
    assert_memory_equal(label, "Cupola views", 12);
    destroy_all();
}

/* libepoxy ends the process where one of their functions is called without being there. */
static void contexts_without_groups_do_as_well(void **state)
{
    (void)state;
    if (debug_is_there())
        skip();
    make_all(false);
    work();
    destroy_all();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_phase_is_a_group),
        cmocka_unit_test(a_table_that_follows_the_eye_is_a_group),
        cmocka_unit_test(what_the_host_draws_is_in_the_views_group),
        cmocka_unit_test(a_full_stack_is_left_alone),
        cmocka_unit_test(frames_that_leave_the_state_have_none_unless_debugged),
        cmocka_unit_test(objects_have_labels),
        cmocka_unit_test(contexts_without_groups_do_as_well),
    };
    return cmocka_run_group_tests_name("debug_groups", tests, open_house, close_house);
}
