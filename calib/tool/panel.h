/*
 * Panels of text: the legend with the values that keys change, the help, the warning, the notice.
 * What they say; where and how they are drawn is the stage's.
 */
#ifndef PANEL_H
#define PANEL_H

#include "tool/tool.h"

enum { PANEL_COLUMNS = 3, PANEL_TEXT = 1600 /* bytes of a column */, PANELS = 4 };

enum panel_place {
    PANEL_LEGEND,
    PANEL_HELP,
    PANEL_WARNING,
    PANEL_NOTICE,
};

/* Lines stand side by side in columns. */
struct panel {
    int columns; /* 0: nothing to say */
    char text[PANEL_COLUMNS][PANEL_TEXT];
};

/* What a panel says now; lines are at most about `width` letters long. */
void panel_write(const struct tool *tool, enum panel_place place, int width, struct panel *panel);

#endif
