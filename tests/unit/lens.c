/* The curves of the lenses: closed forms, round trips, names and what is refused. */
#include "cupola/lens.h"
#include "message.h"
#include "rig_random.h"

static const double epsilon = 2.2204460492503131e-16;

/* Fields of view that the tests try; those that a model does not reach are skipped. */
static const double fovs_deg[] = {1.0, 40.0, 90.0, 140.0, 180.0, 220.0, 340.0, 360.0};
enum { FOV_COUNT = sizeof fovs_deg / sizeof fovs_deg[0] };

static double fov_limit_deg(int model)
{
    switch (model) {
    case CUPOLA_LENS_HEMISPHERIC:
        return 180.0;
    case CUPOLA_LENS_STEREOGRAPHIC:
        return 340.0;
    case CUPOLA_LENS_POLYNOMIAL:
        return 220.0; /* as far as random_lens promises to be increasing */
    default:
        return 360.0;
    }
}

/* Calls `fact` with lenses of all models and fields of view. */
static void for_every_lens(void (*fact)(uint64_t *seed, const struct cupola_lens *lens, double h))
{
    uint64_t seed = 2;
    for (int model = 0; model <= CUPOLA_LENS_TABLE; model++) {
        for (int i = 0; i < FOV_COUNT; i++) {
            if (fovs_deg[i] > fov_limit_deg(model))
                continue;
            double fov = radians(fovs_deg[i]);
            struct cupola_lens lens = random_lens(&seed, (enum cupola_lens_model)model, fov);
            struct cupola_error error = {CUPOLA_OK, ""};
            if (cupola_lens_validate(&lens, &error) != CUPOLA_OK)
                fail_msg("%s %g: %s", cupola_lens_model_name(model), fovs_deg[i], error.message);
            double last = lens.table_count ? lens.table[lens.table_count - 1].angle_rad : fov / 2.0;
            fact(&seed, &lens, last);
        }
    }
}

/*
 * How far an angle moves when a radius moves by 1, where that is singular at the rim: hemispheric
 * at 180 degrees and equisolid at 360.
 */
static double condition(const struct cupola_lens *lens, double angle, double h)
{
    if (lens->model == CUPOLA_LENS_HEMISPHERIC)
        return sin(h) / fabs(cos(angle));
    if (lens->model == CUPOLA_LENS_EQUISOLID)
        return 2.0 * sin(h / 2.0) / fabs(cos(angle / 2.0));
    return 1.0;
}

/*
 * 1e-12 rad. Where an angle moves a thousand times as fast as a radius (the last 0.06 degrees of
 * the two singular rims), the rounding of a radius between 1/2 and 1 and of the three operations
 * of the inverse are multiplied by that; at the rim itself the curve is a parabola on its side,
 * so a rounding of some epsilon is an angle of the root of it.
 */
static double round_trip_tolerance(double condition)
{
    if (condition < 1000.0)
        return 1e-12;
    return fmin(8.0 * epsilon * condition, 4.0 * sqrt(epsilon));
}

static double round_trip_error(const struct cupola_lens *there, const struct cupola_lens *back,
                               double angle)
{
    return fabs(cupola_lens_angle(back, cupola_lens_radius(there, angle)) - angle);
}

static void round_trip(uint64_t *seed, const struct cupola_lens *lens, double h)
{
    int ill_conditioned = 0;
    for (int i = 0; i < 2000; i++) {
        double angle = random_between(seed, 0.0, h);
        double tolerance = round_trip_tolerance(condition(lens, angle, h));
        check_at_most(round_trip_error(lens, lens, angle), tolerance);
        ill_conditioned += tolerance > 1e-12;

        double radius = random_between(seed, 0.0, 1.0);
        check_near(cupola_lens_radius(lens, cupola_lens_angle(lens, radius)), radius, 1e-12);
    }
    check_at_most(ill_conditioned, 10);
    for (int i = 1; i <= 15; i++) { /* and close to the rim and the axis */
        double near_rim = h * (1.0 - pow(10.0, -i)), near_axis = h * pow(10.0, -i);
        check_at_most(round_trip_error(lens, lens, near_rim),
                      round_trip_tolerance(condition(lens, near_rim, h)));
        check_at_most(round_trip_error(lens, lens, near_axis), 1e-12);
    }
}

