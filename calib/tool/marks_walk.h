/* From mark to mark with the cross-hair. */
#ifndef MARKS_WALK_H
#define MARKS_WALK_H

#include "tool/tool.h"

/* The next mark without a pixel behind one, round the end; that one itself if all have theirs. */
int marks_walk_next(const struct tool *tool, int mark);

/* Goes to a mark: the cross-hair to its pixel, or to the one that the present rig predicts. */
void marks_walk_to(struct tool *tool, int mark);

/* How many have a pixel. */
int marks_walk_steered(const struct tool *tool);

/*
 * What a mark is called on the screen: its name as it is drawn, or its number in the file ("mark
 * 3") where letters of it cannot be, so that no two names look alike as question marks; "mark 3
 * (2)" where another is really called "mark 3", and so on.
 */
void marks_walk_label(const struct tool *tool, int mark, char label[MARK_NAME_MAX + 1]);

/* The cross-hair is on the present mark: takes its pixel and goes on. And forgets it. */
void marks_walk_accept(struct tool *tool);
void marks_walk_forget(struct tool *tool);

/* The projector from the marks so far; one step of history, with notice or warning. */
void marks_walk_solve(struct tool *tool);

#endif
