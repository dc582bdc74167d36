/* What the panels of text say. */
#include "tool/panel.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "tool/keys.h"
#include "tool/parameters.h"

__attribute__((format(printf, 2, 3))) static void add(char *column, const char *format, ...)
{
    size_t used = strlen(column);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(column + used, PANEL_TEXT - used, format, arguments);
    va_end(arguments);
}

static const char *file_name(const char *path)
{
    const char *slash = path ? strrchr(path, '/') : NULL;

    return slash ? slash + 1 : path ? path : "no file";
}

/* One line in each of the columns. */
static void add_line(struct panel *panel, const char *name, const char *value, const char *step)
{
    add(panel->text[0], "%s\n", name);
    add(panel->text[1], "%s\n", value);
    add(panel->text[2], "%s\n", step);
}

static void add_parameter(const struct tool *tool, struct panel *panel, int which)
{
    static const char *const keys[3] = {"Left Right", "Up Down", "Page Up Down"};
    char name[80], value[80], step[120];
    enum parameter parameter;

    if (!tool_group_parameter(tool, which, &parameter))
        return;
    parameter_label(parameter, name, sizeof name);
    parameter_text(tool, parameter, value, sizeof value);
    /* There is little room on the dome. */
    snprintf(step, sizeof step, "%s%sstep %g", tool->text_on_dome ? "" : keys[which],
             tool->text_on_dome ? "" : ": ", tool->step_scale * parameter_step(tool, parameter));
    add_line(panel, name, value, step);
}

/* What came from a tracker: reports, then what was none, so that whoever sends wrongly sees it. */
static void add_tracker(const struct tool *tool, struct panel *panel)
{
    const struct viewer_osc_counts *counts = &tool->tracker.counts;
    const struct {
        long count;
        const char *what;
    } kinds[] = {{counts->others, "not /viewer x y z"},
                 {counts->malformed, "no OSC"},
                 {counts->refused, "refused"},
                 {counts->late, "late"}};
    char reports[200], rest[200] = "";

    if (!*tool->tracker.address)
        return;
    snprintf(reports, sizeof reports, "%s: %ld report%s", tool->tracker.address, counts->taken,
             counts->taken == 1 ? "" : "s");
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        size_t used = strlen(rest);
        if (kinds[i].count > 0)
            snprintf(rest + used, sizeof rest - used, "%s%ld %s", used ? ", " : "", kinds[i].count,
                     kinds[i].what);
    }
    add_line(panel, "tracker", reports, rest);
}

static void write_legend(const struct tool *tool, struct panel *panel)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    double eye_m[3] = {tool->rig.eye_m[0], tool->rig.eye_m[1], tool->rig.eye_m[2]};
    char text[200], number[80];

    tool_live_eye(tool, tool->rig.screen.radius_m, eye_m);
    panel->columns = 3;
    add_line(panel, tool_group_name(tool->group), "", tool->shows_before ? "BEFORE" : "");
    for (int which = 0; which < 3; which++)
        add_parameter(tool, panel, which);
    if (tool->text_on_dome)
        return;
    add_line(panel, "", "", "");
    parameter_text(tool, PARAMETER_FOV, number, sizeof number);
    snprintf(text, sizeof text, "%s %s", cupola_lens_model_name((int)output->lens.model), number);
    add_line(panel, "lens", text, "");
    snprintf(text, sizeof text, "%.3f, %.3f, %.3f m", output->position_m[0], output->position_m[1],
             output->position_m[2]);
    add_line(panel, "projector", text, "");
    snprintf(text, sizeof text, "%.3f, %.3f, %.3f m", eye_m[0], eye_m[1], eye_m[2]);
    add_line(panel, "viewer", text, tool->viewer_lives ? "from the tracker" : "");
    add_tracker(tool, panel);
    snprintf(text, sizeof text, "%s about the %s", tool_pattern_name(tool->pattern),
             tool_about_name(tool->about));
    add_line(panel, "pattern", text, "");
    snprintf(text, sizeof text, "%s%s", file_name(tool->rig_path),
             tool->unsaved ? " (unsaved)" : "");
    add_line(panel, "file", text, "");
}

/* The values belong to what is seen. */
static void write_shown_legend(const struct tool *tool, struct panel *panel)
{
    struct tool shown = *tool;

    if (tool->shows_before)
        shown.rig = tool->before;
    write_legend(&shown, panel);
}

static void write_help(struct panel *panel)
{
    struct key_line line;

    panel->columns = 2;
    for (int i = 0; key_line(i, &line); i++) {
        add(panel->text[0], "%s\n", line.keys);
        add(panel->text[1], "%s\n", line.help);
    }
}

/* Breaks a long line where a blank is. */
static void wrap(char *text, int width)
{
    char *line = text, *blank = NULL;

    for (char *at = text; *at; at++) {
        if (*at == ' ')
            blank = at;
        if (*at == '\n') {
            line = at + 1;
            blank = NULL;
        }
        if (at - line >= width && blank) {
            *blank = '\n';
            line = blank + 1;
            blank = NULL;
        }
    }
}

static void write_message(const char *message, int width, struct panel *panel)
{
    panel->columns = *message != 0;
    add(panel->text[0], "%s", message);
    wrap(panel->text[0], width);
}

static void write_warnings(const struct tool *tool, int width, struct panel *panel)
{
    char text[2 * MESSAGE_SIZE];

    tool_warnings(tool, "\n", text);
    write_message(text, width, panel);
}

void panel_write(const struct tool *tool, enum panel_place place, int width, struct panel *panel)
{
    memset(panel, 0, sizeof *panel);
    if (place == PANEL_LEGEND && tool->shows_legend)
        write_shown_legend(tool, panel);
    else if (place == PANEL_HELP && tool->shows_help)
        write_help(panel);
    else if (place == PANEL_WARNING)
        write_warnings(tool, width, panel);
    else if (place == PANEL_NOTICE)
        write_message(tool->notice, width, panel);
    /* No empty lines at the end: less is hidden. */
    for (int i = 0; i < panel->columns; i++) {
        size_t length = strlen(panel->text[i]);
        while (length > 0 && panel->text[i][length - 1] == '\n')
            panel->text[i][--length] = 0;
    }
}
