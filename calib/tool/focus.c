/* What is worked with in the image. */
#include "tool/focus.h"

#include <string.h>

#include "tool/marks_walk.h"
#include "tool/pattern.h"

static void add(struct focus *focus, double x_px, double y_px, double width_px, double height_px)
{
    if (focus->count < FOCUS_MAX)
        focus->list[focus->count++] =
            (struct focus_box){{x_px, y_px}, {x_px + width_px, y_px + height_px}};
}

static void add_label(struct focus *focus, const cupola_dome *dome, int output,
                      const struct dome_label *label)
{
    int box[4];

    if (dome_label_box(cupola_dome_rig(dome), output, label, box))
        add(focus, box[0], box[1], box[2], box[3]);
}

bool focus_cross_label(const struct tool *tool, const cupola_dome *dome,
                       char name[MARK_NAME_MAX + 1], struct dome_label *label)
{
    struct cupola_ray ray;

    if (tool->mark < 0 || tool->mark >= tool->marks.count ||
        cupola_dome_ray(dome, tool->output, NULL, tool->cross_px[0], tool->cross_px[1], &ray) < 0)
        return false;
    marks_walk_label(tool, tool->mark, name);
    *label = (struct dome_label){.text = name, .ink = {1, 0.75f, 0.1f}, .ground = 0.8f};
    label->unit_rad = pattern_label_unit_rad(dome, tool->output, ray.direction);
    memcpy(label->direction, ray.direction, sizeof label->direction);
    dome_label_anchor(label, 1, 1);
    return true;
}

static void add_cross(const struct tool *tool, const cupola_dome *dome, struct focus *focus)
{
    double arm_px = pattern_cross_arm_px(&tool->rig.outputs[tool->output]);
    char name[MARK_NAME_MAX + 1];
    struct dome_label label;

    add(focus, tool->cross_px[0] - arm_px, tool->cross_px[1] - arm_px, 2 * arm_px, 2 * arm_px);
    if (focus_cross_label(tool, dome, name, &label))
        add_label(focus, dome, tool->output, &label);
}

static void add_dot(const struct tool *tool, const cupola_dome *dome, struct focus *focus)
{
    double size = tool->dot_size_rad;
    struct dome_label ground = {
        .unit_rad = 1, .corner = {-0.5 * size, -0.5 * size}, .size = {size, size}};

    pattern_dot(tool, ground.direction);
    add_label(focus, dome, tool->output, &ground);
}

void focus_find(const struct tool *tool, const cupola_dome *dome, struct pattern_labels *labels,
                struct focus *focus)
{
    focus->count = 0;
    if (tool->group == GROUP_MARKS)
        add_cross(tool, dome, focus);
    if (tool->pattern == PATTERN_DOT)
        add_dot(tool, dome, focus);
    labels->count = 0;
    if (tool->shows_labels)
        pattern_labels_list(tool, dome, labels);
    for (int i = 0; i < labels->count; i++)
        if (labels->list[i].matters)
            add_label(focus, dome, tool->output, &labels->list[i]);
}
