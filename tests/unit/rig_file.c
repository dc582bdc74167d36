/* Rig files: what is valid is read, what is broken is explained. */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/rig_keys.h"
#include "io/rig_number.h"
#include "rig_equal.h"

static const double pi = 3.14159265358979323846;

static void for_each_rig(const char *kind, void (*check)(const char *path), int at_least)
{
    char path[1024];
    int count = 0;
    snprintf(path, sizeof path, "%s/rigs/%s", getenv("TEST_DATA"), kind);
    DIR *directory = opendir(path);
    assert_non_null(directory);
    for (struct dirent *entry; (entry = readdir(directory));) {
        size_t length = strlen(entry->d_name);
        if (length < 4 || strcmp(entry->d_name + length - 4, ".cfg") != 0)
            continue;
        snprintf(path, sizeof path, "%s/rigs/%s/%s", getenv("TEST_DATA"), kind, entry->d_name);
        check(path);
        count++;
    }
    closedir(directory);
    check_at_least(count, at_least);
}

static void check_broken(const char *path)
{
    char expected_path[1024];
    struct cupola_error error = {0};
    struct cupola_rig rig, before;
    memset(&rig, 0x5a, sizeof rig);
    before = rig;
    snprintf(expected_path, sizeof expected_path, "%.*s.txt", (int)strlen(path) - 4, path);
    char *expected = content_of(expected_path);
    expected[strcspn(expected, "\n")] = 0;
    int status = cupola_rig_read(path, NULL, &rig, &error);
    if (status >= 0 || strncmp(error.message, path, strlen(path)) != 0 ||
        strcmp(error.message + strlen(path), expected) != 0)
        fail_msg("%s: '%s' instead of '%s'", path, error.message, expected);
    assert_int_equal(status, error.status);
    assert_true(status == CUPOLA_ERROR_SYNTAX || status == CUPOLA_ERROR_ARGUMENT);
    assert_memory_equal(&rig, &before, sizeof rig);
    assert_int_equal(cupola_rig_read(path, NULL, &rig, NULL), status);
    free(expected);
}

static void broken_files_are_explained(void **state)
{
    (void)state;
    for_each_rig("broken", check_broken, 90);
}