static void the_inverse_returns_where_the_forward_form_began(void **state)
{
    (void)state;
    for_every_lens(round_trip);
}

static void a_lens_wrong_by_a_tenth_of_a_degree_fails_the_round_trip(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int model = 0; model < CUPOLA_LENS_TABLE; model++) {
        struct cupola_lens right =
            random_lens(&seed, (enum cupola_lens_model)model, radians(140.0));
        struct cupola_lens wrong = right;
        wrong.fov_rad += radians(0.1);
        check_at_least(round_trip_error(&right, &wrong, 1.0), 1e-6);
    }
}

/* r as a ratio of chords, heights or tangents, none in the form that the library computes. */
static double closed_radius(const struct cupola_lens *lens, double angle, double h)
{
    long double a = (long double)angle, b = (long double)h;
    switch (lens->model) {
    case CUPOLA_LENS_ANGULAR:
        return (double)(a / b);
    case CUPOLA_LENS_HEMISPHERIC:
        return (double)(sinl(a) / sinl(b));
    case CUPOLA_LENS_EQUISOLID:
        return (double)sqrtl((1.0L - cosl(a)) / (1.0L - cosl(b)));
    case CUPOLA_LENS_STEREOGRAPHIC:
        return (double)(sinl(a) / (1.0L + cosl(a)) * (1.0L + cosl(b)) / sinl(b));
    default: {
        long double sum[2] = {0.0L, 0.0L};
        for (int i = 0; i < 4; i++) {
            sum[0] += (long double)lens->k[i] * powl(a, (long double)(2 * i + 1));
            sum[1] += (long double)lens->k[i] * powl(b, (long double)(2 * i + 1));
        }
        return (double)(sum[0] / sum[1]);
    }
    }
}

static void closed_form(uint64_t *seed, const struct cupola_lens *lens, double h)
{
    if (lens->model == CUPOLA_LENS_TABLE)
        return;
    for (int i = 0; i < 200; i++) {
        double angle = random_between(seed, 1e-3, h);
        /* Some roundings of numbers up to 1. */
        check_near(cupola_lens_radius(lens, angle), closed_radius(lens, angle, h), 4e-15);
    }
}

static void every_curve_is_its_closed_form(void **state)
{
    (void)state;
    for_every_lens(closed_form);
}

static void ends(uint64_t *seed, const struct cupola_lens *lens, double h)
{
    (void)seed;
    check_near(cupola_lens_radius(lens, 0.0), 0.0, 0.0);
    check_near(cupola_lens_angle(lens, 0.0), 0.0, epsilon);
    check_near(cupola_lens_radius(lens, h), 1.0, epsilon);
    check_near(cupola_lens_angle(lens, 1.0), h, h * epsilon);
    check_near(cupola_lens_radius(lens, h + 1.0), 1.0, epsilon);
    check_near(cupola_lens_angle(lens, 1.5), h, h * epsilon);
}

static void the_rim_is_at_half_of_the_field_of_view(void **state)
{
    (void)state;
    for_every_lens(ends);
}

static void increasing(uint64_t *seed, const struct cupola_lens *lens, double h)
{
    (void)seed;
    for (int i = 1; i <= 5000; i++) {
        double low = (i - 1) / 5000.0, high = i / 5000.0;
        check_at_least(cupola_lens_radius(lens, high * h) - cupola_lens_radius(lens, low * h),
                       1e-9);
        check_at_least(cupola_lens_angle(lens, high) - cupola_lens_angle(lens, low), 1e-9 * h);
    }
}

static void every_curve_is_strictly_increasing(void **state)
{
    (void)state;
    for_every_lens(increasing);
}

/* Solid angle per area of the image circle of radius 1, from differences of the curve. */
static double solid_angle_per_area(const struct cupola_lens *lens, double radius)
{
    double step = 1e-4;
    double slope =
        (8.0 * (cupola_lens_angle(lens, radius + step) - cupola_lens_angle(lens, radius - step)) -
         (cupola_lens_angle(lens, radius + 2.0 * step) -
          cupola_lens_angle(lens, radius - 2.0 * step))) /
        (12.0 * step);
    return sin(cupola_lens_angle(lens, radius)) * slope / radius;
}

