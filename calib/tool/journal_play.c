/* Playing a journal: the start, then every line that was written since. */
#include "tool/journal_play.h"

#include <stdlib.h>
#include <string.h>

#include "tool/journal_start.h"
#include "tool/state.h"

void journal_play_print(const struct values *before, const struct change *change, bool merges,
                        struct journal_text *text)
{
    *text = (struct journal_text){0};
    journal_text_add(text, "%s", merges ? "merge" : "change");
    for (int i = 0; i < PARAMETER_COUNT; i++)
        if (memcmp(&before->raw[i], &change->values.raw[i], sizeof *before->raw) != 0)
            journal_text_add(text, "%d %.17g", i, change->values.raw[i]);
    if (change->mark >= 0)
        journal_text_add(text, "at %d %d %.17g %.17g", change->mark, change->mark_after.steered,
                         change->mark_after.pixel_px[0], change->mark_after.pixel_px[1]);
}

static bool play_mark(struct tool *tool, char **at, struct change *change)
{
    int steered;

    if (!journal_integer(at, 0, tool->marks.count - 1, &change->mark) ||
        !journal_integer(at, 0, 1, &steered) ||
        !journal_numbers(at, 2, change->mark_after.pixel_px))
        return false;
    change->mark_after.steered = steered;
    change->mark_before = tool_mark_state(tool, change->mark);
    return true;
}

static bool play_change(struct tool *tool, char *at, bool merges)
{
    struct change change = {.mark = -1, .key = -1};
    char message[MESSAGE_SIZE];

    values_take(tool, &change.values);
    while (*at) {
        int index;
        if (strncmp(at, "at ", 3) == 0) {
            at += 3;
            if (!play_mark(tool, &at, &change))
                return false;
        } else if (!journal_integer(&at, 0, PARAMETER_COUNT - 1, &index) ||
                   !journal_numbers(&at, 1, &change.values.raw[index])) {
            return false;
        }
    }
    if ((merges && history_undo_count(tool->history) == 0) ||
        !values_check(tool, &change.values, message))
        return false;
    tool_record(tool, &change, merges);
    return true;
}

static bool play_look(struct tool *tool, char *at)
{
    int pattern, group, about, coefficient;

    if (!journal_integer(&at, 0, PATTERN_COUNT - 1, &pattern) ||
        !journal_integer(&at, 0, GROUP_COUNT - 1, &group) ||
        !journal_integer(&at, 0, ABOUT_COUNT - 1, &about) ||
        !journal_integer(&at, 0, 3, &coefficient) || *at)
        return false;
    tool->pattern = (enum pattern)pattern;
    tool->group = (enum group)group;
    tool->about = (enum about)about;
    tool->coefficient = coefficient;
    return true;
}

static bool play_resize(struct tool *tool, char *at)
{
    char message[MESSAGE_SIZE];
    int width, height;

    return journal_integer(&at, 1, 32768, &width) && journal_integer(&at, 1, 32768, &height) &&
           !*at && tool_resize_quietly(tool, width, height, message);
}

static bool play_line(struct tool *tool, char *text)
{
    char *at = text;
    const char *word = journal_word(&at);

    if (!word)
        return false;
    if (strcmp(word, "change") == 0 || strcmp(word, "merge") == 0)
        return play_change(tool, at, *word == 'm');
    if (strcmp(word, "look") == 0)
        return play_look(tool, at);
    if (strcmp(word, "resize") == 0)
        return play_resize(tool, at);
    if (*at)
        return false;
    if (strcmp(word, "undo") == 0)
        return tool_undo_quietly(tool);
    if (strcmp(word, "redo") == 0)
        return tool_redo_quietly(tool);
    if (strcmp(word, "saved") == 0) {
        tool_note_saved(tool);
        return true;
    }
    if (strcmp(word, "marks-saved") == 0) {
        tool_note_marks_saved(tool);
        return true;
    }
    return false;
}

/* The state while it is played. */
struct playing {
    struct journal_start start;
    struct tool trial;
    bool opened;
    struct journal_others from_start, from_saved; /* how the given tool differs from them */
    struct journal_play *play;
};

static struct journal_others compare(const struct tool *tool, const struct tool *then)
{
    /* Without marks, those of the journal are what is wished. */
    return (struct journal_others){!journal_start_same_rig(tool, then),
                                   tool->marks_path &&
                                       !journal_start_same_marks(&tool->marks, &then->marks)};
}

