/* Rigs as values: defaults, presets, resizing, and every impossible value refused by name. */
#include "cupola/rig.h"
#include "message.h"
#include "rig_random.h"

static void check_rigs_equal(const struct cupola_rig *a, const struct cupola_rig *b)
{
    assert_memory_equal(a, b, sizeof *a);
}

static void a_zero_rig_is_a_domemaster_without_tilt(void **state)
{
    (void)state;
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    check_near(rig.screen.radius_m, 1.0, 0.0);
    check_near(rig.screen.cap_rad, pi, 0.0);
    check_near(rig.tilt_rad, 0.0, 0.0);
    check_near(rig.units_per_metre, 1.0, 0.0);
    assert_int_equal(rig.output_count, 1);
    const struct cupola_output *output = &rig.outputs[0];
    assert_int_equal(output->width_px, 1024);
    assert_int_equal(output->height_px, 1024);
    check_near(output->circle.center_x_px, 512.0, 0.0);
    check_near(output->circle.center_y_px, 512.0, 0.0);
    check_near(output->circle.radius_px, 512.0, 0.0);
    assert_int_equal(output->flip, CUPOLA_FLIP_NONE);
    assert_int_equal(output->lens.model, CUPOLA_LENS_ANGULAR);
    check_near(output->lens.fov_rad, pi, 0.0);
    for (int i = 0; i < 3; i++) {
        check_near(rig.eye_m[i], 0.0, 0.0);
        check_near(output->position_m[i], 0.0, 0.0);
    }
}

static void what_is_given_stays_and_the_rest_follows_from_it(void **state)
{
    (void)state;
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    rig.output_count = 2;
    rig.outputs[0].width_px = 801;
    rig.outputs[0].height_px = 600;
    rig.outputs[0].circle.center_x_px = 17.0; /* ignored, as there is no radius */
    rig.outputs[1].height_px = 400;
    rig.outputs[1].lens.model = CUPOLA_LENS_TABLE;
    rig.outputs[1].lens.table_count = 2;
    rig.outputs[1].lens.table[0] = (struct cupola_lens_sample){0.5, 2.0};
    rig.outputs[1].lens.table[1] = (struct cupola_lens_sample){1.25, 4.0};
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    check_near(rig.outputs[0].circle.center_x_px, 400.5, 0.0);
    check_near(rig.outputs[0].circle.center_y_px, 300.0, 0.0);
    check_near(rig.outputs[0].circle.radius_px, 300.0, 0.0);
    assert_int_equal(rig.outputs[1].width_px, 1024);
    check_near(rig.outputs[1].circle.center_x_px, 512.0, 0.0);
    check_near(rig.outputs[1].circle.radius_px, 200.0, 0.0);
    check_near(rig.outputs[1].lens.fov_rad, 2.5, 0.0);
}

static void completing_twice_changes_nothing_more(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int i = 0; i < 200; i++) {
        struct cupola_rig once, twice;
        memset(&once, 0, sizeof once);
        random_output(&seed, 0.8, &once.outputs[0]);
        assert_int_equal(cupola_rig_complete(&once, &once, NULL), CUPOLA_OK);
        memcpy(&twice, &once, sizeof twice);
        assert_int_equal(cupola_rig_complete(&twice, &twice, NULL), CUPOLA_OK);
        check_rigs_equal(&once, &twice);
    }
}

static void a_rig_can_be_checked_without_a_result(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    assert_int_equal(cupola_rig_complete(&rig, NULL, NULL), CUPOLA_OK);
    rig.screen.radius_m = -1.0;
    assert_int_equal(cupola_rig_complete(&rig, NULL, NULL), CUPOLA_ERROR_ARGUMENT);
}

static void eight_outputs_are_allowed_and_each_is_completed(void **state)
{
    (void)state;
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    rig.output_count = CUPOLA_OUTPUTS_MAX;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        check_near(rig.outputs[i].circle.radius_px, 512.0, 0.0);
}

struct preset {
    const char *name;
    int width_px, height_px;
    struct cupola_circle circle;
    double radius_m, cap_deg, tilt_deg;
};

