/*
 * The density map: against the closed forms of lenses, the rule for eyes off the axis, and the
 * solid angle that the lens throws.
 */
#include <stdlib.h>

#include "cupola/resolution.h"
#include "message.h"
#include "oracle.h"

enum { SIDE_PX = 101 };

/* Single precision alone is 6e-8. */
static const double map_tolerance = 1e-6;

static float *map_of(const struct cupola_rig *rig, const double eye_m[3])
{
    cupola_dome *dome = dome_of(rig);
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[0];
    float *map = malloc((size_t)(size->width_px * size->height_px) * sizeof *map);
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_non_null(map);
    if (cupola_density_map(dome, 0, eye_m, map, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    cupola_dome_destroy(&dome);
    return map;
}

/* d(angle)/dr by differences of fourth order; for lenses of numbers, which have no closed form. */
static double slope_of(const struct cupola_lens *lens, double r)
{
    double step = 1e-4;
    return (8.0 * (cupola_lens_angle(lens, r + step) - cupola_lens_angle(lens, r - step)) -
            cupola_lens_angle(lens, r + 2.0 * step) + cupola_lens_angle(lens, r - 2.0 * step)) /
           (12.0 * step);
}

/* Solid angle per area of a circle of radius 1, at an image radius. */
static double closed_form(const struct cupola_lens *lens, double r)
{
    double h = lens->fov_rad / 2.0, angle = cupola_lens_angle(lens, r);
    switch (lens->model) {
    case CUPOLA_LENS_ANGULAR:
        return angle > 0.0 ? h * h * sin(angle) / angle : h * h;
    case CUPOLA_LENS_HEMISPHERIC:
        return sin(h) * sin(h) / cos(angle);
    case CUPOLA_LENS_EQUISOLID:
        return 4.0 * sin(h / 2.0) * sin(h / 2.0);
    case CUPOLA_LENS_STEREOGRAPHIC:
        return 4.0 * pow(tan(h / 2.0), 2.0) * pow(cos(angle / 2.0), 4.0);
    default:
        return r > 1e-3 ? sin(angle) * slope_of(lens, r) / r : pow(slope_of(lens, 0.01), 2.0);
    }
}

/* The image radius that a pixel of an uncut circle in the middle stands for; -1: it is not lit. */
static double radius_of(int x, int y)
{
    double rho = SIDE_PX / 2.0, r = hypot(x + 0.5 - rho, y + 0.5 - rho) / rho;
    if (r > 1.0 + 0.75 / rho)
        return -1.0;
    return fmin(r, 1.0 - 0.5 / rho);
}

/* The largest error of a map of the lens in the middle, as a part of what is expected. */
static double error_of(const float *map, const struct cupola_lens *lens, double least_r)
{
    double rho = SIDE_PX / 2.0, worst = 0.0;
    int lit = 0;
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++) {
        double r = radius_of(i % SIDE_PX, i / SIDE_PX);
        if (r < least_r || !(map[i] > 0.0f))
            continue;
        double expected = closed_form(lens, r) / (rho * rho);
        worst = fmax(worst, fabs((double)map[i] / expected - 1.0));
        lit++;
    }
    check_at_least(lit, 0.9 * pi * rho * rho * (1.0 - least_r * least_r));
    return worst;
}

static void on_axis_the_map_is_the_closed_form_of_every_lens(void **state)
{
    (void)state;
    uint64_t seed = 4301;
    for (int i = 0; i < 24; i++) {
        enum cupola_lens_model model = (enum cupola_lens_model)(i % 6);
        bool numeric = model >= CUPOLA_LENS_POLYNOMIAL;
        double most = model == CUPOLA_LENS_HEMISPHERIC ? 180.0 : 300.0;
        double fov_deg = i < 6 ? 180.0 : random_between(&seed, 60.0, numeric ? 200.0 : most);
        struct cupola_rig rig = plain_rig(model, fov_deg, SIDE_PX);
        rig.outputs[0].lens = random_lens(&seed, model, radians(fov_deg));
        assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
        float *map = map_of(&rig, NULL);
        struct cupola_lens lens = rig.outputs[0].lens;
        /* A table's curve bends suddenly at its samples, where differences see both sides. */
        double tolerance = model == CUPOLA_LENS_TABLE ? 5e-3 : map_tolerance;
        check_at_most(error_of(map, &lens, numeric ? 0.02 : 0.0), tolerance);
        /* The control. A hemispheric lens of 180 degrees has its greatest density there. */
        if (!numeric) {
            lens.fov_rad -= radians(i == CUPOLA_LENS_HEMISPHERIC ? 0.5 : 0.001);
            check_at_least(error_of(map, &lens, 0.0), 3.0 * map_tolerance);
        }
        free(map);
    }
}

/* Section 4: of the screen's patch, seen from the middle, times R^2 cos(gamma) / |D - E|^2. */
static double patch_error(const struct cupola_rig *rig, const float *map, const double eye_m[3])
{
    double rho = SIDE_PX / 2.0, radius_m = rig->screen.radius_m, worst = 0.0;
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++) {
        double x = i % SIDE_PX + 0.5 - rho, y = i / SIDE_PX + 0.5 - rho, across[3], square = 0.0;
        double r = radius_of(i % SIDE_PX, i / SIDE_PX), theta = atan2(y, x), cosine = 0.0;
        if (r < 0.0 || !(map[i] > 0.0f))
            continue;
        double angle = cupola_lens_angle(&rig->outputs[0].lens, r);
        double up[3] = {sin(angle) * cos(theta), sin(angle) * sin(theta), -cos(angle)};
        for (int k = 0; k < 3; k++) {
            across[k] = radius_m * up[k] - eye_m[k];
            square += across[k] * across[k];
        }
        for (int k = 0; k < 3; k++)
            cosine += across[k] * up[k] / sqrt(square);
        double patch = closed_form(&rig->outputs[0].lens, r) / (rho * rho);
        worst = fmax(worst,
                     fabs((double)map[i] / (patch * radius_m * radius_m * cosine / square) - 1.0));
    }
    return worst;
}

