/* Labels and cursors of the demo stand where they were asked for. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/cupola.h>
#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

enum { SIDE = 300 };

static const char rig[] = "--headless --preset domemaster --size 300x300";

static struct process process;
static struct picture without; /* any mark */

/* The middle of what the marks changed, px. */
static double changed(const struct picture *with, double middle[2])
{
    double sum = 0;

    middle[0] = middle[1] = 0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            double off = 0;
            for (int c = 0; c < 3; c++)
                off += fabs((double)picture_pixel(with, i, j)[c] -
                            (double)picture_pixel(&without, i, j)[c]);
            off = off > 1e-3;
            sum += off;
            middle[0] += off * (i + 0.5);
            middle[1] += off * (j + 0.5);
        }
    for (int i = 0; i < 2; i++)
        middle[i] /= sum;
    return sum;
}

/* On a planetarium of 180 degrees: 150 px for 90 degrees from the zenith, the front below. */
static void check_place(const char *mark, double yaw_deg, double pitch_deg, double within_px)
{
    char command[200];
    double yaw = yaw_deg * 3.14159265358979323846 / 180, middle[2];
    double radius = (90 - pitch_deg) / 90 * 150;

    snprintf(command, sizeof command, "%s %s", rig, mark);
    struct picture with = demo_run_pfm(&process, command);
    if (!without.rgba)
        without = demo_run_pfm(&process, rig);
    assert_int_equal(with.width, SIDE);
    check_at_least(changed(&with, middle), 15);
    check_near(middle[0], 150 - radius * sin(yaw), within_px);
    check_near(middle[1], 150 - radius * cos(yaw), within_px);
    cupola_image_free(&with.rgba);
}

static void a_cursor_stands_in_its_direction(void **state)
{
    (void)state;
    check_place("--cursor 0,30", 0, 30, 0.5);
    check_place("--cursor -75,10", -75, 10, 0.5);
}

/* The ink of capitals; an x is lower than they are. */
static void a_label_stands_in_its_direction(void **state)
{
    (void)state;
    check_place("--label H@0,30,8", 0, 30, 0.5);
    check_place("--label H@-120,20,10", -120, 20, 0.5);
    check_place("--label x@x@60,20,10", 60, 20, 3);
}

static struct picture seen(const char *mark)
{
    char command[300];

    snprintf(command, sizeof command,
             "--headless --preset visionstation --size 256x256 --preview eye %s", mark);
    return demo_run_pfm(&process, command);
}

/* 60 degrees from bottom to top, straight ahead of the eye. */
static void the_viewer_sees_a_label_where_it_was_asked_for(void **state)
{
    static const double pi = 3.14159265358979323846;
    struct picture before = seen(""), with = seen("--label H@8,-5,10");
    double across = 0, up = 0, count = 0, px = with.height / 2.0 / tan(pi / 6);

    (void)state;
    for (int j = 0; j < with.height; j++)
        for (int i = 0; i < with.width; i++)
            if (fabs((double)picture_pixel(&with, i, j)[1] -
                     (double)picture_pixel(&before, i, j)[1]) > 0.02) {
                across += i + 0.5;
                up += j + 0.5;
                count++;
            }
    check_at_least(count, 50);
    double yaw = atan((with.width / 2.0 - across / count) / px);
    double pitch = atan((up / count - with.height / 2.0) / px * cos(yaw));
    printf("seen at %.2f, %.2f degrees\n", yaw * 180 / pi, pitch * 180 / pi);
    check_near(yaw * 180 / pi, 8, 0.3);
    check_near(pitch * 180 / pi, -5, 0.3);
    cupola_image_free(&before.rgba);
    cupola_image_free(&with.rgba);
}

/* 100 characters of two bytes each are allowed, 101 are not. */
static void the_length_of_a_label_counts_characters(void **state)
{
    char command[400] = "--headless --preset domemaster --size 16x16 --output x.png --label ";
    size_t start = strlen(command);

    (void)state;
    for (int count = 100; count <= 101; count++) {
        for (int i = 0; i < count; i++)
            memcpy(command + start + 2 * i, "\xc3\xa4", 2);
        strcpy(command + start + 2 * count, "@0,30,1");
        process_run(&process, command, NULL);
        assert_int_equal(process.status, count == 100 ? 0 : 2);
    }
}

static void labels_that_are_too_much_are_refused(void **state)
{
    char many[1200] = "--headless --size 16x16", wide[200] = "--headless --size 16x16 --label ";
    size_t length = strlen(many);
    int files = process_count_files();

    (void)state;
    for (int i = 0; i < 33; i++)
        length += (size_t)snprintf(many + length, sizeof many - length, " --label=N@%d,2", i);
    process_run(&process, many, NULL);
    assert_int_equal(process.status, 2);
    assert_non_null(strstr(process.err, "'N@32,2' is one too many; allowed: 32"));
    length = strlen(wide);
    memset(wide + length, 'x', 90);
    snprintf(wide + length + 90, 20, "@1,2,60");
    process_run(&process, wide, NULL);
    assert_int_equal(process.status, 1);
    assert_non_null(strstr(process.err, "degrees wide; allowed: up to 150"));
    assert_int_equal(process_count_files(), files);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_cursor_stands_in_its_direction, process_enter_directory,
                                        process_leave_directory),
        cmocka_unit_test_setup_teardown(a_label_stands_in_its_direction, process_enter_directory,
                                        process_leave_directory),
        cmocka_unit_test_setup_teardown(the_viewer_sees_a_label_where_it_was_asked_for,
                                        process_enter_directory, process_leave_directory),
        cmocka_unit_test_setup_teardown(the_length_of_a_label_counts_characters,
                                        process_enter_directory, process_leave_directory),
        cmocka_unit_test_setup_teardown(labels_that_are_too_much_are_refused,
                                        process_enter_directory, process_leave_directory),
    };
    int failures = cmocka_run_group_tests_name("cli-marks", tests, NULL, NULL);
    cupola_image_free(&without.rgba);
    return failures;
}
