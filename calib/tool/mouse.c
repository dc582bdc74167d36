/* The mouse over the image: what it drags. */
#include <math.h>
#include <string.h>

#include <cupola/dome.h>

#include "tool/history.h"
#include "tool/state.h"
#include "tool/tool.h"

/* The dot goes to where the picture has the mouse, by the eye that it is drawn for. */
static void set_dot(struct tool *tool)
{
    cupola_dome *dome = NULL;
    struct cupola_rig shown;
    struct cupola_ray ray;

    tool_shown_rig(tool, &shown);
    if (cupola_dome_create(&shown, &dome, NULL) < 0)
        return;
    if (cupola_dome_ray(dome, tool->output, NULL, tool->mouse_px[0], tool->mouse_px[1], &ray) ==
        1) {
        tool->dot_yaw_rad = atan2(-ray.direction[0], -ray.direction[2]);
        tool->dot_pitch_rad = asin(fmin(fmax(ray.direction[1], -1), 1));
    }
    cupola_dome_destroy(&dome);
}

static void set_cross(struct tool *tool)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];

    tool->cross_px[0] = fmin(fmax(tool->mouse_px[0], 0), output->width_px);
    tool->cross_px[1] = fmin(fmax(tool->mouse_px[1], 0), output->height_px);
}

static bool drags_anything(const struct tool *tool)
{
    return tool->group == GROUP_CIRCLE || tool->group == GROUP_MARKS || tool->group == GROUP_DOT ||
           tool->pattern == PATTERN_DOT;
}

/* Moves what the group is about, by `moved_px` or to where the mouse is. */
static void drag(struct tool *tool, const double moved_px[2])
{
    struct values before;
    struct cupola_rig rig = tool->rig;
    struct cupola_circle *circle = &tool->rig.outputs[tool->output].circle;
    struct cupola_error error = {0};

    if (!drags_anything(tool))
        return;
    /* What is dragged is what is set up: that is shown, even where nothing changes. */
    tool->shows_before = false;
    values_take(tool, &before);
    if (tool->group == GROUP_CIRCLE) {
        circle->center_x_px += moved_px[0];
        circle->center_y_px += moved_px[1];
    } else if (tool->group == GROUP_MARKS) {
        set_cross(tool);
    } else {
        set_dot(tool);
    }
    if (cupola_rig_complete(&tool->rig, NULL, &error) < 0) {
        tool->rig = rig;
        memcpy(tool->warning, error.message, sizeof error.message);
        return;
    }
    tool_commit(tool, &before, -1, NULL, HISTORY_DRAG + tool->drag);
}

void tool_mouse(struct tool *tool, double x_px, double y_px)
{
    double moved_px[2] = {x_px - tool->mouse_px[0], y_px - tool->mouse_px[1]};

    if (!isfinite(x_px) || !isfinite(y_px))
        return;
    tool->mouse_px[0] = x_px;
    tool->mouse_px[1] = y_px;
    if (tool->drags)
        drag(tool, moved_px);
}

static bool is_over_image(const struct tool *tool)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];

    return tool->mouse_px[0] >= 0 && tool->mouse_px[0] <= output->width_px &&
           tool->mouse_px[1] >= 0 && tool->mouse_px[1] <= output->height_px;
}

void tool_mouse_button(struct tool *tool, bool pressed)
{
    if (!pressed) {
        tool->drags = false;
    } else if (!tool->drags && is_over_image(tool)) {
        tool->drag = (tool->drag + 1) % 1000000;
        tool->drags = true;
        drag(tool, (double[2]){0, 0});
    }
}
