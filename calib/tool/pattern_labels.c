/* Labels of patterns. Directions are written in the pattern's frame, as in its shader. */
#include "tool/pattern_labels.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/dome.h>

#include "angles.h"
#include "rotation.h"
#include "tool/pattern.h"

static const float white[3] = {0.9f, 0.9f, 0.9f}, yellow[3] = {0.9f, 0.7f, 0.2f},
                   red[3] = {1.0f, 0.15f, 0.1f}, green[3] = {0.1f, 0.8f, 0.15f},
                   blue[3] = {0.25f, 0.5f, 1.0f};

/* What is under way. */
struct list {
    const struct tool *tool;
    const cupola_dome *dome;
    const struct cupola_rig *rig; /* the dome's */
    struct pattern_frame frame;
    struct pattern_labels *labels;
};

/* Where a label stands beside its direction: across and up, -1, 0 or 1 each. */
struct side {
    int across, up;
};

/* From the pattern's frame to the direction from the eye in the camera's. */
static void direction_of(const struct list *list, const double v[3], double direction[3])
{
    const struct cupola_rig *rig = list->rig;
    double tilt[9], seen[3];

    if (list->frame.about_viewer) {
        memcpy(direction, v, 3 * sizeof *v);
        return;
    }
    for (int i = 0; i < 3; i++)
        seen[i] = rig->screen.radius_m * v[i] - rig->eye_m[i];
    rotation_from_tilt(rig->tilt_rad, tilt);
    rotation_apply(tilt, seen, direction);
}

/* Returns the label, to be changed; NULL where the list is full. */
__attribute__((format(printf, 5, 6))) static struct dome_label *put(struct list *list,
                                                                    const double v[3],
                                                                    struct side side,
                                                                    const float ink[3],
                                                                    const char *format, ...)
{
    struct pattern_labels *labels = list->labels;
    struct dome_label *label = &labels->list[labels->count];
    va_list arguments;

    if (labels->count == PATTERN_LABELS_MAX)
        return NULL;
    va_start(arguments, format);
    vsnprintf(labels->texts[labels->count], PATTERN_LABEL_TEXT, format, arguments);
    va_end(arguments);
    *label = (struct dome_label){.text = labels->texts[labels->count], .ground = 0.8f};
    direction_of(list, v, label->direction);
    label->unit_rad = pattern_label_unit_rad(list->dome, list->tool->output, label->direction);
    memcpy(label->ink, ink, sizeof label->ink);
    dome_label_anchor(label, side.across, side.up);
    labels->count++;
    return label;
}

/* Off the middle and round it, from the right counter-clockwise. */
static const double *round_middle(double off_deg, double round_deg, double v[3])
{
    double off = off_deg * rad_per_deg, round = round_deg * rad_per_deg;

    v[0] = sin(off) * cos(round);
    v[1] = sin(off) * sin(round);
    v[2] = -cos(off);
    return v;
}

/* To the left and above the horizon, the zenith being +Y. */
static const double *above_horizon(double left_deg, double up_deg, double v[3])
{
    double left = left_deg * rad_per_deg, up = up_deg * rad_per_deg;

    v[0] = -cos(up) * sin(left);
    v[1] = sin(up);
    v[2] = -cos(up) * cos(left);
    return v;
}

static void label_viewer_grid(struct list *list)
{
    const struct side beside = {1, 1};
    double v[3];

    for (int left = -150; left <= 180; left += 30) {
        const char *end = left % 180 == 0 ? "" : left > 0 ? " L" : " R";
        put(list, above_horizon(left, 0, v), beside, left ? yellow : white, "%d%s",
            left < 0 ? -left : left, end);
    }
    for (int left = -90; left <= 90; left += 90)
        for (int up = -60; up <= 60; up += 30)
            if (up != 0)
                put(list, above_horizon(left, up, v), beside, left ? white : blue, "%+d", up);
    /* Where the horizon is not lit. */
    for (int left = -150; left <= 150; left += 30)
        if (left % 90 != 0)
            put(list, above_horizon(left, 30, v), beside, yellow, "%d %c", abs(left),
                left > 0 ? 'L' : 'R');
    put(list, above_horizon(0, 90, v), (struct side){0, 0}, white, "zenith");
}

