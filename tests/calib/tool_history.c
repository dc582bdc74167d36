/* History: what is one step, how many there may be, and what is lost. */
#include <sys/resource.h>
#include <sys/wait.h>

#include "tool_fixture.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED true
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define SANITIZED true
#endif
#if !defined(SANITIZED)
#define SANITIZED false
#endif

static void open_plain(struct tool *tool)
{
    struct cupola_rig rig = {0};
    char message[MESSAGE_SIZE];

    cupola_rig_complete(&rig, &rig, NULL);
    assert_true(tool_open(tool, &rig, 0, NULL, "rig.cfg", NULL, message));
    tool->group = GROUP_AIM;
}

static void a_key_held_down_is_one_step(void **state)
{
    struct tool tool;

    (void)state;
    open_plain(&tool);
    for (int i = 0; i < 30; i++) {
        tool.time_s += 0.03;
        tool_key_repeat(&tool, GLFW_KEY_RIGHT, 0);
    }
    check_near(parameter_get(&tool, PARAMETER_YAW), 3, 1e-9);
    assert_int_equal(history_undo_count(tool.history), 1);
    tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_YAW), 0, 0);
    tool_close(&tool);
}

static void a_pause_or_another_value_begins_a_step(void **state)
{
    struct tool tool;

    (void)state;
    open_plain(&tool);
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    tool.time_s += 1.5;
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    tool_key(&tool, GLFW_KEY_UP, 0);
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    assert_int_equal(history_undo_count(tool.history), 4);
    tool_close(&tool);
}

static void a_clock_that_runs_back_does_no_harm(void **state)
{
    struct tool tool;

    (void)state;
    open_plain(&tool);
    tool.time_s = 100;
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    tool.time_s = 50;
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    assert_int_equal(history_undo_count(tool.history), 2);
    tool_close(&tool);
}

static void after_undo_the_next_change_is_a_step_of_its_own(void **state)
{
    struct tool tool;

    (void)state;
    open_plain(&tool);
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    tool_key(&tool, GLFW_KEY_UP, 0);
    tool_undo(&tool);
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    assert_int_equal(history_undo_count(tool.history), 2);
    assert_int_equal(history_redo_count(tool.history), 0);
    tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_YAW), 0.1, 1e-12);
    tool_close(&tool);
}

static void a_change_that_changes_nothing_is_no_step(void **state)
{
    struct tool tool;

    (void)state;
    open_plain(&tool);
    assert_true(tool_set(&tool, PARAMETER_YAW, 0));
    assert_int_equal(history_undo_count(tool.history), 0);
    tool_close(&tool);
}

static const struct {
    enum parameter parameter;
    double value;
    const char *says;
} impossible[] = {
    {PARAMETER_PROJECTOR_X, 2, "inside of the screen"},
    {PARAMETER_VIEWER_Z, -1, "inside of the screen"},
    {PARAMETER_FOV, 0, "above 0"},
    {PARAMETER_FOV, 500, "360"},
    {PARAMETER_SCREEN_RADIUS, 0, "above 0"},
    {PARAMETER_CIRCLE_RADIUS, 0, "above 0"},
    {PARAMETER_CIRCLE_X, 1e6, "outside of the frame buffer"},
    {PARAMETER_CAP, 181, "180"},
    {PARAMETER_LENS, CUPOLA_LENS_TABLE, "samples"},
    {PARAMETER_LENS, 17, "a lens that exists"},
    {PARAMETER_FLIP, 1.5, "none, x, y, xy"},
    {PARAMETER_YAW, 361, "360"},
    {PARAMETER_YAW, (double)NAN, "finite"},
    {PARAMETER_DOT_SIZE, 91, "90"},
    {PARAMETER_CROSS_X, 1025, "0 to 1024"},
    {PARAMETER_MARK, 1, "no marks"},
};