static void presets_are_the_theatres_that_they_name(void **state)
{
    (void)state;
    static const struct preset presets[] = {
        {"visionstation", 1024, 768, {512.0, 384.0, 512.0}, 0.75, 90.0, 0.0},
        {"domemaster", 1024, 1024, {512.0, 512.0, 512.0}, 1.0, 180.0, 90.0},
        {"truncated-16x10", 1920, 1200, {960.0, 600.0, 960.0}, 1.0, 180.0, 0.0},
    };
    for (size_t i = 0; i < 3; i++) {
        const struct preset *preset = &presets[i];
        struct cupola_rig rig, complete;
        memset(&rig, 0, sizeof rig);
        assert_int_equal(cupola_rig_preset(preset->name, &rig, NULL), CUPOLA_OK);
        assert_int_equal(rig.output_count, 1);
        const struct cupola_output *output = &rig.outputs[0];
        assert_int_equal(output->width_px, preset->width_px);
        assert_int_equal(output->height_px, preset->height_px);
        check_near(output->circle.center_x_px, preset->circle.center_x_px, 0.0);
        check_near(output->circle.center_y_px, preset->circle.center_y_px, 0.0);
        check_near(output->circle.radius_px, preset->circle.radius_px, 0.0);
        assert_int_equal(output->lens.model, CUPOLA_LENS_ANGULAR);
        check_near(output->lens.fov_rad, pi, 1e-15);
        check_near(rig.screen.radius_m, preset->radius_m, 0.0);
        check_near(rig.screen.cap_rad, radians(preset->cap_deg), 1e-15);
        check_near(rig.tilt_rad, radians(preset->tilt_deg), 1e-15);

        memcpy(&complete, &rig, sizeof rig);
        assert_int_equal(cupola_rig_complete(&complete, &complete, NULL), CUPOLA_OK);
        check_rigs_equal(&rig, &complete);
    }
}

static void an_unknown_preset_is_answered_with_those_that_exist(void **state)
{
    (void)state;
    struct cupola_rig rig, before;
    memset(&rig, 0x5a, sizeof rig);
    memcpy(&before, &rig, sizeof rig);
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_rig_preset("planetariumm", &rig, &error), CUPOLA_ERROR_ARGUMENT);
    check_rigs_equal(&rig, &before);
    assert_non_null(strstr(error.message, "planetariumm"));
    int count = 0;
    for (const char *name; (name = cupola_rig_preset_name(count)) != NULL; count++)
        assert_non_null(strstr(error.message, name));
    assert_int_equal(count, 3);
    assert_null(cupola_rig_preset_name(-1));
    assert_int_equal(cupola_rig_preset(NULL, &rig, NULL), CUPOLA_ERROR_ARGUMENT);
}

#define REAL(member, value)                                                                        \
    {                                                                                              \
#member, offsetof(struct cupola_rig, member), 1, value                                     \
    }
#define WHOLE(member, value)                                                                       \
    {                                                                                              \
#member, offsetof(struct cupola_rig, member), 0, value                                     \
    }