/* Latitudes are 90 at the pole, where the dome's axis is. */
static void label_dome_grid(struct list *list)
{
    static const char *const latitudes[6] = {"+90", "+60", "+30", "0", "-30", "-60"};
    const struct side beside = {1, 1};
    double v[3];

    for (int round = 0; round < 360; round += 30)
        put(list, round_middle(60, round, v), beside, yellow, "%d", round);
    for (int round = 0; round < 360; round += 90)
        for (int off = 30; off <= 150; off += 30)
            if (off != 60)
                put(list, round_middle(off, round, v), beside, round ? white : blue, "%s",
                    latitudes[off / 30]);
    put(list, round_middle(0, 0, v), (struct side){0, 0}, white, "90");
}

/* Of a planetarium the dome's +Y is behind the viewer: about the dome it is no more than that. */
static void label_meridians(struct list *list)
{
    const char *up = list->frame.about_viewer ? "UP" : "+Y";
    const char *down = list->frame.about_viewer ? "DOWN" : "-Y";
    double v[3];

    for (int off = 30; off <= 90; off += 30) {
        put(list, round_middle(off, 180, v), (struct side){0, 1}, red, "%d L", off);
        put(list, round_middle(off, 0, v), (struct side){0, 1}, green, "%d R", off);
        put(list, round_middle(off, 90, v), (struct side){1, 0}, blue, "%d %s", off, up);
        put(list, round_middle(off, 270, v), (struct side){1, 0}, white, "%d %s", off, down);
    }
    put(list, round_middle(12, 180, v), (struct side){0, 0}, red, "LEFT");
    put(list, round_middle(12, 0, v), (struct side){0, 0}, green, "RIGHT");
    put(list, round_middle(12, 90, v), (struct side){0, 0}, blue, "%s", up);
    put(list, round_middle(5, 225, v), (struct side){0, -1}, white,
        list->frame.about_viewer ? "straight ahead" : "axis of the dome");
}

static void label_circles(struct list *list)
{
    double v[3];

    for (int off = 10; off < 180; off += 10) {
        put(list, round_middle(off, 90, v), (struct side){1, 0}, off % 30 ? white : yellow, "%d",
            off);
        if (off % 30)
            continue;
        for (int round = 0; round < 360; round += 90)
            if (round != 90)
                put(list, round_middle(off, round, v), (struct side){1, 1}, yellow, "%d", off);
    }
}

static void label_checker(struct list *list)
{
    double v[3];

    put(list, round_middle(0, 0, v), (struct side){0, 0}, white,
        "each field 2 pi / 144 = 0.0436 sr");
}

static void label_star(struct list *list, double off_deg, double round_deg)
{
    static const float *const inks[4] = {red, yellow, green, blue};
    double v[3];

    round_middle(off_deg, round_deg, v);
    for (int i = 0; i < 4; i++) {
        /* In a row below the star, as the viewer sees it. */
        struct dome_label *label = put(list, v, (struct side){0, 0}, inks[i], "%d", 1 << i);
        if (!label)
            return;
        label->corner[0] = (i - 2) * 10 + 1;
        label->corner[1] = -9 * rad_per_deg / label->unit_rad - 6;
    }
}

static void label_wedges(struct list *list)
{
    double spacing_deg = pattern_star_spacing_rad(list->rig) / rad_per_deg, v[3];
    struct dome_label *unit;

    label_star(list, 0, 0);
    for (int round = 0; round < 360; round += 90)
        for (int ring = 1; ring <= 3; ring++)
            label_star(list, ring * spacing_deg, round);
    /* Under the numbers of the one in the middle. */
    unit = put(list, round_middle(0, 0, v), (struct side){0, 0}, white, "cycles per degree");
    if (unit)
        unit->corner[1] = -9 * rad_per_deg / unit->unit_rad - 19;
}

