/*
 * The point table without views: what the C functions say of every pixel, for any rig, and after
 * any change of one.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "interposed.h"
#include "rig_random.h"
#include "table_bits.h"
#include "worse.h"

/* As of the tables that a warp has: the rounding of floats, and distances of some 200 px. */
static const double bar_radii = 1e-5, bar_coverage = 1e-4;

enum { RIGS = 24, MODELS = 6 };

static cupola_dome *dome_of(const struct cupola_rig *rig)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    if (cupola_dome_create(rig, &dome, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    return dome;
}

static cupola_points *points_of(const struct cupola_rig *rig, int output)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_points *points = NULL;
    cupola_dome *dome = dome_of(rig);
    if (cupola_points_create(dome, output, &points, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    cupola_dome_destroy(&dome);
    return points;
}

static void set_rig(cupola_points *points, const struct cupola_rig *rig, int output)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = dome_of(rig);
    if (cupola_points_set_dome(points, dome, output, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    cupola_dome_destroy(&dome);
}

/* Two projectors; all lens models, with caps and without, of other sizes. */
static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 8101 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, 0.8);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % MODELS);
    double most_deg = model == CUPOLA_LENS_HEMISPHERIC ? 160.0 : 220.0;
    rig.output_count = 2;
    rig.outputs[1] = rig.outputs[0];
    rig.outputs[number % 2].lens =
        random_lens(&seed, model, radians(random_between(&seed, 90.0, most_deg)));
    rig.outputs[1 - number % 2].width_px += 7;
    rig.outputs[number % 2].aim.yaw_rad *= 0.2; /* so that a cap leaves something */
    rig.outputs[number % 2].aim.pitch_rad *= 0.2;
    rig.screen.cap_rad = number / MODELS % 2 ? radians(random_between(&seed, 40.0, 120.0)) : 0.0;
    return rig;
}

struct points_error {
    double points; /* radii of the screen */
    double coverage;
    int lit;
};

static struct points_error error_of(const cupola_points *points, const struct cupola_rig *rig,
                                    int output)
{
    cupola_dome *dome = dome_of(rig);
    struct points_error error = {0.0, 0.0, 0};
    int width = rig->outputs[output].width_px, height = rig->outputs[output].height_px;
    float *entries = table_bits(cupola_points_texture(points), width, height);
    for (int at = 0; at < width * height; at++) {
        const float *entry = entries + 4 * at;
        struct cupola_ray ray;
        double square = 0.0;
        cupola_dome_ray(dome, output, NULL, at % width + 0.5, at / width + 0.5, &ray);
        for (int i = 0; i < 3; i++)
            square += pow((double)entry[i] - ray.point_m[i], 2.0);
        error.coverage = worse_of(error.coverage, fabs((double)entry[3] - ray.coverage));
        if (ray.coverage < 0.01)
            continue; /* no one looks there */
        error.points = worse_of(error.points, sqrt(square) / rig->screen.radius_m);
        error.lit++;
    }
    free(entries);
    cupola_dome_destroy(&dome);
    return error;
}

/* One table is given all of them in a row. */
static void every_pixel_holds_what_the_c_functions_say(void **state)
{
    struct cupola_rig rig = rig_number(0);
    cupola_points *points = points_of(&rig, 0);
    struct points_error worst = {0.0, 0.0, 0};
    (void)state;
    for (int number = 0; number < RIGS; number++) {
        if (number > 0) {
            rig = rig_number(number);
            set_rig(points, &rig, number % 2);
        }
        struct points_error error = error_of(points, &rig, number % 2);
        check_at_least(error.lit, 200);
        worst.points = worse_of(worst.points, error.points);
        worst.coverage = worse_of(worst.coverage, error.coverage);
    }
    cupola_points_destroy(&points);
    printf("points %.2g R, coverage %.2g\n", worst.points, worst.coverage);
    check_at_most(worst.points, bar_radii);
    check_at_most(worst.coverage, bar_coverage);
}

static void a_rig_wrong_by_a_hundredth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    for (int number = 0; number < MODELS; number++) {
        struct cupola_rig rig = rig_number(number), turned = rig, shifted = rig;
        cupola_points *points = points_of(&rig, number % 2);
        turned.outputs[number % 2].aim.yaw_rad += radians(0.01);
        shifted.outputs[number % 2].circle.center_x_px += 0.01;
        check_at_least(error_of(points, &turned, number % 2).points, 2.0 * bar_radii);
        check_at_least(error_of(points, &shifted, number % 2).coverage, 2.0 * bar_coverage);
        cupola_points_destroy(&points);
    }
}

/* What differs from the rig that all start from. */
static struct cupola_rig start_rig(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_POLYNOMIAL, 170.0, 96);
    struct cupola_output *output = &rig.outputs[0];
    output->lens.k[0] = 1.0;
    output->lens.k[1] = 0.02;
    output->circle = (struct cupola_circle){50.0, 46.0, 49.0};
    output->position_m[0] = 0.1;
    rig.screen.radius_m = 2.0;
    rig.screen.cap_rad = radians(85.0);
    rig.eye_m[1] = 0.2;
    rig.tilt_rad = 0.3;
    return rig;
}

