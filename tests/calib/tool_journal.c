/* Journals: cut off or damaged anywhere, used by two, of another projector, on full disks. */
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "tool_fixture.h"

enum { SEED = 5, KEYS = 40 };

static char *read_bytes(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    char *bytes;

    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    bytes = malloc(*size + 1);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, *size, file), *size);
    fclose(file);
    return bytes;
}

static void write_bytes(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");

    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* The tool that every test here begins with. */
static void open_same(struct tool *tool)
{
    uint64_t seed = SEED;

    open_by_chance(tool, &seed, "rig.cfg");
}

static enum journal_found open_journal(struct tool *tool, char *message)
{
    message[0] = '\0';
    return journal_open(tool, false, message);
}

static void forget(struct tool *tool)
{
    tool->unsaved = false;
    tool_close(tool);
}

/* A session of some keys; its values and the journal's size after each. */
static char *play_session(struct values *values, size_t *sizes, size_t *size)
{
    uint64_t seed = SEED + 1;
    struct tool tool;
    struct stat file;
    char message[MESSAGE_SIZE], *bytes;

    unlink("rig.cfg.journal");
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
    for (int i = 0; i < KEYS; i++) {
        values_take(&tool, &values[i]);
        assert_int_equal(stat("rig.cfg.journal", &file), 0);
        sizes[i] = (size_t)file.st_size;
        act_by_chance(&tool, &seed);
    }
    bytes = read_bytes("rig.cfg.journal", size);
    forget(&tool);
    return bytes;
}

static void cut_off_at_any_byte_it_restores_all_whole_lines(void **state)
{
    struct values values[KEYS], now;
    size_t sizes[KEYS], size;
    char *bytes = play_session(values, sizes, &size);
    int after = 0;

    (void)state;
    for (size_t cut = 0; cut <= size; cut++) {
        struct tool tool;
        char message[MESSAGE_SIZE];
        while (after + 1 < KEYS && sizes[after + 1] <= cut)
            after++;
        write_bytes("rig.cfg.journal", bytes, cut);
        open_same(&tool);
        assert_int_not_equal(open_journal(&tool, message), JOURNAL_FAILED);
        assert_string_equal(tool.warning, "");
        values_take(&tool, &now);
        /* Between two keys there may be a line of the next one already. */
        if (cut == sizes[after] || cut < sizes[0])
            assert_memory_equal(&now, &values[after], sizeof now);
        forget(&tool);
    }
    free(bytes);
}

static void garbage_at_its_end_is_passed_over_and_written_over(void **state)
{
    struct values values[KEYS], now;
    size_t sizes[KEYS], size;
    char *bytes = play_session(values, sizes, &size), *more = malloc(size + 400);

    (void)state;
    for (int trial = 0; trial < 100; trial++) {
        uint64_t seed = (uint64_t)trial;
        size_t length = 1 + (size_t)random_index(&seed, 300);
        struct tool tool;
        char message[MESSAGE_SIZE];
        memcpy(more, bytes, sizes[20]);
        for (size_t i = 0; i < length; i++) {
            more[sizes[20] + i] = (char)random_index(&seed, 256);
            if (more[sizes[20] + i] == '\n')
                more[sizes[20] + i] = 0;
        }
        write_bytes("rig.cfg.journal", more, sizes[20] + length);
        open_same(&tool);
        assert_int_equal(open_journal(&tool, message), JOURNAL_RESTORED);
        values_take(&tool, &now);
        assert_memory_equal(&now, &values[20], sizeof now);
        tool_set(&tool, PARAMETER_YAW, 12.5);
        tool.unsaved = true;
        tool_close(&tool);
        open_same(&tool);
        assert_int_equal(open_journal(&tool, message), JOURNAL_RESTORED);
        check_near(parameter_get(&tool, PARAMETER_YAW), 12.5, 0);
        forget(&tool);
    }
    free(bytes);
    free(more);
}

static void damaged_in_the_middle_it_is_refused_and_kept(void **state)
{
    struct values values[KEYS], now;
    size_t sizes[KEYS], size, kept_size;
    char *bytes = play_session(values, sizes, &size), *kept;

    (void)state;
    for (size_t at = 0; at < sizes[KEYS - 3]; at += 7) {
        struct tool tool;
        char message[MESSAGE_SIZE];
        bytes[at] ^= 1;
        write_bytes("rig.cfg.journal", bytes, size);
        open_same(&tool);
        assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
        assert_non_null(strstr(tool.warning, "damaged"));
        values_take(&tool, &now);
        assert_memory_equal(&now, &values[0], sizeof now);
        kept = read_bytes("rig.cfg.journal.damaged", &kept_size);
        assert_int_equal(kept_size, size);
        assert_memory_equal(kept, bytes, size);
        free(kept);
        unlink("rig.cfg.journal.damaged");
        bytes[at] ^= 1;
        forget(&tool);
    }
    free(bytes);
}

static void what_is_kept_aside_is_never_written_over(void **state)
{
    struct tool tool;
    char message[MESSAGE_SIZE];

    (void)state;
    for (int i = 0; i < 3; i++) {
        write_bytes("rig.cfg.journal", "my shopping list\n", 17);
        open_same(&tool);
        assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
        forget(&tool);
    }
    assert_int_equal(access("rig.cfg.journal.damaged", F_OK), 0);
    assert_int_equal(access("rig.cfg.journal.damaged.2", F_OK), 0);
    assert_int_equal(access("rig.cfg.journal.damaged.3", F_OK), 0);
}

static void fresh_moves_it_aside(void **state)
{
    struct values values[KEYS], now;
    size_t sizes[KEYS], size;
    char *bytes = play_session(values, sizes, &size), message[MESSAGE_SIZE] = "";
    struct tool tool;

    (void)state;
    write_bytes("rig.cfg.journal", bytes, size);
    open_same(&tool);
    assert_int_equal(journal_open(&tool, true, message), JOURNAL_NEW);
    values_take(&tool, &now);
    assert_memory_equal(&now, &values[0], sizeof now);
    assert_int_equal(access("rig.cfg.journal.old", F_OK), 0);
    forget(&tool);
    free(bytes);
}

static void a_second_tool_is_refused(void **state)
{
    struct tool tool, second;
    char message[MESSAGE_SIZE];

    (void)state;
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
    open_same(&second);
    assert_int_equal(open_journal(&second, message), JOURNAL_FAILED);
    assert_non_null(strstr(message, "in use"));
    assert_null(second.journal);
    forget(&tool);
    assert_int_equal(open_journal(&second, message), JOURNAL_NEW);
    forget(&second);
}

static void of_another_projector_it_is_refused_and_stays(void **state)
{
    struct values values[KEYS];
    size_t sizes[KEYS], size;
    char *bytes = play_session(values, sizes, &size), message[MESSAGE_SIZE];
    struct cupola_rig rig = {.output_count = 4};
    struct tool tool;

    (void)state;
    write_bytes("rig.cfg.journal", bytes, size);
    cupola_rig_complete(&rig, &rig, NULL);
    assert_true(tool_open(&tool, &rig, 3, NULL, "rig.cfg", NULL, message));
    assert_int_equal(open_journal(&tool, message), JOURNAL_FAILED);
    assert_non_null(strstr(message, "allowed: --projector"));
    tool_close(&tool);
    assert_int_equal(access("rig.cfg.journal", F_OK), 0);
    unlink("rig.cfg.journal");
    free(bytes);
}

static void what_is_no_plain_file_is_left_alone(void **state)
{
    struct tool tool;
    char message[MESSAGE_SIZE];

    (void)state;
    assert_int_equal(mkfifo("rig.cfg.journal", 0600), 0);
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
    assert_null(tool.journal);
    assert_non_null(strstr(tool.standing, "no plain file"));
    tool_set(&tool, PARAMETER_YAW, 1);
    assert_non_null(strstr(tool.standing, "a crash would lose changes"));
    assert_true(tool_key(&tool, GLFW_KEY_ESCAPE, 0));
    assert_non_null(strstr(tool.notice, "quits without saving, and they are lost"));
    forget(&tool);
    unlink("rig.cfg.journal");
}

/* Whatever is done meanwhile. */
static void check_warns_of_the_journal(struct tool *tool)
{
    static const int keys[] = {GLFW_KEY_A, GLFW_KEY_RIGHT, GLFW_KEY_B, GLFW_KEY_X, GLFW_KEY_H};
    char warnings[2 * MESSAGE_SIZE];

    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        assert_true(tool_key(tool, keys[i], 0));
        tool->time_s += 5;
        tool_idle(tool);
        tool_warnings(tool, "; ", warnings);
        assert_ptr_equal(strstr(warnings, "the journal cannot be written (File too"), warnings);
    }
    tool_undo(tool);
    tool_undo(tool);
    assert_false(tool_set(tool, PARAMETER_CAP, 400));
    tool_warnings(tool, "; ", warnings);
    assert_non_null(strstr(warnings, "save soon, a crash would lose changes; "));
    assert_non_null(strstr(warnings, "400"));
    assert_true(tool_key(tool, GLFW_KEY_ESCAPE, 0));
    assert_non_null(strstr(tool->notice, "quits without saving, and they are lost"));
}

