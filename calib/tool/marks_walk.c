/* From mark to mark with the cross-hair: each place of the screen gets its pixel. */
#include "tool/marks_walk.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/projection.h>
#include <cupola/text.h>

#include "tool/state.h"

int marks_walk_next(const struct tool *tool, int mark)
{
    for (int i = 1; i <= tool->marks.count; i++) {
        int next = (mark + i) % tool->marks.count;
        if (!tool->marks.list[next].steered)
            return next;
    }
    return mark < 0 ? 0 : mark;
}

/* Its name as it is drawn; how many letters of it cannot be. */
static int drawn_name(const struct tool *tool, int mark, char name[MARK_NAME_MAX + 1])
{
    return cupola_text_letters(tool->marks.list[mark].name, name, MARK_NAME_MAX + 1);
}

static bool is_drawn_name(const struct tool *tool, const char *label)
{
    char name[MARK_NAME_MAX + 1];

    for (int i = 0; i < tool->marks.count; i++)
        if (drawn_name(tool, i, name) == 0 && strcmp(name, label) == 0)
            return true;
    return false;
}

void marks_walk_label(const struct tool *tool, int mark, char label[MARK_NAME_MAX + 1])
{
    if (drawn_name(tool, mark, label) == 0)
        return;
    snprintf(label, MARK_NAME_MAX + 1, "mark %d", mark + 1);
    for (int i = 2; is_drawn_name(tool, label); i++)
        snprintf(label, MARK_NAME_MAX + 1, "mark %d (%d)", mark + 1, i);
}

int marks_walk_steered(const struct tool *tool)
{
    int steered = 0;

    for (int i = 0; i < tool->marks.count; i++)
        steered += tool->marks.list[i].steered;
    return steered;
}

void marks_walk_to(struct tool *tool, int index)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    const int size_px[2] = {output->width_px, output->height_px};
    const struct mark *mark;
    double point_m[3], pixel_px[2];

    if (tool->marks.count == 0)
        return;
    tool->mark = index;
    mark = &tool->marks.list[index];
    memcpy(pixel_px, mark->pixel_px, sizeof pixel_px);
    for (int i = 0; i < 3; i++)
        point_m[i] =
            mark->place[i] * (tool->marks.kind == MARKS_DIRECTIONS ? tool->rig.screen.radius_m : 1);
    if (!mark->steered && cupola_output_pixel(output, point_m, pixel_px, NULL) < 0)
        return;
    for (int i = 0; i < 2; i++)
        if (isfinite(pixel_px[i]))
            tool->cross_px[i] = fmin(fmax(pixel_px[i], 0), size_px[i]);
}

static bool refuse_without(struct tool *tool)
{
    if (tool->marks.count > 0)
        return false;
    snprintf(tool->warning, MESSAGE_SIZE, "there are no marks; give --marks FILE.csv");
    return true;
}

void marks_walk_accept(struct tool *tool)
{
    struct values before;
    struct mark_state state = tool_mark_state(tool, tool->mark);
    char label[MARK_NAME_MAX + 1], next[MARK_NAME_MAX + 1];
    int index = tool->mark, left;
    struct mark *mark;

    if (refuse_without(tool))
        return;
    mark = &tool->marks.list[index];
    values_take(tool, &before);
    mark->steered = true;
    memcpy(mark->pixel_px, tool->cross_px, sizeof mark->pixel_px);
    left = tool->marks.count - marks_walk_steered(tool);
    marks_walk_to(tool, marks_walk_next(tool, index));
    tool_commit(tool, &before, index, &state, -1);
    marks_walk_label(tool, index, label);
    marks_walk_label(tool, tool->mark, next);
    if (left > 0)
        snprintf(tool->notice, MESSAGE_SIZE, "%s is at (%.1f, %.1f) px; next %s, %d of %d left",
                 label, mark->pixel_px[0], mark->pixel_px[1], next, left, tool->marks.count);
    else
        snprintf(tool->notice, MESSAGE_SIZE,
                 "%s is at (%.1f, %.1f) px; all %d marks are steered to", label, mark->pixel_px[0],
                 mark->pixel_px[1], tool->marks.count);
}

void marks_walk_forget(struct tool *tool)
{
    struct values before;
    struct mark_state state = tool_mark_state(tool, tool->mark);
    char label[MARK_NAME_MAX + 1];

    if (refuse_without(tool))
        return;
    values_take(tool, &before);
    tool->marks.list[tool->mark].steered = false;
    tool->marks.list[tool->mark].pixel_px[0] = tool->marks.list[tool->mark].pixel_px[1] = 0;
    marks_walk_to(tool, tool->mark);
    tool_commit(tool, &before, tool->mark, &state, -1);
    marks_walk_label(tool, tool->mark, label);
    snprintf(tool->notice, MESSAGE_SIZE, "%s is forgotten", label);
}
