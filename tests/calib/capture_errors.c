/* What `capture` says to wrong input: one sentence, the right exit status, and nothing written. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cupola/rig_file.h>

#include "capture/code_check.h"
#include "capture/code_map.h"
#include "capture/folder.h"
#include "capture/photo.h"
#include "capture_fixture.h"
#include "check.h"
#include "option_values.h"

enum { FAILED = 1, USAGE = 2 };

#define DECODE "decode --rig r.cfg --camera angular:180 --output m.csv "

/* A projector of 64 x 48 and photographs of 60 x 48 that show it pixel by pixel. */
struct flaw {
    double lit;
    double ambient;
    struct series_picture taken, instead; /* where they differ: one photograph of another picture */
    bool black;                           /* and of nothing at all */
    double hole;                          /* not 0: what one pixel is in all that are decoded */
};

/* The first two stand for all of them. */
static const double holes[] = {0, (double)NAN, HUGE_VAL, -HUGE_VAL};

static bool same_picture(const struct series_picture *a, const struct series_picture *b)
{
    return a->kind == b->kind && a->axis == b->axis && a->index == b->index;
}

static double photo_light(const struct series_picture *picture, int i, int j, void *data)
{
    static const struct series series = {.size_px = {64, 48}, .period_px = 8, .steps = 4};
    const struct flaw *flaw = data;

    if (flaw->hole != 0 && i == 30 && j == 24 && picture->kind != SERIES_WHITE &&
        picture->kind != SERIES_BLACK)
        return flaw->hole;
    if (same_picture(picture, &flaw->taken) && flaw->black)
        return flaw->ambient;
    if (flaw->black)
        return flaw->ambient + flaw->lit * series_light(&series, picture, i, j);
    if (same_picture(picture, &flaw->taken))
        picture = &flaw->instead;
    else if (same_picture(picture, &flaw->instead))
        picture = &flaw->taken;
    return flaw->ambient + flaw->lit * series_light(&series, picture, i, j);
}

static int make_folders(void **state)
{
    struct cupola_rig rig = {.outputs = {{.width_px = 64, .height_px = 48}}};
    struct series series = {.size_px = {64, 48}, .period_px = 8, .steps = 4};
    struct flaw right = {.lit = 0.7}, dark = {.lit = 0.01};

    if (capture_enter_directory(state) != 0)
        return -1;
    capture_write_rig("r.cfg", &rig);
    rig.outputs[0].width_px = 80;
    capture_write_rig("other.cfg", &rig);
    capture_write_photos("right", &series, 60, 48, photo_light, &right);
    capture_write_photos("dark", &series, 60, 48, photo_light, &dark);
    capture_write_photos("fewer", &series, 60, 48, photo_light, &right);
    capture_write_photos("mixed", &series, 60, 48, photo_light, &right);
    return unlink("fewer/05-x-inverse-1.pfm") == 0 ? 0 : -1;
}

static void test_wrong_command_lines_are_refused(void **state)
{
    static const char *const wrong[][2] = {
        {"", "is no command of capture"},
        {"dekode", "'dekode' is no command of capture; allowed: patterns, show, decode, simulate"},
        {"patterns --folder p", "--rig is missing"},
        {"patterns --rig r.cfg --folder p --period 13", "even numbers"},
        {"patterns --rig r.cfg --folder p --period 6", "8 to 1024"},
        {"patterns --rig r.cfg --folder p --steps 3", "4 to 16"},
        {"patterns --rig r.cfg --folder p --projector 1", "allowed: 0 to 0"},
        {"patterns --rig r.cfg --folder p --noise 1", "--noise is not for patterns"},
        {"patterns --rig r.cfg --folder p more", "'more' is not allowed"},
        {"patterns --rig r.cfg --folder", "--folder needs a value"},
        {"patterns --wrong", "--wrong is no option"},
        {"show --patterns p --shots 3", "need --device"},
        {"show --patterns p --device /dev/video0", "--device needs --folder"},
        {DECODE, "decode needs photographs"},
        {DECODE "--folder right one.png", "not both"},
        {DECODE "one.png two.png", "--patterns is missing"},
        {DECODE "--folder right --marks 3", "12 to 5000"},
        {DECODE "--folder right --contrast 0", "above 0"},
        {DECODE "--folder right --camera angular", "'angular' is not allowed; allowed: "},
        {"simulate --rig r.cfg --patterns right --folder s --camera angular:180 --photo-size "
         "20000x10",
         "--photo-size is 20000 x 10 px; allowed: up to 16384 each way"},
        {DECODE "--folder right --camera fish", "'fish' is not allowed"},
        {DECODE "--folder right --camera rectilinear:60 --camera-circle 1,2,3", "is for a fisheye"},
        {DECODE "--folder right --camera-circle 1,2,0", "radius of 0"},
        {DECODE "--folder right --camera-free pose", "needs --references"},
        {DECODE "--folder right --camera-free lens", "'lens' is not allowed"},
        {DECODE "--folder right --solved s.cfg", "changes no photograph"},
    };

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        capture_refuse(wrong[i][0], USAGE, wrong[i][1]);
}

