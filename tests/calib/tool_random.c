/* Whatever keys are pressed: the rig stays possible, undo leads back, the journal agrees. */
#include "tool_fixture.h"

static void no_keys_make_an_impossible_rig(void **state)
{
    (void)state;
    for (int trial = 0; trial < 20; trial++) {
        uint64_t seed = (uint64_t)trial + 1;
        struct tool tool;
        open_by_chance(&tool, &seed, "rig.cfg");
        for (int i = 0; i < 3000; i++) {
            act_by_chance(&tool, &seed);
            check_possible(&tool);
        }
        tool_close(&tool);
    }
}

static void undoing_all_leads_to_the_start_and_redoing_all_to_the_end(void **state)
{
    (void)state;
    for (int trial = 0; trial < 20; trial++) {
        uint64_t seed = (uint64_t)trial + 100;
        struct tool tool;
        struct values start, end, now;
        struct mark marks_start[5], marks_end[5];
        int steps;
        open_by_chance(&tool, &seed, "rig.cfg");
        values_take(&tool, &start);
        memcpy(marks_start, tool.marks.list, sizeof marks_start);
        for (int i = 0; i < 2000; i++)
            press_by_chance(&tool, &seed);
        while (history_redo_count(tool.history) > 0)
            tool_redo(&tool);
        values_take(&tool, &end);
        memcpy(marks_end, tool.marks.list, sizeof marks_end);
        steps = history_undo_count(tool.history);
        check_at_least(steps, 100);
        for (int i = 0; i < steps; i++)
            tool_undo(&tool);
        values_take(&tool, &now);
        assert_memory_equal(&now, &start, sizeof now);
        assert_memory_equal(marks_start, tool.marks.list, sizeof marks_start);
        assert_false(tool.unsaved);
        for (int i = 0; i < steps; i++)
            tool_redo(&tool);
        values_take(&tool, &now);
        assert_memory_equal(&now, &end, sizeof now);
        assert_memory_equal(marks_end, tool.marks.list, sizeof marks_end);
        tool_close(&tool);
    }
}

/* What another tool would restore at this moment from a copy of the journal. */
static void check_restored(const struct tool *live)
{
    struct cupola_rig rig = {0};
    struct tool other;
    char message[MESSAGE_SIZE] = "";

    assert_int_equal(system("cp rig.cfg.journal copy.cfg.journal"), 0);
    cupola_rig_complete(&rig, &rig, NULL);
    rig.output_count = live->output + 1;
    cupola_rig_complete(&rig, &rig, NULL);
    assert_true(tool_open(&other, &rig, live->output, NULL, "copy.cfg", NULL, message));
    if (journal_open(&other, false, message) == JOURNAL_RESTORED) {
        check_same(live, &other);
        /* One bit would be seen. */
        other.rig.outputs[other.output].aim.yaw_rad =
            nextafter(other.rig.outputs[other.output].aim.yaw_rad, 9);
        assert_false(same_values(live, &other));
        other.rig = live->rig;
        check_possible(&other);
    } else {
        assert_string_equal(other.warning, "");
        assert_string_equal(message, "");
        assert_int_equal(history_undo_count(live->history), 0);
    }
    other.unsaved = false;
    tool_close(&other);
}

static void the_journal_leads_to_the_live_state_after_every_key(void **state)
{
    (void)state;
    for (int trial = 0; trial < 4; trial++) {
        uint64_t seed = (uint64_t)trial + 1000;
        struct tool tool;
        char message[MESSAGE_SIZE] = "";
        open_by_chance(&tool, &seed, "rig.cfg");
        assert_int_equal(journal_open(&tool, true, message), JOURNAL_NEW);
        for (int i = 0; i < 150; i++) {
            act_by_chance(&tool, &seed);
            if (i % 40 == 39)
                assert_true(tool_save(&tool, "rig.cfg"));
            check_restored(&tool);
        }
        for (int i = 0; i < 2000; i++)
            act_by_chance(&tool, &seed);
        check_restored(&tool);
        tool.unsaved = false;
        tool_close(&tool);
        assert_int_not_equal(access("rig.cfg.journal", F_OK), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_keys_make_an_impossible_rig),
        cmocka_unit_test(undoing_all_leads_to_the_start_and_redoing_all_to_the_end),
        cmocka_unit_test(the_journal_leads_to_the_live_state_after_every_key),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
