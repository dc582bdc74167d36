/*
 * The density map of the GPU against that in C: whatever the lens, off the axis, cut and flipped;
 * it follows an eye that moves, and is the same where the GL cannot draw into floats.
 *
 * Tolerances: single precision. Angles off the axis are known to some 1e-7 rad by place, which a
 * lens that is steep at its rim multiplies: half a pixel inside of the rim of a hemispheric one of
 * 180 degrees the density is proportional to 1 / sqrt(1 - r^2), with 1 - r^2 some 1 / 100 known to
 * 2e-7. Angular lenses lose digits where sin(angle) / angle bends, up to 360 degrees.
 */
#include <stdio.h>
#include <stdlib.h>

#include "cupola/resolution.h"
#include "eye_theatres.h"
#include "gl/instance.h"
#include "group.h"
#include "worse.h"

static const double inside_tolerance = 1e-5, rim_tolerance = 1e-4;

struct apart {
    double inside, rim; /* parts of what C says */
    int pixels, strange;
};

static float *map_in_c(const cupola_dome *dome, int output)
{
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[output];
    float *map = malloc((size_t)size->width_px * (size_t)size->height_px * sizeof *map);
    assert_non_null(map);
    assert_int_equal(cupola_density_map(dome, output, NULL, map, NULL), CUPOLA_OK);
    return map;
}

static float *map_of_gl(const struct fixture *fixture, int output)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    const struct cupola_output *size = fixture_output(fixture, output);
    unsigned int texture = 0;
    if (cupola_gl_density(fixture->gl, output, &texture, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    return texture_read(texture, size->width_px, size->height_px);
}

/* Pixels with a coverage of 1e-4 and less may be lit to one and not to the other. */
static struct apart compare(const struct fixture *fixture, int output, const cupola_dome *expected)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    float *shown = map_of_gl(fixture, output), *map = map_in_c(expected, output);
    struct apart apart = {0.0, 0.0, 0, 0};
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        struct cupola_ray ray;
        double x = i % size->width_px + 0.5, y = i / size->width_px + 0.5;
        cupola_dome_ray(expected, output, NULL, x, y, &ray);
        double r = hypot(x - size->circle.center_x_px, y - size->circle.center_y_px);
        if ((map[i] > 0.0f) != (shown[4 * i] > 0.0f)) {
            apart.strange += ray.coverage > 1e-4 || shown[4 * i] < 0.0f;
            continue;
        }
        if (!(map[i] > 0.0f))
            continue;
        double error = fabs((double)shown[4 * i] / (double)map[i] - 1.0);
        if (r < size->circle.radius_px - 3.0)
            apart.inside = worse_of(apart.inside, error);
        else
            apart.rim = worse_of(apart.rim, error);
        apart.pixels++;
    }
    free(map);
    free(shown);
    return apart;
}

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 6200 + (uint64_t)number;
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    struct cupola_rig rig = random_rig(&seed, number < 6 ? 0.0 : 0.6);
    double fov_deg = number < 6 ? 180.0 : random_between(&seed, 90.0, 220.0);
    if (model == CUPOLA_LENS_HEMISPHERIC)
        fov_deg = fmin(fov_deg, 180.0);
    rig.outputs[0].lens = random_lens(&seed, model, radians(fov_deg));
    rig.outputs[0].lens.fov_rad *= number == 12 ? 360.0 / fov_deg : 1.0;
    if (number % 3 == 2)
        rig.screen.cap_rad = radians(75.0);
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    return rig;
}

static cupola_dome *dome_of(const struct cupola_rig *rig)
{
    cupola_dome *dome = NULL;
    assert_int_equal(cupola_dome_create(rig, &dome, NULL), CUPOLA_OK);
    return dome;
}

static void the_map_of_the_gl_is_that_in_c(void **state)
{
    (void)state;
    struct apart worst = {0.0, 0.0, 0, 0};
    const struct cupola_gl_params params = {.sources = 1u << CUPOLA_SOURCE_DOMEMASTER};
    for (int number = 0; number < 18; number++) {
        struct cupola_rig rig = rig_number(number), wrong = rig;
        struct fixture fixture;
        fixture_make(&rig, NULL, &params, &fixture);
        struct apart apart = compare(&fixture, 0, fixture.dome);
        assert_int_equal(apart.strange, 0);
        check_at_least(apart.pixels, 50);
        check_at_most(apart.inside, inside_tolerance);
        check_at_most(apart.rim, rim_tolerance);
        worst.inside = worse_of(worst.inside, apart.inside);
        worst.rim = worse_of(worst.rim, apart.rim);
        worst.pixels += apart.pixels;
        wrong.eye_m[1] += 1e-3 * rig.screen.radius_m; /* the control */
        cupola_dome *dome = dome_of(&wrong);
        check_at_least(compare(&fixture, 0, dome).inside, 10.0 * inside_tolerance);
        cupola_dome_destroy(&dome);
        fixture_release(&fixture);
    }
    printf("  %d pixels: at most %.2g apart, %.2g within 3 px of the rim\n", worst.pixels,
           worst.inside, worst.rim);
}

static void move_both(struct fixture *fixture, const double eye_m[3])
{
    assert_int_equal(cupola_gl_set_eye(fixture->gl, eye_m, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_set_eye(fixture->plan, eye_m, NULL), CUPOLA_OK);
}

static void check_moved(struct fixture *fixture, const struct eye_theatre *theatre, uint64_t seed)
{
    for (int output = 0; output < theatre->rig.output_count; output++) {
        unsigned int before = 0, after = 0;
        double eye_m[3];
        assert_int_equal(cupola_gl_density(fixture->gl, output, &before, NULL), CUPOLA_OK);
        eye_place(theatre, &seed, true, eye_m);
        move_both(fixture, eye_m);
        struct apart apart = compare(fixture, output, cupola_plan_dome(fixture->plan));
        assert_int_equal(apart.strange, 0);
        check_at_most(apart.inside, inside_tolerance);
        check_at_most(apart.rim, rim_tolerance);
        /* The control: where the eye was. */
        check_at_least(compare(fixture, output, fixture->dome).inside, 100.0 * inside_tolerance);
        assert_int_equal(cupola_gl_density(fixture->gl, output, &after, NULL), CUPOLA_OK);
        assert_int_equal(after, before);
    }
}

static void the_map_follows_an_eye_that_moves(void **state)
{
    (void)state;
    for (int number = 0; number < EYE_THEATRES; number += 2) {
        const struct eye_theatre theatre = eye_theatre(number);
        struct fixture fixture;
        fixture_make(&theatre.rig, &theatre.params, NULL, &fixture);
        check_moved(&fixture, &theatre, 6300 + (uint64_t)number);
        fixture_release(&fixture);
    }
}

/* Read back where floats can be: there the GL is as if they could not. */
static void a_gl_that_cannot_draw_floats_has_the_map_of_the_cpu(void **state)
{
    (void)state;
    const struct eye_theatre theatre = eye_theatre(3);
    struct fixture fixture;
    fixture_make(&theatre.rig, &theatre.params, NULL, &fixture);
    fixture.gl->features.float_targets = false;
    struct apart apart = compare(&fixture, 0, fixture.dome);
    assert_int_equal(apart.strange, 0);
    check_at_most(fmax(apart.inside, apart.rim), 0.0);
    check_moved(&fixture, &theatre, 6400);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_map_of_the_gl_is_that_in_c),
        cmocka_unit_test(the_map_follows_an_eye_that_moves),
        cmocka_unit_test(a_gl_that_cannot_draw_floats_has_the_map_of_the_cpu),
    };
    return run_gpu_group("density", tests);
}
