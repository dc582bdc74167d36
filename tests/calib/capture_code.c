/* Structured light: what pictures hold, and what photographs of them say, against closed form. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "capture/code_map.h"
#include "capture/folder.h"
#include "capture_fixture.h"
#include "check.h"
#include "option_values.h"

static const double PI = 3.14159265358979323846;

static const struct series small = {.size_px = {200, 72}, .period_px = 16, .steps = 4};

enum { SIGHT_WIDTH = 240, SIGHT_HEIGHT = 85 };

/* What a camera of as many pixels sees of the projector's image, with its noise. */
struct sight {
    const struct series *series;
    double scale, shift_px[2]; /* place = scale * pixel + shift */
    double ambient, lit, read, counted;
    double faded;       /* part of the stripes' contrast that is lost, out of focus */
    double fall;        /* of the light, from left to right, as a part of it */
    int first_step;     /* the sines begin with another one */
    bool swapped_steps; /* and are shown the other way round */
    uint64_t state;
};

static double place_of(const struct sight *sight, int axis, int pixel)
{
    return sight->scale * (pixel + 0.5) + sight->shift_px[axis];
}

static double normal(uint64_t *state)
{
    double sum = -6;

    for (int i = 0; i < 12; i++)
        sum += random_between(state, 0, 1);
    return sum;
}

/* By words of the documents, not by series_light: the code as numbers in a table, sines exact. */
static double sight_light(const struct series_picture *picture, int i, int j, void *data)
{
    struct sight *sight = data;
    double place = place_of(sight, picture->axis, picture->axis ? j : i), shown = 0;
    int bits = series_bits(sight->series, picture->axis);
    int stripe = (int)floor(place / (0.5 * sight->series->period_px));
    int step = sight->first_step + (sight->swapped_steps ? -picture->index : picture->index);

    if (picture->kind == SERIES_WHITE)
        shown = 1;
    /* The bit that has value 2^b of a Gray code is bright on stripes 2^b to 3 2^b - 1 of 4 2^b. */
    if (picture->kind == SERIES_CODE || picture->kind == SERIES_INVERSE) {
        int b = bits - 1 - picture->index, within = stripe % (4 << b);
        bool bright = within >= 1 << b && within < 3 << b;
        shown =
            bright == (picture->kind == SERIES_CODE) ? 1 - 0.5 * sight->faded : 0.5 * sight->faded;
    }
    if (picture->kind == SERIES_SINE)
        shown = 0.5 +
                0.5 * cos(2 * PI *
                          (place / sight->series->period_px - (double)step / sight->series->steps));
    shown = sight->ambient + sight->lit * shown;
    shown *= 1 - sight->fall * (i + 0.5) / SIGHT_WIDTH;
    if (sight->read > 0 || sight->counted > 0)
        shown += normal(&sight->state) *
                 sqrt(sight->read * sight->read + sight->counted * sight->counted * shown);
    return shown;
}

static bool try_map(const char *folder, const struct series *series, struct code_map *map,
                    char *message)
{
    struct folder_photos photos;
    struct code_settings settings = {.series = series, .least_contrast = 0.02};
    bool done;

    assert_true(folder_list(folder, &photos, message));
    assert_int_equal(photos.count, series_count(series));
    settings.paths = photos.paths;
    done = code_map_read(&settings, map, message);
    folder_photos_free(&photos);
    return done;
}

static void read_map(const char *folder, const struct series *series, struct code_map *map)
{
    char message[MESSAGE_SIZE];

    if (!try_map(folder, series, map, message))
        fail_msg("%s", message);
}

static double worst_error(const struct sight *sight, const struct code_map *map)
{
    double worst = 0;

    for (int j = 0; j < map->height; j++) {
        for (int i = 0; i < map->width; i++) {
            size_t at = (size_t)(j * map->width + i);
            worst = fmax(worst, fabs((double)map->place_px[0][at] - place_of(sight, 0, i)));
            worst = fmax(worst, fabs((double)map->place_px[1][at] - place_of(sight, 1, j)));
        }
    }
    return worst;
}