static void check_valid(const char *path)
{
    struct cupola_rig rig;
    struct cupola_error error = {0};
    if (cupola_rig_read(path, NULL, &rig, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    check_round_trip(&rig);
}

static void valid_files_are_read(void **state)
{
    (void)state;
    for_each_rig("valid", check_valid, 8);
}

static struct cupola_rig valid(const char *name)
{
    char path[1024];
    struct cupola_rig rig;
    snprintf(path, sizeof path, "%s/rigs/valid/%s.cfg", getenv("TEST_DATA"), name);
    assert_int_equal(cupola_rig_read(path, NULL, &rig, NULL), CUPOLA_OK);
    return rig;
}

static void values_arrive_where_they_belong(void **state)
{
    (void)state;
    struct cupola_rig rig = valid("empty"), defaults = {0};
    cupola_rig_complete(&defaults, &defaults, NULL);
    check_rig_equal(&rig, &defaults);
    rig = valid("mixed-numbers");
    check_bits(rig.screen.radius_m, 2);
    check_bits(rig.screen.cap_rad, pi / 2);
    check_bits(rig.eye_m[1], 0.25);
    check_bits(rig.eye_m[2], -0.01);
    check_bits(rig.outputs[0].position_m[2], 0.5);
    check_bits(rig.outputs[0].circle.radius_px, 240);
    check_bits(valid("crlf-and-mark").tilt_rad, pi / 4);
    check_bits(valid("crlf-and-mark").screen.radius_m, 3.5);
    check_bits(valid("comments").tilt_rad, pi / 2);
    rig = valid("default-circle");
    check_bits(rig.outputs[0].circle.center_x_px, 960);
    check_bits(rig.outputs[0].circle.center_y_px, 600);
    check_bits(rig.outputs[0].circle.radius_px, 960);
    assert_int_equal(rig.outputs[1].flip, CUPOLA_FLIP_X | CUPOLA_FLIP_Y);
    assert_int_equal(rig.outputs[1].lens.model, CUPOLA_LENS_EQUISOLID);
    check_bits(rig.outputs[1].aim.roll_rad, rig_number_angle_rad("-12.5"));
    assert_int_equal(rig.outputs[1].width_px, 1024);
    rig = valid("lens-table");
    check_bits(rig.outputs[0].lens.fov_rad, 2 * rig_number_angle_rad("82.5"));
    rig = valid("lens-polynomial");
    check_bits(rig.outputs[0].lens.k[1], -0.05);
    check_bits(rig.outputs[0].lens.k[2], 0);
}

static void the_circle_of_a_preset_follows_the_size(void **state)
{
    (void)state;
    struct cupola_rig rig = valid("preset-resized");
    check_bits(rig.screen.radius_m, 0.75);
    check_bits(rig.screen.cap_rad, rig_number_angle_rad("80"));
    check_bits(rig.outputs[0].circle.center_x_px, 256);
    check_bits(rig.outputs[0].circle.center_y_px, 256);
    check_bits(rig.outputs[0].circle.radius_px, 256);
}

static void too_much_of_anything_is_refused(void **state)
{
    (void)state;
    enum { SIZE = 300000 };
    struct cupola_rig rig;
    struct cupola_error error = {0};
    char *text = malloc(SIZE + 1);
    assert_non_null(text);
    memset(text, '(', SIZE);
    memcpy(text, "tilt_deg = ", 11);
    text[100000] = 0;
    assert_int_equal(cupola_rig_parse(text, "deep", NULL, &rig, &error), CUPOLA_ERROR_SYNTAX);
    assert_string_equal(error.message,
                        "deep:1: groups and lists are nested too deeply; allowed: 16 levels");
    memset(text, '#', SIZE);
    text[SIZE] = 0;
    put(in_folder("long.cfg"), text);
    assert_int_equal(cupola_rig_read(in_folder("long.cfg"), NULL, &rig, &error),
                     CUPOLA_ERROR_SYNTAX);
    assert_non_null(strstr(error.message, "long.cfg: too long; allowed: up to 262144 bytes"));
    text[256 * 1024] = 0;
    put(in_folder("long.cfg"), text);
    assert_int_equal(cupola_rig_read(in_folder("long.cfg"), NULL, &rig, &error), CUPOLA_OK);
    free(text);
}

static uint64_t seed;

static double between(double low, double high)
{
    return random_between(&seed, low, high);
}

static void bytes_in_disorder_do_no_harm(void **state)
{
    (void)state;
    static const char alphabet[] = "{}[]()=:;,#/*\"\\@.+-019eExL \n";
    struct cupola_rig start = valid("default-circle"), rig;
    struct cupola_error error;
    assert_int_equal(cupola_rig_write(in_folder("rig.cfg"), &start, NULL), CUPOLA_OK);
    char *good = content_of(in_folder("rig.cfg"));
    size_t length = strlen(good);
    char *text = malloc(length + 1);
    assert_non_null(text);
    int refused = 0;
    for (int number = 0; number < 4000; number++) {
        seed = (uint64_t)number;
        memcpy(text, good, length + 1);
        for (int changes = (int)between(1, 4); changes > 0; changes--)
            text[(size_t)between(0, (double)length)] =
                alphabet[(size_t)between(0, (double)sizeof alphabet - 1)];
        if (between(0, 1) < 0.2)
            memcpy(text + (size_t)between(0, (double)length - 20), "\n@include \".\"\n", 14);
        int status = cupola_rig_parse(text, "changed", NULL, &rig, &error);
        assert_true(status == CUPOLA_OK || strncmp(error.message, "changed:", 8) == 0);
        refused += status != CUPOLA_OK;
    }
    check_at_least(refused, 1000);
    check_at_most(refused, 3990);
    free(text);
    free(good);
}

static void nothing_is_not_a_rig(void **state)
{
    (void)state;
    struct cupola_rig rig;
    struct cupola_error error;
    assert_int_equal(cupola_rig_read(NULL, NULL, &rig, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_rig_read("", NULL, &rig, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_rig_parse(NULL, "x", NULL, &rig, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_rig_parse("", "x", NULL, NULL, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_rig_parse("x", NULL, NULL, &rig, NULL), CUPOLA_ERROR_SYNTAX);
    assert_int_equal(cupola_rig_read(in_folder("none"), NULL, &rig, &error), CUPOLA_ERROR_FILE);
    assert_non_null(strstr(error.message, "none: cannot be opened: No such file or directory"));
    assert_int_equal(cupola_rig_read(folder, NULL, &rig, &error), CUPOLA_ERROR_FILE);
    assert_non_null(strstr(error.message, ": is a directory; allowed: a regular file"));
    assert_int_equal(mkfifo(in_folder("pipe"), 0600), 0);
    assert_int_equal(cupola_rig_read(in_folder("pipe"), NULL, &rig, &error), CUPOLA_ERROR_FILE);
    assert_non_null(strstr(error.message, ": is a device or a pipe; allowed: a regular file"));
}

static void check_documented(const char *document, const struct rig_section *section)
{
    char needle[256];
    for (int i = 0; i < section->key_count; i++) {
        const struct rig_key *key = &section->keys[i];
        snprintf(needle, sizeof needle, "| `%s` |", key->name);
        if (!strstr(document, needle))
            fail_msg("docs/rig-format.md has no row %s", needle);
        if (key->kind != RIG_GROUP && key->kind != RIG_GROUPS && !strstr(document, key->allowed))
            fail_msg("docs/rig-format.md does not say what is allowed for %s: %s", key->name,
                     key->allowed);
        if (key->section)
            check_documented(document, key->section);
    }
}

static void every_key_is_documented(void **state)
{
    (void)state;
    char path[1024];
    snprintf(path, sizeof path, "%s/../../docs/rig-format.md", getenv("TEST_DATA"));
    char *document = content_of(path);
    check_documented(document, &rig_section_rig);
    free(document);
}

static void the_documented_example_is_read(void **state)
{
    (void)state;
    char path[1024];
    struct cupola_rig rig;
    struct cupola_error error;
    snprintf(path, sizeof path, "%s/../../docs/rig-format.md", getenv("TEST_DATA"));
    char *document = content_of(path);
    char *example = strstr(document, "```libconfig\n");
    assert_non_null(example);
    example += strlen("```libconfig\n");
    char *end = strstr(example, "```");
    assert_non_null(end);
    *end = 0;
    if (cupola_rig_parse(example, "docs/rig-format.md", NULL, &rig, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    free(document);
}

static void a_file_changes_no_more_of_its_base_than_it_says(void **state)
{
    (void)state;
    struct cupola_rig base, rig;
    assert_int_equal(cupola_rig_preset("visionstation", &base, NULL), CUPOLA_OK);
    assert_int_equal(cupola_rig_parse("tilt_deg = 30;", "x", &base, &rig, NULL), CUPOLA_OK);
    check_near(rig.tilt_rad, 30 * 3.14159265358979323846 / 180, 1e-15);
    assert_int_equal(rig.outputs[0].height_px, 768);
    check_near(rig.screen.radius_m, 0.75, 0);
    base.screen.radius_m = -1;
    assert_int_equal(cupola_rig_parse("", "x", &base, &rig, NULL), CUPOLA_ERROR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest rig_file[] = {
        cmocka_unit_test(broken_files_are_explained),
        cmocka_unit_test(valid_files_are_read),
        cmocka_unit_test(values_arrive_where_they_belong),
        cmocka_unit_test(the_circle_of_a_preset_follows_the_size),
        cmocka_unit_test(too_much_of_anything_is_refused),
        cmocka_unit_test(bytes_in_disorder_do_no_harm),
        cmocka_unit_test(nothing_is_not_a_rig),
        cmocka_unit_test(every_key_is_documented),
        cmocka_unit_test(the_documented_example_is_read),
        cmocka_unit_test(a_file_changes_no_more_of_its_base_than_it_says),
    };
    return cmocka_run_group_tests(rig_file, make_folder, remove_folder);
}