enum { CHANGES = 26, HARMLESS = 2 };

/* The first ones are no business of the table's. */
static struct cupola_rig changed_rig(int change)
{
    struct cupola_rig rig = start_rig();
    struct cupola_output *output = &rig.outputs[0];
    const struct cupola_lens table = {
        .model = CUPOLA_LENS_TABLE, .table_count = 3, .table = {{0.4, 1}, {0.9, 2}, {1.4, 3.2}}};
    double *const numbers[] = {
        &rig.eye_m[1],
        &rig.tilt_rad,
        &rig.screen.radius_m,
        &rig.screen.cap_rad,
        &output->lens.k[0],
        &output->lens.k[1],
        &output->lens.k[2],
        &output->lens.k[3],
        &output->circle.center_x_px,
        &output->circle.center_y_px,
        &output->circle.radius_px,
        &output->position_m[0],
        &output->position_m[1],
        &output->position_m[2],
        &output->aim.yaw_rad,
        &output->aim.pitch_rad,
        &output->aim.roll_rad,
        &output->lens.fov_rad,
    };
    enum { NUMBERS = sizeof numbers / sizeof numbers[0] };
    if (change < NUMBERS)
        *numbers[change] += 0.01;
    else if (change < NUMBERS + CUPOLA_LENS_POLYNOMIAL)
        output->lens.model = (enum cupola_lens_model)(change - NUMBERS);
    else if (change == NUMBERS + CUPOLA_LENS_POLYNOMIAL)
        output->lens = table;
    else if (change == NUMBERS + CUPOLA_LENS_TABLE)
        rig.screen.cap_rad = 0.0;
    else
        output->flip = change % 2 ? CUPOLA_FLIP_X : CUPOLA_FLIP_Y;
    return rig;
}

static bool same_bits(const cupola_points *a, const cupola_points *b)
{
    const struct cupola_rig rig = start_rig(); /* all of its size */
    int width = rig.outputs[0].width_px, height = rig.outputs[0].height_px;
    float *first = table_bits(cupola_points_texture(a), width, height);
    float *second = table_bits(cupola_points_texture(b), width, height);
    bool same = memcmp(first, second, 4 * sizeof *first * (size_t)(width * height)) == 0;
    free(first);
    free(second);
    return same;
}

static void whatever_changes_is_taken_in_as_if_made_anew(void **state)
{
    const struct cupola_rig start = start_rig();
    cupola_points *first = points_of(&start, 0), *points = points_of(&start, 0);
    (void)state;
    assert_true(same_bits(first, points));
    for (int change = 0; change < CHANGES; change++) {
        const struct cupola_rig rig = changed_rig(change);
        cupola_points *anew = points_of(&rig, 0);
        set_rig(points, &rig, 0);
        if (!same_bits(points, anew))
            fail_msg("change %d: not as made anew", change);
        if (same_bits(points, first) != (change < HARMLESS))
            fail_msg("change %d: %s", change, change < HARMLESS ? "matters" : "does not matter");
        cupola_points_destroy(&anew);
    }
    set_rig(points, &start, 0);
    assert_true(same_bits(first, points));
    cupola_points_destroy(&points);
    cupola_points_destroy(&first);
}

/* How many things the GL had to make for it. */
static int made_for(cupola_points *points, const struct cupola_rig *rig)
{
    interposed_begin();
    set_rig(points, rig, 0);
    int made = interposed.made;
    interposed_end();
    return made;
}

static void nothing_is_made_but_for_another_size_and_for_lenses_and_caps_not_seen_yet(void **state)
{
    const struct cupola_rig start = start_rig();
    struct cupola_rig moved = start, other = start, capless = start, wider = start;
    cupola_points *points = points_of(&start, 0);
    unsigned int texture = cupola_points_texture(points);
    bool draws = context_has_floats();
    (void)state;
    moved.outputs[0].aim.yaw_rad = 0.1;
    moved.outputs[0].lens.k[1] = 0.03;
    other.outputs[0].lens.model = CUPOLA_LENS_EQUISOLID;
    capless.screen.cap_rad = 0.0;
    wider.outputs[0].width_px++;
    assert_int_equal(made_for(points, &moved), 0);
    assert_int_equal(made_for(points, &other) > 0, draws);
    assert_int_equal(made_for(points, &capless) > 0, draws);
    assert_int_equal(made_for(points, &start), 0);
    assert_int_equal(made_for(points, &other), 0);
    assert_int_equal(cupola_points_texture(points), texture);
    check_at_least(made_for(points, &wider), 1);
    assert_int_not_equal(cupola_points_texture(points), texture);
    assert_false(glIsTexture(texture));
    cupola_points_destroy(&points);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_holds_what_the_c_functions_say),
        cmocka_unit_test(a_rig_wrong_by_a_hundredth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(whatever_changes_is_taken_in_as_if_made_anew),
        cmocka_unit_test(nothing_is_made_but_for_another_size_and_for_lenses_and_caps_not_seen_yet),
    };
    return run_gpu_group("points", tests);
}