static double closed_solid_angle_per_area(enum cupola_lens_model model, double angle, double h)
{
    switch (model) {
    case CUPOLA_LENS_ANGULAR:
        return h * h * sin(angle) / angle;
    case CUPOLA_LENS_HEMISPHERIC:
        return pow(sin(h), 2.0) / cos(angle);
    case CUPOLA_LENS_EQUISOLID:
        return 4.0 * pow(sin(h / 2.0), 2.0);
    default:
        return 4.0 * pow(tan(h / 2.0), 2.0) * pow(cos(angle / 2.0), 4.0);
    }
}

static void the_solid_angle_of_an_area_is_the_closed_form(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int model = 0; model <= CUPOLA_LENS_STEREOGRAPHIC; model++) {
        for (int i = 0; i < 200; i++) {
            double h = radians(random_between(&seed, 20.0, 80.0));
            double radius = random_between(&seed, 0.05, 0.95);
            struct cupola_lens lens = random_lens(&seed, (enum cupola_lens_model)model, 2.0 * h);
            double expected = closed_solid_angle_per_area((enum cupola_lens_model)model,
                                                          cupola_lens_angle(&lens, radius), h);
            /* Differences of fourth order with steps of 1e-4: rounding of 1e-12. */
            check_near(solid_angle_per_area(&lens, radius) / expected, 1.0, 1e-8);
        }
    }
}

static void a_zero_lens_is_angular_of_180_degrees(void **state)
{
    (void)state;
    struct cupola_lens lens;
    memset(&lens, 0, sizeof lens);
    assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_OK);
    check_near(cupola_lens_angle(&lens, 0.5), pi / 4.0, 1e-15);
}

static void a_polynomial_of_its_first_term_is_angular(void **state)
{
    (void)state;
    struct cupola_lens lens = {.model = CUPOLA_LENS_POLYNOMIAL, .k = {0.37}};
    for (int i = 0; i <= 100; i++)
        check_near(cupola_lens_angle(&lens, i / 100.0), pi / 2.0 * (i / 100.0), 1e-15);
}

static void a_factor_common_to_all_terms_cancels(void **state)
{
    (void)state;
    uint64_t seed = 6;
    struct cupola_lens lens = random_lens(&seed, CUPOLA_LENS_POLYNOMIAL, radians(180.0));
    struct cupola_lens scaled = lens;
    for (int i = 0; i < 4; i++)
        scaled.k[i] *= 1234.5;
    for (int i = 0; i <= 100; i++)
        check_near(cupola_lens_angle(&scaled, i / 100.0), cupola_lens_angle(&lens, i / 100.0),
                   1e-14);
}

static void models_have_names_and_are_found_by_them(void **state)
{
    (void)state;
    static const char *names[] = {"angular",       "hemispheric", "equisolid",
                                  "stereographic", "polynomial",  "table"};
    for (int model = 0; model < 6; model++) {
        assert_string_equal(cupola_lens_model_name(model), names[model]);
        assert_int_equal(cupola_lens_model_find(names[model]), model);
    }
    assert_null(cupola_lens_model_name(6));
    assert_null(cupola_lens_model_name(-1));
    assert_int_equal(cupola_lens_model_find("fisheye"), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_lens_model_find("angula"), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_lens_model_find(""), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_lens_model_find(NULL), CUPOLA_ERROR_ARGUMENT);
}

static void a_field_of_view_outside_of_its_limits_is_refused(void **state)
{
    (void)state;
    static const struct {
        enum cupola_lens_model model;
        double fov_rad;
    } cases[] = {
        {CUPOLA_LENS_ANGULAR, -1.25},        {CUPOLA_LENS_ANGULAR, 6.75},
        {CUPOLA_LENS_ANGULAR, (double)NAN},  {CUPOLA_LENS_ANGULAR, (double)INFINITY},
        {CUPOLA_LENS_HEMISPHERIC, 3.1875},   {CUPOLA_LENS_HEMISPHERIC, -0.5},
        {CUPOLA_LENS_EQUISOLID, 7.25},       {CUPOLA_LENS_EQUISOLID, (double)NAN},
        {CUPOLA_LENS_STEREOGRAPHIC, 6.5},    {CUPOLA_LENS_STEREOGRAPHIC, 6.283185307179586},
        {CUPOLA_LENS_STEREOGRAPHIC, -6.125}, {CUPOLA_LENS_POLYNOMIAL, 6.75},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cupola_lens lens = {
            .model = cases[i].model, .fov_rad = cases[i].fov_rad, .k = {1.0}};
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(cupola_lens_validate(&lens, &error), CUPOLA_ERROR_ARGUMENT);
        assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
        check_message(&error, cases[i].fov_rad);
        assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_ERROR_ARGUMENT);
        assert_true(isnan(cupola_lens_radius(&lens, 0.1)));
        assert_true(isnan(cupola_lens_angle(&lens, 0.1)));
    }
}

