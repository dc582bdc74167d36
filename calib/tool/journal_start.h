/* The start of a journal: the rig in full, the marks and all values, so that no other file is
 * needed to bring the state back. */
#ifndef JOURNAL_START_H
#define JOURNAL_START_H

#include "tool/journal_line.h"
#include "tool/tool.h"

/* The text of line 0, 1, ... of a tool's start; false beyond the last. */
bool journal_start_line(const struct tool *tool, int index, struct journal_text *text);

/* A start on its way in. All zero before the first line. */
struct journal_start {
    int line; /* how many were taken */
    int output;
    int outputs, samples, places; /* how many are there already */
    struct cupola_rig rig;
    struct marks marks;
    char *marks_path; /* NULL: none */
    struct values values;
    bool done;
};

/* Takes the next line. False where it is none that can stand there; `text` is written into. */
bool journal_start_take(struct journal_start *start, char *text);

/*
 * Whether two tools have the same rig, or the same marks, but for what files lose by writing
 * angles as degrees.
 */
bool journal_start_same_rig(const struct tool *a, const struct tool *b);
bool journal_start_same_marks(const struct marks *a, const struct marks *b);

/* Gives back what it holds. */
void journal_start_free(struct journal_start *start);

#endif
