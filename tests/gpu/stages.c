/*
 * The lens mathematics exists twice, in C and in GLSL, and the stages of the tables cut it at
 * different places; here all of them are tied together.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "rig_random.h"
#include "worse.h"

/* GLSL against C. llvmpipe's atan errs by 3e-6 rad, the rest is the rounding of floats. */
static const double bar_rad = 1e-5;
/* Coverage of rim and cap: distances of some 200 px in floats. */
static const double bar_coverage = 1e-4;
/* Texels of an atlas that is up to 2000 wide: coordinates from 0 to 1 in floats have 6e-8. */
static const double bar_texel = 0.002;

enum { STAGES = 6, RIGS = 18, CENTRED = 6 };

/* All lens models three times: centred, and twice with eye and projector up to 0.8 R off. */
static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 5001 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, number < CENTRED ? 0.0 : 0.8);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    double fov_deg = model == CUPOLA_LENS_HEMISPHERIC ? 180.0 : 210.0;
    rig.outputs[0].width_px = 161;
    rig.outputs[0].height_px = 122;
    rig.outputs[0].circle = (struct cupola_circle){80.0, 61.25, number % 2 ? 80.0 : 60.0};
    rig.outputs[0].lens = random_lens(&seed, model, radians(number < 2 * CENTRED ? fov_deg : 120));
    /* A cap whose edge is the rim's, and one that cuts through the image. */
    rig.screen.cap_rad = number % 3 == 2 ? 0.0 : radians(number < CENTRED ? fov_deg / 2.0 : 70.0);
    if (number < CENTRED)
        memset(&rig.outputs[0].aim, 0, sizeof rig.outputs[0].aim);
    else
        rig.outputs[0].aim.yaw_rad *= 0.2;
    return rig;
}

static void set_stage(struct fixture *fixture, int stage)
{
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F,
                                      .table = (enum cupola_table)stage};
    fixture_replace_gl(fixture, &params);
}

static double angle_between(const double a[3], const double b[3])
{
    double dot = 0.0, square = 0.0;
    for (int i = 0; i < 3; i++) {
        double across = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        dot += a[i] * b[i];
        square += across * across;
    }
    return atan2(sqrt(square), dot);
}

static bool has_table(int stage)
{
    return stage != CUPOLA_TABLE_NONE && stage != CUPOLA_TABLE_TILES;
}

static double bar_of(int stage)
{
    return stage == CUPOLA_TABLE_COORDINATES ? bar_texel : bar_rad;
}

/* How far entries of a table are from C. */
struct table_error {
    double main;     /* rad, radii or texels, by the stage */
    double coverage; /* 0 to 1 */
    int lit;
};

static void direction_of_angles(double angle, double azimuth, double direction[3])
{
    direction[0] = sin(angle) * cos(azimuth);
    direction[1] = sin(angle) * sin(azimuth);
    direction[2] = -cos(angle);
}

/* The nearest of the places that the ray has on views whose claims to it differ by rounding only.
 */
static double texel_error(const struct fixture *fixture, const struct cupola_ray *ray,
                          const float *entry)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    const double *direction = ray->direction;
    int own = cupola_plan_select(fixture->plan, direction);
    double claims[CUPOLA_VIEWS_MAX], error = (double)INFINITY;
    for (int v = 0; v < report->views; v++) {
        const double *selector = cupola_plan_view(fixture->plan, v)->selector;
        claims[v] = 0.0;
        for (int i = 0; i < 3; i++)
            claims[v] += selector[i] * direction[i];
    }
    for (int v = 0; v < report->views; v++) {
        double texel[2];
        if (claims[v] < claims[own] - 1e-6 ||
            cupola_plan_texel(fixture->plan, v, direction, texel) != 1)
            continue;
        error = fmin(error, hypot((double)entry[0] * report->atlas_width_px - texel[0],
                                  (double)entry[1] * report->atlas_height_px - texel[1]));
    }
    return error;
}

