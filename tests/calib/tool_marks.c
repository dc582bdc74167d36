/* Marks: the cross-hair starts where the rig predicts it, and goes on from there. */
#include <sys/stat.h>

#include <cupola/dome.h>
#include <cupola/projection.h>
#include <cupola/rig_file.h>

#include "tool/marks_walk.h"
#include "tool_fixture.h"

static void open_with_marks(struct tool *tool, struct marks marks)
{
    struct cupola_rig rig;
    char message[MESSAGE_SIZE];

    assert_int_equal(cupola_rig_preset("visionstation", &rig, NULL), CUPOLA_OK);
    rig.outputs[0].position_m[1] = -0.1;
    assert_true(tool_open(tool, &rig, 0, &marks, "rig.cfg", "marks-steered.csv", message));
    tool_key(tool, GLFW_KEY_M, 0);
}

static struct marks three_marks(void)
{
    struct marks marks = {MARKS_DIRECTIONS, calloc(3, sizeof *marks.list), 3};

    assert_non_null(marks.list);
    for (int i = 0; i < 3; i++) {
        snprintf(marks.list[i].name, sizeof marks.list[i].name, "m%d", i + 1);
        marks.list[i].place[0] = 0.6 * (i - 1);
        marks.list[i].place[2] = -sqrt(1 - 0.36 * (i - 1) * (i - 1));
    }
    return marks;
}

static void the_cross_hair_starts_at_the_pixel_that_lights_the_mark(void **state)
{
    struct tool tool;

    (void)state;
    open_with_marks(&tool, three_marks());
    for (int i = 0; i < 3; i++) {
        cupola_dome *dome = NULL;
        struct cupola_ray ray;
        assert_int_equal(tool.mark, i);
        assert_int_equal(cupola_dome_create(&tool.rig, &dome, NULL), CUPOLA_OK);
        assert_int_equal(cupola_dome_ray(dome, 0, NULL, tool.cross_px[0], tool.cross_px[1], &ray),
                         1);
        for (int axis = 0; axis < 3; axis++)
            check_near(ray.point_m[axis], 0.75 * tool.marks.list[i].place[axis], 1e-9);
        cupola_dome_destroy(&dome);
        tool_key(&tool, GLFW_KEY_PAGE_UP, 0);
    }
    assert_int_equal(tool.mark, 0);
    tool_close(&tool);
}

static void enter_takes_the_pixel_and_goes_to_the_next(void **state)
{
    struct tool tool;
    double taken[2];

    (void)state;
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_RIGHT, GLFW_MOD_CONTROL);
    memcpy(taken, tool.cross_px, sizeof taken);
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    assert_int_equal(tool.mark, 1);
    assert_true(tool.marks.list[0].steered);
    assert_memory_equal(tool.marks.list[0].pixel_px, taken, sizeof taken);
    assert_true(tool.unsaved);
    tool_undo(&tool);
    assert_false(tool.marks.list[0].steered);
    assert_int_equal(tool.mark, 0);
    assert_memory_equal(tool.cross_px, taken, sizeof taken);
    tool_redo(&tool);
    assert_true(tool.marks.list[0].steered);
    tool_key(&tool, GLFW_KEY_PAGE_DOWN, 0);
    assert_memory_equal(tool.cross_px, taken, sizeof taken);
    tool_key(&tool, GLFW_KEY_BACKSPACE, 0);
    assert_int_equal(marks_walk_steered(&tool), 0);
    tool_undo(&tool);
    assert_int_equal(marks_walk_steered(&tool), 1);
    for (int i = 0; i < 3; i++)
        tool_key(&tool, GLFW_KEY_ENTER, 0);
    assert_int_equal(marks_walk_steered(&tool), 3);
    assert_non_null(strstr(tool.notice, "all 3 marks"));
    tool_close(&tool);
}

static void saving_writes_what_reads_back(void **state)
{
    struct tool tool;
    struct marks marks;
    struct cupola_rig rig;
    char message[MESSAGE_SIZE];

    (void)state;
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    assert_true(tool_set(&tool, PARAMETER_YAW, 12.3));
    tool_key(&tool, GLFW_KEY_S, 0);
    assert_false(tool.unsaved);
    assert_true(marks_read("marks-steered.csv", false, &marks, message));
    check_same_marks(&marks, &tool.marks);
    marks_free(&marks);
    assert_int_equal(cupola_rig_read("rig.cfg", NULL, &rig, NULL), CUPOLA_OK);
    assert_memory_equal(&rig.outputs[0].aim, &tool.rig.outputs[0].aim, sizeof rig.outputs[0].aim);
    tool_key(&tool, GLFW_KEY_X, 0);
    assert_true(tool.unsaved);
    tool_undo(&tool);
    assert_false(tool.unsaved);
    assert_false(tool_save(&tool, "there/is/no/folder.cfg"));
    assert_true(tool.warning[0]);
    tool_close(&tool);
}

