/* The mouse: what a drag does, where it may begin, and that the dot goes where it points. */
#include <cupola/dome.h>

#include "tool_fixture.h"

static void open_tool(struct tool *tool, enum group group)
{
    struct cupola_rig rig;
    char message[MESSAGE_SIZE];

    assert_int_equal(cupola_rig_preset("visionstation", &rig, NULL), CUPOLA_OK);
    rig.outputs[0].position_m[1] = -0.1;
    assert_true(tool_open(tool, &rig, 0, NULL, "rig.cfg", NULL, message));
    tool->group = group;
}

static void press_at(struct tool *tool, double x_px, double y_px)
{
    tool_mouse_button(tool, false);
    tool_mouse(tool, x_px, y_px);
    tool_mouse_button(tool, true);
}

static void a_drag_moves_the_circle_in_one_step(void **state)
{
    struct tool tool;

    (void)state;
    open_tool(&tool, GROUP_CIRCLE);
    press_at(&tool, 100, 100);
    for (int i = 1; i <= 50; i++) {
        tool.time_s += 0.5;
        tool_mouse(&tool, 100 + i, 100 - 0.5 * i);
    }
    tool_mouse_button(&tool, false);
    tool_mouse(&tool, 0, 0);
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_X), 562, 1e-9);
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_Y), 359, 1e-9);
    assert_int_equal(history_undo_count(tool.history), 1);
    tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_X), 512, 0);
    tool_close(&tool);
}

static void beside_the_image_no_drag_begins(void **state)
{
    static const double beside[][2] = {{-0.5, 300}, {1024.5, 300}, {300, -0.5}, {300, 768.5}};
    static const enum group groups[] = {GROUP_CIRCLE, GROUP_DOT, GROUP_MARKS};
    struct values before, after;

    (void)state;
    for (int g = 0; g < 3; g++) {
        struct tool tool;
        open_tool(&tool, groups[g]);
        values_take(&tool, &before);
        /* Nobody has said yet where it is. */
        tool_mouse_button(&tool, true);
        tool_mouse(&tool, 200, 200);
        for (int i = 0; i < 4; i++) {
            tool_mouse_button(&tool, false);
            tool_mouse(&tool, 100, 100);
            press_at(&tool, beside[i][0], beside[i][1]);
            tool_mouse(&tool, 500, 200);
        }
        values_take(&tool, &after);
        assert_memory_equal(&before, &after, sizeof before);
        assert_int_equal(history_undo_count(tool.history), 0);
        tool_close(&tool);
    }
}

static void a_drag_may_leave_the_image_and_come_back(void **state)
{
    struct tool tool;

    (void)state;
    open_tool(&tool, GROUP_MARKS);
    press_at(&tool, 1000, 300);
    tool_mouse(&tool, 2000, -50);
    check_near(tool.cross_px[0], 1024, 0);
    check_near(tool.cross_px[1], 0, 0);
    tool_mouse(&tool, 700, 400);
    check_near(tool.cross_px[0], 700, 0);
    tool.group = GROUP_CIRCLE;
    tool_mouse(&tool, 1100, 400);
    tool_mouse(&tool, 710, 400);
    tool_mouse_button(&tool, false);
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_X), 522, 1e-9);
    assert_int_equal(history_undo_count(tool.history), 1);
    tool_close(&tool);
}

/* Where the picture that is shown has the dot. */
static void find_dot(const struct tool *tool, double pixel_px[2])
{
    const double direction[3] = {-sin(tool->dot_yaw_rad) * cos(tool->dot_pitch_rad),
                                 sin(tool->dot_pitch_rad),
                                 -cos(tool->dot_yaw_rad) * cos(tool->dot_pitch_rad)};
    cupola_dome *dome = NULL;
    struct cupola_rig shown;

    tool_shown_rig(tool, &shown);
    assert_int_equal(cupola_dome_create(&shown, &dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_dome_pixel(dome, 0, NULL, direction, pixel_px), 1);
    cupola_dome_destroy(&dome);
}

static void press_for_dot(struct tool *tool)
{
    double pixel_px[2];

    press_at(tool, 300, 500);
    find_dot(tool, pixel_px);
    check_near(pixel_px[0], 300, 1e-6);
    check_near(pixel_px[1], 500, 1e-6);
}

static void the_dot_goes_to_the_mouse(void **state)
{
    struct tool tool;
    double pixel_px[2];

    (void)state;
    open_tool(&tool, GROUP_DOT);
    press_for_dot(&tool);
    /* The picture of an eye elsewhere has it elsewhere. */
    memcpy(tool.live_eye_m, (double[]){0.2, 0.1, 0.1}, sizeof tool.live_eye_m);
    tool.viewer_lives = true;
    find_dot(&tool, pixel_px);
    check_at_least(fabs(pixel_px[0] - 300), 10);
    press_for_dot(&tool);
    tool.viewer_lives = false;
    find_dot(&tool, pixel_px);
    check_at_least(fabs(pixel_px[0] - 300), 10);
    press_for_dot(&tool);
    tool_close(&tool);
}

static void a_drag_shows_what_is_set_up(void **state)
{
    struct tool tool;

    (void)state;
    open_tool(&tool, GROUP_DOT);
    assert_true(tool_set(&tool, PARAMETER_PITCH, 10));
    press_for_dot(&tool);
    /* The dot is there already: nothing changes but what is shown. */
    tool_key(&tool, GLFW_KEY_B, 0);
    assert_true(tool.shows_before);
    press_for_dot(&tool);
    assert_false(tool.shows_before);
    /* What takes no mouse leaves it. */
    tool_key(&tool, GLFW_KEY_B, 0);
    tool.group = GROUP_AIM;
    press_at(&tool, 310, 510);
    assert_true(tool.shows_before);
    tool_close(&tool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drag_moves_the_circle_in_one_step),
        cmocka_unit_test(beside_the_image_no_drag_begins),
        cmocka_unit_test(a_drag_may_leave_the_image_and_come_back),
        cmocka_unit_test(the_dot_goes_to_the_mouse),
        cmocka_unit_test(a_drag_shows_what_is_set_up),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
