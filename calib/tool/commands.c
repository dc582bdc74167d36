/* What keys do. */
#include "angles.h"
#include "tool/tool.h"

#include <math.h>
#include <stdio.h>

#include "tool/journal.h"
#include "tool/keys.h"
#include "tool/marks_walk.h"
#include "tool/state.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

bool tool_group_parameter(const struct tool *tool, int which, enum parameter *parameter)
{
    static const enum parameter table[GROUP_COUNT][3] = {
        [GROUP_CIRCLE] = {PARAMETER_CIRCLE_X, PARAMETER_CIRCLE_Y, PARAMETER_CIRCLE_RADIUS},
        [GROUP_LENS] = {PARAMETER_COUNT, PARAMETER_K1, PARAMETER_FOV},
        [GROUP_POSITION] = {PARAMETER_PROJECTOR_X, PARAMETER_PROJECTOR_Y, PARAMETER_PROJECTOR_Z},
        [GROUP_AIM] = {PARAMETER_YAW, PARAMETER_PITCH, PARAMETER_ROLL},
        [GROUP_SCREEN] = {PARAMETER_TILT, PARAMETER_CAP, PARAMETER_SCREEN_RADIUS},
        [GROUP_VIEWER] = {PARAMETER_VIEWER_X, PARAMETER_VIEWER_Y, PARAMETER_VIEWER_Z},
        [GROUP_DOT] = {PARAMETER_DOT_YAW, PARAMETER_DOT_PITCH, PARAMETER_DOT_SIZE},
        [GROUP_MARKS] = {PARAMETER_CROSS_X, PARAMETER_CROSS_Y, PARAMETER_MARK},
    };

    *parameter = table[tool->group][which];
    if (tool->group == GROUP_LENS && which == 1)
        *parameter = (enum parameter)(PARAMETER_K1 + tool->coefficient);
    return *parameter != PARAMETER_COUNT;
}

bool tool_set(struct tool *tool, enum parameter parameter, double value)
{
    struct values before;

    values_take(tool, &before);
    if (!parameter_set(tool, parameter, value))
        return false;
    if (parameter == PARAMETER_MARK)
        marks_walk_to(tool, tool->mark);
    tool_commit(tool, &before, -1, NULL, (int)parameter);
    return true;
}

static void next_coefficient(struct tool *tool, int sign)
{
    tool->coefficient = (tool->coefficient + 4 + sign) % 4;
    snprintf(tool->notice, MESSAGE_SIZE, "coefficient %s",
             parameter_name(PARAMETER_K1 + tool->coefficient));
    journal_look(tool);
}

static void next_mark(struct tool *tool, int sign)
{
    int count = tool->marks.count;

    if (count == 0)
        snprintf(tool->warning, MESSAGE_SIZE, "there are no marks; give --marks FILE.csv");
    else
        tool_set(tool, PARAMETER_MARK, (tool->mark + count + sign) % count + 1);
}

/* The cross-hair stops at the edge of the image. */
static double within_image(const struct tool *tool, enum parameter parameter, double value)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];

    if (parameter == PARAMETER_CROSS_X)
        return fmin(fmax(value, 0), output->width_px);
    if (parameter == PARAMETER_CROSS_Y)
        return fmin(fmax(value, 0), output->height_px);
    return value;
}

static void step(struct tool *tool, int argument)
{
    int sign = argument & 1 ? -1 : 1;
    enum parameter parameter;
    double value;

    if (!tool_group_parameter(tool, argument >> 1, &parameter)) {
        next_coefficient(tool, sign);
        return;
    }
    if (parameter == PARAMETER_MARK) {
        next_mark(tool, sign);
        return;
    }
    value =
        parameter_get(tool, parameter) + sign * tool->step_scale * parameter_step(tool, parameter);
    tool_set(tool, parameter, within_image(tool, parameter, value));
}

/* Whether a lens can take over, if need be with a smaller field of view or plain coefficients. */
static bool try_lens(struct tool *tool, int model)
{
    struct cupola_lens *lens = &tool->rig.outputs[tool->output].lens, old = *lens;

    lens->model = (enum cupola_lens_model)model;
    if (cupola_rig_complete(&tool->rig, NULL, NULL) >= 0)
        return true;
    if (model == CUPOLA_LENS_TABLE && lens->table_count >= 2)
        lens->fov_rad = 2 * lens->table[lens->table_count - 1].angle_rad;
    else if (model == CUPOLA_LENS_HEMISPHERIC)
        lens->fov_rad = pi;
    else if (model == CUPOLA_LENS_STEREOGRAPHIC)
        lens->fov_rad = 2 * 3.1;
    else if (model == CUPOLA_LENS_POLYNOMIAL)
        lens->k[0] = 1, lens->k[1] = lens->k[2] = lens->k[3] = 0;
    if (cupola_rig_complete(&tool->rig, NULL, NULL) >= 0)
        return true;
    *lens = old;
    return false;
}