static void rig_and_marks_are_saved_together_or_not_at_all(void **state)
{
    struct tool tool;

    (void)state;
    unlink("together.cfg");
    unlink("marks-steered.csv");
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    assert_false(tool_save(&tool, "there/is/no/folder.cfg"));
    assert_int_not_equal(access("marks-steered.csv", F_OK), 0);
    assert_int_equal(mkdir("marks-steered.csv", 0777), 0);
    assert_false(tool_save(&tool, "together.cfg"));
    assert_non_null(strstr(tool.warning, "marks-steered.csv"));
    assert_int_not_equal(access("together.cfg", F_OK), 0);
    assert_true(tool.unsaved);
    assert_int_equal(rmdir("marks-steered.csv"), 0);
    assert_true(tool_save(&tool, "together.cfg"));
    assert_int_equal(access("marks-steered.csv", F_OK), 0);
    assert_int_equal(access("together.cfg", F_OK), 0);
    unlink("together.cfg");
    tool_close(&tool);
}

static int steered_in_file(void)
{
    struct marks marks;
    char message[MESSAGE_SIZE];
    int steered = 0;

    if (!marks_read("marks-steered.csv", false, &marks, message))
        fail_msg("%s", message);
    for (int i = 0; i < marks.count; i++)
        steered += marks.list[i].steered;
    marks_free(&marks);
    return steered;
}

static void forgetting_all_is_saved_like_any_change(void **state)
{
    struct marks saved;
    struct tool tool;
    char message[MESSAGE_SIZE];

    (void)state;
    unlink("marks-steered.csv");
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_S, 0);
    assert_int_not_equal(access("marks-steered.csv", F_OK), 0); /* there is nothing to say */
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    tool_key(&tool, GLFW_KEY_S, 0);
    assert_int_equal(steered_in_file(), 2);
    tool_close(&tool);
    assert_true(marks_read("marks-steered.csv", false, &saved, message));
    open_with_marks(&tool, saved);
    for (int i = 0; i < 2; i++) {
        assert_true(tool_set(&tool, PARAMETER_MARK, i + 1));
        tool_key(&tool, GLFW_KEY_BACKSPACE, 0);
    }
    assert_true(tool.unsaved);
    tool_key(&tool, GLFW_KEY_S, 0);
    assert_non_null(strstr(tool.notice, "marks-steered.csv"));
    assert_false(tool.unsaved);
    assert_int_equal(steered_in_file(), 0);
    tool_close(&tool);
}

static void marks_that_cannot_be_written_are_unsaved(void **state)
{
    struct tool tool;

    (void)state;
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    free(tool.marks_path);
    tool.marks_path = strdup("there/is/no/folder.csv");
    tool_key(&tool, GLFW_KEY_S, 0);
    assert_true(tool.warning[0]);
    assert_true(tool.unsaved);
    tool_close(&tool);
}

/* They have one file, wherever the rig is saved to. */
static void with_another_rig_the_marks_are_saved_too(void **state)
{
    struct tool tool, restored;
    char message[MESSAGE_SIZE] = "";

    (void)state;
    unlink("marks-steered.csv");
    unlink("rig.cfg.journal");
    open_with_marks(&tool, three_marks());
    assert_int_equal(journal_open(&tool, false, message), JOURNAL_NEW);
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    assert_true(tool_save(&tool, "other.cfg"));
    assert_int_equal(steered_in_file(), 1);
    tool_undo(&tool);
    assert_true(tool.unsaved);
    assert_int_equal(system("cp rig.cfg.journal copy.cfg.journal"), 0);

    open_with_marks(&restored, three_marks());
    free(restored.rig_path);
    restored.rig_path = strdup("copy.cfg");
    assert_int_equal(journal_open(&restored, false, message), JOURNAL_RESTORED);
    check_same(&tool, &restored);
    tool.unsaved = false;
    tool_close(&tool);
    tool_key(&restored, GLFW_KEY_S, 0);
    assert_int_equal(steered_in_file(), 0);
    assert_false(restored.unsaved);
    tool_close(&restored);
}

static void without_marks_their_keys_say_so(void **state)
{
    static const int keys[] = {GLFW_KEY_ENTER, GLFW_KEY_BACKSPACE, GLFW_KEY_PAGE_UP, GLFW_KEY_R};
    struct tool tool;

    (void)state;
    open_with_marks(&tool, (struct marks){0});
    for (int i = 0; i < 4; i++) {
        tool.warning[0] = '\0';
        tool_key(&tool, keys[i], 0);
        assert_true(tool.warning[0]);
        assert_int_equal(history_undo_count(tool.history), 0);
    }
    tool_close(&tool);
}

static void another_image_size_keeps_all_in_its_place(void **state)
{
    struct tool tool;

    (void)state;
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    tool_set(&tool, PARAMETER_CIRCLE_RADIUS, 500);
    assert_true(tool_resize(&tool, 2048, 1536));
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_RADIUS), 1000, 1e-9);
    assert_non_null(strstr(tool.notice, "1024x768"));
    tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_RADIUS), 1024, 1e-9);
    check_near(parameter_get(&tool, PARAMETER_CIRCLE_X), 1024, 1e-9);
    tool_undo(&tool);
    assert_false(tool.unsaved);
    tool_redo(&tool);
    marks_walk_to(&tool, 0);
    check_near(tool.cross_px[0], tool.marks.list[0].pixel_px[0], 0);
    tool.marks.list[0].steered = false;
    marks_walk_to(&tool, 0);
    check_near(tool.cross_px[0], tool.marks.list[0].pixel_px[0], 1e-9);
    check_near(tool.cross_px[1], tool.marks.list[0].pixel_px[1], 1e-9);
    assert_false(tool_resize(&tool, 0, 5));
    tool_close(&tool);
}

