/* The table of keys, and their names. */
#include "tool/keys.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tool/tool.h"

enum { CTRL = GLFW_MOD_CONTROL, SHIFT = GLFW_MOD_SHIFT };

/* Entries without help follow the one whose line they share or repeat. */
static const struct key_binding bindings[] = {
    {GLFW_KEY_1, 0, COMMAND_PATTERN, PATTERN_GRID, "grid of degrees"},
    {GLFW_KEY_2, 0, COMMAND_PATTERN, PATTERN_MERIDIANS, "meridians through straight ahead"},
    {GLFW_KEY_3, 0, COMMAND_PATTERN, PATTERN_CIRCLES, "circles round straight ahead"},
    {GLFW_KEY_4, 0, COMMAND_PATTERN, PATTERN_CHECKER, "fields of equal solid angle"},
    {GLFW_KEY_5, 0, COMMAND_PATTERN, PATTERN_WEDGES, "wedges for the focus"},
    {GLFW_KEY_6, 0, COMMAND_PATTERN, PATTERN_RAMPS, "ramps of colours and greys"},
    {GLFW_KEY_7, 0, COMMAND_PATTERN, PATTERN_RIM, "rim, image circle and frame"},
    {GLFW_KEY_8, 0, COMMAND_PATTERN, PATTERN_DOT, "one dot"},
    {GLFW_KEY_C, 0, COMMAND_GROUP, GROUP_CIRCLE, "arrows: image circle"},
    {GLFW_KEY_K, 0, COMMAND_GROUP, GROUP_LENS, "arrows: coefficient, its value; page: fov"},
    {GLFW_KEY_T, 0, COMMAND_GROUP, GROUP_POSITION, "arrows: where the projector stands"},
    {GLFW_KEY_A, 0, COMMAND_GROUP, GROUP_AIM, "arrows: where it aims"},
    {GLFW_KEY_D, 0, COMMAND_GROUP, GROUP_SCREEN, "arrows: dome's tilt and cap; page: radius"},
    {GLFW_KEY_V, 0, COMMAND_GROUP, GROUP_VIEWER, "arrows: the viewer's eye"},
    {GLFW_KEY_O, 0, COMMAND_GROUP, GROUP_DOT, "arrows: the dot; page: its size"},
    {GLFW_KEY_M, 0, COMMAND_GROUP, GROUP_MARKS, "arrows: the cross-hair; page: which mark"},
    {GLFW_KEY_RIGHT, ANY_STEP, COMMAND_STEP, 0, "first value; Shift a tenth, Ctrl ten times"},
    {GLFW_KEY_LEFT, ANY_STEP, COMMAND_STEP, 1, NULL},
    {GLFW_KEY_UP, ANY_STEP, COMMAND_STEP, 2, "second value"},
    {GLFW_KEY_DOWN, ANY_STEP, COMMAND_STEP, 3, NULL},
    {GLFW_KEY_PAGE_UP, ANY_STEP, COMMAND_STEP, 4, "third value"},
    {GLFW_KEY_PAGE_DOWN, ANY_STEP, COMMAND_STEP, 5, NULL},
    {GLFW_KEY_L, 0, COMMAND_LENS, 0, "next lens"},
    {GLFW_KEY_X, 0, COMMAND_FLIP, CUPOLA_FLIP_X, "left and right change places"},
    {GLFW_KEY_Y, 0, COMMAND_FLIP, CUPOLA_FLIP_Y, "top and bottom change places"},
    {GLFW_KEY_U, 0, COMMAND_ABOUT, 0, "pattern about the dome or the viewer"},
    {GLFW_KEY_Z, CTRL, COMMAND_UNDO, 0, "undo"},
    {GLFW_KEY_Y, CTRL, COMMAND_REDO, 0, "redo"},
    {GLFW_KEY_Z, CTRL | SHIFT, COMMAND_REDO, 0, NULL},
    {GLFW_KEY_B, 0, COMMAND_BEFORE, 0, "before or after"},
    {GLFW_KEY_ENTER, 0, COMMAND_ACCEPT, 0, "the mark is at the cross-hair; next mark"},
    {GLFW_KEY_KP_ENTER, 0, COMMAND_ACCEPT, 0, NULL},
    {GLFW_KEY_BACKSPACE, 0, COMMAND_FORGET, 0, "forget where the mark is"},
    {GLFW_KEY_R, 0, COMMAND_SOLVE, 0, "solve: projector from the marks"},
    {GLFW_KEY_S, 0, COMMAND_SAVE, 0, "save rig and marks"},
    {GLFW_KEY_S, CTRL, COMMAND_SAVE, 0, NULL},
    {GLFW_KEY_H, 0, COMMAND_HELP, 0, "these keys"},
    {GLFW_KEY_F1, 0, COMMAND_HELP, 0, NULL},
    {GLFW_KEY_I, 0, COMMAND_LEGEND, 0, "values"},
    {GLFW_KEY_N, 0, COMMAND_LABELS, 0, "numbers on the dome"},
    {GLFW_KEY_W, 0, COMMAND_TEXT, 0, "words on the dome or plain"},
    {GLFW_KEY_P, 0, COMMAND_PREVIEW, 0, "simulated theatre: eye, outside, none"},
    {GLFW_KEY_F11, 0, COMMAND_FULLSCREEN, 0, "whole monitor or a window"},
    {GLFW_KEY_F12, 0, COMMAND_PICTURE, 0, "picture of the window as a file"},
    {GLFW_KEY_ESCAPE, 0, COMMAND_QUIT, 0, "quit"},
};

