/* Journals of long paths: whole as far as a system takes them, and none that is cut. */
#include "tool_fixture.h"

enum { SEED = 5 };

/* Every byte of it is one that a journal writes as three. */
static void open_with_path(struct tool *tool, size_t length)
{
    uint64_t seed = SEED;
    char message[MESSAGE_SIZE], *path = calloc(length + 1, 1);
    struct marks marks = random_marks(&seed, 5);
    struct cupola_rig rig = random_rig(&seed);

    assert_non_null(path);
    memset(path, ' ', length);
    unlink("rig.cfg.journal");
    assert_true(tool_open(tool, &rig, 0, &marks, "rig.cfg", path, message));
    assert_int_equal(journal_open(tool, false, message), JOURNAL_NEW);
    tool_set(tool, PARAMETER_YAW, 5);
    free(path);
}

static void forget(struct tool *tool)
{
    tool->unsaved = false;
    tool_close(tool);
}

static void the_longest_path_of_marks_comes_back_whole(void **state)
{
    struct cupola_rig rig;
    struct tool tool, other;
    char message[MESSAGE_SIZE];

    (void)state;
    open_with_path(&tool, 4095);
    assert_string_equal(tool.standing, "");
    assert_int_equal(system("cp rig.cfg.journal copy.cfg.journal"), 0);
    /* Without --marks the journal's own are gone on with. */
    rig = tool.rig;
    assert_true(tool_open(&other, &rig, 0, NULL, "copy.cfg", NULL, message));
    assert_int_equal(journal_open(&other, false, message), JOURNAL_RESTORED);
    assert_string_equal(other.marks_path, tool.marks_path);
    check_same(&tool, &other);
    forget(&other);
    forget(&tool);
}

static void what_is_too_long_for_a_line_is_never_cut(void **state)
{
    struct cupola_rig rig;
    struct tool tool, other;
    char message[MESSAGE_SIZE];

    (void)state;
    open_with_path(&tool, 5000);
    tool.time_s += 5;
    tool_idle(&tool);
    assert_non_null(strstr(tool.standing, "the journal cannot be written (File name too long)"));
    assert_false(journal_is_whole(tool.journal));
    assert_int_equal(system("cp rig.cfg.journal copy.cfg.journal"), 0);
    rig = tool.rig;
    assert_true(tool_open(&other, &rig, 0, NULL, "copy.cfg", NULL, message));
    assert_int_equal(journal_open(&other, false, message), JOURNAL_NEW);
    assert_string_equal(other.warning, "");
    forget(&other);
    forget(&tool);
    assert_int_not_equal(access("rig.cfg.journal", F_OK), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_longest_path_of_marks_comes_back_whole),
        cmocka_unit_test(what_is_too_long_for_a_line_is_never_cut),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
