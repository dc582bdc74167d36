/* Keys: each of the table does something, none is there twice, names lead back to keys. */
#include "tool_fixture.h"

static void no_key_is_there_twice(void **state)
{
    (void)state;
    for (int i = 0; key_binding(i); i++) {
        const struct key_binding *binding = key_binding(i);
        for (int j = 0; j < i; j++) {
            const struct key_binding *other = key_binding(j);
            bool clash = binding->key == other->key &&
                         (binding->modifiers == other->modifiers ||
                          binding->modifiers == ANY_STEP || other->modifiers == ANY_STEP);
            assert_false(clash);
        }
        assert_ptr_equal(
            key_find(binding->key, binding->modifiers == ANY_STEP ? 0 : binding->modifiers),
            binding);
    }
}

static void values_of(const struct tool *tool, char text[4000])
{
    struct values values;
    size_t length = 0;

    values_take(tool, &values);
    for (int i = 0; i < PARAMETER_COUNT; i++)
        length += (size_t)snprintf(text + length, 4000 - length, "%.17g ", values.raw[i]);
    snprintf(text + length, 4000 - length, "%d %d %d %d %d %d %d %d %d %d %d %d %d %s %s",
             (int)tool->pattern, (int)tool->group, (int)tool->about, tool->shows_before,
             tool->shows_help, tool->shows_legend, tool->shows_labels, tool->text_on_dome,
             (int)tool->preview, tool->wants_picture, tool->wants_fullscreen, tool->ends,
             history_undo_count(tool->history), tool->notice, tool->warning);
}

static void every_key_does_something(void **state)
{
    (void)state;
    for (int i = 0; key_binding(i); i++) {
        const struct key_binding *binding = key_binding(i);
        uint64_t seed = 7;
        struct tool tool;
        char before[4000], after[4000];
        open_by_chance(&tool, &seed, "rig.cfg");
        tool_set(&tool, PARAMETER_YAW, 1);
        tool.pattern = PATTERN_DOT + (binding->argument == PATTERN_DOT ? -1 : 0);
        tool.group = GROUP_AIM;
        values_of(&tool, before);
        assert_true(
            tool_key(&tool, binding->key, binding->modifiers == ANY_STEP ? 0 : binding->modifiers));
        values_of(&tool, after);
        if (strcmp(before, after) == 0)
            fail_msg("key %d of the table changes nothing", i);
        tool_close(&tool);
    }
    unlink("rig.cfg");
}

static void arrows_change_the_three_values_of_each_group(void **state)
{
    static const int arrows[6] = {GLFW_KEY_RIGHT, GLFW_KEY_LEFT,    GLFW_KEY_UP,
                                  GLFW_KEY_DOWN,  GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN};
    uint64_t seed = 11;
    struct tool tool;

    (void)state;
    open_by_chance(&tool, &seed, "rig.cfg");
    tool.rig.outputs[tool.output].lens.model = CUPOLA_LENS_POLYNOMIAL;
    tool.rig.outputs[tool.output].lens.k[0] = 1;
    tool_set(&tool, PARAMETER_CROSS_X, 100);
    tool_set(&tool, PARAMETER_CROSS_Y, 100);
    for (int group = 0; group < GROUP_COUNT; group++) {
        for (int arrow = 0; arrow < 6; arrow++) {
            enum parameter parameter;
            double before, step;
            tool.group = (enum group)group;
            if (!tool_group_parameter(&tool, arrow / 2, &parameter) || parameter == PARAMETER_MARK)
                continue;
            before = parameter_get(&tool, parameter);
            /* That of coefficients grows with them. */
            step = parameter_step(&tool, parameter) * (arrow % 2 ? -1 : 1);
            tool_key(&tool, arrows[arrow], GLFW_MOD_SHIFT);
            check_near(parameter_get(&tool, parameter), before + 0.1 * step, 0.01 * fabs(step));
            tool_key(&tool, arrows[arrow], GLFW_MOD_CONTROL);
            check_near(parameter_get(&tool, parameter), before + 10.1 * step, 0.02 * fabs(step));
            tool_key(&tool, arrows[arrow], 0);
            check_near(parameter_get(&tool, parameter), before + 11.1 * step, 0.03 * fabs(step));
        }
    }
    tool_close(&tool);
}

