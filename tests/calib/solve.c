/*
 * Solving from marks over 200 random theatres: no estimator can do better than the bound of Cramer
 * and Rao, and this one does as well. CUPOLA_LONG=1: 2000.
 */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "option_values.h"
#include "solve_theatre.h"

static const double degree = 3.14159265358979323846 / 180;

/* What came out over all theatres, in standard deviations of the bound, by value. */
struct tally {
    int counts[THEATRE_VALUES];
    double sums[THEATRE_VALUES], squares[THEATRE_VALUES];
    double sd_ratio[THEATRE_VALUES]; /* of reported sd to the bound, summed */
    int theatres, good_rejected, wrong_missed, refused;
    double *medians, *worsts; /* of the directions, rad */
    double median, worst;     /* of these */
};

static int theatre_count(void)
{
    return getenv("CUPOLA_LONG") ? 2000 : 200;
}

static double reported_sd(const struct solve_result *result, int value)
{
    const double sds[] = {
        result->position_sd_m[0], result->position_sd_m[1], result->position_sd_m[2],
        result->aim_sd_rad[0],    result->aim_sd_rad[1],    result->aim_sd_rad[2],
        result->circle_sd_px[0],  result->circle_sd_px[1],  result->circle_sd_px[2],
        result->fov_sd_rad,       result->k_sd[1],          result->k_sd[2],
        result->radius_sd_m};

    return sds[value];
}

static void begin(struct tally *tally)
{
    *tally = (struct tally){0};
    tally->medians = calloc((size_t)theatre_count(), sizeof *tally->medians);
    tally->worsts = calloc((size_t)theatre_count(), sizeof *tally->worsts);
}

static void end(struct tally *tally)
{
    free(tally->medians);
    free(tally->worsts);
}

static void add(struct tally *tally, const struct theatre *theatre,
                const struct solve_result *result, const int *values, int count,
                const double *bound)
{
    for (int i = 0; i < count; i++) {
        int value = values[i];
        double error =
            (theatre_value(&result->rig, value) - theatre_value(&theatre->truth, value)) / bound[i];
        tally->counts[value]++;
        tally->sums[value] += error;
        tally->squares[value] += error * error;
        tally->sd_ratio[value] += reported_sd(result, value) / bound[i];
    }
    theatre_direction_error(theatre, &result->rig, &tally->medians[tally->theatres],
                            &tally->worsts[tally->theatres]);
    tally->theatres++;
}

/* How a run differs from the plain one. */
struct run {
    const char *name;
    int free;
    enum noise noise;
    bool points;
    int wrong;      /* 3: a swapped pair and a pixel far off */
    double shift;   /* of the solved values, in sd of the bound: a deliberate error */
    int only_marks; /* uses fewer of them: a deliberate error; 0: all */
    bool half;      /* of the theatres are enough */
};

static double apart_px(const struct mark *a, const struct mark *b)
{
    return hypot(a->pixel_px[0] - b->pixel_px[0], a->pixel_px[1] - b->pixel_px[1]);
}

/* Three wrong marks, each off by more than 1.5 degrees of the lens. The theatre keeps its bound. */
static void spoil(struct theatre *theatre, uint64_t seed, bool wrong[THEATRE_MARKS])
{
    double least_px = 30 * theatre->noise_px, pixel[2];
    struct mark *list = theatre->list;
    int a, b, c;

    do {
        a = (int)random_between(&seed, 0, THEATRE_MARKS);
        b = (int)random_between(&seed, 0, THEATRE_MARKS);
        c = (int)random_between(&seed, 0, THEATRE_MARKS);
    } while (c == a || c == b || apart_px(&list[a], &list[b]) < least_px);
    memcpy(pixel, list[a].pixel_px, sizeof pixel);
    memcpy(list[a].pixel_px, list[b].pixel_px, sizeof pixel);
    memcpy(list[b].pixel_px, pixel, sizeof pixel);
    double way = random_between(&seed, 0, 6.28), far = random_between(&seed, 1, 8) * least_px;
    list[c].pixel_px[0] += far * cos(way);
    list[c].pixel_px[1] += far * sin(way);
    wrong[a] = wrong[b] = wrong[c] = true;
}

static void solve_one(const struct run *run, uint64_t seed, struct tally *tally)
{
    struct theatre theatre;
    struct cupola_rig start;
    struct solve_result result;
    char message[MESSAGE_SIZE] = "";
    int values[THEATRE_VALUES], count;
    double bound[THEATRE_VALUES];
    bool wrong[THEATRE_MARKS] = {false};

    theatre_random(seed, &theatre);
    for (int i = 0; i < THEATRE_MARKS && run->points; i++) {
        for (int k = 0; k < 3; k++)
            theatre.list[i].place[k] *= theatre.truth.screen.radius_m;
    }
    theatre.marks.kind = run->points ? MARKS_POINTS : MARKS_DIRECTIONS;
    count = theatre_values(&theatre, run->free, values);
    theatre_bound(&theatre, values, count, run->noise, bound);
    theatre_add_noise(&theatre, run->noise, 1, seed + 1000000);
    if (run->wrong)
        spoil(&theatre, seed, wrong);
    if (run->only_marks)
        theatre.marks.count = run->only_marks;
    theatre_start(&theatre, run->free, seed, &start);
    const struct solve_request request = {&start, 0, &theatre.marks, run->free};
    if (!solve(&request, &result, message)) {
        /* Where nobody could tell where the projector stands. */
        if (!(bound[T_Z] > 0.05 * theatre.truth.screen.radius_m))
            fail_msg("%s, theatre %d: %s", run->name, (int)seed, message);
        tally->refused++;
        return;
    }
    for (int i = 0; i < count; i++)
        theatre_move(&result.rig, values[i], run->shift * bound[i]);
    for (int i = 0; i < theatre.marks.count; i++) {
        tally->good_rejected += result.marks[i].rejected && !wrong[i];
        tally->wrong_missed += !result.marks[i].rejected && wrong[i];
    }
    add(tally, &theatre, &result, values, count, bound);
    solve_result_free(&result);
}