static void off_axis_the_map_is_that_of_patches_of_the_screen(void **state)
{
    (void)state;
    uint64_t seed = 4302;
    for (int i = 0; i < 16; i++) {
        struct cupola_rig rig = plain_rig((enum cupola_lens_model)(i % 4), 180.0, SIDE_PX);
        double eye_m[3];
        rig.screen.radius_m = random_between(&seed, 0.5, 10.0);
        rig.tilt_rad = random_between(&seed, -3.0, 3.0);
        random_in_ball(&seed, 0.8 * rig.screen.radius_m, eye_m);
        assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
        float *map = map_of(&rig, eye_m);
        check_at_most(patch_error(&rig, map, eye_m), map_tolerance);
        eye_m[0] += 1e-4 * rig.screen.radius_m;
        check_at_least(patch_error(&rig, map, eye_m), 10.0 * map_tolerance);
        eye_m[0] -= 1e-4 * rig.screen.radius_m;
        /* The rig's own eye is where none is given. */
        float *own = NULL;
        memcpy(rig.eye_m, eye_m, sizeof eye_m);
        own = map_of(&rig, NULL);
        assert_memory_equal(own, map, SIDE_PX * SIDE_PX * sizeof *map);
        free(own);
        free(map);
    }
}

/* How much of a pixel lies within a circle of some radius in the middle, by 64 chords. */
static double part_within(int x, int y, double radius_px)
{
    double rho = SIDE_PX / 2.0, part = 0.0, dx = x + 0.5 - rho;
    for (int k = 0; k < 64; k++) {
        double dy = y + (k + 0.5) / 64.0 - rho;
        double half = sqrt(fmax(0.0, radius_px * radius_px - dy * dy));
        part += fmax(0.0, fmin(dx + 0.5, half) - fmax(dx - 0.5, -half)) / 64.0;
    }
    return part;
}

/* Of the pixels inside, by the map, and of the outermost part in closed form, by its angles. */
static double sum_of(const float *map, const struct cupola_lens *lens, double rim_px)
{
    double rho = SIDE_PX / 2.0, sum = 0.0;
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++)
        sum += (double)map[i] * part_within(i % SIDE_PX, i / SIDE_PX, rho - rim_px);
    double from = cupola_lens_angle(lens, 1.0 - rim_px / rho);
    return sum + 2.0 * pi * (cos(from) - cos(lens->fov_rad / 2.0));
}

