/* What the tool's files share: steps of history as live changes and the journal make them. */
#ifndef STATE_H
#define STATE_H

#include "tool/history.h"
#include "tool/tool.h"

/* Takes a step over into state and history. */
void tool_record(struct tool *tool, const struct change *change, bool merges);

/* False where there is none. */
bool tool_undo_quietly(struct tool *tool);
bool tool_redo_quietly(struct tool *tool);

struct mark_state tool_mark_state(const struct tool *tool, int index);

/* Whether anything is unsaved; that nothing is; that the marks are as their file has them. */
void tool_compare_saved(struct tool *tool);
void tool_note_saved(struct tool *tool);
void tool_note_marks_saved(struct tool *tool);

/* Whether a mark has another pixel than in the file, or one more or less has one. */
bool tool_marks_differ(const struct tool *tool);

/* tool_resize without a word to the journal. False with one line in `message`. */
bool tool_resize_quietly(struct tool *tool, int width_px, int height_px, char *message);

#endif
