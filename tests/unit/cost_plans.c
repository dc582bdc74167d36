/*
 * Prices as they are measured: the trials' own plans, times that are off by some percent. What
 * counts is the plan that comes out: by the true prices it costs hardly more than the best one.
 */
#include "check.h"
#include "geometry/cost_trials.h"
#include "message.h"
#include "rig_random.h"

enum { DOMES = 4, ROWS = COST_TRIALS + 1, SCENES = 5, TRIES = 2 };

static const struct {
    enum cupola_lens_model lens;
    double fov_deg;
    bool unmasked;
} houses[DOMES] = {{CUPOLA_LENS_ANGULAR, 100.0, false},
                   {CUPOLA_LENS_ANGULAR, 180.0, true},
                   {CUPOLA_LENS_ANGULAR, 220.0, false},
                   {CUPOLA_LENS_STEREOGRAPHIC, 140.0, true}};

/* Fill alone, the mixed scene, dear views, dear memory, forests. */
static const struct cupola_cost scenes[SCENES] = {
    {0.002, 0.02, 0.001}, {0.03, 0.2, 1.5}, {0.3, 0.05, 0.5}, {0.01, 0.8, 0.2}, {0.05, 0.1, 100.0}};

static cupola_dome *dome_of(int house)
{
    struct cupola_rig rig = {.screen.radius_m = 8.0, .output_count = 1};
    cupola_dome *dome = NULL;
    rig.outputs[0].width_px = rig.outputs[0].height_px = 512;
    rig.outputs[0].lens = (struct cupola_lens){.model = houses[house].lens,
                                               .fov_rad = radians(houses[house].fov_deg)};
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    return dome;
}

static void plan_rows(const cupola_dome *dome, bool unmasked, struct cupola_cost_trial rows[ROWS])
{
    const struct cupola_plan_params wishes = {.unmasked = unmasked};
    rows[COST_TRIALS] = (struct cupola_cost_trial){0};
    for (int i = 0; i < COST_TRIALS; i++) {
        cupola_plan *plan = NULL;
        assert_int_equal(cost_trial_plan(dome, &wishes, i, &plan, NULL), CUPOLA_OK);
        cupola_cost_trial_of(plan, unmasked || cost_trial_is_maskless(i), &rows[i]);
        cupola_plan_destroy(&plan);
    }
}

/* 2 ms for a texel per pixel, 0.2 ms for anything at all. */
static void time_rows(const struct cupola_cost *cost, double noise, uint64_t *seed,
                      struct cupola_cost_trial rows[ROWS])
{
    for (int i = 0; i < ROWS; i++)
        rows[i].seconds =
            (0.0002 +
             0.002 * (rows[i].texels_shaded + cost->texel_allocated * rows[i].texels_allocated +
                      cost->view * rows[i].views + cost->vertices * rows[i].directions_drawn)) *
            random_between(seed, 1.0 - noise, 1.0 + noise);
}

/* What the plan by some prices costs by the true ones. */
static double cost_by(const cupola_dome *dome, bool unmasked, const struct cupola_cost *prices,
                      const struct cupola_cost *truth)
{
    const struct cupola_plan_params wishes = {.unmasked = unmasked, .cost = *prices};
    struct cupola_cost_trial amounts;
    cupola_plan *plan = NULL;
    assert_int_equal(cupola_plan_create(dome, &wishes, &plan, NULL), CUPOLA_OK);
    cupola_cost_trial_of(plan, unmasked, &amounts);
    cupola_plan_destroy(&plan);
    return amounts.texels_shaded + truth->texel_allocated * amounts.texels_allocated +
           truth->view * amounts.views + truth->vertices * amounts.directions_drawn;
}

/* The most that plans by measured prices cost, as a part of what the best one does. */
static double worst_of(const cupola_dome *dome, bool unmasked, const struct cupola_cost *truth,
                       double best, struct cupola_cost_trial rows[ROWS])
{
    static const double noise[TRIES] = {0.01, 0.03};
    static uint64_t seed = 71;
    double worst = 0.0;
    for (int i = 0; i < TRIES; i++) {
        struct cupola_cost found;
        time_rows(truth, noise[i], &seed, rows);
        assert_int_equal(cupola_cost_fit(rows, ROWS, &found, NULL), CUPOLA_OK);
        worst = fmax(worst, cost_by(dome, unmasked, &found, truth) / best);
    }
    return worst;
}

static void measured_prices_plan_as_true_ones_do(void **state)
{
    (void)state;
    double control = 1.0;
    for (int house = 0; house < DOMES; house++) {
        cupola_dome *dome = dome_of(house);
        bool unmasked = houses[house].unmasked;
        struct cupola_cost_trial rows[ROWS];
        double worst = 0.0;
        plan_rows(dome, unmasked, rows);
        for (int i = 0; i < SCENES; i++) {
            double best = cost_by(dome, unmasked, &scenes[i], &scenes[i]);
            worst = fmax(worst, worst_of(dome, unmasked, &scenes[i], best, rows));
            /* The control: the prices of another scene. */
            if (house == DOMES - 2)
                control = fmax(
                    control, cost_by(dome, unmasked, &scenes[(i + 1) % SCENES], &scenes[i]) / best);
        }
        printf("  dome %d: %.4f of the least cost\n", house, worst);
        check_at_most(worst, 1.03);
        cupola_dome_destroy(&dome);
    }
    printf("  by another scene's prices: %.4f\n", control);
    check_at_least(control, 1.1);
}

/* Without noise those that are told are right, of four kinds at once. */
static void exact_times_tell_exact_prices(void **state)
{
    (void)state;
    cupola_dome *dome = dome_of(2);
    struct cupola_cost_trial rows[ROWS];
    struct cupola_cost found;
    uint64_t seed = 72;
    plan_rows(dome, false, rows);
    time_rows(&scenes[1], 0.0, &seed, rows);
    assert_int_equal(cupola_cost_fit(rows, ROWS, &found, NULL), CUPOLA_OK);
    check_near(found.view, scenes[1].view, 1e-6);
    check_near(found.texel_allocated, scenes[1].texel_allocated, 1e-6);
    check_near(found.vertices, scenes[1].vertices, 1e-6);
    /* Where all rectangles are shaded whole, what an allocated texel costs cannot be told. */
    plan_rows(dome, true, rows);
    time_rows(&scenes[1], 0.0, &seed, rows);
    assert_int_equal(cupola_cost_fit(rows, ROWS, &found, NULL), CUPOLA_OK);
    check_near(found.texel_allocated, 0.0, 0.0);
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(measured_prices_plan_as_true_ones_do),
        cmocka_unit_test(exact_times_tell_exact_prices),
    };
    return cmocka_run_group_tests_name("cost_plans", tests, NULL, NULL);
}
