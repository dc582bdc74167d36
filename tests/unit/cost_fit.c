/* Prices from measured times: what is known beforehand comes out again, with noise and without. */
#include <string.h>

#include "check.h"
#include "cupola/cost.h"
#include "message.h"

static const struct cupola_cost known = {.view = 0.03, .texel_allocated = 0.2, .vertices = 1.5};

/* Amounts as plans have them; a frame takes 5 ms, and 2 ms more for every texel per pixel. */
static void make_trials(uint64_t *seed, const struct cupola_cost *cost, double noise, int count,
                        struct cupola_cost_trial *trials)
{
    for (int i = 0; i < count; i++) {
        struct cupola_cost_trial *trial = &trials[i];
        trial->texels_shaded = random_between(seed, 0.4, 3.0);
        trial->texels_allocated = trial->texels_shaded * random_between(seed, 1.2, 2.5);
        trial->views = (int)random_between(seed, 1.0, 8.99);
        trial->directions_drawn = random_between(seed, 0.3, 0.9);
        trial->seconds =
            0.005 +
            0.002 * (trial->texels_shaded + cost->texel_allocated * trial->texels_allocated +
                     cost->view * trial->views + cost->vertices * trial->directions_drawn);
        trial->seconds *= random_between(seed, 1.0 - noise, 1.0 + noise);
    }
}

static void known_prices_come_out_again(void **state)
{
    (void)state;
    uint64_t seed = 61;
    for (int round = 0; round < 100; round++) {
        struct cupola_cost_trial trials[12];
        struct cupola_cost found;
        make_trials(&seed, &known, 0.0, 12, trials);
        assert_int_equal(cupola_cost_fit(trials, 12, &found, NULL), CUPOLA_OK);
        check_near(found.view, known.view, 1e-9);
        check_near(found.texel_allocated, known.texel_allocated, 1e-9);
        check_near(found.vertices, known.vertices, 1e-9);
    }
}

static void noise_of_2_percent_moves_them_little(void **state)
{
    (void)state;
    uint64_t seed = 62;
    struct cupola_cost_trial trials[CUPOLA_COST_TRIALS_MAX];
    struct cupola_cost found, wrong = known;
    for (int round = 0; round < 20; round++) {
        make_trials(&seed, &known, 0.02, CUPOLA_COST_TRIALS_MAX, trials);
        assert_int_equal(cupola_cost_fit(trials, CUPOLA_COST_TRIALS_MAX, &found, NULL), CUPOLA_OK);
        check_near(found.view, known.view, 0.03);
        check_near(found.texel_allocated, known.texel_allocated, 0.2);
        check_near(found.vertices, known.vertices, 0.6);
    }
    /* The control: another price is farther off than that. */
    wrong.view = 0.1;
    make_trials(&seed, &wrong, 0.02, CUPOLA_COST_TRIALS_MAX, trials);
    assert_int_equal(cupola_cost_fit(trials, CUPOLA_COST_TRIALS_MAX, &found, NULL), CUPOLA_OK);
    check_at_least(found.view, known.view + 0.03);
}

/* More views that take less time: noise, no gift. */
static void no_price_is_below_0_and_none_is_the_default(void **state)
{
    (void)state;
    uint64_t seed = 63;
    struct cupola_cost_trial trials[12];
    struct cupola_cost found, odd = known;
    odd.view = -0.02;
    odd.vertices = 0.0;
    make_trials(&seed, &odd, 0.0, 12, trials);
    assert_int_equal(cupola_cost_fit(trials, 12, &found, NULL), CUPOLA_OK);
    check_near(found.view, 0.0, 1e-9); /* the default, or nothing */
    check_at_least(found.vertices, 0.0);
    check_at_least(found.texel_allocated, 1e-9);
}

static void check_refused(const struct cupola_cost_trial *trials, int count, const char *word)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_cost found = known;
    assert_int_equal(cupola_cost_fit(trials, count, &found, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, word));
    assert_memory_equal(&found, &known, sizeof found);
}

static void trials_that_cannot_tell_are_refused(void **state)
{
    (void)state;
    uint64_t seed = 64;
    struct cupola_cost_trial trials[12];
    make_trials(&seed, &known, 0.0, 12, trials);
    check_refused(trials, 2, "2; allowed: 3 to 64");
    check_refused(trials, 65, "65; allowed: 3 to 64");
    check_refused(NULL, 12, "trials is NULL");
    assert_int_equal(cupola_cost_fit(trials, 12, NULL, NULL), CUPOLA_ERROR_ARGUMENT);
    trials[4].seconds = (double)NAN;
    check_refused(trials, 12, "time in seconds of trial 4");
    trials[4].seconds = 0.0;
    trials[4].texels_shaded = -1.0;
    check_refused(trials, 12, "texels shaded of trial 4");
    for (int i = 0; i < 12; i++) /* all shade the same */
        trials[i].texels_shaded = 1.0;
    check_refused(trials, 12, "cannot tell");
    make_trials(&seed, &known, 0.0, 12, trials);
    for (int i = 0; i < 12; i++) /* what shades more takes less */
        trials[i].seconds = 1.0 - 0.1 * trials[i].texels_shaded;
    check_refused(trials, 12, "cannot tell");
    trials[0] = trials[1] = trials[2]; /* one trial thrice */
    check_refused(trials, 3, "cannot tell");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_prices_come_out_again),
        cmocka_unit_test(noise_of_2_percent_moves_them_little),
        cmocka_unit_test(no_price_is_below_0_and_none_is_the_default),
        cmocka_unit_test(trials_that_cannot_tell_are_refused),
    };
    return cmocka_run_group_tests_name("cost_fit", tests, NULL, NULL);
}