static void label_steps(struct list *list, double up_deg, int first, int step)
{
    double v[3];

    for (int i = 1; i < 16; i += 2)
        put(list, above_horizon(60 - 8 * i, up_deg, v), (struct side){0, 0}, white, "%d",
            first + step * i);
}

static void label_ramps(struct list *list)
{
    label_steps(list, 31.5, 240, 1);
    label_steps(list, 15.5, 0, 17);
    label_steps(list, -30.5, 0, 1);
}

/* The image's own places, as the viewer sees them. */
static void label_rim(struct list *list)
{
    const struct cupola_output *output = &list->rig->outputs[list->tool->output];
    const struct cupola_circle *circle = &output->circle;
    const double in_px = 0.1 * circle->radius_px;
    struct cupola_ray ray;
    struct pattern_frame dome_frame = list->frame;
    struct dome_label *label;

    list->frame.about_viewer = true; /* rays are the viewer's */
    for (int degrees = 0; degrees < 360; degrees += 90) {
        double c = cos(degrees * rad_per_deg), s = sin(degrees * rad_per_deg);
        double to_frame_px =
            fabs(c) > 0.5 ? (c > 0 ? output->width_px - circle->center_x_px : circle->center_x_px)
                          : (s > 0 ? output->height_px - circle->center_y_px : circle->center_y_px);
        double r_px = fmin(circle->radius_px, to_frame_px) - in_px;
        if (cupola_dome_ray(list->dome, list->tool->output, NULL, circle->center_x_px + r_px * c,
                            circle->center_y_px + r_px * s, &ray) != 1)
            continue;
        label = put(list, ray.direction, (struct side){0, 0}, degrees == 90 ? yellow : white,
                    degrees == 90 ? "%d TOP OF IMAGE" : "%d", degrees);
        if (label)
            label->matters = degrees == 90;
    }
    list->frame = dome_frame;
}

static void label_dot(struct list *list)
{
    struct dome_label *label;
    double v[3];

    pattern_dot(list->tool, v);
    label = put(list, v, (struct side){0, -1}, white, "yaw %.1f pitch %.1f",
                list->tool->dot_yaw_rad / rad_per_deg, list->tool->dot_pitch_rad / rad_per_deg);
    if (!label)
        return;
    label->matters = true;
    label->corner[1] -= 0.5 * list->tool->dot_size_rad / label->unit_rad;
}

double pattern_label_unit_rad(const cupola_dome *dome, int output, const double direction[3])
{
    double height_rad = 9 * dome_pixel_rad(dome, output, direction);

    return fmin(fmax(height_rad, 1.2 * rad_per_deg), 4 * rad_per_deg) / 7;
}

void pattern_labels_list(const struct tool *tool, const cupola_dome *dome,
                         struct pattern_labels *labels)
{
    struct list list = {.tool = tool, .dome = dome, .rig = cupola_dome_rig(dome), .labels = labels};

    labels->count = 0;
    pattern_frame(tool, list.rig, &list.frame);
    switch (tool->pattern) {
    case PATTERN_GRID:
        if (list.frame.about_viewer)
            label_viewer_grid(&list);
        else
            label_dome_grid(&list);
        break;
    case PATTERN_MERIDIANS:
        label_meridians(&list);
        break;
    case PATTERN_CIRCLES:
        label_circles(&list);
        break;
    case PATTERN_CHECKER:
        label_checker(&list);
        break;
    case PATTERN_WEDGES:
        label_wedges(&list);
        break;
    case PATTERN_RAMPS:
        label_ramps(&list);
        break;
    case PATTERN_RIM:
        label_rim(&list);
        break;
    case PATTERN_DOT:
        label_dot(&list);
        break;
    case PATTERN_COUNT:
        break;
    }
}
