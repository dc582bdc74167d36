/*
 * Solving from bad starts and from bad marks: what is found all the same, and that nothing is
 * thrown away that was good.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "option_values.h"
#include "solve_theatre.h"

static const double degree = 3.14159265358979323846 / 180;

enum { POSE = SOLVE_POSITION | SOLVE_AIM };

/* Solves for position and aim; errors in sd of the bound, the largest of the six values. */
static double solved_error(const struct theatre *theatre, const struct theatre *clean,
                           const struct cupola_rig *start, struct solve_result *result)
{
    char message[MESSAGE_SIZE] = "";
    int values[THEATRE_VALUES], count = theatre_values(clean, POSE, values);
    double bound[THEATRE_VALUES], worst = 0;
    const struct solve_request request = {start, 0, &theatre->marks};

    if (!solve(&request, result, message))
        fail_msg("%s", message);
    theatre_bound(clean, values, count, NOISE_PIXELS, bound);
    for (int i = 0; i < count; i++) {
        double error =
            theatre_value(&result->rig, values[i]) - theatre_value(&theatre->truth, values[i]);
        worst = fmax(worst,
                     fabs(values[i] >= T_YAW ? remainder(error, 360 * degree) : error) / bound[i]);
    }
    return worst;
}

static void copy_theatre(const struct theatre *from, struct theatre *to)
{
    *to = *from;
    to->marks.list = to->list;
}

static void a_start_may_be_wrong_by_30_degrees_and_half_a_turn(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct theatre theatre, clean;
        struct solve_result result;
        theatre_random(seed + 500, &clean);
        copy_theatre(&clean, &theatre);
        theatre_add_noise(&theatre, NOISE_PIXELS, 1, seed);
        struct cupola_rig start = theatre.truth;
        struct cupola_output *output = &start.outputs[0];
        memset(output->position_m, 0, sizeof output->position_m);
        output->aim.yaw_rad += (seed % 2 ? 30 : -30) * degree;
        output->aim.pitch_rad += (seed % 4 < 2 ? 30 : -30) * degree;
        output->aim.roll_rad += seed % 3 ? 180 * degree : 0;
        check_at_most(solved_error(&theatre, &clean, &start, &result), 6);
        assert_int_equal(result.rejected, 0);
        solve_result_free(&result);
    }
}

/* A rotation that turns the whole theatre, screen, marks and all, so that the lens looks up. */
static void turn_up(double p[3], bool up)
{
    double y = p[1];

    p[1] = up ? -p[2] : p[2];
    p[2] = up ? y : -y;
}

/* What is noted of yaw and roll near a pitch of +-90 degrees; false: nothing is. */
static bool read_turn(const struct solve_result *result, const char *how, double *turn, double *sd)
{
    for (int i = 0; i < result->warning_count; i++) {
        const char *at = strstr(result->warnings[i], "what counts is yaw ");
        char word[5];
        if (at &&
            sscanf(at, "what counts is yaw %4s roll, %lf degrees (sd %lf)", word, turn, sd) == 3)
            return strcmp(word, how) == 0;
    }
    return false;
}

static void a_lens_may_look_straight_up_or_down(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 10; seed++) {
        struct theatre theatre;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        double median, worst, turn_deg = 0, sd_deg = 0;
        bool up = seed % 2;
        theatre_random(seed + 900, &theatre);
        theatre.truth.outputs[0].aim = (struct cupola_aim){0, 0, 0.3};
        theatre.truth.screen.cap_rad = 180 * degree;
        for (int i = 0; i < THEATRE_MARKS; i++)
            theatre_pixel(&theatre.truth, &theatre.list[i], MARKS_DIRECTIONS,
                          theatre.list[i].pixel_px);
        theatre_add_noise(&theatre, NOISE_PIXELS, 1, seed);
        const struct solve_request level = {&theatre.truth, 0, &theatre.marks};
        assert_true(solve(&level, &result, message));
        assert_false(read_turn(&result, "", &turn_deg, &sd_deg)); /* the control */
        assert_true(sd_deg == 0);
        double roll_sd_rad = result.aim_sd_rad[2];
        solve_result_free(&result);

        for (int i = 0; i < THEATRE_MARKS; i++)
            turn_up(theatre.list[i].place, up);
        turn_up(theatre.truth.outputs[0].position_m, up);
        theatre.truth.outputs[0].aim = (struct cupola_aim){0, (up ? 90 : -90) * degree, 0.3};
        struct cupola_rig start = theatre.truth;
        start.outputs[0].aim = (struct cupola_aim){0.5, up ? 1.2 : -1.2, -0.4};
        const struct solve_request request = {&start, 0, &theatre.marks};
        if (!solve(&request, &result, message))
            fail_msg("%s", message);
        theatre_direction_error(&theatre, &result.rig, &median, &worst);
        check_at_most(worst, 0.4 * degree);
        assert_int_equal(result.rejected, 0);
        /* The turn is the roll of before, and as well known. */
        assert_true(read_turn(&result, up ? "less" : "plus", &turn_deg, &sd_deg));
        check_near(turn_deg * degree, up ? -0.3 : 0.3, 5 * sd_deg * degree);
        check_near(sd_deg * degree / roll_sd_rad, 1, 0.1);
        solve_result_free(&result);
    }
}

static void marks_without_errors_give_the_truth(void **state)
{
    (void)state;
    for (uint64_t seed = 0; seed < 30; seed++) {
        struct theatre theatre;
        struct cupola_rig start;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        int free = POSE | SOLVE_CIRCLE | SOLVE_LENS;
        double median, worst;
        theatre_random(seed + 100, &theatre);
        theatre_start(&theatre, free, seed, &start);
        const struct solve_request request = {&start, 0, &theatre.marks, free};
        if (!solve(&request, &result, message))
            fail_msg("%s", message);
        theatre_direction_error(&theatre, &result.rig, &median, &worst);
        check_at_most(worst, 1e-5 * degree);
        assert_int_equal(result.rejected, 0);
        solve_result_free(&result);
    }
}