static void a_model_that_does_not_exist_is_refused(void **state)
{
    (void)state;
    static const int models[] = {6, 17, -1};
    for (size_t i = 0; i < 3; i++) {
        struct cupola_lens lens = {.model = (enum cupola_lens_model)models[i]};
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(cupola_lens_validate(&lens, &error), CUPOLA_ERROR_ARGUMENT);
        check_message(&error, models[i]);
        assert_true(isnan(cupola_lens_angle(&lens, 0.5)));
    }
}

static void a_polynomial_that_does_not_increase_is_refused(void **state)
{
    (void)state;
    static const double k[][4] = {
        {0.0, 0.0, 0.0, 0.0},
        {1.0, -0.5, 0.0, 0.0},
        {1.0, 0.0, -0.1, 0.0},
        {1.0, -0.85, 0.3, 0.0},
        {1.0, -0.817, 0.3, 0.0},
        {0.0, -1.0, 0.0, 1.0},
        {1.0, 0.0, 0.0, -0.01},
        {1.0, -1.86, 1.55, -0.45},
        {-1.0, 0.5, 0.0, 0.0},
        {(double)NAN, 0.0, 0.0, 0.0},
        {1.0, (double)INFINITY, 0.0, 0.0},
    };
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        struct cupola_lens lens = {.model = CUPOLA_LENS_POLYNOMIAL};
        struct cupola_error error = {CUPOLA_OK, ""};
        memcpy(lens.k, k[i], sizeof lens.k);
        if (cupola_lens_validate(&lens, &error) != CUPOLA_ERROR_ARGUMENT)
            fail_msg("accepted: k = %g %g %g %g", k[i][0], k[i][1], k[i][2], k[i][3]);
        assert_non_null(strstr(error.message, "allowed"));
        assert_true(isnan(cupola_lens_radius(&lens, 0.5)));
    }
}

/* r' = 1 + 3 k3 a^2 with k3 = -0.12 is 0 at 1.667 rad = 95.5 degrees. */
static void a_polynomial_is_judged_only_up_to_its_rim(void **state)
{
    (void)state;
    struct cupola_lens lens = {.model = CUPOLA_LENS_POLYNOMIAL, .k = {1.0, -0.12}};
    lens.fov_rad = radians(190.0);
    assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_OK);
    lens.fov_rad = radians(192.0);
    assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_ERROR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_inverse_returns_where_the_forward_form_began),
        cmocka_unit_test(a_lens_wrong_by_a_tenth_of_a_degree_fails_the_round_trip),
        cmocka_unit_test(every_curve_is_its_closed_form),
        cmocka_unit_test(the_rim_is_at_half_of_the_field_of_view),
        cmocka_unit_test(every_curve_is_strictly_increasing),
        cmocka_unit_test(the_solid_angle_of_an_area_is_the_closed_form),
        cmocka_unit_test(a_zero_lens_is_angular_of_180_degrees),
        cmocka_unit_test(a_polynomial_of_its_first_term_is_angular),
        cmocka_unit_test(a_factor_common_to_all_terms_cancels),
        cmocka_unit_test(models_have_names_and_are_found_by_them),
        cmocka_unit_test(a_field_of_view_outside_of_its_limits_is_refused),
        cmocka_unit_test(a_model_that_does_not_exist_is_refused),
        cmocka_unit_test(a_polynomial_that_does_not_increase_is_refused),
        cmocka_unit_test(a_polynomial_is_judged_only_up_to_its_rim),
    };
    return cmocka_run_group_tests_name("lens", tests, NULL, NULL);
}