static bool open_trial(struct playing *playing, const struct tool *tool)
{
    char message[MESSAGE_SIZE];
    struct journal_start *start = &playing->start;

    playing->opened =
        tool_open(&playing->trial, &start->rig, start->output, &start->marks, tool->rig_path,
                  tool->marks_path ? tool->marks_path : start->marks_path, message);
    if (!playing->opened)
        return false;
    playing->from_start = playing->from_saved = compare(tool, &playing->trial);
    if (!values_check(&playing->trial, &start->values, message))
        return false;
    values_put(&playing->trial, &start->values);
    history_restart(playing->trial.history, &start->values);
    return true;
}

static bool take(struct playing *playing, const struct tool *tool, struct journal_text *text)
{
    bool saves, saves_marks, played;

    if (playing->start.done) {
        /* Looking elsewhere and another size are nothing that anyone would miss. */
        playing->play->changes +=
            strncmp(text->text, "look ", 5) != 0 && strncmp(text->text, "resize ", 7) != 0;
        saves = strcmp(text->text, "saved") == 0;
        saves_marks = saves || strcmp(text->text, "marks-saved") == 0;
        played = play_line(&playing->trial, text->text);
        if (saves)
            playing->from_saved.rig = compare(tool, &playing->trial).rig;
        if (saves_marks)
            playing->from_saved.marks = compare(tool, &playing->trial).marks;
        return played;
    }
    if (!journal_start_take(&playing->start, text->text))
        return false;
    return !playing->start.done || open_trial(playing, tool);
}

/* Takes lines as long as they are whole. Returns whether what follows them is one torn line. */
static bool take_lines(struct playing *playing, const struct tool *tool, const char *bytes,
                       size_t size)
{
    struct journal_play *play = playing->play;
    struct journal_text text;
    long number;

    while (play->good < size) {
        const char *line = bytes + play->good;
        const char *end = memchr(line, '\n', size - play->good);
        if (!end || !journal_line_check(line, (size_t)(end - line), &number, &text))
            return !end || end + 1 == bytes + size;
        if (number != play->lines + 1 || !take(playing, tool, &text))
            return false;
        play->lines++;
        play->good += (size_t)(end + 1 - line);
    }
    return true;
}

/* Whether these bytes may be the torn beginning of a journal's first lines. */
static bool is_beginning(const struct playing *playing, const char *bytes, size_t size)
{
    struct journal_text text;
    char first[JOURNAL_TEXT_MAX + 64];
    size_t length;

    if (playing->play->lines > 0)
        return true;
    journal_start_line(&playing->trial, 0, &text);
    length = journal_line_print(first, 1, &text);
    return memcmp(bytes, first, size < length ? size : length) == 0;
}

static void take_over(struct playing *playing, struct tool *tool)
{
    struct journal *journal = tool->journal;
    struct tool_files files = tool->files;
    double time_s = tool->time_s;

    tool->journal = NULL;
    tool->unsaved = true; /* no file goes with it */
    tool_close(tool);
    *tool = playing->trial;
    tool->journal = journal;
    tool->files = files;
    tool->time_s = time_s;
    tool->shows_before = false;
    playing->opened = false;
}

enum journal_played journal_play(struct tool *tool, const char *bytes, size_t size,
                                 struct journal_play *play)
{
    struct playing *playing = calloc(1, sizeof *playing);
    enum journal_played result;
    bool whole;

    *play = (struct journal_play){0};
    if (!playing)
        return JOURNAL_MEMORY;
    playing->play = play;
    whole = take_lines(playing, tool, bytes, size) && is_beginning(playing, bytes, size);
    play->wrong = play->lines + 1;
    play->output = playing->start.output;
    play->others = (struct journal_others){playing->from_start.rig && playing->from_saved.rig,
                                           playing->from_start.marks && playing->from_saved.marks};
    if (!whole)
        result = JOURNAL_DAMAGED;
    else if (!playing->start.done || play->changes == 0)
        result = JOURNAL_EMPTY;
    else if (play->output != tool->output)
        result = JOURNAL_OTHER;
    else
        result = JOURNAL_PLAYED;
    if (result == JOURNAL_PLAYED)
        take_over(playing, tool);
    if (playing->opened)
        tool_close(&playing->trial);
    journal_start_free(&playing->start);
    free(playing);
    return result;
}
