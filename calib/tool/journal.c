/* The journal: opened and played at the start, then a line for every change. */
#include "tool/journal.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "output_file.h"
#include "short_path.h"
#include "tool/journal_file.h"
#include "tool/journal_play.h"
#include "tool/journal_start.h"

struct journal {
    struct journal_file file;
    long lines;
    bool failing;    /* something could not be written so far */
    double synced_s; /* when it was brought to the disk last */
    int look[4];     /* as it was written last */
    struct journal_others others;
};

static const double sync_s = 1; /* between two times that it is brought to the disk */

static void look_of(const struct tool *tool, int look[4])
{
    look[0] = (int)tool->pattern;
    look[1] = (int)tool->group;
    look[2] = (int)tool->about;
    look[3] = tool->coefficient;
}

/* Where it cannot be written the tool says so for as long as that is so, and works on. */
static void note_written(struct tool *tool, bool written)
{
    struct journal *journal = tool->journal;

    if (!written)
        snprintf(tool->standing, MESSAGE_SIZE,
                 "the journal cannot be written (%s): save soon, a crash would lose changes",
                 strerror(errno));
    else if (journal->failing)
        snprintf(tool->notice, MESSAGE_SIZE, "the journal is written again");
    if (written)
        tool->standing[0] = '\0';
    journal->failing = !written;
}

/* What is missing a word would restore something else: nothing comes after it, either. */
static bool write_line(struct journal *journal, const struct journal_text *text)
{
    char line[JOURNAL_TEXT_MAX + 64];

    if (text->full)
        journal_file_give_up(&journal->file, ENAMETOOLONG);
    return journal_file_append(&journal->file, line,
                               journal_line_print(line, ++journal->lines, text));
}

static void append(struct tool *tool, const struct journal_text *text)
{
    note_written(tool, write_line(tool->journal, text));
}

static void write_start(struct tool *tool)
{
    struct journal_text text;

    for (int i = 0; journal_start_line(tool, i, &text); i++)
        append(tool, &text);
    look_of(&(struct tool){0}, tool->journal->look);
    journal_look(tool);
}

/* Moves what is there aside and begins a new file. */
static bool begin_anew(struct journal *journal, const char *ending, char *name, size_t name_size,
                       char *message)
{
    char *path = strdup(journal->file.path);
    bool begun = path && journal_file_keep_aside(&journal->file, ending, name, name_size, message);

    journal_file_close(&journal->file, false);
    if (begun)
        begun = journal_file_open(&journal->file, path, message) == JOURNAL_FILE_OPEN;
    free(path);
    return begun;
}

static enum journal_found start_damaged(struct tool *tool, const struct journal_play *play,
                                        char *message)
{
    char name[4096];

    if (!begin_anew(tool->journal, "damaged", name, sizeof name, message))
        return JOURNAL_FAILED;
    snprintf(tool->warning, MESSAGE_SIZE,
             "the journal of an earlier session is damaged in line %ld; it was kept as %s, and "
             "nothing of it is restored",
             play->wrong, short_path(name).text);
    return JOURNAL_NEW;
}

static enum journal_found found(struct tool *tool, enum journal_played played,
                                const struct journal_play *play, char *message)
{
    struct journal *journal = tool->journal;
    int steps;

    switch (played) {
    case JOURNAL_PLAYED:
        journal->lines = play->lines;
        journal->others = play->others;
        journal_file_cut(&journal->file, play->good);
        steps = history_undo_count(tool->history);
        snprintf(tool->notice, MESSAGE_SIZE,
                 "restored from %s: %d step%s to undo (--fresh starts without it)",
                 short_path(journal->file.path).text, steps, steps == 1 ? "" : "s");
        return JOURNAL_RESTORED;
    case JOURNAL_EMPTY:
        journal_file_cut(&journal->file, 0);
        return JOURNAL_NEW;
    case JOURNAL_DAMAGED:
        return start_damaged(tool, play, message);
    case JOURNAL_OTHER:
        snprintf(message, MESSAGE_SIZE,
                 "%s is of projector %d, not of %d; allowed: --projector %d to go on with it, or "
                 "--fresh",
                 short_path(journal->file.path).text, play->output, tool->output, play->output);
        return JOURNAL_FAILED;
    case JOURNAL_MEMORY:
        break;
    }
    snprintf(message, MESSAGE_SIZE, "out of memory for %s", short_path(journal->file.path).text);
    return JOURNAL_FAILED;
}

