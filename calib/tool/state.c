/* The tool's state: its beginning and end, steps of history, undo and redo. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "tool/journal.h"
#include "tool/marks_walk.h"
#include "tool/state.h"

static bool copy_marks(const struct marks *from, struct marks *to)
{
    *to = *from;
    if (from->count == 0) {
        to->list = NULL;
        return true;
    }
    to->list = malloc((size_t)from->count * sizeof *to->list);
    if (to->list)
        memcpy(to->list, from->list, (size_t)from->count * sizeof *to->list);
    return to->list != NULL;
}

bool tool_open(struct tool *tool, const struct cupola_rig *rig, int output, struct marks *marks,
               const char *rig_path, const char *marks_path, char *message)
{
    const struct cupola_output *shown = &rig->outputs[output];
    struct values start;

    *tool = (struct tool){.rig = *rig,
                          .before = *rig,
                          .theatre = *rig,
                          .output = output,
                          .step_scale = 1,
                          .dot_size_rad = 1 * rad_per_deg,
                          .mouse_px = {-1, -1},
                          .cross_px = {0.5 * shown->width_px, 0.5 * shown->height_px},
                          .shows_legend = true,
                          .shows_labels = true};
    if (marks) {
        tool->marks = *marks;
        *marks = (struct marks){0};
    }
    marks_walk_to(tool, marks_walk_next(tool, -1));
    values_take(tool, &start);
    tool->history = history_create(&start);
    tool->rig_path = strdup(rig_path);
    tool->marks_path = marks_path ? strdup(marks_path) : NULL;
    if (copy_marks(&tool->marks, &tool->saved_marks) && tool->history && tool->rig_path &&
        (tool->marks_path || !marks_path))
        return true;
    snprintf(message, MESSAGE_SIZE, "out of memory for the tool's history and %d marks",
             tool->marks.count);
    tool_close(tool);
    return false;
}

void tool_close(struct tool *tool)
{
    journal_close(&tool->journal, !tool->unsaved);
    history_destroy(tool->history);
    marks_free(&tool->marks);
    marks_free(&tool->saved_marks);
    free(tool->rig_path);
    free(tool->marks_path);
    *tool = (struct tool){0};
}

double tool_eye_reach_m(double radius_m)
{
    /* Nearer to the screen hosts plan no views (head_radius_m of cupola/plan.h). */
    return 0.9 * radius_m;
}

void tool_live_eye(const struct tool *tool, double radius_m, double eye_m[3])
{
    const double *live_m = tool->live_eye_m;
    double length = hypot(hypot(live_m[0], live_m[1]), live_m[2]);

    if (!tool->viewer_lives || !isfinite(length))
        return;
    for (int i = 0; i < 3; i++)
        eye_m[i] = live_m[i] * fmin(1, tool_eye_reach_m(radius_m) / fmax(length, 1e-300));
}

void tool_shown_rig(const struct tool *tool, struct cupola_rig *rig)
{
    *rig = tool->shows_before ? tool->before : tool->rig;
    tool_live_eye(tool, rig->screen.radius_m, rig->eye_m);
}

static bool same_rig(const struct cupola_rig *a, const struct cupola_rig *b, int output)
{
    struct tool first = {.rig = *a, .output = output}, second = {.rig = *b, .output = output};
    struct values mine, other;

    values_take(&first, &mine);
    values_take(&second, &other);
    for (int i = 0; i < PARAMETER_RIG_COUNT; i++)
        if (!(mine.raw[i] == other.raw[i]))
            return false;
    return a->outputs[output].width_px == b->outputs[output].width_px &&
           a->outputs[output].height_px == b->outputs[output].height_px;
}

bool tool_marks_differ(const struct tool *tool)
{
    for (int i = 0; i < tool->marks.count; i++) {
        const struct mark *now = &tool->marks.list[i], *saved = &tool->saved_marks.list[i];
        if (now->steered != saved->steered ||
            (now->steered &&
             (now->pixel_px[0] != saved->pixel_px[0] || now->pixel_px[1] != saved->pixel_px[1])))
            return true;
    }
    return false;
}

void tool_compare_saved(struct tool *tool)
{
    tool->unsaved = !same_rig(&tool->rig, &tool->before, tool->output) || tool_marks_differ(tool);
}