static void on_a_full_disk_the_tool_works_on_and_catches_up(void **state)
{
    struct rlimit before, small;
    struct tool tool, other;
    struct stat file;
    char message[MESSAGE_SIZE];

    (void)state;
    signal(SIGXFSZ, SIG_IGN);
    unlink("rig.cfg.journal");
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
    assert_int_equal(stat("rig.cfg.journal", &file), 0);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = (rlim_t)file.st_size + 100;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    for (int i = 1; i <= 50; i++) {
        tool.time_s += 5;
        tool_set(&tool, PARAMETER_YAW, i);
    }
    check_warns_of_the_journal(&tool);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    check_near(parameter_get(&tool, PARAMETER_YAW), 50, 1e-12);
    tool_set(&tool, PARAMETER_PITCH, 1);
    assert_non_null(strstr(tool.notice, "written again"));
    assert_string_equal(tool.standing, "");
    assert_true(tool_key(&tool, GLFW_KEY_H, 0));
    assert_true(tool_key(&tool, GLFW_KEY_ESCAPE, 0));
    assert_non_null(strstr(tool.notice, "the journal keeps them"));
    assert_int_equal(system("cp rig.cfg.journal copy.cfg.journal"), 0);
    open_same(&other);
    free(other.rig_path);
    other.rig_path = strdup("copy.cfg");
    assert_int_equal(open_journal(&other, message), JOURNAL_RESTORED);
    check_same(&tool, &other);
    forget(&other);
    forget(&tool);
}

