/* Where panels of text stand, over the window and on the dome. */
#ifndef PANEL_DRAW_H
#define PANEL_DRAW_H

#include "overlay.h"
#include "tool/dome_text.h"
#include "tool/tool.h"

/* Over a frame of `width` x `height` px in a framebuffer. */
void panels_draw(struct overlay *overlay, const struct tool *tool, unsigned int framebuffer,
                 int width, int height);

/*
 * On the dome, into the framebuffer that is bound, as dome_text_draw does it. A pixel in the middle
 * of the image is `per_px_rad` wide.
 */
void panels_draw_on_dome(struct dome_text *text, const struct tool *tool,
                         const struct cupola_rig *rig, unsigned int points, double per_px_rad);

#endif