void tool_note_marks_saved(struct tool *tool)
{
    if (tool->marks.count > 0)
        memcpy(tool->saved_marks.list, tool->marks.list,
               (size_t)tool->marks.count * sizeof *tool->marks.list);
    tool_compare_saved(tool);
}

void tool_note_saved(struct tool *tool)
{
    tool->before = tool->rig;
    tool_note_marks_saved(tool);
}

static void set_mark(struct tool *tool, int index, const struct mark_state *state)
{
    struct mark *mark;

    if (index < 0 || index >= tool->marks.count)
        return;
    mark = &tool->marks.list[index];
    mark->steered = state->steered;
    memcpy(mark->pixel_px, state->pixel_px, sizeof mark->pixel_px);
}

struct mark_state tool_mark_state(const struct tool *tool, int index)
{
    struct mark_state state = {0};

    if (index >= 0 && index < tool->marks.count) {
        state.steered = tool->marks.list[index].steered;
        memcpy(state.pixel_px, tool->marks.list[index].pixel_px, sizeof state.pixel_px);
    }
    return state;
}

void tool_record(struct tool *tool, const struct change *change, bool merges)
{
    values_put(tool, &change->values);
    set_mark(tool, change->mark, &change->mark_after);
    if (merges)
        history_merge(tool->history, change);
    else
        history_push(tool->history, change);
    tool->shows_before = false;
    tool_compare_saved(tool);
}

static bool same_mark(const struct mark_state *a, const struct mark_state *b)
{
    return a->steered == b->steered && a->pixel_px[0] == b->pixel_px[0] &&
           a->pixel_px[1] == b->pixel_px[1];
}

void tool_commit(struct tool *tool, const struct values *before, int mark,
                 const struct mark_state *mark_before, int key)
{
    struct change change = {.mark = mark, .key = key, .time_s = tool->time_s};
    bool merges;

    tool->warning[0] = '\0';
    values_take(tool, &change.values);
    if (mark >= 0) {
        change.mark_before = *mark_before;
        change.mark_after = tool_mark_state(tool, mark);
    }
    if (memcmp(before, &change.values, sizeof *before) == 0 &&
        (mark < 0 || same_mark(&change.mark_before, &change.mark_after)))
        return;
    merges = mark < 0 && history_merges(tool->history, key, tool->time_s);
    tool_record(tool, &change, merges);
    journal_change(tool, before, &change, merges);
}

bool tool_undo_quietly(struct tool *tool)
{
    struct values values;
    struct change step;

    if (!history_undo(tool->history, &values, &step))
        return false;
    values_put(tool, &values);
    set_mark(tool, step.mark, &step.mark_before);
    tool->shows_before = false;
    tool_compare_saved(tool);
    return true;
}

bool tool_redo_quietly(struct tool *tool)
{
    struct values values;
    struct change step;

    if (!history_redo(tool->history, &values, &step))
        return false;
    values_put(tool, &values);
    set_mark(tool, step.mark, &step.mark_after);
    tool->shows_before = false;
    tool_compare_saved(tool);
    return true;
}

void tool_undo(struct tool *tool)
{
    if (!tool_undo_quietly(tool)) {
        snprintf(tool->notice, MESSAGE_SIZE, "nothing to undo");
        return;
    }
    tool->warning[0] = '\0';
    snprintf(tool->notice, MESSAGE_SIZE, "undone; %d steps before",
             history_undo_count(tool->history));
    journal_note(tool, "undo");
}

void tool_redo(struct tool *tool)
{
    if (!tool_redo_quietly(tool)) {
        snprintf(tool->notice, MESSAGE_SIZE, "nothing to redo");
        return;
    }
    tool->warning[0] = '\0';
    snprintf(tool->notice, MESSAGE_SIZE, "redone; %d steps after",
             history_redo_count(tool->history));
    journal_note(tool, "redo");
}

void tool_idle(struct tool *tool)
{
    journal_idle(tool);
}

void tool_warnings(const struct tool *tool, const char *between, char text[2 * MESSAGE_SIZE])
{
    snprintf(text, 2 * MESSAGE_SIZE, "%s%s%s", tool->standing,
             tool->standing[0] && tool->warning[0] ? between : "", tool->warning);
}
