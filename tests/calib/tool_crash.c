/* The tool is killed at any moment: what it had said is there again. */
#include <errno.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>

#include "tool_fixture.h"

enum { SEED = 77, KEYS_MAX = 100000 };

/* Presses keys until it is killed, and tells each number once its key has been pressed. */
static void child(int pipe_end)
{
    uint64_t seed = SEED;
    struct tool tool;
    char message[MESSAGE_SIZE];

    open_by_chance(&tool, &seed, "rig.cfg");
    if (journal_open(&tool, false, message) == JOURNAL_FAILED)
        _exit(1);
    for (int i = 0; i < KEYS_MAX; i++) {
        press_by_chance(&tool, &seed);
        tool_idle(&tool);
        if (write(pipe_end, &i, sizeof i) != sizeof i)
            break;
    }
    _exit(0);
}

/* Kills it after some keys; returns how many it told of. */
static int kill_after(int keys, long delay_ns)
{
    int ends[2], number = -1, told = -1, status;
    pid_t process;

    assert_int_equal(pipe(ends), 0);
    process = fork();
    assert_true(process >= 0);
    if (process == 0) {
        close(ends[0]);
        child(ends[1]);
    }
    close(ends[1]);
    while (told < keys && read(ends[0], &number, sizeof number) == sizeof number)
        told = number;
    nanosleep(&(struct timespec){0, delay_ns}, NULL);
    kill(process, SIGKILL);
    while (read(ends[0], &number, sizeof number) == sizeof number)
        told = number;
    close(ends[0]);
    assert_int_equal(waitpid(process, &status, 0), process);
    assert_true(WIFSIGNALED(status));
    return told + 1;
}

/* The state of the same keys without a crash. */
static void press_again(struct tool *tool, int keys)
{
    uint64_t seed = SEED;

    open_by_chance(tool, &seed, "other.cfg");
    for (int i = 0; i < keys; i++)
        press_by_chance(tool, &seed);
}

static bool is_same(const struct tool *a, const struct tool *b)
{
    return same_values(a, b) && a->pattern == b->pattern && a->group == b->group &&
           a->about == b->about && a->coefficient == b->coefficient &&
           history_undo_count(a->history) == history_undo_count(b->history) &&
           history_redo_count(a->history) == history_redo_count(b->history);
}

static void every_key_that_was_taken_is_there_after_a_kill(void **state)
{
    uint64_t seed = 9;

    (void)state;
    for (int trial = 0; trial < 40; trial++) {
        int keys = kill_after(40 + random_index(&seed, 200), random_index(&seed, 300000));
        struct tool restored, live;
        uint64_t same_seed = SEED;
        char message[MESSAGE_SIZE] = "";
        bool found = false;
        open_by_chance(&restored, &same_seed, "rig.cfg");
        assert_int_equal(journal_open(&restored, false, message), JOURNAL_RESTORED);
        assert_string_equal(restored.warning, "");
        check_possible(&restored);
        /* The key after the last one that was told of may have been written already. */
        press_again(&live, keys);
        found = is_same(&restored, &live);
        if (!found) {
            tool_close(&live);
            press_again(&live, keys + 1);
            found = is_same(&restored, &live);
        }
        assert_true(found);
        tool_close(&live);
        restored.unsaved = false;
        tool_close(&restored);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_that_was_taken_is_there_after_a_kill),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
