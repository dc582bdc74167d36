/* Panels on the dome. */
#include "tool/panel_draw.h"

#include <math.h>
#include <string.h>

#include <cupola/dome.h>

#include "angles.h"
#include "tool/panel.h"

enum {
    GAP = 6,    /* between columns, units of the letters */
    MARGIN = 4, /* of the ground round them, likewise */
};

/* Of the ground, in light: as little is left of white that lies under it as over the window. */
static const float ground_light = 0.99f;

static const struct {
    float ink[3];
    double pitch_deg;  /* from where it is read */
    double hangs;      /* how much of it is below: 1 all, 0.5 one half, 0 nothing */
    double widest_rad; /* what would be larger is drawn smaller */
    double highest_rad;
} looks[PANELS] = {
    [PANEL_LEGEND] = {{0.9f, 0.9f, 0.9f}, -12, 1, 1.5, 0.65},
    [PANEL_HELP] = {{0.9f, 0.85f, 0.6f}, 0, 0.5, 1.8, 1.5},
    [PANEL_WARNING] = {{1.0f, 0.12f, 0.08f}, 11, 0, 1.2, 0.3},
    [PANEL_NOTICE] = {{0.4f, 1.0f, 0.4f}, 4, 0, 1.2, 0.3},
};

/* Of a panel's columns, in units of the letters; returns the width of them all. */
static double measure_columns(const struct panel *panel, double widths[PANEL_COLUMNS],
                              double *height)
{
    double sum = 0, up;

    *height = 0;
    for (int i = 0; i < panel->columns; i++) {
        dome_text_size(panel->text[i], &widths[i], &up);
        *height = fmax(*height, up);
        sum += widths[i] + (i > 0 ? GAP : 0);
    }
    return sum;
}

/* Columns side by side, level with each other. Returns how far up they reach. */
static double draw_on_dome(struct dome_text *text, const struct tool *tool, const cupola_dome *dome,
                           unsigned int points, double pitch_deg, enum panel_place place)
{
    double pitch = pitch_deg * rad_per_deg, widths[PANEL_COLUMNS], height, own, sum, x;
    struct dome_label label = {.direction = {0, sin(pitch), -cos(pitch)}, .ground = ground_light};
    struct panel panel;

    panel_write(tool, place, 44, &panel);
    if (panel.columns == 0)
        return pitch_deg;
    sum = measure_columns(&panel, widths, &height);
    memcpy(label.ink, looks[place].ink, sizeof label.ink);
    label.unit_rad = fmin(1.4 * dome_pixel_rad(dome, tool->output, label.direction),
                          looks[place].widest_rad / fmax(sum, 1));
    label.unit_rad = fmin(label.unit_rad, looks[place].highest_rad / fmax(height, 1));
    x = -0.5 * sum;
    /* One ground for them all, over labels of the pattern. */
    label.corner[0] = x - MARGIN;
    label.corner[1] = -height * looks[place].hangs - MARGIN;
    label.size[0] = sum + 2 * MARGIN;
    label.size[1] = height + 2 * MARGIN;
    dome_text_draw(text, cupola_dome_rig(dome), tool->output, points, &label);
    label.ground = 0;
    for (int i = 0; i < panel.columns; i++) {
        dome_text_size(panel.text[i], &widths[i], &own);
        label.text = panel.text[i];
        label.corner[0] = x;
        label.corner[1] = height * (1 - looks[place].hangs) - own;
        dome_text_draw(text, cupola_dome_rig(dome), tool->output, points, &label);
        x += widths[i] + GAP;
    }
    return pitch_deg +
           atan((height * (1 - looks[place].hangs) + MARGIN) * label.unit_rad) / rad_per_deg;
}

static bool is_lit(const cupola_dome *dome, int output, double yaw_deg, double pitch_deg)
{
    double yaw = yaw_deg * rad_per_deg, pitch = pitch_deg * rad_per_deg, pixel[2];
    const double direction[3] = {-cos(pitch) * sin(yaw), sin(pitch), -cos(pitch) * cos(yaw)};

    return cupola_dome_pixel(dome, output, NULL, direction, pixel) == 1;
}

/*
 * How far above straight ahead text is read: as little as it takes for all from `low` to `high`
 * round there to be lit, since a planetarium has nothing below the horizon; else where the dome's
 * axis is.
 */
static double find_raised_deg(const cupola_dome *dome, int output, double low_deg, double high_deg)
{
    const double side_deg = 25, step_deg = 5;

    for (double up = 0; up <= 90; up += step_deg)
        if (is_lit(dome, output, 0, up + low_deg) && is_lit(dome, output, 0, up + high_deg) &&
            is_lit(dome, output, side_deg, up + low_deg) &&
            is_lit(dome, output, -side_deg, up + low_deg))
            return up;
    return cupola_dome_rig(dome)->tilt_rad / rad_per_deg;
}

void panels_draw_on_dome(struct dome_text *text, const struct tool *tool, const cupola_dome *dome,
                         unsigned int points)
{
    /* The help needs all the room there is. */
    double low_deg = -40, high_deg = tool->shows_help ? 35 : 18;
    double raised_deg = find_raised_deg(dome, tool->output, low_deg, high_deg), top_deg;

    if (tool->shows_help) {
        draw_on_dome(text, tool, dome, points, raised_deg + looks[PANEL_HELP].pitch_deg,
                     PANEL_HELP);
        return;
    }
    draw_on_dome(text, tool, dome, points, raised_deg + looks[PANEL_LEGEND].pitch_deg,
                 PANEL_LEGEND);
    top_deg = draw_on_dome(text, tool, dome, points, raised_deg + looks[PANEL_NOTICE].pitch_deg,
                           PANEL_NOTICE);
    draw_on_dome(text, tool, dome, points,
                 fmax(raised_deg + looks[PANEL_WARNING].pitch_deg, top_deg + 1.5), PANEL_WARNING);
}
