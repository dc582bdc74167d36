/* Places of samples: evenly spread, however many there are, and round the middle. */
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "cupola/jitter.h"

enum { COUNT = 256, AXES = 4 };

static void places(double place[][AXES], int count)
{
    for (int i = 0; i < count; i++) {
        assert_int_equal(cupola_jitter_place(i, place[i], place[i] + 2), CUPOLA_OK);
        for (int k = 0; k < AXES; k++)
            assert_true(fabs(place[i][k]) < 0.5);
    }
}

static void the_mean_of_an_even_number_is_the_middle(void **state)
{
    (void)state;
    static double place[COUNT][AXES];
    double sum[AXES] = {0};
    places(place, COUNT);
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < AXES; k++) {
            sum[k] += place[i][k];
            if (i % 2)
                check_near(sum[k], 0, 1e-12);
        }
    check_at_least(fabs(place[2][3]), 0.1);
}

/* The most of any cell of a grid over two of the axes. */
static int fullest_cell(double place[][AXES], int first, int second, int cells)
{
    int counts[COUNT] = {0}, most = 0;
    for (int i = 0; i < COUNT; i++) {
        int x = (int)((place[i][first] + 0.5) * cells), y = (int)((place[i][second] + 0.5) * cells);
        int count = ++counts[y * cells + x];
        most = count > most ? count : most;
    }
    return most;
}

static void the_first_256_lie_evenly_over_every_two_axes(void **state)
{
    (void)state;
    static double place[COUNT][AXES], alike[COUNT][AXES];
    places(place, COUNT);
    for (int first = 0; first < AXES; first++)
        for (int second = first + 1; second < AXES; second++)
            check_at_most(fullest_cell(place, first, second, 8), 8); /* 4 each is even */
    memcpy(alike, place, sizeof alike);
    for (int i = 0; i < COUNT; i++)
        alike[i][1] = alike[i][0];
    check_at_least(fullest_cell(alike, 0, 1, 8), 20); /* the control */
}

static void the_first_256_lie_evenly_over_all_axes(void **state)
{
    (void)state;
    static double place[COUNT][AXES];
    int counts[16] = {0};
    places(place, COUNT);
    for (int i = 0; i < COUNT; i++) {
        int cell = 0;
        for (int k = 0; k < AXES; k++)
            cell += (place[i][k] > 0) << k;
        counts[cell]++;
    }
    for (int i = 0; i < 16; i++)
        check_near(counts[i], 16, 4);
}

static void what_is_no_frame_is_refused(void **state)
{
    double texels[2] = {7, 7}, pixels[2] = {7, 7};
    (void)state;
    assert_int_equal(cupola_jitter_place(-1, texels, pixels), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_jitter_place(0, NULL, pixels), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_jitter_place(0, texels, NULL), CUPOLA_ERROR_ARGUMENT);
    check_near(texels[0] + pixels[1], 14, 0);
    assert_int_equal(cupola_jitter_place(2147483647, texels, pixels), CUPOLA_OK);
    assert_true(fabs(texels[0]) < 0.5 && fabs(pixels[0]) < 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_mean_of_an_even_number_is_the_middle),
        cmocka_unit_test(the_first_256_lie_evenly_over_every_two_axes),
        cmocka_unit_test(the_first_256_lie_evenly_over_all_axes),
        cmocka_unit_test(what_is_no_frame_is_refused),
    };
    return cmocka_run_group_tests_name("jitter_place", tests, NULL, NULL);
}