static void test_gray_codes_of_neighbours_differ_by_one_bit(void **state)
{
    (void)state;
    for (unsigned int n = 0; n < 4096; n++) {
        unsigned int gray = n ^ n >> 1, other = (n + 1) ^ (n + 1) >> 1, differing = gray ^ other;
        assert_int_equal(series_from_gray(gray), n);
        assert_int_equal(differing & (differing - 1), 0);
        assert_int_not_equal(differing, 0);
    }
}

static void test_numbers_and_pictures_of_a_series_are_one_to_one(void **state)
{
    char names[100][SERIES_NAME_MAX + 1];
    int count = series_count(&small);

    (void)state;
    assert_int_equal(count, 2 + 2 * (5 + 4) + 2 * 4); /* 25 and 9 stripes */
    for (int i = 0; i < count; i++) {
        assert_int_equal(series_find(&small, series_picture(&small, i)), i);
        series_name(&small, i, names[i]);
        if (i > 0)
            assert_true(strcmp(names[i - 1], names[i]) < 0);
    }
    assert_string_equal(names[2], "02-x-code-0");
    assert_string_equal(names[12], "12-x-sine-0");
    assert_string_equal(names[count - 1], "27-y-sine-3");
}

static void test_pictures_are_what_a_camera_of_one_pixel_each_is_said_to_see(void **state)
{
    struct sight sight = {.series = &small, .scale = 1, .lit = 1};

    (void)state;
    for (int number = 0; number < series_count(&small); number++) {
        struct series_picture picture = series_picture(&small, number);
        for (int j = 0; j < small.size_px[1]; j++) {
            for (int i = 0; i < small.size_px[0]; i++)
                check_near(series_light(&small, &picture, i, j),
                           sight_light(&picture, i, j, &sight), 1e-12);
        }
    }
}

/* A code one stripe off at a border is put right by the phase; two off is seen. */
static void test_the_phase_puts_codes_at_borders_right(void **state)
{
    double off;

    (void)state;
    for (double x = 8.05; x < 190; x += 0.1) {
        double phase = 2 * PI * x / small.period_px;
        int stripe = (int)floor(x / 8);
        double within = x / 8 - stripe;
        check_near(series_place(&small, (unsigned int)stripe, phase, &off), x, 1e-9);
        check_at_most(off, 0.5 + 1e-9);
        if (within < 0.25)
            check_near(series_place(&small, (unsigned int)stripe - 1, phase, &off), x, 1e-9);
        if (within > 0.75)
            check_near(series_place(&small, (unsigned int)stripe + 1, phase, &off), x, 1e-9);
        if (within > 0.35 && within < 0.65) {
            series_place(&small, (unsigned int)stripe + 1, phase, &off);
            check_at_least(off, 0.8);
        }
    }
}

static void test_every_pixel_comes_back_without_noise(void **state)
{
    char message[MESSAGE_SIZE];
    struct sight sight = {.series = &small, .scale = 0.45, .shift_px = {0.3, 0.2}, .lit = 0.7};
    struct code_map map;

    (void)state;
    sight.ambient = 0.05;
    capture_write_photos("photos", &small, 440, 158, sight_light, &sight);
    read_map("photos", &small, &map);
    assert_int_equal(map.counts[CODE_DECODED], map.width * map.height);
    check_at_most(worst_error(&sight, &map), 1e-3);
    code_map_free(&map);

    /* The control: sines that run the other way are seen. */
    sight.swapped_steps = true;
    capture_write_photos("photos", &small, 440, 158, sight_light, &sight);
    assert_false(try_map("photos", &small, &map, message));
    assert_non_null(strstr(message, "stripes and sines of x disagree"));
}