static const struct {
    const char *member;
    size_t offset;
    int is_real;
    double value;
} bad_values[] = {
    REAL(screen.radius_m, -1.5),
    REAL(screen.radius_m, 1000.5),
    REAL(screen.radius_m, (double)NAN),
    REAL(screen.radius_m, (double)INFINITY),
    REAL(screen.cap_rad, -0.25),
    REAL(screen.cap_rad, 3.25),
    REAL(screen.cap_rad, (double)NAN),
    REAL(eye_m[0], 2.125), /* the screen's radius is 2 */
    REAL(eye_m[1], -2.125),
    REAL(eye_m[2], 2.0), /* on the screen is not inside */
    REAL(eye_m[2], (double)NAN),
    REAL(eye_m[0], -(double)INFINITY),
    REAL(tilt_rad, 3.25),
    REAL(tilt_rad, -3.25),
    REAL(tilt_rad, (double)NAN),
    REAL(units_per_metre, -2.5),
    REAL(units_per_metre, (double)NAN),
    REAL(units_per_metre, (double)INFINITY),
    WHOLE(output_count, -1),
    WHOLE(output_count, 9),
    WHOLE(outputs[0].width_px, -3),
    WHOLE(outputs[0].width_px, 32769),
    WHOLE(outputs[0].height_px, -7),
    WHOLE(outputs[0].height_px, 40000),
    REAL(outputs[0].circle.radius_px, -4.5),
    REAL(outputs[0].circle.radius_px, (double)NAN),
    REAL(outputs[0].circle.radius_px, (double)INFINITY),
    REAL(outputs[0].circle.center_x_px, (double)NAN),
    REAL(outputs[0].circle.center_y_px, (double)INFINITY),
    WHOLE(outputs[0].flip, 4),
    WHOLE(outputs[0].flip, -1),
    REAL(outputs[0].lens.fov_rad, 6.75),
    REAL(outputs[0].lens.fov_rad, -0.125),
    WHOLE(outputs[0].lens.model, 9),
    REAL(outputs[0].position_m[0], -2.25),
    REAL(outputs[0].position_m[1], 2.0),
    REAL(outputs[0].position_m[2], (double)NAN),
    REAL(outputs[0].aim.yaw_rad, 6.5),
    REAL(outputs[0].aim.yaw_rad, (double)NAN),
    REAL(outputs[0].aim.pitch_rad, -6.5),
    REAL(outputs[0].aim.roll_rad, 7.25),
    REAL(outputs[0].aim.roll_rad, (double)INFINITY),
    WHOLE(outputs[1].width_px, 32770),
    REAL(outputs[1].aim.pitch_rad, 6.75),
    REAL(outputs[1].position_m[2], 3.5),
};

/* The unit tests' ordinary rig with one member overwritten. */
static struct cupola_rig spoilt_rig(size_t offset, int is_real, double value)
{
    struct cupola_rig rig;
    memset(&rig, 0, sizeof rig);
    rig.screen.radius_m = 2.0;
    rig.output_count = 2;
    for (int i = 0; i < 2; i++)
        rig.outputs[i].circle = (struct cupola_circle){500.0, 500.0, 400.0};
    int whole = is_real ? 0 : (int)value;
    if (is_real)
        memcpy((char *)&rig + offset, &value, sizeof value);
    else
        memcpy((char *)&rig + offset, &whole, sizeof whole);
    return rig;
}

static void every_impossible_value_is_refused_by_name(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bad_values / sizeof bad_values[0]; i++) {
        struct cupola_rig rig =
            spoilt_rig(bad_values[i].offset, bad_values[i].is_real, bad_values[i].value);
        struct cupola_rig complete, before;
        memset(&complete, 0x5a, sizeof complete);
        memcpy(&before, &complete, sizeof before);
        struct cupola_error error = {CUPOLA_OK, ""};
        if (cupola_rig_complete(&rig, &complete, &error) != CUPOLA_ERROR_ARGUMENT)
            fail_msg("accepted: %s = %g", bad_values[i].member, bad_values[i].value);
        assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
        check_message(&error, bad_values[i].value);
        check_rigs_equal(&complete, &before);
    }
}

static void the_unspoilt_rig_is_accepted(void **state)
{
    (void)state;
    struct cupola_rig rig = spoilt_rig(offsetof(struct cupola_rig, eye_m[0]), 1, 1.999);
    assert_int_equal(cupola_rig_complete(&rig, NULL, NULL), CUPOLA_OK);
    rig.outputs[0].aim = (struct cupola_aim){2.0 * pi, -2.0 * pi, 2.0 * pi};
    rig.outputs[0].flip = CUPOLA_FLIP_X | CUPOLA_FLIP_Y;
    rig.tilt_rad = -pi;
    rig.screen.cap_rad = pi;
    rig.outputs[0].width_px = 32768;
    rig.outputs[0].height_px = 1;
    rig.outputs[0].circle = (struct cupola_circle){1e4, 0.5, 1e4};
    assert_int_equal(cupola_rig_complete(&rig, NULL, NULL), CUPOLA_OK);
}

