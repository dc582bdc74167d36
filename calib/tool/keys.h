/*
 * Which key does what: one table for the tool itself, the key help on the dome, --help and the
 * tests. Keys are GLFW's, and scripts name them as they are on the keyboard.
 */
#ifndef KEYS_H
#define KEYS_H

#include <stdbool.h>

enum command {
    COMMAND_PATTERN, /* argument: of enum pattern */
    COMMAND_GROUP,   /* argument: of enum group */
    COMMAND_STEP,    /* argument: 2 * which of the group's three values + (1 for less) */
    COMMAND_LENS,
    COMMAND_FLIP, /* argument: of enum cupola_flip */
    COMMAND_ABOUT,
    COMMAND_UNDO,
    COMMAND_REDO,
    COMMAND_BEFORE,
    COMMAND_SAVE,
    COMMAND_HELP,
    COMMAND_LEGEND,
    COMMAND_LABELS,
    COMMAND_TEXT,
    COMMAND_PREVIEW,
    COMMAND_FULLSCREEN,
    COMMAND_PICTURE,
    COMMAND_QUIT,
    COMMAND_ACCEPT, /* and what follows: about the marks */
    COMMAND_FORGET,
    COMMAND_SOLVE,
};

struct key_binding {
    int key;       /* GLFW_KEY_... */
    int modifiers; /* GLFW_MOD_SHIFT and GLFW_MOD_CONTROL, exactly; ANY_STEP: see below */
    enum command command;
    int argument;
    const char *help; /* NULL: said with another key of the same command */
};

enum { ANY_STEP = -1 /* with Shift a tenth of a step, with Ctrl ten, or plain */ };

/* By index; NULL beyond the last. */
const struct key_binding *key_binding(int index);

/* NULL where the key does nothing. */
const struct key_binding *key_find(int key, int modifiers);

/* "Ctrl+Z", "Page Up" as they are read; a static string, or `text` filled in. */
const char *key_text(const struct key_binding *binding, char text[40]);

/*
 * The lines of the key help: `keys` and `help` of line 0, 1, ... False beyond the last. What
 * belongs together ("1 to 8", "Left, Right") is one line.
 */
struct key_line {
    char keys[40];
    const char *help;
};
bool key_line(int index, struct key_line *line);

/* "ctrl+shift+z", "PageUp", "F1": GLFW's key and modifiers. False for a name that is none. */
bool key_parse(const char *name, int *key, int *modifiers);

#endif