static int compare(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;

    return (first > second) - (first < second);
}

/* The largest rms and mean of the normalised errors of any value. */
static void summarise(const struct run *run, struct tally *tally, double *rms, double *mean)
{
    static const char *const names[] = {"x",    "y",        "z",        "yaw",           "pitch",
                                        "roll", "circle x", "circle y", "circle-radius", "fov",
                                        "k3",   "k5",       "radius"};

    *rms = *mean = 0;
    print_message("%s: error / bound, rms (mean; reported sd / bound):", run->name);
    for (int i = 0; i <= T_RADIUS; i++) {
        double n = tally->counts[i];
        if (n == 0)
            continue;
        print_message(" %s %.3f (%+.2f; %.3f)", names[i], sqrt(tally->squares[i] / n),
                      tally->sums[i] / n, tally->sd_ratio[i] / n);
        *rms = fmax(*rms, sqrt(tally->squares[i] / n));
        if (n > 0.7 * tally->theatres) /* polynomials are few */
            *mean = fmax(*mean, fabs(tally->sums[i] / n));
    }
    qsort(tally->medians, (size_t)tally->theatres, sizeof(double), compare);
    qsort(tally->worsts, (size_t)tally->theatres, sizeof(double), compare);
    tally->median = tally->medians[tally->theatres / 2];
    tally->worst = tally->worsts[tally->theatres - 1];
    print_message("\n  directions: median %.4f, worst median %.4f, worst %.4f (9 of 10 below "
                  "%.4f) degrees; %d of %d good marks rejected, %d wrong ones missed\n",
                  tally->median / degree, tally->medians[tally->theatres - 1] / degree,
                  tally->worst / degree, tally->worsts[tally->theatres * 9 / 10] / degree,
                  tally->good_rejected, tally->theatres * (THEATRE_MARKS - run->wrong),
                  tally->wrong_missed);
}

static void run_all(const struct run *run, struct tally *tally, double *rms, double *mean)
{
    begin(tally);
    for (int i = 0; i < theatre_count() / (run->half ? 2 : 1); i++)
        solve_one(run, (uint64_t)i, tally);
    summarise(run, tally, rms, mean);
    end(tally);
}

static const double most_rms = 1.2, most_mean = 0.25;

static void check_run(const struct run *run, double allowed_rms)
{
    struct tally tally;
    double rms, mean;
    run_all(run, &tally, &rms, &mean);
    check_at_most(rms, allowed_rms);
    check_at_most(mean, most_mean);
    check_at_most(tally.median, 0.05 * degree);
    if (!(run->free & SOLVE_LENS)) /* then marks of 0.05 degrees do not tell the rim that well */
        check_at_most(tally.worst, 0.2 * degree);
    check_at_most(tally.good_rejected, 0.002 * tally.theatres * THEATRE_MARKS);
    check_at_most(tally.refused, 0.005 * theatre_count());
    assert_int_equal(tally.wrong_missed, 0);
}

enum { POSE = SOLVE_POSITION | SOLVE_AIM };

static void position_and_aim_are_as_good_as_the_bound(void **state)
{
    (void)state;
    check_run(&(struct run){"position, aim", POSE}, most_rms);
}

static void noise_of_directions_does_little_more_harm(void **state)
{
    (void)state;
    check_run(&(struct run){"noise of directions", POSE, NOISE_DIRECTIONS}, most_rms);
}

static void circle_and_lens_may_be_free_too(void **state)
{
    (void)state;
    check_run(&(struct run){"circle, lens", POSE | SOLVE_CIRCLE | SOLVE_LENS}, most_rms);
}

static void points_serve_as_well(void **state)
{
    (void)state;
    check_run(&(struct run){"points, radius", POSE | SOLVE_RADIUS, .points = true, .half = true},
              most_rms);
}

static void wrong_marks_are_all_found(void **state)
{
    (void)state;
    check_run(&(struct run){"3 wrong marks", POSE, .wrong = 3}, 1.5);
    check_run(&(struct run){"circle, lens, 3 wrong", POSE | SOLVE_CIRCLE | SOLVE_LENS, .wrong = 3},
              1.5);
}

static void small_deliberate_errors_are_noticed(void **state)
{
    struct tally tally;
    double rms, mean;

    (void)state;
    run_all(&(struct run){"shifted by half a sd", POSE, .shift = 0.5, .half = true}, &tally, &rms,
            &mean);
    check_at_least(mean, 1.4 * most_mean);
    run_all(&(struct run){"half of the marks", POSE, .only_marks = 14, .half = true}, &tally, &rms,
            &mean);
    check_at_least(rms, 1.05 * most_rms);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(position_and_aim_are_as_good_as_the_bound),
        cmocka_unit_test(noise_of_directions_does_little_more_harm),
        cmocka_unit_test(circle_and_lens_may_be_free_too),
        cmocka_unit_test(points_serve_as_well),
        cmocka_unit_test(wrong_marks_are_all_found),
        cmocka_unit_test(small_deliberate_errors_are_noticed),
    };

    return cmocka_run_group_tests_name("solve", tests, NULL, NULL);
}
