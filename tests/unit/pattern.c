/* Patterns of rays in the unit disc: weights, moments, distances, and the turn of a pixel. */
#include "geometry/pattern.h"

#include "check.h"
#include "geometry/angle.h"

enum { KINDS = 3 };

struct moments {
    double weights, x, y, xx, xy, yy, farthest, least_weight;
};

static struct moments moments_of(const struct pattern *pattern)
{
    struct moments sum = {.least_weight = 1.0};
    for (int i = 0; i < pattern->count; i++) {
        struct pattern_place p = pattern->places[i];
        sum.weights += p.weight;
        sum.x += p.weight * p.x;
        sum.y += p.weight * p.y;
        sum.xx += p.weight * p.x * p.x;
        sum.xy += p.weight * p.x * p.y;
        sum.yy += p.weight * p.y * p.y;
        sum.farthest = fmax(sum.farthest, hypot(p.x, p.y));
        sum.least_weight = fmin(sum.least_weight, p.weight);
    }
    return sum;
}

static struct pattern made(int kind, int count)
{
    struct pattern pattern;
    pattern_make((enum cupola_pattern)kind, count, &pattern);
    assert_int_equal(pattern.count, count);
    return pattern;
}

/* How far a pattern is from being balanced and as wide as the disc, weighed by 1 - d^2. */
static double imbalance(const struct pattern *pattern)
{
    struct moments sum = moments_of(pattern);
    double uneven = fmax(fabs(sum.x), fabs(sum.y));
    if (pattern->count >= 3) {
        uneven = fmax(uneven, fmax(fabs(sum.xx - 1.0 / 6.0), fabs(sum.yy - 1.0 / 6.0)));
        uneven = fmax(uneven, fabs(sum.xy));
    }
    return uneven;
}

static void weights_sum_to_1_and_no_place_leaves_the_disc(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++)
        for (int count = 1; count <= CUPOLA_RAYS_MAX; count++) {
            struct pattern pattern = made(kind, count);
            struct moments sum = moments_of(&pattern);
            check_near(sum.weights, 1.0, 1e-14);
            check_at_least(sum.least_weight, 0.02 / count);
            check_at_most(sum.farthest, 1.0 + 1e-12);
        }
}

/*
 * The mean square of 1 - d^2 over the disc is 1/3: a sixth each way. Some
 * grids would leave the disc, and are a bit narrower.
 */
static void every_pattern_is_balanced_and_as_wide_as_the_cone(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++)
        for (int count = 1; count <= CUPOLA_RAYS_MAX; count++) {
            struct pattern pattern = made(kind, count);
            check_at_most(imbalance(&pattern), kind == CUPOLA_PATTERN_ROTATED_GRID ? 0.02 : 1e-12);
            struct moments sum = moments_of(&pattern);
            check_near(sum.x, 0.0, 1e-14);
            check_near(sum.y, 0.0, 1e-14);
            check_near(sum.xx - sum.yy, 0.0, count == 2 ? 1.0 : 1e-12);
            if (count == 2)
                check_near(sum.xx + sum.yy, 1.0 / 6.0, 1e-12);
        }
    struct pattern wrong = made(CUPOLA_PATTERN_REGULAR, 16); /* the control */
    wrong.places[3].x += 0.01;
    check_at_least(imbalance(&wrong), 1e-4);
}

/* Least distance of two places, as a part of the side of the square that each stands for. */
static double least_distance(const struct pattern *pattern)
{
    double least = 9.0;
    for (int i = 0; i < pattern->count; i++)
        for (int j = 0; j < i; j++)
            least = fmin(least, hypot(pattern->places[i].x - pattern->places[j].x,
                                      pattern->places[i].y - pattern->places[j].y));
    return least / sqrt(pi / pattern->count);
}

/* The weights draw places together by a fifth: of their squares' sides 0.5 are left at least. */
static void places_are_far_from_each_other(void **state)
{
    (void)state;
    uint64_t seed = 501;
    int near = 0;
    for (int count = 2; count <= CUPOLA_RAYS_MAX; count++) {
        for (int kind = 0; kind < KINDS; kind++) {
            struct pattern pattern = made(kind, count);
            check_at_least(least_distance(&pattern),
                           kind == CUPOLA_PATTERN_ROTATED_GRID ? 0.65 : 0.55);
        }
        struct pattern random = {.count = count}; /* the control: without care */
        for (int i = 0; i < count; i++) {
            double r = sqrt(random_between(&seed, 0.0, 1.0));
            double angle = random_between(&seed, 0.0, 2.0 * pi);
            random.places[i] = (struct pattern_place){r * cos(angle), r * sin(angle), 0.0};
        }
        near += least_distance(&random) < 0.55;
    }
    check_at_least(near, 60);
}

