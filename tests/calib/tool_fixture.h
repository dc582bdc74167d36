/* Tools for tests of the tool: rigs and keys by chance, and whether two tools are in one state. */
#ifndef TOOL_FIXTURE_H
#define TOOL_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "check.h"
#include "tool/history.h"
#include "tool/journal.h"
#include "tool/keys.h"
#include "tool/tool.h"

static inline int random_index(uint64_t *seed, int count)
{
    int index = (int)random_between(seed, 0, count);
    return index < count ? index : count - 1;
}

/* Any possible rig of one projector or two. */
static inline struct cupola_rig random_rig(uint64_t *seed)
{
    struct cupola_rig rig = {0};

    rig.screen.radius_m = random_between(seed, 0.5, 8);
    rig.screen.cap_rad = random_between(seed, 1, 3);
    rig.tilt_rad = random_between(seed, -1, 2);
    rig.output_count = 1 + random_index(seed, 2);
    for (int i = 0; i < 3; i++)
        rig.eye_m[i] = random_between(seed, -0.4, 0.4) * rig.screen.radius_m;
    for (int i = 0; i < rig.output_count; i++) {
        struct cupola_output *output = &rig.outputs[i];
        output->width_px = 300 + random_index(seed, 2000);
        output->height_px = 300 + random_index(seed, 2000);
        output->lens.model = (enum cupola_lens_model)random_index(seed, CUPOLA_LENS_TABLE + 1);
        output->lens.fov_rad = random_between(seed, 1, 3.1);
        output->lens.k[0] = output->lens.model == CUPOLA_LENS_POLYNOMIAL;
        if (random_index(seed, 2) || output->lens.model == CUPOLA_LENS_TABLE) {
            output->lens.table_count = 3;
            output->lens.table[0] = (struct cupola_lens_sample){0.5, 0.3};
            output->lens.table[1] = (struct cupola_lens_sample){1, 0.7};
            output->lens.table[2] = (struct cupola_lens_sample){1.6, 1};
        }
        for (int axis = 0; axis < 3; axis++)
            output->position_m[axis] = random_between(seed, -0.5, 0.5) * rig.screen.radius_m;
        output->aim.yaw_rad = random_between(seed, -3, 3);
        output->aim.pitch_rad = random_between(seed, -3, 3);
    }
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    return rig;
}

/* Directions in front, some of them with a pixel. */
static inline struct marks random_marks(uint64_t *seed, int count)
{
    struct marks marks = {MARKS_DIRECTIONS, calloc((size_t)count, sizeof *marks.list), count};

    assert_non_null(marks.list);
    for (int i = 0; i < count; i++) {
        struct mark *mark = &marks.list[i];
        double yaw = random_between(seed, -1, 1), pitch = random_between(seed, -1, 1);
        snprintf(mark->name, sizeof mark->name, "mark %d, 100%%", i);
        mark->place[0] = sin(yaw) * cos(pitch);
        mark->place[1] = sin(pitch);
        mark->place[2] = -cos(yaw) * cos(pitch);
        mark->steered = random_index(seed, 4) == 0;
        mark->pixel_px[0] = mark->steered ? random_between(seed, 0, 300) : 0;
        mark->pixel_px[1] = mark->steered ? random_between(seed, 0, 300) : 0;
    }
    return marks;
}

static inline void open_by_chance(struct tool *tool, uint64_t *seed, const char *path)
{
    struct cupola_rig rig = random_rig(seed);
    struct marks marks = random_marks(seed, 5);
    char message[MESSAGE_SIZE] = "";

    assert_true(tool_open(tool, &rig, rig.output_count - 1, &marks, path, "m.csv", message));
}

