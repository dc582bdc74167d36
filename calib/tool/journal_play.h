/* Playing a journal's text into a tool. */
#ifndef JOURNAL_PLAY_H
#define JOURNAL_PLAY_H

#include "tool/journal.h"
#include "tool/tool.h"

enum journal_played {
    JOURNAL_PLAYED,
    JOURNAL_EMPTY,   /* no start, or nothing after it */
    JOURNAL_DAMAGED, /* in the middle, or it is none */
    JOURNAL_OTHER,   /* of another projector than the tool's */
    JOURNAL_MEMORY,
};

struct journal_play {
    size_t good;  /* bytes up to the last whole line */
    long lines;   /* whole ones */
    long changes; /* of rig, marks and history behind the start */
    long wrong;   /* JOURNAL_DAMAGED: number of the line */
    int output;   /* whose it is */
    struct journal_others others;
};

/*
 * Plays it. The tool changes only for JOURNAL_PLAYED: it is then as it was when the last whole line
 * was written, with all of the history. A last line that is not whole does not count.
 */
enum journal_played journal_play(struct tool *tool, const char *bytes, size_t size,
                                 struct journal_play *play);

/* Prints a step as a line's text: what differs from `before`. */
struct change;
struct journal_text;
void journal_play_print(const struct values *before, const struct change *change, bool merges,
                        struct journal_text *text);

#endif
