/* Saving, and images of another size. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/rig_file.h>

#include "same_file.h"
#include "short_path.h"
#include "tool/journal.h"
#include "tool/marks_walk.h"
#include "tool/state.h"
#include "whole_file.h"

bool tool_save(struct tool *tool, const char *rig_path)
{
    struct cupola_error error = {0};
    struct whole_file marks = {0};
    /* Also where all were forgotten: the file would keep them. */
    bool writes_marks = marks_walk_steered(tool) > 0 || tool_marks_differ(tool);

    if (writes_marks && !marks_settle(&marks, tool->marks_path, &tool->marks, tool->warning))
        return false;
    if (cupola_rig_write(rig_path, &tool->rig, &error) < 0) {
        whole_file_abort(&marks);
        snprintf(tool->warning, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    if (writes_marks && !whole_file_end(&marks, tool->warning))
        return false;
    tool->warning[0] = '\0';
    if (writes_marks)
        snprintf(tool->notice, MESSAGE_SIZE, "saved %s and %s", short_path(rig_path).text,
                 short_path(tool->marks_path).text);
    else
        snprintf(tool->notice, MESSAGE_SIZE, "saved %s", short_path(rig_path).text);
    if (same_file(rig_path, tool->rig_path)) {
        tool_note_saved(tool);
        journal_note(tool, "saved");
    } else if (writes_marks) {
        /* They have one file, wherever the rig goes. */
        tool_note_marks_saved(tool);
        journal_note(tool, "marks-saved");
    }
    return true;
}

/* What moves with the picture when its size changes. */
struct resizing {
    double scale;
    double from_px[2], to_px[2]; /* sizes */
    const struct tool *tool;     /* of the new size, to check against */
    char *message;               /* what is impossible then; empty: nothing */
};

static double moved(const struct resizing *resizing, double pixel_px, int axis)
{
    return 0.5 * resizing->to_px[axis] +
           resizing->scale * (pixel_px - 0.5 * resizing->from_px[axis]);
}

static void move_values(const struct resizing *resizing, struct values *values)
{
    for (int axis = 0; axis < 2; axis++) {
        double *cross = &values->raw[PARAMETER_CROSS_X + axis];
        double *center = &values->raw[PARAMETER_CIRCLE_X + axis];
        *cross = fmin(fmax(moved(resizing, *cross, axis), 0), resizing->to_px[axis]);
        *center = moved(resizing, *center, axis);
    }
    values->raw[PARAMETER_CIRCLE_RADIUS] *= resizing->scale;
}

static void move_step(void *user, struct values *values, struct change *step)
{
    const struct resizing *resizing = user;

    move_values(resizing, values);
    for (int axis = 0; step && step->mark >= 0 && axis < 2; axis++) {
        double *before = &step->mark_before.pixel_px[axis];
        double *after = &step->mark_after.pixel_px[axis];
        *before = step->mark_before.steered ? moved(resizing, *before, axis) : 0;
        *after = step->mark_after.steered ? moved(resizing, *after, axis) : 0;
    }
}

static void check_step(void *user, struct values *values, struct change *step)
{
    const struct resizing *resizing = user;
    struct values then = *values;

    (void)step;
    move_values(resizing, &then);
    if (resizing->message[0] == '\0')
        values_check(resizing->tool, &then, resizing->message);
}

static void move_marks(const struct resizing *resizing, struct marks *marks)
{
    for (int i = 0; i < marks->count; i++)
        for (int axis = 0; marks->list[i].steered && axis < 2; axis++)
            marks->list[i].pixel_px[axis] = moved(resizing, marks->list[i].pixel_px[axis], axis);
}

/* The rigs of the tool as they are in the new size. */
static bool resize_rigs(struct tool *tool, int width_px, int height_px, char *message)
{
    struct cupola_rig *const rigs[] = {&tool->rig, &tool->before, &tool->theatre};
    struct cupola_error error = {0};

    for (int i = 0; i < 3; i++) {
        if (tool->output < rigs[i]->output_count &&
            (cupola_output_resize(&rigs[i]->outputs[tool->output], width_px, height_px, &error) <
                 0 ||
             cupola_rig_complete(rigs[i], NULL, &error) < 0)) {
            snprintf(message, MESSAGE_SIZE, "%s", error.message);
            return false;
        }
    }
    return true;
}

bool tool_resize_quietly(struct tool *tool, int width_px, int height_px, char *message)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    struct resizing resizing = {.from_px = {output->width_px, output->height_px},
                                .to_px = {width_px, height_px}};
    struct tool resized = *tool;
    struct values values;

    if (output->width_px == width_px && output->height_px == height_px)
        return true;
    if (!resize_rigs(&resized, width_px, height_px, message))
        return false;
    resizing.scale = fmin(width_px / resizing.from_px[0], height_px / resizing.from_px[1]);
    resizing.tool = &resized;
    resizing.message = message;
    message[0] = '\0';
    history_visit(tool->history, check_step, &resizing);
    if (message[0])
        return false;
    values_take(tool, &values);
    move_values(&resizing, &values);
    *tool = resized;
    values_put(tool, &values);
    move_marks(&resizing, &tool->marks);
    move_marks(&resizing, &tool->saved_marks);
    history_visit(tool->history, move_step, &resizing);
    tool_compare_saved(tool);
    return true;
}

bool tool_resize(struct tool *tool, int width_px, int height_px)
{
    int from[2] = {tool->rig.outputs[tool->output].width_px,
                   tool->rig.outputs[tool->output].height_px};
    char line[60], message[MESSAGE_SIZE];

    if (!tool_resize_quietly(tool, width_px, height_px, message)) {
        snprintf(tool->warning, MESSAGE_SIZE, "the image stays %dx%d px, not %dx%d: %.1300s",
                 from[0], from[1], width_px, height_px, message);
        return false;
    }
    if (from[0] == width_px && from[1] == height_px)
        return true;
    snprintf(tool->notice, MESSAGE_SIZE, "the image of %dx%d px is %dx%d px here: the rig takes it",
             from[0], from[1], width_px, height_px);
    snprintf(line, sizeof line, "resize %d %d", width_px, height_px);
    journal_note(tool, line);
    return true;
}