enum { BINDING_COUNT = sizeof bindings / sizeof *bindings };

const struct key_binding *key_binding(int index)
{
    return index >= 0 && index < BINDING_COUNT ? &bindings[index] : NULL;
}

const struct key_binding *key_find(int key, int modifiers)
{
    int exactly = modifiers & (CTRL | SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER);

    for (int i = 0; i < BINDING_COUNT; i++) {
        if (bindings[i].key != key)
            continue;
        if (bindings[i].modifiers == exactly ||
            (bindings[i].modifiers == ANY_STEP && (exactly & ~(CTRL | SHIFT)) == 0))
            return &bindings[i];
    }
    return NULL;
}

static const struct {
    int key;
    const char *name;  /* in scripts */
    const char *shown; /* in the help; NULL: the same */
} names[] = {
    {GLFW_KEY_LEFT, "Left", NULL},
    {GLFW_KEY_RIGHT, "Right", NULL},
    {GLFW_KEY_UP, "Up", NULL},
    {GLFW_KEY_DOWN, "Down", NULL},
    {GLFW_KEY_PAGE_UP, "PageUp", "Page Up"},
    {GLFW_KEY_PAGE_DOWN, "PageDown", "Page Down"},
    {GLFW_KEY_HOME, "Home", NULL},
    {GLFW_KEY_END, "End", NULL},
    {GLFW_KEY_INSERT, "Insert", NULL},
    {GLFW_KEY_DELETE, "Delete", NULL},
    {GLFW_KEY_ENTER, "Enter", NULL},
    {GLFW_KEY_KP_ENTER, "KPEnter", "Enter"},
    {GLFW_KEY_ESCAPE, "Escape", "Esc"},
    {GLFW_KEY_BACKSPACE, "Backspace", NULL},
    {GLFW_KEY_TAB, "Tab", NULL},
    {GLFW_KEY_SPACE, "Space", NULL},
};

enum { NAME_COUNT = sizeof names / sizeof *names };

const char *key_text(const struct key_binding *binding, char text[40])
{
    int held = binding->modifiers == ANY_STEP ? 0 : binding->modifiers;
    int length =
        snprintf(text, 40, "%s%s", held & CTRL ? "Ctrl+" : "", held & SHIFT ? "Shift+" : "");
    char *end = text + length;
    size_t room = 40 - (size_t)length;

    if (binding->key >= GLFW_KEY_F1 && binding->key <= GLFW_KEY_F25)
        snprintf(end, room, "F%d", binding->key - GLFW_KEY_F1 + 1);
    else if (binding->key < 128)
        snprintf(end, room, "%c", binding->key);
    for (int i = 0; i < NAME_COUNT; i++)
        if (names[i].key == binding->key)
            snprintf(end, room, "%s", names[i].shown ? names[i].shown : names[i].name);
    return text;
}

bool key_line(int index, struct key_line *line)
{
    int at = 0, length;
    char text[40];

    for (; at < BINDING_COUNT; at++)
        if (bindings[at].help && index-- == 0)
            break;
    if (at == BINDING_COUNT)
        return false;
    line->help = bindings[at].help;
    length = snprintf(line->keys, sizeof line->keys, "%s", key_text(&bindings[at], text));
    for (at++; at < BINDING_COUNT && !bindings[at].help; at++)
        if (bindings[at].key != GLFW_KEY_KP_ENTER) /* it reads as the other one */
            length += snprintf(line->keys + length, sizeof line->keys - (size_t)length, ", %s",
                               key_text(&bindings[at], text));
    return true;
}

/* The key behind all prefixes. */
static bool parse_plain(const char *name, int *key)
{
    char upper = *name >= 'a' && *name <= 'z' ? (char)(*name - 'a' + 'A') : *name;
    int number, used = 0;

    for (int i = 0; i < NAME_COUNT; i++) {
        if (strcasecmp(names[i].name, name) == 0) {
            *key = names[i].key;
            return true;
        }
    }
    if (((upper >= 'A' && upper <= 'Z') || (upper >= '0' && upper <= '9')) && name[1] == '\0') {
        *key = upper;
        return true;
    }
    if (upper != 'F' || name[1] < '1' || name[1] > '9' || strlen(name) > 3 ||
        sscanf(name + 1, "%2d%n", &number, &used) != 1 || name[1 + used] != '\0' || number > 25)
        return false;
    *key = GLFW_KEY_F1 + number - 1;
    return true;
}

bool key_parse(const char *name, int *key, int *modifiers)
{
    for (*modifiers = 0;;) {
        if (strncasecmp(name, "shift+", 6) == 0) {
            *modifiers |= SHIFT;
            name += 6;
        } else if (strncasecmp(name, "ctrl+", 5) == 0) {
            *modifiers |= CTRL;
            name += 5;
        } else {
            return parse_plain(name, key);
        }
    }
}
