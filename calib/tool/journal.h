/*
 * The journal: a file beside the rig to be saved that holds the start in full and every change
 * since, so that a crash loses nothing. Lines of text, each with its number and a checksum.
 */
#ifndef JOURNAL_H
#define JOURNAL_H

#include <stdbool.h>

#include "tool/history.h"
#include "tool/tool.h"

struct journal;

/* What was found when a journal was opened. */
enum journal_found {
    JOURNAL_FAILED = -1, /* message says why */
    JOURNAL_NEW,         /* none, or one without a start */
    JOURNAL_RESTORED,    /* the tool is where the journal ends; tool->notice says so */
};

/*
 * Opens tool->rig_path + ".journal", behind links, for a tool that was just opened, and locks it.
 * One that exists is played into the tool; with `fresh` it is moved aside as .journal.old. A
 * damaged one is moved aside as .journal.damaged and refused; so is one that another tool uses,
 * that belongs to another projector. One that cannot be written is none: tool->standing says so.
 */
enum journal_found journal_open(struct tool *tool, bool fresh, char *message);

/*
 * The journal of a rig that is saved to this path: one name for one file, whichever of its links it
 * is called by. To be freed; NULL without memory.
 */
char *journal_path_beside(const char *rig_path);

/* Writes a step; values that differ from `before`. */
void journal_change(struct tool *tool, const struct values *before, const struct change *change,
                    bool merges);

/* Writes a line without values: "undo", "redo", "saved", "resize 640 480", "look ...". */
void journal_note(struct tool *tool, const char *line);

/* What is looked at: pattern, group, about, coefficient; only where it has changed. */
void journal_look(struct tool *tool);

/* Once in a second: brings it to the disk, and writes what a full one did not take. */
void journal_idle(struct tool *tool);

/* Its file, as it is named in messages. */
const char *journal_path(const struct journal *journal);

/* Whether all that happened stands in its file; what a full disk did not take is tried again. */
bool journal_is_whole(struct journal *journal);

/* What the tool was opened with that was passed over for a journal, though it has changed since. */
struct journal_others {
    bool rig, marks;
};
struct journal_others journal_others(const struct journal *journal);

/* Lets go of it, and removes the file if nothing in it is needed any more. NULL is allowed. */
void journal_close(struct journal **journal, bool remove_file);

#endif