static void two_errors_in_place_leave_the_rig_as_it_was(void **state)
{
    (void)state;
    struct cupola_rig rig = spoilt_rig(offsetof(struct cupola_rig, tilt_rad), 1, 9.0), before;
    rig.outputs[1].flip = 77;
    memcpy(&before, &rig, sizeof rig);
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_ERROR_ARGUMENT);
    check_rigs_equal(&rig, &before);
}

static void resizing_letterboxes_the_circle(void **state)
{
    (void)state;
    struct cupola_rig rig;
    assert_int_equal(cupola_rig_preset("visionstation", &rig, NULL), CUPOLA_OK);
    struct cupola_output *output = &rig.outputs[0];
    assert_int_equal(cupola_output_resize(output, 1920, 1080, NULL), CUPOLA_OK);
    assert_int_equal(output->width_px, 1920);
    assert_int_equal(output->height_px, 1080);
    check_near(output->circle.radius_px, 720.0, 1e-9);
    check_near(output->circle.center_x_px, 960.0, 1e-9);
    check_near(output->circle.center_y_px, 540.0, 1e-9);
}

/* Off-centre: 40 px right of the middle of 200 x 100, to 100 x 400; scale 1/2. */
static void resizing_keeps_the_circle_in_its_place(void **state)
{
    (void)state;
    struct cupola_output output;
    memset(&output, 0, sizeof output);
    output.width_px = 200;
    output.height_px = 100;
    output.circle = (struct cupola_circle){140.0, 30.0, 60.0};
    assert_int_equal(cupola_output_resize(&output, 100, 400, NULL), CUPOLA_OK);
    check_near(output.circle.radius_px, 30.0, 1e-9);
    check_near(output.circle.center_x_px, 70.0, 1e-9);
    check_near(output.circle.center_y_px, 190.0, 1e-9);
}

static void resizing_an_output_of_zeros_starts_from_its_defaults(void **state)
{
    (void)state;
    struct cupola_output output;
    memset(&output, 0, sizeof output);
    assert_int_equal(cupola_output_resize(&output, 300, 200, NULL), CUPOLA_OK);
    check_near(output.circle.radius_px, 100.0, 1e-9);
    check_near(output.circle.center_x_px, 150.0, 1e-9);
    check_near(output.circle.center_y_px, 100.0, 1e-9);
}

static void a_size_that_cannot_be_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    static const int sizes[][3] = {{0, 10, 0}, {10, -5, -5}, {32769, 10, 32769}, {10, 0, 0}};
    for (size_t i = 0; i < 4; i++) {
        struct cupola_output output, before;
        memset(&output, 0, sizeof output);
        output.circle.radius_px = 77.0;
        memcpy(&before, &output, sizeof output);
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(cupola_output_resize(&output, sizes[i][0], sizes[i][1], &error),
                         CUPOLA_ERROR_ARGUMENT);
        check_message(&error, sizes[i][2]);
        assert_memory_equal(&output, &before, sizeof output);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_zero_rig_is_a_domemaster_without_tilt),
        cmocka_unit_test(what_is_given_stays_and_the_rest_follows_from_it),
        cmocka_unit_test(completing_twice_changes_nothing_more),
        cmocka_unit_test(a_rig_can_be_checked_without_a_result),
        cmocka_unit_test(eight_outputs_are_allowed_and_each_is_completed),
        cmocka_unit_test(presets_are_the_theatres_that_they_name),
        cmocka_unit_test(an_unknown_preset_is_answered_with_those_that_exist),
        cmocka_unit_test(every_impossible_value_is_refused_by_name),
        cmocka_unit_test(the_unspoilt_rig_is_accepted),
        cmocka_unit_test(two_errors_in_place_leave_the_rig_as_it_was),
        cmocka_unit_test(resizing_letterboxes_the_circle),
        cmocka_unit_test(resizing_keeps_the_circle_in_its_place),
        cmocka_unit_test(resizing_an_output_of_zeros_starts_from_its_defaults),
        cmocka_unit_test(a_size_that_cannot_be_is_refused_and_changes_nothing),
    };
    return cmocka_run_group_tests_name("rig", tests, NULL, NULL);
}
