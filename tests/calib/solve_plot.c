/* The picture of the residuals, and the places that its arrows lead to. */
#include <stdio.h>
#include <string.h>

#include "capture/photo.h"
#include "capture_fixture.h"
#include "check.h"
#include "option_values.h"
#include "solve/lit_place.h"
#include "solve/residual_plot.h"
#include "solve_theatre.h"

static const double degree = 3.14159265358979323846 / 180;

static double length(const double v[3])
{
    return hypot(hypot(v[0], v[1]), v[2]);
}

/* Between two directions, rad. */
static double angle(const double a[3], const double b[3])
{
    double sum = 0;

    for (int i = 0; i < 3; i++)
        sum += pow(a[i] / length(a) - b[i] / length(b), 2);
    return sqrt(sum);
}

/* A point so far from the centre that lies about as far off the lens's axis as its rim. */
static void random_point(const struct cupola_rig *rig, double share, double distance_m,
                         uint64_t *seed, struct mark *mark)
{
    double off = share * 0.5 * rig->outputs[0].lens.fov_rad;
    double way = random_between(seed, 0, 360 * degree);

    mark->place[0] = distance_m * sin(off) * cos(way);
    mark->place[1] = distance_m * sin(off) * sin(way);
    mark->place[2] = -distance_m * cos(off);
}

static void pixels_lead_back_to_their_places_also_beyond_the_rim(void **state)
{
    int beyond = 0;

    (void)state;
    for (uint64_t seed = 0; seed < 200; seed++) {
        struct theatre theatre;
        struct cupola_rig *rig = &theatre.truth;
        struct mark mark = {.name = "m"};
        uint64_t random = seed;
        cupola_dome *dome = NULL;
        double found_m[3];
        theatre_random(seed, &theatre);
        struct cupola_circle *circle = &rig->outputs[0].circle;
        /* Polynomials and level rims go on otherwise than the test's own formula. */
        rig->outputs[0].lens = (struct cupola_lens){
            .model = seed % 2 ? CUPOLA_LENS_ANGULAR : CUPOLA_LENS_STEREOGRAPHIC,
            .fov_rad = (150 + (double)(seed % 20)) * degree};
        double distance_m = rig->screen.radius_m * random_between(&random, 0.9, 1.1);
        random_point(rig, random_between(&random, 0.1, 1.1), distance_m, &random, &mark);
        theatre_pixel(rig, &mark, MARKS_POINTS, mark.pixel_px);
        beyond += hypot(mark.pixel_px[0] - circle->center_x_px,
                        mark.pixel_px[1] - circle->center_y_px) > circle->radius_px;
        assert_int_equal(cupola_dome_create(rig, &dome, NULL), CUPOLA_OK);
        assert_true(
            lit_place_find(dome, 0, mark.pixel_px, distance_m, (double[3]){0, 0, -1}, found_m));
        check_at_most(angle(found_m, mark.place), 1e-5);
        check_near(length(found_m), distance_m, 1e-9);
        /* The control: a pixel further is another place. */
        mark.pixel_px[0] += 1;
        assert_true(lit_place_find(dome, 0, mark.pixel_px, distance_m, mark.place, found_m));
        check_at_least(angle(found_m, mark.place), 2e-4);
        cupola_dome_destroy(&dome);
    }
    check_at_least(beyond, 20);
}

static void a_pixel_that_no_lens_has_leads_to_the_rim(void **state)
{
    struct theatre theatre;
    cupola_dome *dome = NULL;
    double found_m[3];

    (void)state;
    theatre_random(1, &theatre);
    assert_int_equal(cupola_dome_create(&theatre.truth, &dome, NULL), CUPOLA_OK);
    assert_false(lit_place_find(dome, 0, (double[2]){90000, 40}, theatre.truth.screen.radius_m,
                                (double[3]){0, 0, -1}, found_m));
    check_near(length(found_m), theatre.truth.screen.radius_m, 1e-9);
    cupola_dome_destroy(&dome);
}

/* Marks in a ring, the first two of them beyond the rim of the lens. */
static void make_ring(struct theatre *theatre)
{
    *theatre = (struct theatre){.truth = {.screen = {1.5, 100 * degree}},
                                .marks = {.kind = MARKS_DIRECTIONS, .count = THEATRE_MARKS}};
    struct cupola_output *output = &theatre->truth.outputs[0];
    uint64_t random = 3;

    theatre->marks.list = theatre->list;
    output->width_px = output->height_px = 1024;
    output->circle = (struct cupola_circle){512, 512, 480};
    output->lens = (struct cupola_lens){.model = CUPOLA_LENS_ANGULAR, .fov_rad = 180 * degree};
    output->position_m[1] = -0.05;
    assert_int_equal(cupola_rig_complete(&theatre->truth, &theatre->truth, NULL), CUPOLA_OK);
    for (int i = 0; i < THEATRE_MARKS; i++) {
        struct mark *mark = &theatre->list[i];
        double off = (i < 2 ? 95 : 50 + i) * degree, way = 15 * i * degree;
        *mark = (struct mark){.place = {sin(off) * cos(way), sin(off) * sin(way), -cos(off)},
                              .steered = true};
        snprintf(mark->name, sizeof mark->name, "m%d", i);
        theatre_pixel(&theatre->truth, mark, MARKS_DIRECTIONS, mark->pixel_px);
        for (int k = 0; k < 2; k++)
            mark->pixel_px[k] += 0.2 * theatre_gauss(&random);
    }
}

/* How many pixels at the left of the picture's middle, where no words are, an arrow covers. */
static int covered(const struct theatre *theatre)
{
    enum { MIDDLE = 500, REACH = 80, LEGEND = 110 };
    const struct solve_request request = {.start = &theatre->truth, .marks = &theatre->marks};
    struct solve_result result;
    struct photo photo;
    char message[MESSAGE_SIZE] = "";
    static const char name[] = "plot.png";
    int count = 0;
    FILE *stream = fopen(name, "wb");

    assert_non_null(stream);
    if (!solve(&request, &result, message) ||
        !residual_plot_write(stream, name, &request, &result, message) || fclose(stream) != 0 ||
        !photo_read(name, PHOTO_SRGB, &photo, message))
        fail_msg("%s", message);
    for (int y = -REACH; y <= REACH; y++) {
        for (int x = -REACH; x < 0; x++)
            count += photo.light[(LEGEND + MIDDLE + y) * photo.width + MIDDLE + x] < 0.5f;
    }
    photo_free(&photo);
    solve_result_free(&result);
    return count;
}

static void arrows_beyond_the_rim_are_as_long_as_their_residuals(void **state)
{
    struct theatre theatre;

    (void)state;
    make_ring(&theatre);
    assert_int_equal(covered(&theatre), 0);
    /* The control: a mark whose pixel is that of one opposite to it. */
    memcpy(theatre.list[5].pixel_px, theatre.list[17].pixel_px, sizeof theatre.list[5].pixel_px);
    check_at_least(covered(&theatre), 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_lead_back_to_their_places_also_beyond_the_rim),
        cmocka_unit_test(a_pixel_that_no_lens_has_leads_to_the_rim),
        cmocka_unit_test_setup_teardown(arrows_beyond_the_rim_are_as_long_as_their_residuals,
                                        capture_enter_directory, capture_leave_directory),
    };

    return cmocka_run_group_tests_name("calib solve_plot", tests, NULL, NULL);
}