static double entry_error(const struct fixture *fixture, int stage, const struct cupola_ray *ray,
                          const float *entry, double *coverage)
{
    double e[4] = {(double)entry[0], (double)entry[1], (double)entry[2], (double)entry[3]};
    double direction[3], square = 0.0;
    switch (stage) {
    case CUPOLA_TABLE_ANGLES:
        *coverage = e[2];
        direction_of_angles(e[0], e[1], direction);
        return angle_between(direction, ray->direction);
    case CUPOLA_TABLE_SINES:
        *coverage = hypot(e[0], e[1]);
        direction_of_angles(atan2(e[0], e[1]), atan2(e[2], e[3]), direction);
        return angle_between(direction, ray->direction);
    case CUPOLA_TABLE_COORDINATES:
        *coverage = e[2];
        return texel_error(fixture, ray, entry);
    default:
        *coverage = e[3];
        for (int i = 0; i < 3; i++)
            square += (e[i] - ray->point_m[i]) * (e[i] - ray->point_m[i]);
        return sqrt(square) / cupola_dome_rig(fixture->dome)->screen.radius_m;
    }
}

/* What C says of every pixel of output 0; to be freed. */
static struct cupola_ray *rays_of(const cupola_dome *oracle)
{
    const struct cupola_output *size = &cupola_dome_rig(oracle)->outputs[0];
    struct cupola_ray *rays =
        test_malloc((size_t)size->width_px * (size_t)size->height_px * sizeof *rays);
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++)
            cupola_dome_ray(oracle, 0, NULL, i + 0.5, j + 0.5, &rays[j * size->width_px + i]);
    return rays;
}

static struct table_error table_error_of(const struct fixture *fixture, int stage,
                                         const struct cupola_ray *rays, GLuint table)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    struct table_error error = {0.0, 0.0, 0};
    float *entries = texture_read(table, size->width_px, size->height_px);
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            const struct cupola_ray *ray = &rays[j * size->width_px + i];
            double coverage;
            double off =
                entry_error(fixture, stage, ray, entries + 4 * (j * size->width_px + i), &coverage);
            double uncovered = fabs(coverage - ray->coverage);
            error.coverage = worse_of(error.coverage, uncovered);
            if (ray->coverage < 0.01)
                continue; /* no one looks there, and sines times nothing have no angle */
            error.main = worse_of(error.main, off);
            error.lit++;
        }
    free(entries);
    return error;
}

static void every_table_holds_what_the_c_functions_say(void **state)
{
    (void)state;
    double worst[STAGES] = {0.0}, worst_coverage = 0.0;
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(number);
        struct fixture fixture;
        fixture_make(&rig, NULL, NULL, &fixture);
        struct cupola_ray *rays = rays_of(fixture.dome);
        for (int stage = 0; stage < STAGES; stage++) {
            if (!has_table(stage))
                continue;
            set_stage(&fixture, stage);
            struct table_error error =
                table_error_of(&fixture, stage, rays, fixture_table(&fixture, 0));
            check_at_least(error.lit, 500);
            check_at_most(error.main, bar_of(stage));
            check_at_most(error.coverage, bar_coverage);
            worst[stage] = fmax(worst[stage], error.main);
            worst_coverage = fmax(worst_coverage, error.coverage);
        }
        test_free(rays);
        fixture_release(&fixture);
    }
    printf("points %.2g R, angles %.2g rad, sines %.2g rad, coordinates %.2g texels, coverage "
           "%.2g\n",
           worst[CUPOLA_TABLE_POINTS], worst[CUPOLA_TABLE_ANGLES], worst[CUPOLA_TABLE_SINES],
           worst[CUPOLA_TABLE_COORDINATES], worst_coverage);
}

/* As they are where a GL cannot draw into floats. */
static void tables_made_on_the_cpu_hold_the_same(void **state)
{
    (void)state;
    for (int number = 0; number < RIGS; number += 5) {
        struct cupola_rig rig = rig_number(number);
        struct fixture fixture;
        fixture_make(&rig, NULL, NULL, &fixture);
        struct cupola_ray *rays = rays_of(fixture.dome);
        for (int stage = 0; stage < STAGES; stage++) {
            if (!has_table(stage))
                continue;
            GLuint table = fixture_table_by_cpu(&fixture, 0, (enum cupola_table)stage);
            struct table_error error = table_error_of(&fixture, stage, rays, table);
            glDeleteTextures(1, &table);
            check_at_most(error.main, bar_of(stage));
            check_at_most(error.coverage, bar_coverage);
        }
        test_free(rays);
        fixture_release(&fixture);
    }
}

