/* What marks are called on the screen: no two look alike. */
#include "tool/marks_walk.h"
#include "tool_fixture.h"

/* Summer in French, and the right in Japanese. */
#define ETE   "\xc3\xa9t\xc3\xa9"
#define RIGHT "\xe5\x8f\xb3\xe5\x81\xb4"

static void open_with_names(struct tool *tool, int count, const char *const *names)
{
    uint64_t seed = 7;
    struct marks marks = random_marks(&seed, count);
    struct cupola_rig rig;
    char message[MESSAGE_SIZE];

    for (int i = 0; i < count; i++) {
        snprintf(marks.list[i].name, sizeof marks.list[i].name, "%s", names[i]);
        marks.list[i].steered = false;
    }
    assert_int_equal(cupola_rig_preset("visionstation", &rig, NULL), CUPOLA_OK);
    assert_true(tool_open(tool, &rig, 0, &marks, "rig.cfg", "marks-steered.csv", message));
    tool_key(tool, GLFW_KEY_M, 0);
}

static void check_labels(int count, const char *const *names, const char *const *labels)
{
    char label[MARK_NAME_MAX + 1];
    struct tool tool;

    open_with_names(&tool, count, names);
    for (int i = 0; i < count; i++) {
        marks_walk_label(&tool, i, label);
        assert_string_equal(label, labels[i]);
    }
    tool_close(&tool);
}

static void names_that_cannot_be_drawn_are_numbers(void **state)
{
    static const char *const names[] = {ETE, RIGHT, "why?"};
    static const char *const labels[] = {"ete", "mark 2", "why?"};
    struct tool tool;
    char text[100];

    (void)state;
    check_labels(3, names, labels);
    open_with_names(&tool, 3, names);
    tool_key(&tool, GLFW_KEY_PAGE_UP, 0);
    parameter_text(&tool, PARAMETER_MARK, text, sizeof text);
    assert_string_equal(text, "2 of 3: mark 2");
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    assert_non_null(strstr(tool.notice, "mark 2 is at"));
    assert_non_null(strstr(tool.notice, "next why?"));
    tool_close(&tool);
}

static void such_a_number_is_no_other_marks_name(void **state)
{
    static const char *const names[] = {RIGHT,     "mark 1",        "mark 2",
                                        RIGHT "!", "m\xc3\xa4rk 4", "mark 4 (2)"};
    static const char *const labels[] = {"mark 1 (2)", "mark 1", "mark 2",
                                         "mark 4 (3)", "mark 4", "mark 4 (2)"};

    (void)state;
    check_labels(6, names, labels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_that_cannot_be_drawn_are_numbers),
        cmocka_unit_test(such_a_number_is_no_other_marks_name),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