static void without_a_key_it_catches_up_when_there_is_room(void **state)
{
    struct rlimit before, small;
    struct tool tool;
    char message[MESSAGE_SIZE];

    (void)state;
    unlink("rig.cfg.journal");
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = 1;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    tool_set(&tool, PARAMETER_YAW, 1);
    assert_true(tool.standing[0]);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    tool.time_s += 5;
    tool_idle(&tool);
    assert_string_equal(tool.standing, "");
    assert_non_null(strstr(tool.notice, "written again"));
    forget(&tool);
}

static void saved_and_ended_it_is_gone_unsaved_it_stays(void **state)
{
    struct tool tool;
    char message[MESSAGE_SIZE];

    (void)state;
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_NEW);
    for (int i = 1; i <= 3; i++) {
        tool.time_s += 5;
        tool_set(&tool, PARAMETER_YAW, i);
    }
    tool_undo(&tool);
    assert_true(tool.unsaved);
    tool_close(&tool);
    assert_int_equal(access("rig.cfg.journal", F_OK), 0);
    open_same(&tool);
    assert_int_equal(open_journal(&tool, message), JOURNAL_RESTORED);
    assert_non_null(strstr(tool.notice, "restored from rig.cfg.journal: 2 steps to undo"));
    assert_true(tool.unsaved);
    assert_true(tool_save(&tool, tool.rig_path));
    assert_false(tool.unsaved);
    tool_close(&tool);
    assert_int_not_equal(access("rig.cfg.journal", F_OK), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_off_at_any_byte_it_restores_all_whole_lines),
        cmocka_unit_test(garbage_at_its_end_is_passed_over_and_written_over),
        cmocka_unit_test(damaged_in_the_middle_it_is_refused_and_kept),
        cmocka_unit_test(what_is_kept_aside_is_never_written_over),
        cmocka_unit_test(fresh_moves_it_aside),
        cmocka_unit_test(a_second_tool_is_refused),
        cmocka_unit_test(of_another_projector_it_is_refused_and_stays),
        cmocka_unit_test(what_is_no_plain_file_is_left_alone),
        cmocka_unit_test(on_a_full_disk_the_tool_works_on_and_catches_up),
        cmocka_unit_test(without_a_key_it_catches_up_when_there_is_room),
        cmocka_unit_test(saved_and_ended_it_is_gone_unsaved_it_stays),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
