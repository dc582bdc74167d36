/* Lenses measured as tables: what the curve does between the samples, and what is refused. */
#include "cupola/lens.h"
#include "message.h"
#include "rig_random.h"

static void the_curve_passes_through_every_sample(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int i = 0; i < 100; i++) {
        double h = radians(random_between(&seed, 20.0, 180.0));
        struct cupola_lens lens = random_lens(&seed, CUPOLA_LENS_TABLE, 2.0 * h);
        int last = lens.table_count - 1;
        for (int j = 0; j <= last; j++) {
            double angle = lens.table[j].angle_rad;
            double radius = lens.table[j].radius / lens.table[last].radius;
            check_near(cupola_lens_radius(&lens, angle), radius, 1e-15);
            check_near(cupola_lens_angle(&lens, radius), angle, 1e-12);
        }
    }
}

/* Steps of 1 beside steps of 1000: where a plain cubic would swing back. */
static void the_curve_stays_between_its_samples_and_increases(void **state)
{
    (void)state;
    uint64_t seed = 7;
    for (int i = 0; i < 100; i++) {
        struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE, .table_count = 12};
        double angle = 0.0, radius = 0.0;
        for (int j = 0; j < 12; j++) {
            angle += random_between(&seed, 0.01, 0.2);
            radius += pow(10.0, random_between(&seed, 0.0, 3.0));
            lens.table[j].angle_rad = angle;
            lens.table[j].radius = radius;
        }
        assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_OK);
        double before = 0.0;
        for (int j = 1; j <= 4000; j++) {
            double now = cupola_lens_radius(&lens, angle * j / 4000.0);
            check_at_least(now - before, 0.0);
            before = now;
        }
        for (int j = 0; j < 1000; j++) {
            double r = random_between(&seed, 0.0, 1.0);
            check_near(cupola_lens_radius(&lens, cupola_lens_angle(&lens, r)), r, 1e-12);
        }
    }
}

/* A cubic that is made of a line's values and slopes is the line. */
static void samples_on_a_line_are_an_angular_lens(void **state)
{
    (void)state;
    struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE, .table_count = 9};
    for (int i = 0; i < 9; i++) {
        lens.table[i].angle_rad = radians(10.0 * (i + 1));
        lens.table[i].radius = 55.0 * (i + 1);
    }
    struct cupola_lens angular = {.model = CUPOLA_LENS_ANGULAR};
    for (int i = 0; i <= 1000; i++) {
        double r = i / 1000.0;
        check_near(cupola_lens_angle(&lens, r), cupola_lens_angle(&angular, r), 1e-14);
        check_near(cupola_lens_radius(&lens, r), cupola_lens_radius(&angular, r), 1e-14);
    }
}

static void the_unit_of_the_radii_does_not_matter(void **state)
{
    (void)state;
    uint64_t seed = 8;
    struct cupola_lens lens = random_lens(&seed, CUPOLA_LENS_TABLE, radians(180.0));
    struct cupola_lens other = lens;
    for (int i = 0; i < other.table_count; i++)
        other.table[i].radius *= 25.4;
    for (int i = 0; i <= 100; i++)
        check_near(cupola_lens_angle(&other, i / 100.0), cupola_lens_angle(&lens, i / 100.0),
                   1e-13);
}

static void a_narrower_field_of_view_scales_the_curve_to_its_rim(void **state)
{
    (void)state;
    uint64_t seed = 9;
    struct cupola_lens whole = random_lens(&seed, CUPOLA_LENS_TABLE, radians(180.0));
    struct cupola_lens part = whole;
    part.fov_rad = radians(101.0);
    double rim = cupola_lens_radius(&whole, radians(50.5));
    for (int i = 0; i <= 100; i++) {
        double angle = radians(50.5) * (i / 100.0);
        check_near(cupola_lens_radius(&part, angle), cupola_lens_radius(&whole, angle) / rim,
                   1e-14);
        check_near(cupola_lens_angle(&part, i / 100.0),
                   cupola_lens_angle(&whole, rim * (i / 100.0)), 1e-12);
    }
    check_near(cupola_lens_radius(&part, radians(90.0)), 1.0, 1e-15);
}

static void a_first_sample_at_the_axis_changes_nothing(void **state)
{
    (void)state;
    struct cupola_lens with = {.model = CUPOLA_LENS_TABLE,
                               .table_count = 3,
                               .table = {{0.0, 0.0}, {0.5, 2.0}, {1.5, 5.0}}};
    struct cupola_lens without = {
        .model = CUPOLA_LENS_TABLE, .table_count = 2, .table = {{0.5, 2.0}, {1.5, 5.0}}};
    for (int i = 0; i <= 100; i++)
        check_near(cupola_lens_angle(&with, i / 100.0), cupola_lens_angle(&without, i / 100.0),
                   0.0);
}

static void a_full_table_whose_first_sample_is_off_the_axis_fits(void **state)
{
    (void)state;
    struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE, .table_count = CUPOLA_LENS_TABLE_MAX};
    for (int i = 0; i < CUPOLA_LENS_TABLE_MAX; i++) {
        lens.table[i].angle_rad = 0.02 * (i + 1);
        lens.table[i].radius = sin(0.02 * (i + 1));
    }
    assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_OK);
    check_near(cupola_lens_angle(&lens, 1.0), 1.28, 1e-15);
    check_near(cupola_lens_radius(&lens, 0.62), sin(0.62) / sin(1.28), 1e-15);
}