/* Least difference of two rows or two columns, as a part of what it is where all are even. */
static double least_gap(const struct pattern *pattern)
{
    double least = 9.0;
    for (int i = 0; i < pattern->count; i++)
        for (int j = 0; j < i; j++) {
            least = fmin(least, fabs(pattern->places[i].x - pattern->places[j].x));
            least = fmin(least, fabs(pattern->places[i].y - pattern->places[j].y));
        }
    return least * pattern->count / 2.0;
}

static void no_two_places_of_a_rotated_grid_share_a_row_or_a_column(void **state)
{
    (void)state;
    for (int count = 2; count <= CUPOLA_RAYS_MAX; count++) {
        struct pattern pattern = made(CUPOLA_PATTERN_ROTATED_GRID, count);
        check_at_least(least_gap(&pattern), 0.1);
    }
    struct pattern straight = made(CUPOLA_PATTERN_REGULAR, 4); /* the control */
    check_at_most(least_gap(&straight), 1e-9);
}

/* With four it is the known one: columns and rows are even, 3 1 -1 -3. */
static void a_rotated_grid_of_four_is_even_in_rows_and_columns(void **state)
{
    (void)state;
    struct pattern pattern = made(CUPOLA_PATTERN_ROTATED_GRID, 4);
    double unit = sqrt(1.0 / 3.0 / 10.0);
    for (int i = 0; i < 4; i++) {
        double x = fabs(pattern.places[i].x) / unit, y = fabs(pattern.places[i].y) / unit;
        check_near(fmin(x, y), 1.0, 1e-12);
        check_near(fmax(x, y), 3.0, 1e-12);
        check_near(pattern.places[i].weight, 0.25, 1e-15);
    }
}

static void aligned_patterns_are_the_same_but_turned(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++)
        for (int count = 1; count <= CUPOLA_RAYS_MAX; count++) {
            struct pattern before = made(kind, count), after = before;
            pattern_align(&after);
            struct pattern_place last = after.places[count - 1];
            check_near(last.y, 0.0, 1e-14);
            check_at_least(last.x, count > 1 ? 0.1 : 0.0);
            for (int i = 0; i < count; i++) {
                struct pattern_place a = before.places[i], b = after.places[i];
                struct pattern_place first = before.places[count - 1];
                check_near(hypot(b.x, b.y), hypot(a.x, a.y), 1e-14);
                check_near(b.x * last.x + b.y * last.y, a.x * first.x + a.y * first.y, 1e-14);
                check_near(b.weight, a.weight, 0.0);
            }
        }
}

/* Numbers made elsewhere, by the same steps in whole numbers: the shaders give the same. */
static void the_hash_has_the_bits_that_it_had(void **state)
{
    (void)state;
    assert_int_equal(pattern_hash(1, 0, 0), 0x688990c0u);
    assert_int_equal(pattern_hash(0, 1, 0), 0x58f54975u);
    assert_int_equal(pattern_hash(5, 9, 77), 0x0ca937e9u);
    assert_int_equal(pattern_hash(4095, 2159, 0xffffffffu), 0x560c3a49u);
}

/* Length of the mean of the turns' directions (of neighbours' differences): n random ones make
 * 1 / sqrt(n), and thrice that with a chance of 1e-4. */
static double mean_direction(uint32_t seed, uint32_t dx, uint32_t dy, uint32_t other_seed)
{
    enum { SIDE = 64 };
    double x = 0.0, y = 0.0;
    for (uint32_t j = 0; j < SIDE; j++)
        for (uint32_t i = 0; i < SIDE; i++) {
            double angle = pattern_turn_rad(i, j, seed);
            check_at_least(angle, 0.0);
            check_at_most(angle, 2.0 * pi * (1.0 - 0x1p-24));
            if (dx || dy || seed != other_seed)
                angle -= pattern_turn_rad(i + dx, j + dy, other_seed);
            x += cos(angle);
            y += sin(angle);
        }
    return hypot(x, y) / (SIDE * SIDE);
}

static void turns_are_even_and_differ_between_neighbours_and_seeds(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 8; seed++) {
        check_at_most(mean_direction(seed, 0, 0, seed), 3.0 / 64.0);
        check_at_most(mean_direction(seed, 1, 0, seed), 3.0 / 64.0);
        check_at_most(mean_direction(seed, 0, 1, seed), 3.0 / 64.0);
        check_at_most(mean_direction(seed, 0, 0, seed + 1), 3.0 / 64.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_sum_to_1_and_no_place_leaves_the_disc),
        cmocka_unit_test(every_pattern_is_balanced_and_as_wide_as_the_cone),
        cmocka_unit_test(places_are_far_from_each_other),
        cmocka_unit_test(no_two_places_of_a_rotated_grid_share_a_row_or_a_column),
        cmocka_unit_test(a_rotated_grid_of_four_is_even_in_rows_and_columns),
        cmocka_unit_test(aligned_patterns_are_the_same_but_turned),
        cmocka_unit_test(the_hash_has_the_bits_that_it_had),
        cmocka_unit_test(turns_are_even_and_differ_between_neighbours_and_seeds),
    };
    return cmocka_run_group_tests_name("pattern", tests, NULL, NULL);
}