static void points_for_hosts_that_cast_rays_are_the_same_in_every_stage(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(9);
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    struct cupola_ray *rays = rays_of(fixture.dome);
    for (int stage = 0; stage < STAGES; stage++) {
        unsigned int points = 0;
        set_stage(&fixture, stage);
        assert_int_equal(cupola_gl_points(fixture.gl, 0, &points, NULL), CUPOLA_OK);
        struct table_error error = table_error_of(&fixture, CUPOLA_TABLE_POINTS, rays, points);
        check_at_most(error.main, bar_rad);
        check_at_most(error.coverage, bar_coverage);
    }
    test_free(rays);
    fixture_release(&fixture);
}

static void a_table_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(8), turned = rig, shifted = rig;
    cupola_dome *turned_dome = NULL, *shifted_dome = NULL;
    struct fixture fixture;
    turned.outputs[0].aim.yaw_rad += radians(0.1);
    shifted.outputs[0].circle.center_x_px += 1.0;
    assert_int_equal(cupola_dome_create(&turned, &turned_dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_dome_create(&shifted, &shifted_dome, NULL), CUPOLA_OK);
    struct cupola_ray *turned_rays = rays_of(turned_dome);
    struct cupola_ray *shifted_rays = rays_of(shifted_dome);
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int stage = 0; stage < STAGES; stage++) {
        if (!has_table(stage))
            continue;
        set_stage(&fixture, stage);
        GLuint table = fixture_table(&fixture, 0);
        struct table_error error = table_error_of(&fixture, stage, turned_rays, table);
        check_at_least(error.main, 2.0 * bar_of(stage));
        error = table_error_of(&fixture, stage, shifted_rays, table);
        check_at_least(error.main, 2.0 * bar_of(stage));
        check_at_least(error.coverage, 2.0 * bar_coverage);
    }
    test_free(turned_rays);
    test_free(shifted_rays);
    fixture_release(&fixture);
    cupola_dome_destroy(&turned_dome);
    cupola_dome_destroy(&shifted_dome);
}

/* Largest difference of a channel between two images; alpha is the coverage. */
static double difference(const float *a, const float *b, size_t pixels)
{
    double worst = 0.0;
    for (size_t i = 0; i < 4 * pixels; i++)
        worst = worse_of(worst, fabs((double)a[i] - (double)b[i]));
    return worst;
}

/* Colours are directions: what differs is an angle in rad, with the bar of the tables. */
static void every_stage_shows_the_same_image(void **state)
{
    (void)state;
    double worst = 0.0;
    for (int number = 0; number < RIGS; number += 2) {
        struct cupola_rig rig = rig_number(number);
        size_t pixels = (size_t)rig.outputs[0].width_px * (size_t)rig.outputs[0].height_px;
        struct fixture fixture;
        float *first = NULL;
        fixture_make(&rig, NULL, NULL, &fixture);
        for (int stage = 0; stage < STAGES; stage++) {
            set_stage(&fixture, stage);
            fixture_paint(&fixture, PAINT_DIRECTIONS);
            float *image = fixture_warp(&fixture, 0);
            if (!first) {
                first = image;
                continue;
            }
            worst = worse_of(worst, difference(first, image, pixels));
            free(image);
        }
        free(first);
        fixture_release(&fixture);
    }
    printf("images of all stages at most %.2g apart\n", worst);
    check_at_most(worst, bar_rad);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_table_holds_what_the_c_functions_say),
        cmocka_unit_test(tables_made_on_the_cpu_hold_the_same),
        cmocka_unit_test(points_for_hosts_that_cast_rays_are_the_same_in_every_stage),
        cmocka_unit_test(a_table_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(every_stage_shows_the_same_image),
    };
    return run_gpu_group("stages", tests);
}