static void test_wrong_files_are_refused(void **state)
{
    FILE *file = fopen("refs.csv", "w");

    (void)state;
    fputs("name,x_px,y_px,dir_x,dir_y,dir_z\na,10,10,0,0,-1\nb,20,20,0,0,1\n", file);
    fclose(file);
    capture_refuse("decode --rig none.cfg --camera angular:180 --output m.csv --folder right",
                   FAILED, "none.cfg");
    capture_refuse(DECODE "--folder nowhere", FAILED, "nowhere");
    capture_refuse("decode --rig other.cfg --camera angular:180 --output m.csv --folder right",
                   FAILED, "the patterns are of 64x48 px, and projector 0 of the rig is of 80x48");
    capture_refuse(DECODE "--folder fewer", FAILED, "none is called 05-x-inverse-1");
    capture_refuse(DECODE "--patterns right right/00-white.pfm", FAILED,
                   "1 photograph; allowed: 26");
    capture_refuse(DECODE "--folder right --camera equirectangular", FAILED,
                   "twice as wide as high");
    capture_refuse(DECODE "--folder right --output gone/m.csv", FAILED,
                   "gone/m.csv cannot be written");
    capture_refuse(DECODE "--folder right --references refs.csv", FAILED, "5 to 175 degrees");
    capture_refuse("simulate --rig r.cfg --patterns right --folder s --camera angular:180", FAILED,
                   "00-white.png");
}

static void test_no_file_is_written_over_another(void **state)
{
    char message[MESSAGE_SIZE];
    struct cupola_rig rig;
    static const char *const wrong[][2] = {
        {DECODE "--folder right --output r.cfg", "--rig and --output are the same file, r.cfg"},
        {DECODE "--folder right --references r.csv --output ./r.csv", "--references and --output"},
        {DECODE "--folder right --references r.csv --output s --solved s", "--output and --solved"},
        {DECODE "--folder right --references r.csv --solved r.csv", "--references and --solved"},
        {DECODE "--folder right --output right/00-white.pfm", "--output and a photograph"},
        {"simulate --rig r.cfg --patterns right --folder right --camera angular:180",
         "--patterns and --folder are the same folder, right"},
        {"simulate --rig r.cfg --patterns right --folder s --camera angular:180 --references r.cfg",
         "--rig and --references"},
        {"simulate --rig r.cfg --patterns right --folder s --camera angular:180 "
         "--references right/00-white.png",
         "--references and a pattern"},
        {"show --patterns right --device /dev/video0 --folder right/", "the same folder"},
        {"patterns --rig patterns.txt --folder .", "--rig and a picture are the same file"},
    };

    (void)state;
    capture_write_rig("patterns.txt",
                      &(struct cupola_rig){.outputs = {{.width_px = 64, .height_px = 48}}});
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        capture_refuse(wrong[i][0], USAGE, wrong[i][1]);
    /* The control: the rig alone may be changed in place, and nothing was. */
    capture_refuse(DECODE "--folder right --references none.csv --solved r.cfg", FAILED,
                   "none.csv");
    assert_int_equal(cupola_rig_read("r.cfg", NULL, &rig, NULL), 0);
    if (capture_run("patterns --rig r.cfg --folder fresh", message) != 0)
        fail_msg("%s", message);
}