/* The orders in which they are still sines; they may then even be where the stripes are. */
static void test_sines_that_begin_elsewhere_or_run_the_other_way_are_seen(void **state)
{
    static const int steps[] = {4, 5, 8, 16};

    (void)state;
    for (size_t s = 0; s < sizeof steps / sizeof *steps; s++) {
        for (int order = 0; order < 2 * steps[s]; order++) {
            char message[MESSAGE_SIZE];
            struct series series = small;
            struct sight sight = {.series = &series, .scale = 1.8, .shift_px = {0.9, 0.2}};
            struct code_map map;
            series.steps = steps[s];
            sight.lit = 0.7;
            sight.ambient = 0.05;
            sight.read = 0.02;
            sight.first_step = order / 2;
            sight.swapped_steps = order % 2;
            capture_write_photos("photos", &series, 110, 39, sight_light, &sight);
            if (try_map("photos", &series, &map, message)) {
                if (order > 0)
                    fail_msg("sines begin with step %d of %d", order / 2, steps[s]);
                code_map_free(&map);
            } else {
                assert_non_null(strstr(message, "ines of x d"));
                assert_int_not_equal(order, 0);
            }
        }
        assert_int_equal(system("rm -r photos"), 0);
    }
}

static void test_stripes_out_of_focus_are_not_called_dark(void **state)
{
    struct cupola_rig rig = {.outputs = {{.width_px = 200, .height_px = 72}}};
    struct sight sight = {.series = &small, .scale = 1.8, .lit = 0.7, .faded = 0.9};
    char message[MESSAGE_SIZE];

    (void)state;
    capture_write_rig("rig.cfg", &rig);
    capture_write_photos("photos", &small, 110, 39, sight_light, &sight);
    assert_int_equal(capture_run("decode --rig rig.cfg --camera rectilinear:60 --folder photos "
                                 "--output marks.csv",
                                 message),
                     1);
    assert_non_null(strstr(message, "100.0 % code unsure"));
    assert_non_null(strstr(message, "order of the photographs and at their focus"));
    assert_null(strstr(message, "darken"));
}

/* The pictures as they are written, 8 bits of sRGB: photographed at less than full light. */
static void test_every_pixel_of_written_pictures_comes_back(void **state)
{
    struct cupola_rig rig = {.outputs = {{.width_px = 200, .height_px = 72}}};
    struct sight sight = {.series = &small, .scale = 1};
    struct series series;
    struct code_map map;
    char message[MESSAGE_SIZE], name[SERIES_NAME_MAX + 1], path[PATH_MAX];

    (void)state;
    capture_write_rig("rig.cfg", &rig);
    assert_int_equal(capture_run("patterns --rig rig.cfg --folder pictures", message), 0);
    assert_true(folder_read_series("pictures", &series, message));
    assert_memory_equal(&series, &small, sizeof series);
    assert_true(folder_make("--folder", "photos", message));
    for (int i = 0; i < series_count(&series); i++) {
        struct photo photo;
        series_name(&series, i, name);
        assert_true(folder_path("pictures", name, ".png", path, message));
        assert_true(photo_read(path, PHOTO_SRGB, &photo, message));
        for (int k = 0; k < photo.width * photo.height; k++)
            photo.light[k] *= 0.8f;
        assert_true(folder_path("photos", name, ".png", path, message));
        assert_true(photo_write(path, &photo, i % 2 ? PHOTO_PNG16 : PHOTO_PNG8, message));
        photo_free(&photo);
    }
    read_map("photos", &small, &map);
    assert_int_equal(map.counts[CODE_DECODED], map.width * map.height);
    check_at_most(worst_error(&sight, &map), 0.02);
    code_map_free(&map);
}

/* The squares of errors in predicted standard deviations, over all decoded pixels. */
static double mean_square(const struct sight *sight, const struct code_map *map)
{
    double sum = 0;

    for (int j = 0; j < map->height; j++) {
        for (int i = 0; i < map->width; i++) {
            size_t at = (size_t)(j * map->width + i);
            double x = (double)map->place_px[0][at] - place_of(sight, 0, i);
            double y = (double)map->place_px[1][at] - place_of(sight, 1, j);
            if (map->state[at] != CODE_DECODED)
                continue;
            x /= (double)map->sd_px[0][at];
            y /= (double)map->sd_px[1][at];
            sum += 0.5 * (x * x + y * y);
        }
    }
    return sum / map->counts[CODE_DECODED];
}

static double mean_sd(const struct code_map *map)
{
    double sum = 0;

    for (int i = 0; i < map->width * map->height; i++)
        sum += 0.5 * (double)(map->sd_px[0][i] + map->sd_px[1][i]);
    return sum / (map->width * map->height);
}