/* Random places of the image in place of the pixels: five of 24. */
static void a_fifth_of_the_marks_may_be_wrong(void **state)
{
    int missed = 0, lost = 0;

    (void)state;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct theatre theatre, clean;
        struct cupola_rig start;
        struct solve_result result;
        uint64_t random = seed + 4000;
        theatre_random(seed + 200, &clean);
        copy_theatre(&clean, &theatre);
        theatre_add_noise(&theatre, NOISE_PIXELS, 1, seed);
        for (int i = 0; i < 5; i++) {
            theatre.list[4 * i].pixel_px[0] += (i % 2 ? -1 : 1) * random_between(&random, 40, 400);
            theatre.list[4 * i].pixel_px[1] += random_between(&random, -400, 400);
        }
        theatre_start(&theatre, POSE, seed, &start);
        check_at_most(solved_error(&theatre, &clean, &start, &result), 8);
        for (int i = 0; i < THEATRE_MARKS; i++) {
            bool wrong = i % 4 == 0 && i < 20;
            missed += wrong && !result.marks[i].rejected;
            lost += !wrong && result.marks[i].rejected;
        }
        solve_result_free(&result);
    }
    assert_int_equal(missed, 0);
    check_at_most(lost, 3);
}

/* However few there are: 4 to 9 marks for six values. */
static void few_good_marks_are_not_rejected(void **state)
{
    int solved = 0, lost = 0;

    (void)state;
    for (uint64_t seed = 0; seed < 120; seed++) {
        struct theatre theatre;
        struct cupola_rig start;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        theatre_random(seed + 300, &theatre);
        theatre_add_noise(&theatre, NOISE_PIXELS, 1, seed);
        theatre.marks.list += 7;
        theatre.marks.count = 4 + (int)(seed % 6);
        theatre_start(&theatre, POSE, seed, &start);
        const struct solve_request request = {&start, 0, &theatre.marks};
        if (!solve(&request, &result, message))
            continue; /* so few may lie close together */
        solved++;
        lost += result.rejected;
        solve_result_free(&result);
    }
    check_at_least(solved, 90);
    check_at_most(lost, 1);
}

/* One of eight that is far off, which six values could still follow a long way. */
static void one_wrong_of_eight_is_found(void **state)
{
    int found = 0, lost = 0;

    (void)state;
    for (uint64_t seed = 0; seed < 60; seed++) {
        struct theatre theatre;
        struct cupola_rig start;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        theatre_random(seed + 700, &theatre);
        theatre_add_noise(&theatre, NOISE_PIXELS, 1, seed);
        for (int i = 0; i < 8; i++)
            theatre.list[i] = theatre.list[3 * i];
        theatre.marks.count = 8;
        theatre.list[5].pixel_px[0] += 150;
        theatre_start(&theatre, POSE, seed, &start);
        const struct solve_request request = {&start, 0, &theatre.marks};
        if (!solve(&request, &result, message))
            fail_msg("theatre %d: %s", (int)seed, message);
        found += result.marks[5].rejected;
        lost += result.rejected - result.marks[5].rejected;
        solve_result_free(&result);
    }
    print_message("one wrong of eight: found %d times of 60, %d good ones lost\n", found, lost);
    check_at_least(found, 57);
    check_at_most(lost, 3);
}

static void points_tell_the_radius_and_how_well(void **state)
{
    double squares = 0, sds = 0;
    enum { COUNT = 60 };

    (void)state;
    for (uint64_t seed = 0; seed < COUNT; seed++) {
        struct theatre theatre;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        uint64_t random = seed;
        theatre_random(seed + 50, &theatre);
        theatre.marks.kind = MARKS_POINTS;
        theatre_add_noise(&theatre, NOISE_PIXELS, 1, seed);
        for (int i = 0; i < THEATRE_MARKS; i++) {
            double length = theatre.truth.screen.radius_m * (1 + 1e-3 * theatre_gauss(&random));
            for (int k = 0; k < 3; k++)
                theatre.list[i].place[k] *= length;
        }
        struct cupola_rig start = theatre.truth;
        start.screen.radius_m *= 1.2;
        const struct solve_request request = {&start, 0, &theatre.marks, POSE | SOLVE_RADIUS};
        if (!solve(&request, &result, message))
            fail_msg("%s", message);
        squares += pow(result.rig.screen.radius_m / theatre.truth.screen.radius_m - 1, 2);
        sds += result.radius_sd_m / theatre.truth.screen.radius_m;
        solve_result_free(&result);
    }
    double least = 1e-3 / sqrt(THEATRE_MARKS);
    check_near(sqrt(squares / COUNT) / least, 1, 0.3);
    check_near(sds / COUNT / least, 1, 0.1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_start_may_be_wrong_by_30_degrees_and_half_a_turn),
        cmocka_unit_test(a_lens_may_look_straight_up_or_down),
        cmocka_unit_test(marks_without_errors_give_the_truth),
        cmocka_unit_test(a_fifth_of_the_marks_may_be_wrong),
        cmocka_unit_test(few_good_marks_are_not_rejected),
        cmocka_unit_test(one_wrong_of_eight_is_found),
        cmocka_unit_test(points_tell_the_radius_and_how_well),
    };

    return cmocka_run_group_tests_name("solve_robust", tests, NULL, NULL);
}