static void test_dark_and_broken_photographs_are_said(void **state)
{
    char message[MESSAGE_SIZE];
    struct photo photo;
    FILE *file;

    (void)state;
    capture_refuse(DECODE "--folder dark", FAILED, "100.0 % too little contrast");
    capture_refuse(DECODE "--folder dark", FAILED, "for contrast expose longer");
    assert_true(photo_create(&photo, 59, 48, message));
    assert_true(photo_write("mixed/07-x-inverse-2.pfm", &photo, PHOTO_PFM, message));
    photo_free(&photo);
    capture_refuse(DECODE "--folder mixed", FAILED,
                   "07-x-inverse-2.pfm is 59 x 48 px; allowed: 60 x 48");
    assert_int_equal(rename("mixed/01-black.pfm", "kept"), 0);
    file = fopen("mixed/01-black.png", "w");
    fputs("GIF89a and what follows", file);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED, "01-black.png cannot be read (no PNG or JPEG)");
    assert_int_equal(remove("mixed/01-black.png"), 0);
    assert_int_equal(rename("kept", "mixed/01-black.pfm"), 0);
    file = fopen("mixed/07-x-inverse-2.pfm", "w");
    fputs("no picture", file);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED, "07-x-inverse-2.pfm");
    file = fopen("mixed/patterns.txt", "w");
    fputs("version = 1\nwidth_px = 64\nheight_px = 48\nsteps = 4\n", file);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED, "patterns.txt: period_px is missing");
    file = fopen("mixed/patterns.txt", "w");
    fputs("version = 1\nsteps = 4\nsteps = 4\n", file);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED, "patterns.txt:3: steps is there twice");
    file = fopen("mixed/patterns.txt", "w");
    fprintf(file, "version = 1\n# %300d\n", 0);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED, "patterns.txt:2: the line is too long");
    file = fopen("mixed/patterns.txt", "w");
    fputs("version = 1\nwidth_px = 0\n", file);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED, "patterns.txt:2: width_px: '0' is not allowed");
    file = fopen("mixed/patterns.txt", "w");
    fputs("version = 1\ncolour = red\n", file);
    fclose(file);
    capture_refuse(DECODE "--folder mixed", FAILED,
                   "patterns.txt:2: 'colour = red' is not allowed");
}

static void test_photographs_of_another_picture_are_said(void **state)
{
    struct series series = {.size_px = {64, 48}, .period_px = 8, .steps = 4};
    struct {
        struct flaw flaw;
        const char *reason;
    } wrong[] = {
        {{.taken = {SERIES_SINE, 0, 0}, .instead = {SERIES_SINE, 0, 1}},
         "the sines of x do not follow each other: what is left over is "},
        {{.taken = {SERIES_SINE, 1, 2}, .instead = {SERIES_SINE, 1, 3}}, "the sines of y do not"},
        {{.taken = {SERIES_SINE, 0, 0}, .instead = {SERIES_SINE, 0, 2}},
         "the sines of x do not lie as their stripes do: their phase is off by 180 degrees"},
        {{.taken = {SERIES_SINE, 1, 2}, .instead = {SERIES_SINE, 1, 0}},
         "the sines of y do not lie as their stripes do"},
        {{.taken = {SERIES_SINE, 1, 1}, .instead = {SERIES_SINE, 1, 3}},
         "stripes and sines of y disagree at "},
        {{.taken = {SERIES_SINE, 1, 1}, .black = true}, "the sines of y do not"},
        {{.taken = {SERIES_CODE, 0, 1}, .black = true},
         "04-x-code-1.pfm and odd/05-x-inverse-1.pfm do not show stripes and their inverse"},
        {{.taken = {SERIES_CODE, 0, 1}, .instead = {SERIES_CODE, 1, 1}}, "and their inverse"},
        {{.taken = {SERIES_CODE, 1, 0}, .instead = {SERIES_INVERSE, 1, 0}},
         "stripes and sines of y disagree at "},
        {{.taken = {SERIES_CODE, 0, 3}, .instead = {SERIES_INVERSE, 0, 3}},
         "stripes and sines of x disagree at "},
    };

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        wrong[i].flaw.lit = 0.7;
        wrong[i].flaw.ambient = 0.05;
        for (size_t k = 0; k < 2; k++) {
            wrong[i].flaw.hole = holes[k];
            capture_write_photos("odd", &series, 60, 48, photo_light, &wrong[i].flaw);
            capture_refuse(DECODE "--folder odd", FAILED, wrong[i].reason);
        }
    }
}