/* Any key of the table but those that need files, with a modifier where that is meant. */
static inline void press_by_chance(struct tool *tool, uint64_t *seed)
{
    static const int held[] = {0, GLFW_MOD_SHIFT, GLFW_MOD_CONTROL};
    const struct key_binding *binding;
    int count = 0;

    while (key_binding(count))
        count++;
    do {
        binding = key_binding(random_index(seed, count));
    } while (binding->command == COMMAND_SAVE || binding->command == COMMAND_SOLVE);
    /* Half of all keys are arrows. */
    if (random_index(seed, 2))
        binding = key_find(GLFW_KEY_RIGHT + random_index(seed, 4), 0);
    tool->time_s += random_between(seed, 0, 1.5);
    assert_true(tool_key(tool, binding->key,
                         binding->modifiers == ANY_STEP ? held[random_index(seed, 3)]
                                                        : binding->modifiers));
}

/* Drags, resizes and typed values as well. */
static inline void act_by_chance(struct tool *tool, uint64_t *seed)
{
    int what = random_index(seed, 40);

    if (what == 0) {
        tool_resize(tool, 200 + random_index(seed, 3000), 200 + random_index(seed, 3000));
    } else if (what < 4) {
        tool_mouse(tool, random_between(seed, -100, 3000), random_between(seed, -100, 3000));
        tool_mouse_button(tool, true);
        for (int i = 0; i < 3; i++)
            tool_mouse(tool, random_between(seed, -100, 3000), random_between(seed, -100, 3000));
        tool_mouse_button(tool, false);
    } else if (what < 8) {
        tool_set(tool, (enum parameter)random_index(seed, PARAMETER_COUNT),
                 random_between(seed, -1, 1) * pow(10, random_between(seed, -3, 4)));
    } else {
        press_by_chance(tool, seed);
    }
}

static inline void check_possible(const struct tool *tool)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    struct cupola_error error = {0};
    struct cupola_rig rig;

    if (cupola_rig_complete(&tool->rig, &rig, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    assert_memory_equal(&rig.outputs[tool->output], output, sizeof *output);
    assert_true(tool->cross_px[0] >= 0 && tool->cross_px[0] <= output->width_px);
    assert_true(tool->cross_px[1] >= 0 && tool->cross_px[1] <= output->height_px);
    assert_true(tool->mark >= 0 && (tool->mark < tool->marks.count || tool->mark == 0));
}

static inline bool same_values(const struct tool *a, const struct tool *b)
{
    struct values mine, other;

    values_take(a, &mine);
    values_take(b, &other);
    return memcmp(&mine, &other, sizeof mine) == 0;
}

static inline void check_same_marks(const struct marks *a, const struct marks *b)
{
    assert_int_equal(a->count, b->count);
    for (int i = 0; i < a->count; i++) {
        const struct mark *mine = &a->list[i], *other = &b->list[i];
        assert_string_equal(mine->name, other->name);
        assert_memory_equal(mine->place, other->place, sizeof mine->place);
        assert_int_equal(mine->steered, other->steered);
        if (mine->steered)
            assert_memory_equal(mine->pixel_px, other->pixel_px, sizeof mine->pixel_px);
    }
}

/* To the last bit, but for what no journal holds. */
static inline void check_same(const struct tool *a, const struct tool *b)
{
    assert_true(same_values(a, b));
    assert_int_equal(a->output, b->output);
    assert_int_equal(a->rig.outputs[a->output].width_px, b->rig.outputs[b->output].width_px);
    assert_int_equal(a->rig.outputs[a->output].height_px, b->rig.outputs[b->output].height_px);
    assert_int_equal(a->rig.output_count, b->rig.output_count);
    check_same_marks(&a->marks, &b->marks);
    assert_int_equal(a->pattern, b->pattern);
    assert_int_equal(a->group, b->group);
    assert_int_equal(a->about, b->about);
    assert_int_equal(a->coefficient, b->coefficient);
    assert_int_equal(a->unsaved, b->unsaved);
    assert_int_equal(history_undo_count(a->history), history_undo_count(b->history));
    assert_int_equal(history_redo_count(a->history), history_redo_count(b->history));
}

/* A folder of the test's own; the tests work in it. */
static inline int enter_folder(void **state)
{
    static char folder[] = "/tmp/cupola-calib-test-XXXXXX";

    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

#endif
