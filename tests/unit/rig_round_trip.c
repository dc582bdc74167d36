/* Rig files: what is written comes back to the last bit. */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comma_locale.h"
#include "io/rig_keys.h"
#include "io/rig_number.h"
#include "rig_equal.h"

static const double pi = 3.14159265358979323846;

static void presets_come_back_and_read_nicely(void **state)
{
    (void)state;
    struct cupola_rig rig;
    for (int i = 0; cupola_rig_preset_name(i); i++) {
        assert_int_equal(cupola_rig_preset(cupola_rig_preset_name(i), &rig, NULL), CUPOLA_OK);
        check_round_trip(&rig);
        char *text = content_of(in_folder("rig.cfg"));
        assert_non_null(strstr(text, i == 0 ? "    cap_deg = 90.0;" : "    cap_deg = 180.0;"));
        assert_non_null(strstr(text, "fov_deg = 180.0;"));
        assert_null(strstr(text, "99999"));
        free(text);
        assert_non_null(strstr(rig_section_rig.keys[1].allowed, cupola_rig_preset_name(i)));
    }
}

static uint64_t seed;

static double between(double low, double high)
{
    return random_between(&seed, low, high);
}

static struct cupola_lens random_lens(int model)
{
    struct cupola_lens lens = {.model = (enum cupola_lens_model)model};
    lens.fov_rad = between(0.1, pi);
    if (model == CUPOLA_LENS_POLYNOMIAL)
        for (int i = 0; i < 4; i++)
            lens.k[i] = between(0, 10);
    if (model != CUPOLA_LENS_TABLE)
        return lens;
    lens.fov_rad = 0;
    lens.table_count = (int)between(2, 64.999);
    double angle = 0, radius = 0;
    for (int i = 0; i < lens.table_count; i++) {
        angle += between(0.001, pi / 64);
        radius += between(1e-9, 1e3);
        lens.table[i] = (struct cupola_lens_sample){angle, radius};
    }
    return lens;
}

static struct cupola_output random_output(int model)
{
    struct cupola_output output = {
        .width_px = (int)between(1, 32768.99),
        .height_px = (int)between(1, 32768.99),
        .flip = (int)between(0, 3.99),
        .lens = random_lens(model),
        .position_m = {between(-0.01, 0.01), between(-0.01, 0.01), between(-0.01, 0.01)},
        .aim = {between(-2 * pi, 2 * pi), between(-2 * pi, 2 * pi), between(-1e-6, 1e-6)},
    };
    output.circle = (struct cupola_circle){between(0, output.width_px),
                                           between(0, output.height_px), between(0.1, 1e6)};
    return output;
}

static void random_rigs_come_back_to_the_last_bit(void **state)
{
    (void)state;
    for (int number = 0; number < 120; number++) {
        seed = (uint64_t)number;
        struct cupola_rig rig = {
            .screen = {between(0.1, 1000), between(0.001, pi)},
            .eye_m = {between(-0.05, 0.05), between(-1e-300, 1e-300), -0.0},
            .tilt_rad = between(-pi, pi),
            .units_per_metre = pow(10, between(-300, 9)),
            .output_count = 1 + number % CUPOLA_OUTPUTS_MAX,
        };
        for (int i = 0; i < rig.output_count; i++)
            rig.outputs[i] = random_output((number + i) % 6);
        check_round_trip(&rig);
    }
}

static void every_angle_comes_back_from_degrees(void **state)
{
    (void)state;
    char text[RIG_NUMBER_SIZE];
    for (int i = 0; i < 200000; i++) {
        double angle = between(-2 * pi, 2 * pi) * pow(2, -floor(between(0, 40)));
        rig_number_print_angle(angle, text);
        check_bits(rig_number_angle_rad(text), angle);
    }
    for (int degrees = -360; degrees <= 360; degrees++) {
        char expected[RIG_NUMBER_SIZE];
        snprintf(expected, sizeof expected, "%d.0", degrees);
        rig_number_print_angle(rig_number_angle_rad(expected), text);
        assert_string_equal(text, expected);
        rig_number_print_angle(degrees * pi / 180, text);
        check_bits(rig_number_angle_rad(text), degrees * pi / 180);
    }
    check_bits(rig_number_angle_rad("180"), pi);
}

static void limits_are_allowed(void **state)
{
    (void)state;
    struct cupola_rig rig = {
        .screen = {1000, pi}, .tilt_rad = -pi, .outputs[0].aim = {2 * pi, -2 * pi, 0}};
    rig.outputs[0].lens.fov_rad = 2 * pi;
    check_round_trip(&rig);
    rig.screen.cap_rad = pi + 1e-12;
    rig.tilt_rad = pi + 1e-12;
    rig.outputs[0].lens.fov_rad = 2 * pi + 1e-12;
    check_round_trip(&rig);
}

static void the_locale_changes_nothing(void **state)
{
    (void)state;
    struct cupola_rig rig = {.eye_m = {0.125, 1.0 / 3, 0}, .outputs[0].lens = random_lens(5)}, read;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    struct cupola_error error = {0};
    assert_int_equal(cupola_rig_write(in_folder("c.cfg"), &rig, NULL), CUPOLA_OK);
    locale_t locale = comma_locale();
    if (!locale)
        skip();
    locale_t before = uselocale(locale);
    char sample[16];
    snprintf(sample, sizeof sample, "%.1f", 0.5);
    int wrote = cupola_rig_write(in_folder("de.cfg"), &rig, &error);
    int status = cupola_rig_read(in_folder("de.cfg"), NULL, &read, &error);
    int refused = cupola_rig_parse("eye_m = [2.5, 0, 0];", "x", NULL, &read, &error);
    assert_ptr_equal(uselocale(before), locale);
    freelocale(locale);
    assert_string_equal(sample, "0,5");
    assert_int_equal(wrote, CUPOLA_OK);
    assert_int_equal(status, CUPOLA_OK);
    assert_int_equal(refused, CUPOLA_ERROR_ARGUMENT);
    assert_string_equal(error.message, "x:1: eye_m: value [2.5, 0, 0]; allowed: inside of the "
                                       "screen sphere, less than 1 from its centre");
    check_rig_equal(&read, &rig);
    char *in_c = content_of(in_folder("c.cfg")), *in_de = content_of(in_folder("de.cfg"));
    assert_string_equal(in_c, in_de);
    free(in_c);
    free(in_de);
}

int main(void)
{
    const struct CMUnitTest rig_round_trip[] = {
        cmocka_unit_test(presets_come_back_and_read_nicely),
        cmocka_unit_test(random_rigs_come_back_to_the_last_bit),
        cmocka_unit_test(every_angle_comes_back_from_degrees),
        cmocka_unit_test(limits_are_allowed),
        cmocka_unit_test(the_locale_changes_nothing),
    };
    return cmocka_run_group_tests(rig_round_trip, make_folder, remove_folder);
}
