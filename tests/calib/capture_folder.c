/* The folder of a series: whose it is, and that nothing in it is lost. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "capture/photo.h"
#include "capture_fixture.h"
#include "check.h"
#include "option_values.h"

enum { FAILED = 1 };

static int make_rig(void **state)
{
    struct cupola_rig rig = {.outputs = {{.width_px = 64, .height_px = 48}}};

    if (capture_enter_directory(state) != 0)
        return -1;
    capture_write_rig("r.cfg", &rig);
    return 0;
}

static void run(const char *line)
{
    char message[MESSAGE_SIZE];

    if (capture_run(line, message) != 0)
        fail_msg("%s: %s", line, message);
}

static void test_a_folder_is_for_one_series(void **state)
{
    (void)state;
    run("patterns --rig r.cfg --folder long --period 8");
    capture_refuse("patterns --rig r.cfg --folder long --period 32", FAILED,
                   "which is not of this series; allowed: a folder without pictures");
    /* The control: the same series is written anew. */
    run("patterns --rig r.cfg --folder long --period 8");
    run("simulate --rig r.cfg --patterns long --folder photos --camera angular:180 --format pfm "
        "--photo-size 60x48");
    capture_refuse("simulate --rig r.cfg --patterns long --folder photos --camera angular:180",
                   FAILED, "photos has ");
    assert_int_equal(link("long/00-white.png", "long/holiday.png"), 0);
    capture_refuse("decode --rig r.cfg --camera angular:180 --output m.csv --folder long", FAILED,
                   "27 photographs; allowed: 26, one of each pattern, in the order of the "
                   "patterns; long/holiday.png is called as none of them is");
}

/* One pixel of a picture; -1 where there is no picture of 64 x 48. */
static float pixel_of(const char *path)
{
    char message[MESSAGE_SIZE];
    struct photo photo;
    float light = -1;

    if (!photo_read(path, PHOTO_SRGB, &photo, message))
        return -1;
    if (photo.width == 64 && photo.height == 48)
        light = photo.light[0];
    photo_free(&photo);
    return light;
}

/* Photographs have the names of their patterns. */
static void test_patterns_are_not_written_over_photographs(void **state)
{
    static const char patterns[] = "patterns --rig r.cfg --folder photos --period 8";
    static const char last[] = "photos/25-y-sine-3.png", first[] = "photos/00-white.png";
    char message[MESSAGE_SIZE];
    struct photo photo;
    FILE *file;

    (void)state;
    run("patterns --rig r.cfg --folder series --period 8");
    run("simulate --rig r.cfg --patterns series --folder photos --camera angular:180 "
        "--photo-size 64x48");
    float before = pixel_of(first);
    capture_refuse(patterns, FAILED,
                   "--folder: photos/00-white.png is there and is not the pattern of that name");
    assert_true(pixel_of(first) == before);

    /* Of the right size, one pixel differs by one; the others are not written either. */
    assert_int_equal(system("rm photos/*.png"), 0);
    run(patterns);
    float right = pixel_of(last);
    assert_true(photo_read(last, PHOTO_SRGB, &photo, message));
    photo.light[64 * 48 - 1] += photo.light[64 * 48 - 1] > 0.5f ? -0.01f : 0.01f;
    assert_true(photo_write(last, &photo, PHOTO_PNG8, message));
    photo_free(&photo);
    assert_int_equal(unlink(first), 0);
    capture_refuse(patterns, FAILED, last);
    assert_int_not_equal(access(first, F_OK), 0);

    /* Not even what is no picture; the control is what is missing. */
    file = fopen(last, "w");
    fputs("notes", file);
    fclose(file);
    capture_refuse(patterns, FAILED, last);
    assert_int_equal(unlink(last), 0);
    run(patterns);
    assert_true(pixel_of(first) == 1);
    assert_true(pixel_of(last) == right);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_a_folder_is_for_one_series, make_rig,
                                        capture_leave_directory),
        cmocka_unit_test_setup_teardown(test_patterns_are_not_written_over_photographs, make_rig,
                                        capture_leave_directory),
    };
    return cmocka_run_group_tests_name("calib capture_folder", tests, NULL, NULL);
}