static void an_impossible_value_changes_nothing_and_says_why(void **state)
{
    struct tool tool;
    struct values before, after;

    (void)state;
    open_plain(&tool);
    values_take(&tool, &before);
    for (size_t i = 0; i < sizeof impossible / sizeof *impossible; i++) {
        tool.warning[0] = '\0';
        assert_false(tool_set(&tool, impossible[i].parameter, impossible[i].value));
        if (!strstr(tool.warning, impossible[i].says))
            fail_msg("%s: '%s'", impossible[i].says, tool.warning);
        values_take(&tool, &after);
        assert_memory_equal(&before, &after, sizeof before);
    }
    assert_int_equal(history_undo_count(tool.history), 0);
    tool_key(&tool, GLFW_KEY_H, 0);
    assert_true(tool.warning[0]);
    tool_key(&tool, GLFW_KEY_RIGHT, 0);
    assert_false(tool.warning[0]);
    tool_close(&tool);
}

static void memory_is_bounded_and_the_newest_steps_stay(void **state)
{
    struct tool tool;
    int steps;

    (void)state;
    open_plain(&tool);
    for (int i = 1; i <= 3 * HISTORY_STEPS_MAX; i++) {
        tool.time_s += 2;
        assert_true(tool_set(&tool, PARAMETER_YAW, 1e-3 * i));
    }
    steps = history_undo_count(tool.history);
    check_at_most(steps, HISTORY_STEPS_MAX);
    check_at_least(steps, 0.9 * HISTORY_STEPS_MAX);
    for (int i = 0; i < steps; i++)
        tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_YAW), 1e-3 * (3 * HISTORY_STEPS_MAX - steps), 1e-9);
    tool_undo(&tool);
    assert_string_equal(tool.notice, "nothing to undo");
    tool_close(&tool);
}

static void without_memory_the_oldest_steps_are_forgotten(void **state)
{
    const struct rlimit none = {0, 0};
    struct tool tool;
    pid_t process;
    int status;

    (void)state;
    if (SANITIZED) /* it needs memory itself */
        skip();
    open_plain(&tool);
    process = fork();
    assert_true(process >= 0);
    if (process == 0) {
        bool good = setrlimit(RLIMIT_AS, &none) == 0;
        for (int i = 1; i <= 5000; i++) {
            tool.time_s += 2;
            good = good && tool_set(&tool, PARAMETER_YAW, 1e-2 * i);
        }
        status = history_undo_count(tool.history);
        tool_undo(&tool);
        good = good && status >= 20 && status < 5000;
        good = good && fabs(parameter_get(&tool, PARAMETER_YAW) - 49.99) < 1e-9;
        _exit(good ? 0 : 1);
    }
    assert_int_equal(waitpid(process, &status, 0), process);
    assert_int_equal(status, 0);
    tool_close(&tool);
}

static void the_next_lens_takes_a_field_of_view_that_it_can(void **state)
{
    struct tool tool;
    bool seen[CUPOLA_LENS_TABLE + 1] = {false};

    (void)state;
    open_plain(&tool);
    assert_true(tool_set(&tool, PARAMETER_FOV, 360));
    for (int i = 0; i < 5; i++) {
        tool_key(&tool, GLFW_KEY_L, 0);
        seen[tool.rig.outputs[0].lens.model] = true;
        check_possible(&tool);
    }
    /* A table that was not measured cannot be chosen. */
    for (int model = 0; model < CUPOLA_LENS_TABLE; model++)
        assert_true(seen[model]);
    assert_false(seen[CUPOLA_LENS_TABLE]);
    for (int i = 0; i < 5; i++)
        tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_FOV), 360, 0);
    assert_int_equal(tool.rig.outputs[0].lens.model, CUPOLA_LENS_ANGULAR);
    tool_close(&tool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_key_held_down_is_one_step),
        cmocka_unit_test(a_pause_or_another_value_begins_a_step),
        cmocka_unit_test(a_clock_that_runs_back_does_no_harm),
        cmocka_unit_test(after_undo_the_next_change_is_a_step_of_its_own),
        cmocka_unit_test(a_change_that_changes_nothing_is_no_step),
        cmocka_unit_test(an_impossible_value_changes_nothing_and_says_why),
        cmocka_unit_test(memory_is_bounded_and_the_newest_steps_stay),
        cmocka_unit_test(without_memory_the_oldest_steps_are_forgotten),
        cmocka_unit_test(the_next_lens_takes_a_field_of_view_that_it_can),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