/* Neither are the others refused for it, nor has it a place itself. */
static void test_a_pixel_that_is_no_number_is_left_out(void **state)
{
    struct series series = {.size_px = {64, 48}, .period_px = 8, .steps = 4};
    struct flaw flaw = {.lit = 0.7};
    struct folder_photos photos;
    struct code_settings settings = {.series = &series, .least_contrast = 0.02};
    struct code_map map;
    char message[MESSAGE_SIZE];

    (void)state;
    for (size_t k = 0; k < sizeof holes / sizeof *holes; k++) {
        flaw.hole = holes[k];
        capture_write_photos("hole", &series, 60, 48, photo_light, &flaw);
        assert_true(folder_list("hole", &photos, message));
        settings.paths = photos.paths;
        if (!code_map_read(&settings, &map, message))
            fail_msg("%s", message);
        assert_int_equal(map.counts[CODE_NO_NUMBER], holes[k] != 0);
        assert_int_equal(map.counts[CODE_DECODED], 60 * 48 - (holes[k] != 0));
        assert_int_equal(map.state[24 * 60 + 30], holes[k] != 0 ? CODE_NO_NUMBER : CODE_DECODED);
        check_at_most(map.noise, 1e-6);
        code_map_free(&map);
        folder_photos_free(&photos);
    }
}

static void test_noise_and_lost_places_are_worth_a_warning(void **state)
{
    struct code_check check = {.noise = {0.01, 0.08}};
    char text[300];

    (void)state;
    code_check_warning(&check, 1000, 0, text, sizeof text);
    assert_non_null(strstr(text, "the noise is 8 % of the contrast"));
    check.noise[1] = 0.03;
    code_check_warning(&check, 1000, 300, text, sizeof text);
    assert_non_null(strstr(text, "30 % of what is lit has no sure place"));
    code_check_warning(&check, 1000, 200, text, sizeof text);
    assert_string_equal(text, "");
}

/* By name, so that nothing of them need be read. */
static void test_names_in_another_order_are_refused(void **state)
{
    struct series series = {.size_px = {64, 48}, .period_px = 8, .steps = 4};
    int count = series_count(&series);
    char line[2000] = DECODE "--patterns right", name[SERIES_NAME_MAX + 1];

    (void)state;
    for (int i = 0; i < count; i++) {
        size_t length = strlen(line);
        series_name(&series, count - 1 - i, name);
        snprintf(line + length, sizeof line - length, " right/%s.pfm", name);
    }
    capture_refuse(
        line, FAILED,
        "photograph 1 is right/25-y-sine-3.pfm; allowed: the order of the patterns, where "
        "00-white has this place");
}

static void test_saturated_photographs_are_said(void **state)
{
    char message[MESSAGE_SIZE], name[SERIES_NAME_MAX + 1], path[PATH_MAX];
    struct series series = {.size_px = {64, 48}, .period_px = 8, .steps = 4};

    (void)state;
    assert_true(folder_make("--folder", "bright", message));
    assert_true(folder_write_series("bright", &series, message));
    for (int i = 0; i < series_count(&series); i++) {
        struct photo photo;
        assert_true(photo_create(&photo, 60, 48, message));
        for (int k = 0; k < 60 * 48; k++)
            photo.light[k] = 1;
        series_name(&series, i, name);
        assert_true(folder_path("bright", name, ".png", path, message));
        assert_true(photo_write(path, &photo, PHOTO_PNG8, message));
        photo_free(&photo);
    }
    capture_refuse(DECODE "--folder bright", FAILED, "100.0 % saturated");
}

static void test_the_right_input_is_taken(void **state)
{
    char message[MESSAGE_SIZE];

    (void)state;
    /* The camera stands in the middle and sees what it lights, cut off at the right. */
    assert_int_equal(capture_run("decode --rig r.cfg --camera angular:180 --camera-circle 32,24,24 "
                                 "--output right.csv --folder right --marks 12",
                                 message),
                     0);
    assert_int_equal(access("right.csv", F_OK), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wrong_command_lines_are_refused),
        cmocka_unit_test(test_wrong_files_are_refused),
        cmocka_unit_test(test_no_file_is_written_over_another),
        cmocka_unit_test(test_dark_and_broken_photographs_are_said),
        cmocka_unit_test(test_photographs_of_another_picture_are_said),
        cmocka_unit_test(test_a_pixel_that_is_no_number_is_left_out),
        cmocka_unit_test(test_noise_and_lost_places_are_worth_a_warning),
        cmocka_unit_test(test_names_in_another_order_are_refused),
        cmocka_unit_test(test_saturated_photographs_are_said),
        cmocka_unit_test(test_the_right_input_is_taken),
    };
    return cmocka_run_group_tests_name("calib capture_errors", tests, make_folders,
                                       capture_leave_directory);
}