/* Samples of a smooth curve 5 degrees apart: what is between them is within 1e-4 of it. */
static void samples_of_a_smooth_curve_give_the_curve(void **state)
{
    (void)state;
    struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE, .table_count = 16};
    for (int i = 0; i < 16; i++) {
        lens.table[i].angle_rad = radians(5.0 * (i + 1));
        lens.table[i].radius = sin(radians(5.0 * (i + 1)) / 2.0);
    }
    struct cupola_lens smooth = {.model = CUPOLA_LENS_EQUISOLID, .fov_rad = radians(160.0)};
    double most = 0.0;
    for (int i = 0; i <= 1000; i++) {
        double angle = radians(80.0) * (i / 1000.0);
        most =
            fmax(most, fabs(cupola_lens_radius(&lens, angle) - cupola_lens_radius(&smooth, angle)));
    }
    check_at_most(most, 1e-4);
    /* A chord between samples is off by more: a curve of straight lines would not pass. */
    check_at_least(sin(radians(38.75)) - (sin(radians(37.5)) + sin(radians(40.0))) / 2.0, 1e-4);
}

static void check_refused(const struct cupola_lens *lens, double value)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_lens_validate(lens, &error) != CUPOLA_ERROR_ARGUMENT)
        fail_msg("accepted a table with %g", value);
    assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, value);
    assert_true(isnan(cupola_lens_angle(lens, 0.5)));
    assert_true(isnan(cupola_lens_radius(lens, 0.5)));
}

static void a_number_of_samples_outside_of_2_to_64_is_refused(void **state)
{
    (void)state;
    static const int counts[] = {-3, 0, 1, 65, 1000};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE,
                                   .table_count = counts[i],
                                   .table = {{0.5, 0.5}, {1.0, 1.0}}};
        check_refused(&lens, counts[i]);
    }
}

static void samples_that_do_not_increase_are_refused(void **state)
{
    (void)state;
    static const struct {
        struct cupola_lens_sample table[3];
        double named;
    } cases[] = {
        {{{0.5, 1.0}, {0.375, 2.0}, {1.0, 3.0}}, 0.375},  /* angle falls */
        {{{0.5, 1.0}, {0.5, 2.0}, {1.0, 3.0}}, 0.5},      /* angle stands */
        {{{0.5, 1.0}, {0.75, 0.875}, {1.0, 3.0}}, 0.875}, /* radius falls */
        {{{0.5, 1.0}, {0.75, 2.125}, {1.0, 2.125}}, 2.125} /* radius stands */,
        {{{-0.25, 1.0}, {0.75, 2.0}, {1.0, 3.0}}, -0.25}, /* behind the axis */
        {{{0.5, -1.5}, {0.75, 2.0}, {1.0, 3.0}}, -1.5},   /* falls from the axis */
        {{{0.0, 1.5}, {0.75, 2.0}, {1.0, 3.0}}, 1.5},     /* the axis is not at the centre */
        {{{0.5, 1.0}, {0.75, 2.0}, {3.25, 3.0}}, 3.25},   /* beyond pi */
        {{{0.5, 1.0}, {0.75, (double)NAN}, {1.0, 3.0}}, (double)NAN},
        {{{0.5, 1.0}, {(double)NAN, 2.0}, {1.0, 3.0}}, (double)NAN},
        {{{0.5, 1.0}, {0.75, 2.0}, {1.0, (double)INFINITY}}, (double)INFINITY},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE, .table_count = 3};
        memcpy(lens.table, cases[i].table, sizeof cases[i].table);
        check_refused(&lens, cases[i].named);
    }
}

static void a_field_of_view_beyond_the_last_sample_is_refused(void **state)
{
    (void)state;
    struct cupola_lens lens = {.model = CUPOLA_LENS_TABLE,
                               .fov_rad = 2.25,
                               .table_count = 2,
                               .table = {{0.5, 0.5}, {1.0, 1.0}}};
    check_refused(&lens, 2.25);
    lens.fov_rad = 2.0;
    assert_int_equal(cupola_lens_validate(&lens, NULL), CUPOLA_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_curve_passes_through_every_sample),
        cmocka_unit_test(the_curve_stays_between_its_samples_and_increases),
        cmocka_unit_test(samples_on_a_line_are_an_angular_lens),
        cmocka_unit_test(the_unit_of_the_radii_does_not_matter),
        cmocka_unit_test(a_narrower_field_of_view_scales_the_curve_to_its_rim),
        cmocka_unit_test(a_first_sample_at_the_axis_changes_nothing),
        cmocka_unit_test(a_full_table_whose_first_sample_is_off_the_axis_fits),
        cmocka_unit_test(samples_of_a_smooth_curve_give_the_curve),
        cmocka_unit_test(a_number_of_samples_outside_of_2_to_64_is_refused),
        cmocka_unit_test(samples_that_do_not_increase_are_refused),
        cmocka_unit_test(a_field_of_view_beyond_the_last_sample_is_refused),
    };
    return cmocka_run_group_tests_name("lens_table", tests, NULL, NULL);
}
