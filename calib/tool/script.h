/*
 * A session of the tool as a text: keys, values to be set, and expectations, a line each. The
 * language is described in docs/calibration.md.
 */
#ifndef SCRIPT_H
#define SCRIPT_H

#include <stdio.h>

#include "tool/tool.h"

/* What draws for a script. Each returns false with one line in `message`, MESSAGE_SIZE bytes. */
struct script_stage {
    void *user;
    /* Writes a picture: of the window, or of the dome's image alone. */
    bool (*picture)(void *user, struct tool *tool, bool dome, const char *path, char *message);
    /* Draws frames and throws them away. */
    bool (*frames)(void *user, struct tool *tool, int count, char *message);
};

/*
 * Plays a script from a stream; `name` stands for it in messages. Returns an exit status, with
 * "name:line: what was expected and what is there" in `message` unless STATUS_OK. Without a stage,
 * what draws is refused.
 */
int script_play(struct tool *tool, FILE *stream, const char *name, const struct script_stage *stage,
                char *message);

#endif