static void next_lens(struct tool *tool)
{
    const struct cupola_lens *lens = &tool->rig.outputs[tool->output].lens;
    int models = CUPOLA_LENS_TABLE + 1, now = (int)lens->model;
    struct values before;

    values_take(tool, &before);
    for (int i = 1; i < models; i++) {
        if (!try_lens(tool, (now + i) % models))
            continue;
        tool_commit(tool, &before, -1, NULL, -1);
        snprintf(tool->notice, MESSAGE_SIZE, "lens: %s of %g degrees",
                 cupola_lens_model_name((int)lens->model), parameter_get(tool, PARAMETER_FOV));
        return;
    }
}

static void set_group(struct tool *tool, int group)
{
    tool->group = (enum group)group;
    snprintf(tool->notice, MESSAGE_SIZE, "arrows: %s", tool_group_name(tool->group));
    journal_look(tool);
}

static void set_look(struct tool *tool, const struct key_binding *binding)
{
    if (binding->command == COMMAND_PATTERN)
        tool->pattern = (enum pattern)binding->argument;
    else
        tool->about = (enum about)((tool->about + 1) % ABOUT_COUNT);
    if (binding->command == COMMAND_PATTERN)
        snprintf(tool->notice, MESSAGE_SIZE, "pattern: %s", tool_pattern_name((int)tool->pattern));
    else
        snprintf(tool->notice, MESSAGE_SIZE, "pattern about the %s",
                 tool_about_name((int)tool->about));
    journal_look(tool);
}

static void quit(struct tool *tool)
{
    bool kept = tool->journal && journal_is_whole(tool->journal);

    tool->ends = !tool->unsaved || tool->asked_to_quit;
    tool->asked_to_quit = true;
    if (!tool->ends)
        snprintf(tool->notice, MESSAGE_SIZE,
                 "there are unsaved changes: S saves, Esc once more quits without saving%s",
                 kept ? "; the journal keeps them" : ", and they are lost");
}

static void show(struct tool *tool, enum command command)
{
    if (command == COMMAND_BEFORE)
        tool->shows_before = !tool->shows_before;
    else if (command == COMMAND_HELP)
        tool->shows_help = !tool->shows_help;
    else if (command == COMMAND_LEGEND)
        tool->shows_legend = !tool->shows_legend;
    else if (command == COMMAND_LABELS)
        tool->shows_labels = !tool->shows_labels;
    else if (command == COMMAND_TEXT)
        tool->text_on_dome = !tool->text_on_dome;
    else if (command == COMMAND_PREVIEW)
        tool->preview = (enum preview)((tool->preview + 1) % PREVIEW_COUNT);
    else if (command == COMMAND_FULLSCREEN)
        tool->wants_fullscreen = !tool->wants_fullscreen;
    else
        tool->wants_picture = true;
    if (command == COMMAND_BEFORE)
        snprintf(tool->notice, MESSAGE_SIZE, "%s", tool->shows_before ? "before" : "after");
}

static void flip(struct tool *tool, int bit)
{
    tool_set(tool, PARAMETER_FLIP, tool->rig.outputs[tool->output].flip ^ bit);
}

/* Commands about the marks. */
static void run_marks(struct tool *tool, enum command command)
{
    if (command == COMMAND_ACCEPT)
        marks_walk_accept(tool);
    else if (command == COMMAND_FORGET)
        marks_walk_forget(tool);
    else
        marks_walk_solve(tool);
}

static void run(struct tool *tool, const struct key_binding *binding)
{
    switch (binding->command) {
    case COMMAND_PATTERN:
    case COMMAND_ABOUT:
        set_look(tool, binding);
        break;
    case COMMAND_GROUP:
        set_group(tool, binding->argument);
        break;
    case COMMAND_STEP:
        step(tool, binding->argument);
        break;
    case COMMAND_LENS:
        next_lens(tool);
        break;
    case COMMAND_FLIP:
        flip(tool, binding->argument);
        break;
    case COMMAND_UNDO:
        tool_undo(tool);
        break;
    case COMMAND_REDO:
        tool_redo(tool);
        break;
    case COMMAND_SAVE:
        tool_save(tool, tool->rig_path);
        break;
    case COMMAND_QUIT:
        quit(tool);
        break;
    default:
        if (binding->command >= COMMAND_ACCEPT)
            run_marks(tool, binding->command);
        else
            show(tool, binding->command);
    }
}

bool tool_key(struct tool *tool, int key, int modifiers)
{
    const struct key_binding *binding = key_find(key, modifiers);

    if (!binding)
        return false;
    if (binding->command != COMMAND_QUIT)
        tool->asked_to_quit = false;
    tool->step_scale = 1;
    if (binding->modifiers == ANY_STEP)
        tool->step_scale =
            (modifiers & GLFW_MOD_SHIFT ? 0.1 : 1) * (modifiers & GLFW_MOD_CONTROL ? 10 : 1);
    tool->notice[0] = '\0';
    run(tool, binding);
    return true;
}

bool tool_key_repeat(struct tool *tool, int key, int modifiers)
{
    const struct key_binding *binding = key_find(key, modifiers);

    if (!binding || (binding->command != COMMAND_STEP && binding->command != COMMAND_UNDO &&
                     binding->command != COMMAND_REDO))
        return binding != NULL;
    return tool_key(tool, key, modifiers);
}