static void test_errors_are_as_large_as_predicted(void **state)
{
    const struct {
        double read, counted, lit;
        int steps;
    } cases[] = {{0.01, 0, 0.7, 4}, {0.005, 0.02, 0.6, 4}, {0.01, 0.01, 0.4, 7}};

    (void)state;
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct series series = small;
        struct sight sight = {.series = &series, .scale = 0.8, .shift_px = {3.1, 1.7}};
        struct code_map map;
        char folder[32];
        double light;
        series.steps = cases[c].steps;
        sight.ambient = 0.1;
        sight.lit = cases[c].lit;
        sight.read = cases[c].read;
        sight.counted = cases[c].counted;
        sight.state = c;
        snprintf(folder, sizeof folder, "photos-%d", (int)c);
        capture_write_photos(folder, &series, SIGHT_WIDTH, SIGHT_HEIGHT, sight_light, &sight);
        read_map(folder, &series, &map);
        light = 0.1 + 0.5 * cases[c].lit;
        assert_int_equal(map.counts[CODE_DECODED], map.width * map.height);
        check_near(mean_square(&sight, &map), 1, 0.06);
        /* Closed form: period / 2 pi, sqrt(2 / steps), noise over the sine's amplitude. */
        check_near(mean_sd(&map),
                   16 / (2 * PI) * sqrt(2.0 / series.steps) *
                       sqrt(pow(cases[c].read, 2) + pow(cases[c].counted, 2) * light) /
                       (0.5 * cases[c].lit),
                   0.03 * mean_sd(&map));
        check_at_least(worst_error(&sight, &map), 0.05); /* there was noise */
        code_map_free(&map);
    }
}

/* Brightness halves from left to right, so that what light adds to the noise can be told. */
static void test_noise_is_told_at_mid_grey_whatever_the_ambient_light(void **state)
{
    static const double ambients[] = {0, 0.5, 3};

    (void)state;
    for (size_t c = 0; c < sizeof ambients / sizeof *ambients; c++) {
        struct sight sight = {.series = &small, .scale = 0.8, .shift_px = {3.1, 1.7}};
        struct code_map map;
        double grey = 0.75 * (ambients[c] + 0.5 * 0.7);
        sight.ambient = ambients[c];
        sight.lit = 0.7;
        sight.fall = 0.5;
        sight.read = 0.002;
        sight.counted = 0.01;
        sight.state = c;
        capture_write_photos("grey", &small, SIGHT_WIDTH, SIGHT_HEIGHT, sight_light, &sight);
        read_map("grey", &small, &map);
        check_near(map.contrast, 0.75 * 0.7, 0.01);
        check_near(map.noise, sqrt(0.002 * 0.002 + 0.01 * 0.01 * grey), 0.03 * map.noise);
        code_map_free(&map);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gray_codes_of_neighbours_differ_by_one_bit),
        cmocka_unit_test(test_numbers_and_pictures_of_a_series_are_one_to_one),
        cmocka_unit_test(test_pictures_are_what_a_camera_of_one_pixel_each_is_said_to_see),
        cmocka_unit_test(test_the_phase_puts_codes_at_borders_right),
        cmocka_unit_test_setup_teardown(test_every_pixel_comes_back_without_noise,
                                        capture_enter_directory, capture_leave_directory),
        cmocka_unit_test_setup_teardown(
            test_sines_that_begin_elsewhere_or_run_the_other_way_are_seen, capture_enter_directory,
            capture_leave_directory),
        cmocka_unit_test_setup_teardown(test_stripes_out_of_focus_are_not_called_dark,
                                        capture_enter_directory, capture_leave_directory),
        cmocka_unit_test_setup_teardown(test_every_pixel_of_written_pictures_comes_back,
                                        capture_enter_directory, capture_leave_directory),
        cmocka_unit_test_setup_teardown(test_noise_is_told_at_mid_grey_whatever_the_ambient_light,
                                        capture_enter_directory, capture_leave_directory),
        cmocka_unit_test_setup_teardown(test_errors_are_as_large_as_predicted,
                                        capture_enter_directory, capture_leave_directory),
    };
    return cmocka_run_group_tests_name("calib capture_code", tests, NULL, NULL);
}
