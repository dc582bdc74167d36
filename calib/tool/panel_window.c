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

/* What a panel is to leave in sight: what is worked with before all else, then other panels. */
struct taken {
    int count;
    struct taken_box {
        struct panel_box box;
        double worth; /* of each px */
    } list[FOCUS_MAX + PANELS];
};

static void take(struct taken *taken, struct panel_box box, double worth)
{
    if (taken->count < FOCUS_MAX + PANELS)
        taken->list[taken->count++] = (struct taken_box){box, worth};
}

static void take_panel(struct taken *taken, const struct laid *laid)
{
    const double beside_px = 2;

    take(taken,
         (struct panel_box){laid->x - beside_px, laid->y - beside_px, laid->width + 2 * beside_px,
                            laid->height + 2 * beside_px},
         1);
}

/* What a panel would hide. */
static double hides(const struct laid *laid, const struct taken *taken)
{
    double hidden = 0, x = laid->x;

    for (int i = 0; i < laid->panel.columns; x += laid->widths[i++]) {
        for (int k = 0; k < taken->count; k++) {
            const struct panel_box *box = &taken->list[k].box;
            double across = fmin(x + laid->widths[i], box->x + box->width) - fmax(x, box->x);
            double down =
                fmin(laid->y + laid->heights[i], box->y + box->height) - fmax(laid->y, box->y);
            hidden += taken->list[k].worth * fmax(across, 0) * fmax(down, 0);
        }
    }
    return hidden;
}

/*
 * To the lowest place of its column that hides the least: at the window's end, or right above
 * something. Returns how much it hides.
 */
static double lay_low(struct laid *laid, int height, const struct taken *taken)
{
    double least = HUGE_VAL, best_y = 0;

    for (int i = -1; i < taken->count; i++) {
        double end = fmin(height - EDGE, i < 0 ? HUGE_VAL : taken->list[i].box.y);
        double hidden;
        laid->y = floor(end - laid->height);
        if (i < 0)
            laid->y = fmax(laid->y, 0);
        if (laid->y < 0)
            continue;
        hidden = hides(laid, taken);
        if (hidden < least || (!(hidden > least) && laid->y > best_y)) {
            least = hidden;
            best_y = laid->y;
        }
    }
    laid->y = best_y;
    return least;
}

/*
 * In the first corner and with the largest letters that hide nothing, else the least; smaller ones
 * come before another corner. `room` is how wide the image's part of the window is.
 */
static void lay_legend(struct laid *laid, int width, int height, int room, double most,
                       const struct taken *taken)
{
    struct laid best;
    double least = HUGE_VAL;

    fit(laid, most, room - 2 * EDGE, height - 2 * EDGE);
    most = laid->scale;
    best = *laid;
    for (int corner = 0; corner < 4 && least > 0; corner++) {
        for (double scale = most; scale >= 1 && least > 0; scale -= 0.5) {
            double hidden;
            measure(laid, scale);
            laid->x = corner < 2 ? EDGE : fmax(EDGE, width - EDGE - laid->width);
            laid->y = EDGE;
            hidden = corner % 2 == 0 ? hides(laid, taken) : lay_low(laid, height, taken);
            if (hidden < least) {
                least = hidden;
                best = *laid;
            }
        }
    }
    *laid = best;
}

/* In the middle, as low and with as large letters as hide nothing, else the least. */
static void lay_message(struct laid *laid, int width, int height, double most,
                        const struct taken *taken)
{
    struct laid best;
    double least = HUGE_VAL;

    fit(laid, most, width - 2 * EDGE, height - 2 * EDGE);
    best = *laid;
    for (double scale = laid->scale; scale >= 1 && least > 0; scale -= 0.5) {
        double hidden;
        measure(laid, scale);
        laid->x = fmax(EDGE, (width - laid->width) / 2);
        hidden = lay_low(laid, height, taken);
        if (hidden < least) {
            least = hidden;
            best = *laid;
        }
    }
    *laid = best;
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

/* Messages from the last up, then the legend where there is room. */
static void lay_all(struct laid laid[PANELS], const struct tool *tool, int width, int height,
                    const struct panel_clear *clear)
{
    const double most = width >= 900 && height >= 500 ? 2 : 1, before_all = 1e6;
    struct taken taken = {0};

    for (int i = 0; i < clear->count; i++)
        take(&taken, clear->list[i], before_all);
    for (int i = PANEL_NOTICE; i >= PANEL_WARNING; i--) {
        if (laid[i].panel.columns == 0)
            continue;
        lay_message(&laid[i], width, height, most, &taken);
        take_panel(&taken, &laid[i]);
    }
    lay_help(&laid[PANEL_HELP], width, height, most);
    lay_legend(&laid[PANEL_LEGEND], width, height,
               tool->preview == PREVIEW_NONE ? width : width / 2, most, &taken);
}

void panels_draw(struct overlay *overlay, const struct tool *tool, unsigned int framebuffer,
                 int width, int height, const struct panel_clear *clear)
{
    const struct overlay_place place = {
        .framebuffer = framebuffer, .width = width, .height = height};
    struct laid laid[PANELS];

    for (int i = 0; i < PANELS; i++)
        panel_write(tool, (enum panel_place)i, width / (width >= 900 ? 16 : 8) - 2, &laid[i].panel);
    lay_all(laid, tool, width, height, clear);
    for (int i = 0; i < PANELS; i++)
        if (laid[i].panel.columns > 0 && !(i == PANEL_LEGEND && tool->shows_help))
            draw(overlay, place, (enum panel_place)i, &laid[i]);
}