static void a_tracked_eye_is_shown_and_kept_inside(void **state)
{
    struct tool tool;
    struct cupola_rig rig;

    (void)state;
    open_with_marks(&tool, (struct marks){0});
    tool.viewer_lives = true;
    memcpy(tool.live_eye_m, (double[]){0.1, 0.2, 0.3}, sizeof tool.live_eye_m);
    tool_shown_rig(&tool, &rig);
    assert_memory_equal(rig.eye_m, tool.live_eye_m, sizeof rig.eye_m);
    memcpy(tool.live_eye_m, (double[]){0, 50, 0}, sizeof tool.live_eye_m);
    tool_shown_rig(&tool, &rig);
    assert_int_equal(cupola_rig_complete(&rig, NULL, NULL), CUPOLA_OK);
    tool.live_eye_m[0] = (double)NAN;
    tool_shown_rig(&tool, &rig);
    assert_int_equal(cupola_rig_complete(&rig, NULL, NULL), CUPOLA_OK);
    tool_close(&tool);
}

/* Marks all over, as a projector elsewhere lights them, but for the last one. */
static struct marks marks_of(const struct cupola_rig *truth)
{
    uint64_t seed = 12;
    struct marks marks = random_marks(&seed, 20);

    for (int i = 0; i < marks.count; i++) {
        double point_m[3];
        for (int axis = 0; axis < 3; axis++)
            point_m[axis] = marks.list[i].place[axis] * truth->screen.radius_m;
        marks.list[i].steered = true;
        assert_true(
            cupola_output_pixel(&truth->outputs[0], point_m, marks.list[i].pixel_px, NULL) >= 0);
    }
    marks.list[19].pixel_px[0] += 50;
    return marks;
}

static void solving_is_one_step_that_names_wrong_marks(void **state)
{
    struct cupola_rig truth;
    struct tool tool;
    double before;

    (void)state;
    assert_int_equal(cupola_rig_preset("visionstation", &truth, NULL), CUPOLA_OK);
    memcpy(truth.outputs[0].position_m, (double[]){0.05, -0.12, 0.02}, 3 * sizeof(double));
    truth.outputs[0].aim.pitch_rad = 0.05;
    open_with_marks(&tool, marks_of(&truth));
    before = parameter_get(&tool, PARAMETER_PROJECTOR_X);
    tool_key(&tool, GLFW_KEY_R, 0);
    assert_string_equal(tool.warning, "");
    assert_non_null(strstr(tool.notice, "19 marks"));
    assert_non_null(strstr(tool.notice, tool.marks.list[19].name));
    /* What the solver notes is said, too: of marks without any noise, that there is none. */
    assert_non_null(strstr(tool.notice, "note: the residuals are 0"));
    for (int axis = 0; axis < 3; axis++)
        check_near(tool.rig.outputs[0].position_m[axis], truth.outputs[0].position_m[axis], 1e-6);
    check_near(tool.rig.outputs[0].aim.pitch_rad, 0.05, 1e-6);
    assert_int_equal(history_undo_count(tool.history), 1);
    tool_undo(&tool);
    check_near(parameter_get(&tool, PARAMETER_PROJECTOR_X), before, 0);
    tool_close(&tool);
}

static void too_few_marks_are_refused_with_the_reason(void **state)
{
    struct tool tool;

    (void)state;
    open_with_marks(&tool, three_marks());
    tool_key(&tool, GLFW_KEY_R, 0);
    assert_non_null(strstr(tool.warning, "no mark has a pixel"));
    tool_key(&tool, GLFW_KEY_ENTER, 0);
    tool_key(&tool, GLFW_KEY_R, 0);
    assert_true(tool.warning[0]);
    assert_int_equal(history_undo_count(tool.history), 1);
    tool_close(&tool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cross_hair_starts_at_the_pixel_that_lights_the_mark),
        cmocka_unit_test(enter_takes_the_pixel_and_goes_to_the_next),
        cmocka_unit_test(saving_writes_what_reads_back),
        cmocka_unit_test(rig_and_marks_are_saved_together_or_not_at_all),
        cmocka_unit_test(forgetting_all_is_saved_like_any_change),
        cmocka_unit_test(marks_that_cannot_be_written_are_unsaved),
        cmocka_unit_test(with_another_rig_the_marks_are_saved_too),
        cmocka_unit_test(without_marks_their_keys_say_so),
        cmocka_unit_test(solving_is_one_step_that_names_wrong_marks),
        cmocka_unit_test(too_few_marks_are_refused_with_the_reason),
        cmocka_unit_test(another_image_size_keeps_all_in_its_place),
        cmocka_unit_test(a_tracked_eye_is_shown_and_kept_inside),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