/*
 * The midpoint rule for squares of 1 px errs by some (1 px / rho)^2 times how the density bends,
 * which is most near the rim of a hemispheric lens of 180 degrees: its outer 6 px are integrated.
 */
static void the_map_adds_up_to_the_cap_that_the_lens_throws(void **state)
{
    (void)state;
    for (int model = 0; model <= CUPOLA_LENS_STEREOGRAPHIC; model++) {
        bool singular = model == CUPOLA_LENS_HEMISPHERIC;
        struct cupola_rig rig = plain_rig((enum cupola_lens_model)model, 180.0, SIDE_PX);
        assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
        const struct cupola_lens *lens = &rig.outputs[0].lens;
        float *map = map_of(&rig, NULL);
        double whole = 2.0 * pi * (1.0 - cos(lens->fov_rad / 2.0));
        check_near(sum_of(map, lens, singular ? 6.0 : 1.0) / whole, 1.0, 5e-4);
        for (int i = 0; i < SIDE_PX * SIDE_PX; i++)
            map[i] *= 1.001f; /* the control */
        check_at_least(fabs(sum_of(map, lens, singular ? 6.0 : 1.0) / whole - 1.0), 5e-4);
        free(map);
    }
}

static void lit_pixels_alone_have_a_density_and_it_is_finite(void **state)
{
    (void)state;
    uint64_t seed = 4303;
    for (int i = 0; i < 60; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        if (i == 0)
            rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 64);
        if (i == 1)
            rig = plain_rig(CUPOLA_LENS_ANGULAR, 360.0, 64);
        if (i % 3 == 2)
            rig.screen.cap_rad = radians(70.0);
        cupola_dome *dome = dome_of(&rig);
        rig = *cupola_dome_rig(dome);
        float *map = map_of(&rig, NULL);
        int width = rig.outputs[0].width_px;
        for (int p = 0; p < width * rig.outputs[0].height_px; p++) {
            struct cupola_ray ray;
            int lit = cupola_dome_ray(dome, 0, NULL, p % width + 0.5, p / width + 0.5, &ray);
            assert_int_equal(map[p] > 0.0f, lit);
            assert_true(isfinite(map[p]));
        }
        free(map);
        cupola_dome_destroy(&dome);
    }
}

static void what_makes_no_sense_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    struct cupola_rig rig = {.outputs[0] = {.width_px = 2, .height_px = 2}};
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = dome_of(&rig);
    float map[4] = {-7.0f, -7.0f, -7.0f, -7.0f};
    const double outside[3] = {0.0, 1.5, 0.0}, nowhere[3] = {(double)NAN, 0.0, 0.0};
    assert_int_equal(cupola_density_map(NULL, 0, NULL, map, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_density_map(dome, 0, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_density_map(dome, 1, NULL, map, &error), CUPOLA_ERROR_ARGUMENT);
    check_message(&error, 1.0);
    assert_int_equal(cupola_density_map(dome, -1, NULL, map, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_density_map(dome, 0, outside, map, &error), CUPOLA_ERROR_ARGUMENT);
    check_message(&error, 1.5);
    assert_int_equal(cupola_density_map(dome, 0, nowhere, map, NULL), CUPOLA_ERROR_ARGUMENT);
    for (int i = 0; i < 4; i++)
        assert_true(map[i] < -6.0f);
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_axis_the_map_is_the_closed_form_of_every_lens),
        cmocka_unit_test(off_axis_the_map_is_that_of_patches_of_the_screen),
        cmocka_unit_test(the_map_adds_up_to_the_cap_that_the_lens_throws),
        cmocka_unit_test(lit_pixels_alone_have_a_density_and_it_is_finite),
        cmocka_unit_test(what_makes_no_sense_is_refused_and_changes_nothing),
    };
    return cmocka_run_group_tests_name("density_map", tests, NULL, NULL);
}
