/* Panels over the window, clear of what is worked with. */
#include <math.h>
#include <string.h>

#include "tool/panel.h"
#include "tool/panel_draw.h"

enum { GROUND = 230, EDGE = 4 /* px between a panel and the window's edge */ };

static const unsigned char inks[PANELS][4] = {
    [PANEL_LEGEND] = {255, 255, 255, 255},
    [PANEL_HELP] = {255, 240, 200, 255},
    [PANEL_WARNING] = {255, 90, 80, 255},
    [PANEL_NOTICE] = {170, 255, 170, 255},
};

/* Columns side by side at a place of the window, px from its top left. */
struct laid {
    struct panel panel;
    double scale, x, y, width, height;
    double widths[PANEL_COLUMNS], heights[PANEL_COLUMNS];
};

static void measure(struct laid *laid, double scale)
{
    laid->scale = scale;
    laid->width = laid->height = 0;
    for (int i = 0; i < laid->panel.columns; i++) {
        overlay_size(laid->panel.text[i], scale, &laid->widths[i], &laid->heights[i]);
        laid->width += laid->widths[i];
        laid->height = fmax(laid->height, laid->heights[i]);
    }
}

/* The largest letters, in halves, with which a panel fits; `most` at most. */
static void fit(struct laid *laid, double most, double width, double height)
{
    for (double scale = most; scale >= 1; scale -= 0.5) {
        measure(laid, scale);
        if (laid->width <= width && laid->height <= height)
            return;
    }
}

/* What a panel would hide of what is worked with, px of the window's area. */
static double hides(const struct laid *laid, const struct panel_clear *clear)
{
    double area = 0, x = laid->x;

    for (int i = 0; i < laid->panel.columns; x += laid->widths[i++]) {
        for (int k = 0; k < clear->count; k++) {
            const struct panel_box *box = &clear->list[k];
            double across = fmin(x + laid->widths[i], box->x + box->width) - fmax(x, box->x);
            double down =
                fmin(laid->y + laid->heights[i], box->y + box->height) - fmax(laid->y, box->y);
            area += fmax(across, 0) * fmax(down, 0);
        }
    }
    return area;
}

/*
 * In the first corner and with the largest letters that hide nothing, else the least; smaller ones
 * come before another corner. `room` is how wide the image's part of the window is, `bottom` where
 * messages begin.
 */
static void lay_legend(struct laid *laid, int width, int room, double bottom, double most,
                       const struct panel_clear *clear)
{
    struct laid best;
    double least = HUGE_VAL;

    fit(laid, most, room - 2 * EDGE, bottom - 2 * EDGE);
    most = laid->scale;
    best = *laid;
    for (int corner = 0; corner < 4 && least > 0; corner++) {
        for (double scale = most; scale >= 1 && least > 0; scale -= 0.5) {
            measure(laid, scale);
            laid->x = corner < 2 ? EDGE : fmax(EDGE, width - EDGE - laid->width);
            laid->y = corner % 2 == 0 ? EDGE : fmax(EDGE, bottom - EDGE - laid->height);
            if (hides(laid, clear) < least) {
                least = hides(laid, clear);
                best = *laid;
            }
        }
    }
    *laid = best;
}

/* In the middle, above `bottom`, and above what it would hide. */
static void lay_message(struct laid *laid, int width, double bottom, double most,
                        const struct panel_clear *clear)
{
    fit(laid, most, width - 2 * EDGE, bottom - 2 * EDGE);
    laid->x = fmax(EDGE, (width - laid->width) / 2);
    laid->y = bottom - laid->height;
    for (int i = 0; i < clear->count; i++) {
        double raised = clear->list[i].y - laid->height;
        struct panel_clear one = {1, {clear->list[i]}};
        if (hides(laid, &one) > 0 && raised >= 0)
            laid->y = raised;
    }
}

/* All the room there is but for a line or two of messages. */
static void lay_help(struct laid *laid, int width, int height, double most)
{
    const double footer_px = 90;

    fit(laid, most, width - 2 * EDGE, height - 2 * EDGE - footer_px);
    laid->x = fmax(EDGE, (width - laid->width) / 2);
    laid->y = EDGE;
}

static void draw(struct overlay *overlay, struct overlay_place place, enum panel_place what,
                 const struct laid *laid)
{
    place.x = laid->x;
    place.y = laid->y;
    place.scale = laid->scale;
    place.ink = inks[what];
    place.ground = GROUND;
    for (int i = 0; i < laid->panel.columns; i++) {
        overlay_text(overlay, &place, laid->panel.text[i]);
        place.x += laid->widths[i];
    }
}

void panels_draw(struct overlay *overlay, const struct tool *tool, unsigned int framebuffer,
                 int width, int height, const struct panel_clear *clear)
{
    const struct overlay_place place = {
        .framebuffer = framebuffer, .width = width, .height = height};
    const double most = width >= 900 && height >= 500 ? 2 : 1;
    struct laid laid[PANELS];
    double bottom = height - EDGE;

    for (int i = 0; i < PANELS; i++)
        panel_write(tool, (enum panel_place)i, width / (width >= 900 ? 16 : 8) - 2, &laid[i].panel);
    for (int i = PANEL_NOTICE; i >= PANEL_WARNING; i--) {
        if (laid[i].panel.columns == 0)
            continue;
        lay_message(&laid[i], width, bottom, most, clear);
        bottom = laid[i].y - 2;
    }
    lay_help(&laid[PANEL_HELP], width, height, most);
    lay_legend(&laid[PANEL_LEGEND], width, tool->preview == PREVIEW_NONE ? width : width / 2,
               bottom, most, clear);
    for (int i = 0; i < PANELS; i++)
        if (laid[i].panel.columns > 0 && !(i == PANEL_LEGEND && tool->shows_help))
            draw(overlay, place, (enum panel_place)i, &laid[i]);
}
