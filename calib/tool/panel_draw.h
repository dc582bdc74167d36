/* Panels of text: where they stand, over the window and on the dome. */
#ifndef PANEL_DRAW_H
#define PANEL_DRAW_H

#include "overlay.h"
#include "tool/dome_text.h"
#include "tool/focus.h"
#include "tool/tool.h"

/* What panels stay clear of as far as there is room: boxes of the window, px from its top left. */
struct panel_clear {
    int count;
    struct panel_box {
        double x, y, width, height;
    } list[FOCUS_MAX];
};

/* Over a frame of `width` x `height` px in a framebuffer. */
void panels_draw(struct overlay *overlay, const struct tool *tool, unsigned int framebuffer,
                 int width, int height, const struct panel_clear *clear);

/* On the dome of the rig that is shown, into the framebuffer that is bound, as dome_text_draw. */
void panels_draw_on_dome(struct dome_text *text, const struct tool *tool, const cupola_dome *dome,
                         unsigned int points);

#endif
