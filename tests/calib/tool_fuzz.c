/* Mutated scripts and journals: no crash, no impossible rig, whatever stands in them. */
#include "tool/journal_line.h"
#include "tool/journal_play.h"
#include "tool/script.h"
#include "tool_fixture.h"

static const char script[] = "key A\nkey Right 10\nset fov_deg 120.5\nset lens polynomial\n"
                             "set k3 -0.01\nexpect yaw_deg 1 within 2\nmouse 100 200\npress\n"
                             "mouse 300 250\nrelease\nkey ctrl+Z 3\nkey ctrl+shift+Z\nkey M\n"
                             "key Enter 2\nset mark 3\neye 0.1 0.2 0.3\nkey X\nkey L 4\n"
                             "expect warning none\n";

/* Changes some bytes, takes some out, doubles some. Returns the new size. */
static size_t mutate(uint64_t *seed, char *bytes, size_t size, size_t room)
{
    static const char liked[] = "0123456789-+.e \n\"#%\xff";
    int changes = 1 + random_index(seed, 6);

    for (int i = 0; i < changes && size > 1; i++) {
        size_t at = (size_t)random_index(seed, (int)size);
        size_t length = 1 + (size_t)random_index(seed, 12);
        if (length > size - at)
            length = size - at;
        switch (random_index(seed, 4)) {
        case 0:
            bytes[at] = (char)random_index(seed, 256);
            break;
        case 1:
            bytes[at] = liked[random_index(seed, sizeof liked - 1)];
            break;
        case 2:
            memmove(bytes + at, bytes + at + length, size - at - length);
            size -= length;
            break;
        default:
            if (size + length > room)
                break;
            memmove(bytes + at + length, bytes + at, size - at);
            size += length;
        }
    }
    return size;
}

static void no_script_breaks_the_tool(void **state)
{
    (void)state;
    for (int trial = 0; trial < 4000; trial++) {
        uint64_t seed = (uint64_t)trial;
        char text[sizeof script + 200], message[MESSAGE_SIZE] = "";
        size_t size = sizeof script - 1;
        struct tool tool;
        FILE *stream;
        memcpy(text, script, size);
        size = mutate(&seed, text, size, sizeof text);
        stream = fmemopen(text, size, "r");
        assert_non_null(stream);
        open_by_chance(&tool, &seed, "rig.cfg");
        if (script_play(&tool, stream, "s", NULL, message) != 0)
            assert_true(strncmp(message, "s:", 2) == 0);
        check_possible(&tool);
        fclose(stream);
        tool_close(&tool);
    }
}

/* Gives each line that reads like one its number and checksum, so that what it says counts. */
static size_t sign_again(const char *bytes, size_t size, char *out, size_t room)
{
    size_t used = 0;
    long number = 0;

    while (size > 0) {
        const char *end = memchr(bytes, '\n', size), *start = memchr(bytes, ' ', size);
        size_t length = end ? (size_t)(end - bytes) : size, text_length;
        struct journal_text text = {0};
        start = start && start < bytes + length ? start + 1 : bytes;
        text_length = (size_t)(bytes + length - start);
        if (text_length > 18)
            text_length -= 18;
        if (text_length > 0 && text_length < sizeof text.text && used + text_length + 80 < room) {
            memcpy(text.text, start, text_length);
            text.length = text_length;
            used += journal_line_print(out + used, ++number, &text);
        }
        bytes += length + (end != NULL);
        size -= length + (end != NULL);
    }
    return used;
}

static char *make_journal(size_t *size)
{
    uint64_t seed = 31;
    struct tool tool;
    char message[MESSAGE_SIZE] = "", *bytes = calloc(1, 200000);
    FILE *file;

    assert_non_null(bytes);
    open_by_chance(&tool, &seed, "rig.cfg");
    assert_int_equal(journal_open(&tool, true, message), JOURNAL_NEW);
    for (int i = 0; i < 60; i++)
        act_by_chance(&tool, &seed);
    file = fopen("rig.cfg.journal", "rb");
    assert_non_null(file);
    *size = fread(bytes, 1, 100000, file);
    fclose(file);
    tool.unsaved = false;
    tool_close(&tool);
    return bytes;
}

static void no_journal_breaks_the_tool(void **state)
{
    size_t size, changed;
    char *bytes = make_journal(&size), *mutated = malloc(200000), *again = malloc(1 << 20);
    int played[JOURNAL_MEMORY + 1] = {0};

    (void)state;
    assert_true(mutated && again);
    for (int trial = 0; trial < 4000; trial++) {
        uint64_t seed = (uint64_t)trial;
        struct journal_play play;
        struct tool tool;
        bool is_signed = trial % 4 != 0;
        struct values values;
        char message[MESSAGE_SIZE];
        memcpy(mutated, bytes, size);
        changed = mutate(&seed, mutated, size, 200000);
        if (is_signed)
            changed = sign_again(mutated, changed, again, 1 << 20);
        open_by_chance(&tool, &seed, "rig.cfg");
        played[journal_play(&tool, is_signed ? again : mutated, changed, &play)]++;
        check_possible(&tool);
        while (history_undo_count(tool.history) > 0) {
            tool_undo(&tool);
            values_take(&tool, &values);
            assert_true(values_check(&tool, &values, message));
        }
        assert_true(play.good <= changed);
        tool_close(&tool);
    }
    /* It was worth it: some were played in spite of all, and some refused. */
    check_at_least(played[JOURNAL_PLAYED], 100);
    check_at_least(played[JOURNAL_DAMAGED], 100);
    free(bytes);
    free(mutated);
    free(again);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_script_breaks_the_tool),
        cmocka_unit_test(no_journal_breaks_the_tool),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