static void names_lead_back_to_keys(void **state)
{
    static const struct {
        const char *name;
        int key, modifiers;
    } known[] = {
        {"Left", GLFW_KEY_LEFT, 0},
        {"pageup", GLFW_KEY_PAGE_UP, 0},
        {"a", GLFW_KEY_A, 0},
        {"8", GLFW_KEY_8, 0},
        {"F1", GLFW_KEY_F1, 0},
        {"F12", GLFW_KEY_F12, 0},
        {"ctrl+shift+Z", GLFW_KEY_Z, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT},
        {"Shift+Enter", GLFW_KEY_ENTER, GLFW_MOD_SHIFT},
    };
    static const char *const unknown[] = {"",      "F0", "F26", "F1x", "F123",  "Lef",
                                          "ctrl+", "AB", "+",   "!",   "alt+A", "\xc3\xa4"};
    int key, modifiers;

    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        assert_true(key_parse(known[i].name, &key, &modifiers));
        assert_int_equal(key, known[i].key);
        assert_int_equal(modifiers, known[i].modifiers);
    }
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++)
        assert_false(key_parse(unknown[i], &key, &modifiers));
}

static void the_help_has_every_key(void **state)
{
    struct key_line line;
    char all[4000] = "", text[40];

    (void)state;
    for (int i = 0; key_line(i, &line); i++) {
        assert_true(strlen(line.help) < 48);
        strcat(strcat(all, line.keys), ", ");
    }
    for (int i = 0; key_binding(i); i++)
        assert_non_null(strstr(all, key_text(key_binding(i), text)));
}

static void a_held_key_does_not_toggle(void **state)
{
    uint64_t seed = 3;
    struct tool tool;

    (void)state;
    open_by_chance(&tool, &seed, "rig.cfg");
    assert_true(tool_key_repeat(&tool, GLFW_KEY_H, 0));
    assert_false(tool.shows_help);
    tool.group = GROUP_AIM;
    tool_set(&tool, PARAMETER_YAW, 0);
    assert_true(tool_key_repeat(&tool, GLFW_KEY_RIGHT, 0));
    check_near(parameter_get(&tool, PARAMETER_YAW), 0.1, 1e-12);
    assert_false(tool_key_repeat(&tool, GLFW_KEY_HOME, 0));
    assert_false(tool_key(&tool, GLFW_KEY_A, GLFW_MOD_ALT));
    tool_close(&tool);
}

static void escape_asks_before_it_loses_anything(void **state)
{
    uint64_t seed = 3;
    struct tool tool;

    (void)state;
    open_by_chance(&tool, &seed, "rig.cfg");
    tool_key(&tool, GLFW_KEY_ESCAPE, 0);
    assert_true(tool.ends);
    tool.ends = false;
    tool_key(&tool, GLFW_KEY_X, 0);
    assert_true(tool.unsaved);
    tool_key(&tool, GLFW_KEY_ESCAPE, 0);
    assert_false(tool.ends);
    tool_key(&tool, GLFW_KEY_H, 0);
    tool_key(&tool, GLFW_KEY_ESCAPE, 0);
    assert_false(tool.ends);
    tool_key(&tool, GLFW_KEY_ESCAPE, 0);
    assert_true(tool.ends);
    tool_close(&tool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_key_is_there_twice),
        cmocka_unit_test(every_key_does_something),
        cmocka_unit_test(arrows_change_the_three_values_of_each_group),
        cmocka_unit_test(names_lead_back_to_keys),
        cmocka_unit_test(the_help_has_every_key),
        cmocka_unit_test(a_held_key_does_not_toggle),
        cmocka_unit_test(escape_asks_before_it_loses_anything),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
