/* The filter that follows a moving viewer, against closed forms and a recursion of its own. */
#include <string.h>

#include "check.h"
#include "cupola/viewer.h"

static const double pi = 3.14159265358979323846;

static struct cupola_viewer started(struct cupola_viewer_params params)
{
    struct cupola_viewer viewer;
    struct cupola_error error = {0};

    if (params.radius_m == 0)
        params.radius_m = 1000; /* nothing is out of reach */
    if (cupola_viewer_start(&viewer, &params, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    return viewer;
}

static double eye_x(const struct cupola_viewer *viewer, double time_s)
{
    double eye_m[3];

    assert_int_equal(cupola_viewer_eye(viewer, time_s, eye_m), 1);
    return eye_m[0];
}

static void report_x(struct cupola_viewer *viewer, double time_s, double x_m)
{
    assert_int_equal(cupola_viewer_report(viewer, time_s, (double[3]){x_m, -2 * x_m, 0.5}), 1);
}

/* Reports at random intervals between 2 and 40 ms. */
static double next_time(uint64_t *seed, double time_s)
{
    return time_s + random_between(seed, 0.002, 0.04);
}

static void a_steady_walk_is_followed_without_lag(void **state)
{
    (void)state;
    struct cupola_viewer viewer = started((struct cupola_viewer_params){0});
    uint64_t seed = 1;
    double time_s = 5;

    for (int i = 0; i < 200; i++, time_s = next_time(&seed, time_s))
        report_x(&viewer, time_s, 0.3 + 1.5 * time_s);
    for (double ahead_s = 0; ahead_s < 0.1; ahead_s += 0.01)
        check_near(eye_x(&viewer, viewer.time_s + ahead_s), 0.3 + 1.5 * (viewer.time_s + ahead_s),
                   1e-9);
    check_near(viewer.velocity_m_s[1], -3, 1e-9);
    check_near(viewer.velocity_m_s[2], 0, 1e-12);
    assert_int_equal(viewer.reports, 200);
    assert_int_equal(viewer.refused, 0);
}

/*
 * The fading memory filter is the line that fits all reports best, in the sense of least squares,
 * where one that is k reports old counts theta^k (Brookner's definition): after a step from a long
 * rest, the sums over the past are geometric series. Position and velocity are those of the line at
 * the last report.
 */
static void step_by_least_squares(double theta, int after, double interval_s, double line[2])
{
    double s0 = 0, s1 = 0, s2 = 0, z0 = 0, z1 = 0;

    for (int k = 0; k < 4000; k++) {
        double weight = pow(theta, k), time_s = -k * interval_s, z = k <= after ? 1 : 0;
        s0 += weight;
        s1 += weight * time_s;
        s2 += weight * time_s * time_s;
        z0 += weight * z;
        z1 += weight * z * time_s;
    }
    line[0] = (z0 * s2 - z1 * s1) / (s0 * s2 - s1 * s1);
    line[1] = (z1 * s0 - z0 * s1) / (s0 * s2 - s1 * s1);
}

/* How far the filter is from that line after a step, with a memory that is wrong by a factor. */
static double step_error(double memory_s, double factor, double interval_s)
{
    struct cupola_viewer viewer = started((struct cupola_viewer_params){.memory_s = memory_s});
    double theta = exp(-interval_s / (factor * memory_s)), worst = 0, line[2];

    for (int i = -20; i < 0; i++)
        report_x(&viewer, i * interval_s, 0);
    for (int i = 0; i < 40; i++) {
        report_x(&viewer, i * interval_s, 1);
        step_by_least_squares(theta, i, interval_s, line);
        worst = fmax(worst, fabs(viewer.position_m[0] - line[0]));
        worst = fmax(worst, fabs(viewer.velocity_m_s[0] - line[1]) * interval_s);
    }
    return worst;
}

static void a_step_is_answered_as_by_least_squares_that_fade(void **state)
{
    (void)state;
    check_at_most(step_error(0.02, 1, 1.0 / 60), 1e-9);
    check_at_most(step_error(0.05, 1, 1.0 / 120), 1e-9);
    check_at_most(step_error(1e-3, 1, 0.1), 1e-9);
    /* and gains that are wrong by a few per cent are told */
    check_at_least(step_error(0.02, 1.03, 1.0 / 60), 1e-3);
    check_at_least(step_error(0.05, 0.97, 1.0 / 120), 1e-3);
}

/* What is predicted of an impulse in many small reports is what a few large ones say. */
static void irregular_reports_mean_the_same_as_regular_ones(void **state)
{
    (void)state;
    struct cupola_viewer fine = started((struct cupola_viewer_params){.memory_s = 0.2});
    struct cupola_viewer random = fine;
    uint64_t seed = 7;

    for (int i = 0; i <= 200000; i++)
        report_x(&fine, i * 1e-5, sin(2 * pi * 1e-5 * i));
    for (double time_s = 0; time_s < 2; time_s += random_between(&seed, 2e-5, 2e-4))
        report_x(&random, time_s, sin(2 * pi * time_s));
    report_x(&random, 2, 0);
    check_near(random.position_m[0], fine.position_m[0], 2e-3);
    check_near(random.velocity_m_s[0], fine.velocity_m_s[0], 0.01 * 2 * pi);
    /* the limit of short intervals: the error is the curvature times what is remembered */
    check_at_least(fabs(fine.velocity_m_s[0] - 2 * pi), 0.5);
}

static void what_makes_no_sense_is_refused_and_counted(void **state)
{
    (void)state;
    struct cupola_viewer viewer = started((struct cupola_viewer_params){.radius_m = 1}), before;
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e300, 101};
    double eye_m[3] = {7, 7, 7};

    assert_int_equal(cupola_viewer_eye(&viewer, 1, eye_m), 0);
    check_near(eye_m[0], 7, 0);
    report_x(&viewer, 10, 0.1);
    report_x(&viewer, 10.02, 0.2);
    before = viewer;
    assert_int_equal(cupola_viewer_report(&viewer, 10.02, (double[3]){0}), 0);
    assert_int_equal(cupola_viewer_report(&viewer, 9, (double[3]){0}), 0);
    for (int i = 0; i < 3; i++)
        assert_int_equal(cupola_viewer_report(&viewer, bad[i], (double[3]){0}), 0);
    for (int i = 0; i < 15; i++) {
        double position_m[3] = {0};
        position_m[i % 3] = bad[i / 3];
        assert_int_equal(cupola_viewer_report(&viewer, 11, position_m), 0);
    }
    assert_int_equal(viewer.refused, 20);
    viewer.refused = before.refused;
    assert_memory_equal(viewer.position_m, before.position_m, sizeof before.position_m);
    assert_memory_equal(viewer.velocity_m_s, before.velocity_m_s, sizeof before.velocity_m_s);
    assert_int_equal(viewer.reports, 2);
    assert_int_equal(cupola_viewer_report(&viewer, 10.04, (double[3]){99, 0, 0}), 1);
    assert_int_equal(cupola_viewer_eye(&viewer, (double)NAN, eye_m), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_viewer_eye(&viewer, (double)INFINITY, eye_m), CUPOLA_ERROR_ARGUMENT);
}

static void prediction_ends_at_the_horizon(void **state)
{
    (void)state;
    struct cupola_viewer viewer = started((struct cupola_viewer_params){.horizon_s = 0.05});

    for (int i = 0; i <= 100; i++)
        report_x(&viewer, 0.01 * i, 0.01 * i);
    check_near(eye_x(&viewer, 1.03), 1.03, 1e-9);
    check_near(eye_x(&viewer, 1.05), 1.05, 1e-9);
    check_near(eye_x(&viewer, 1.2), 1.05, 1e-9);
    check_near(eye_x(&viewer, 1e6), 1.05, 1e-9);
    check_near(eye_x(&viewer, 0.5), 1, 1e-9);
    viewer = started((struct cupola_viewer_params){.horizon_s = -1});
    for (int i = 0; i <= 100; i++)
        report_x(&viewer, 0.01 * i, 0.01 * i);
    check_near(eye_x(&viewer, 1.05), 1, 1e-9);
}

static void a_gap_begins_anew(void **state)
{
    (void)state;
    struct cupola_viewer viewer = started((struct cupola_viewer_params){0});

    for (int i = 0; i <= 100; i++)
        report_x(&viewer, 0.01 * i, 0.01 * i);
    report_x(&viewer, 2.1, 5);
    check_near(eye_x(&viewer, 2.15), 5, 0);
    report_x(&viewer, 2.2, 5.1);
    check_at_least(viewer.velocity_m_s[0], 0.9);
    report_x(&viewer, 1e300, 3);
    check_near(eye_x(&viewer, 1e300), 3, 0);
}

static double distance(const double a[3], const double b[3])
{
    double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

static void the_eye_is_always_inside_of_reach(void **state)
{
    (void)state;
    uint64_t seed = 11;
    int clamped = 0;

    for (int run = 0; run < 200; run++) {
        double radius = pow(10, random_between(&seed, -3, 3)), far = random_between(&seed, 0, 90);
        struct cupola_viewer_params params = {.radius_m = radius,
                                              .reach = random_between(&seed, 1e-3, 1 - 1e-6)};
        for (int i = 0; i < 3; i++)
            params.center_m[i] = random_between(&seed, -3, 3);
        struct cupola_viewer viewer = started(params);
        double time_s = 0, eye_m[3], position_m[3];
        for (int k = 0; k < 50; k++) {
            time_s += pow(10, random_between(&seed, -9, 0));
            for (int i = 0; i < 3; i++)
                position_m[i] = params.center_m[i] + random_between(&seed, -far, far) / 2 * radius;
            assert_int_equal(cupola_viewer_report(&viewer, time_s, position_m), 1);
            assert_int_equal(cupola_viewer_eye(&viewer, time_s + 0.05, eye_m), 1);
            double off = distance(eye_m, params.center_m);
            assert_true(off < params.reach * radius);
            clamped += off > 0.999 * params.reach * radius;
        }
    }
    check_at_least(clamped, 5000);
}

static void wrong_wishes_are_refused_by_name(void **state)
{
    (void)state;
    const double nan = (double)NAN;
    const struct {
        struct cupola_viewer_params params;
        const char *text;
    } cases[] = {
        {{0}, "radius is 0 m"},
        {{.radius_m = nan}, "radius is nan"},
        {{.radius_m = 2e6}, "radius is 2e+06"},
        {{.radius_m = 1, .memory_s = -1}, "memory is -1 s"},
        {{.radius_m = 1, .memory_s = nan}, "memory is nan s"},
        {{.radius_m = 1, .memory_s = 11}, "memory is 11 s"},
        {{.radius_m = 1, .horizon_s = 1.5}, "horizon is 1.5 s"},
        {{.radius_m = 1, .horizon_s = nan}, "horizon is nan s"},
        {{.radius_m = 1, .reach = 1}, "reach is 1;"},
        {{.radius_m = 1, .reach = -0.1}, "reach is -0.1;"},
        {{.radius_m = 1, .center_m = {0, nan, 0}}, "centre is (0, nan, 0)"},
    };
    struct cupola_viewer viewer = {.reports = 77};
    struct cupola_error error;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(cupola_viewer_start(&viewer, &cases[i].params, &error),
                         CUPOLA_ERROR_ARGUMENT);
        if (!strstr(error.message, cases[i].text) || !strstr(error.message, "allowed"))
            fail_msg("'%s' does not say '%s'", error.message, cases[i].text);
    }
    assert_int_equal(viewer.reports, 77);
    assert_int_equal(cupola_viewer_start(NULL, &cases[0].params, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_viewer_start(&viewer, NULL, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_viewer_report(&viewer, 1, (double[3]){0}), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_viewer_report(NULL, 1, (double[3]){0}), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_viewer_eye(&viewer, 1, (double[3]){0}), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_viewer_eye(NULL, 1, (double[3]){0}), CUPOLA_ERROR_ARGUMENT);
}

/* Gaussian enough: the sum of twelve (Irwin and Hall). */
static double noise(uint64_t *seed)
{
    double sum = -6;

    for (int i = 0; i < 12; i++)
        sum += random_between(seed, 0, 1);
    return sum;
}

/*
 * Root mean square of the error 30 ms after the last report, millimetres: of the eye that is
 * predicted (ahead 1) or of the report as it came (ahead 0). A head that goes to and fro by
 * `amplitude_m` once a second, reports with 2 mm of noise 60 times a second.
 */
static double error_mm(double amplitude_m, double memory_s, bool predicted)
{
    struct cupola_viewer viewer = started((struct cupola_viewer_params){.memory_s = memory_s});
    uint64_t seed = 3;
    double sum = 0;
    int count = 0;

    for (int i = 0; i < 24000; i++) {
        double time_s = i / 60.0, seen_s = time_s + 0.03;
        double reported = amplitude_m * sin(2 * pi * time_s) + 0.002 * noise(&seed);
        double truth = amplitude_m * sin(2 * pi * seen_s), error;
        report_x(&viewer, time_s, reported);
        error = (predicted ? eye_x(&viewer, seen_s) : reported) - truth;
        if (i < 60)
            continue;
        sum += error * error;
        count++;
    }
    return 1000 * sqrt(sum / count);
}

/* docs/guide.md states these figures. */
static void prediction_is_better_than_none(void **state)
{
    (void)state;
    print_message("0.1 m, 1 Hz, 30 ms ahead: %.2f mm predicted, %.2f mm as reported; at rest %.2f "
                  "and %.2f mm\n",
                  error_mm(0.1, 0, true), error_mm(0.1, 0, false), error_mm(0, 0, true),
                  error_mm(0, 0, false));
    check_near(error_mm(0.1, 0, true), 5.3, 0.2);
    check_near(error_mm(0.1, 0, false), 13.4, 0.2);
    check_near(error_mm(0, 0, true), 2.8, 0.1);
    check_near(error_mm(0, 0, false), 2, 0.05);
    /* the default is about the best memory for that, and a long one is no better than none */
    check_at_least(error_mm(0.1, 0.01, true), 0.95 * error_mm(0.1, 0, true));
    check_at_least(error_mm(0.1, 0.04, true), 1.5 * error_mm(0.1, 0, true));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_steady_walk_is_followed_without_lag),
        cmocka_unit_test(a_step_is_answered_as_by_least_squares_that_fade),
        cmocka_unit_test(irregular_reports_mean_the_same_as_regular_ones),
        cmocka_unit_test(what_makes_no_sense_is_refused_and_counted),
        cmocka_unit_test(prediction_ends_at_the_horizon),
        cmocka_unit_test(a_gap_begins_anew),
        cmocka_unit_test(the_eye_is_always_inside_of_reach),
        cmocka_unit_test(wrong_wishes_are_refused_by_name),
        cmocka_unit_test(prediction_is_better_than_none),
    };
    return cmocka_run_group_tests_name("viewer", tests, NULL, NULL);
}