static enum journal_found look_into(struct tool *tool, bool fresh, char *message)
{
    struct journal_play play;
    enum journal_found result;
    char name[4096];
    size_t size;
    char *bytes = journal_file_read(&tool->journal->file, &size, message);

    if (!bytes)
        return JOURNAL_FAILED;
    if (size == 0)
        result = JOURNAL_NEW;
    else if (fresh)
        result = begin_anew(tool->journal, "old", name, sizeof name, message) ? JOURNAL_NEW
                                                                              : JOURNAL_FAILED;
    else
        result = found(tool, journal_play(tool, bytes, size, &play), &play, message);
    free(bytes);
    return result;
}

char *journal_path_beside(const char *rig_path)
{
    char *behind = output_file_behind_links(rig_path), *path = NULL;
    struct stat named;
    const char *rig = rig_path;
    size_t size;

    if (!behind)
        return NULL;
    /* What is no link keeps the name it was given. */
    if (lstat(rig_path, &named) == 0 && S_ISLNK(named.st_mode))
        rig = behind;
    size = strlen(rig) + sizeof ".journal";
    path = malloc(size);
    if (path)
        snprintf(path, size, "%s.journal", rig);
    free(behind);
    return path;
}

enum journal_found journal_open(struct tool *tool, bool fresh, char *message)
{
    char *path = journal_path_beside(tool->rig_path);
    struct journal *journal = calloc(1, sizeof *journal);
    enum journal_file_opened opened = JOURNAL_FILE_REFUSED;
    enum journal_found result = JOURNAL_FAILED;

    if (!path || !journal) {
        snprintf(message, MESSAGE_SIZE, "out of memory for the journal");
    } else {
        opened = journal_file_open(&journal->file, path, message);
    }
    free(path);
    if (opened != JOURNAL_FILE_OPEN) {
        free(journal);
        if (opened == JOURNAL_FILE_REFUSED)
            snprintf(tool->standing, MESSAGE_SIZE, "%.1400s; a crash would lose changes", message);
        return opened == JOURNAL_FILE_REFUSED ? JOURNAL_NEW : JOURNAL_FAILED;
    }
    tool->journal = journal;
    result = look_into(tool, fresh, message);
    if (result == JOURNAL_FAILED)
        journal_close(&tool->journal, false);
    else if (result == JOURNAL_NEW)
        write_start(tool);
    else
        look_of(tool, journal->look);
    return result;
}

void journal_change(struct tool *tool, const struct values *before, const struct change *change,
                    bool merges)
{
    struct journal_text text;

    if (!tool->journal)
        return;
    journal_play_print(before, change, merges, &text);
    append(tool, &text);
}

void journal_note(struct tool *tool, const char *line)
{
    struct journal_text text = {0};

    if (!tool->journal)
        return;
    journal_text_add(&text, "%s", line);
    append(tool, &text);
}

void journal_look(struct tool *tool)
{
    int look[4];
    char line[80];

    if (!tool->journal)
        return;
    look_of(tool, look);
    if (memcmp(look, tool->journal->look, sizeof look) == 0)
        return;
    memcpy(tool->journal->look, look, sizeof look);
    snprintf(line, sizeof line, "look %d %d %d %d", look[0], look[1], look[2], look[3]);
    journal_note(tool, line);
}

void journal_idle(struct tool *tool)
{
    struct journal *journal = tool->journal;

    if (!journal || (!journal->file.dirty && !journal->failing) ||
        (tool->time_s >= journal->synced_s && tool->time_s - journal->synced_s < sync_s))
        return;
    journal->synced_s = tool->time_s;
    if (journal->failing)
        note_written(tool, journal_file_flush(&journal->file));
    journal_file_sync(&journal->file);
}

const char *journal_path(const struct journal *journal)
{
    return journal->file.path;
}

bool journal_is_whole(struct journal *journal)
{
    return journal_file_flush(&journal->file);
}

struct journal_others journal_others(const struct journal *journal)
{
    return journal ? journal->others : (struct journal_others){false, false};
}

void journal_close(struct journal **journal, bool remove_file)
{
    if (!*journal)
        return;
    journal_file_close(&(*journal)->file, remove_file);
    free(*journal);
    *journal = NULL;
}
