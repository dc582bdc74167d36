/*
 * A viewer who moves, with every filter that sends out rays: after cupola_gl_set_eye the image is
 * that of a gl that was made for the eye's place, and that of the C reference of the moved plan.
 */
#include <stdlib.h>

#include "eye_theatres.h"
#include "filter_cases.h"
#include "group.h"
#include "worse.h"

/* One gl has the eye's place as a uniform, the other as a constant. */
static const double bar = 0.001;

/* Two for each theatre, without a table and by tiles. */
static const struct cupola_filter moved_filters[] = {
    {.method = CUPOLA_ANTIALIASING_CONE},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE},
};

static float *noise_shown(const struct fixture *fixture)
{
    fixture_paint(fixture, PAINT_NOISE);
    return fixture_warp(fixture, 0);
}

/* Pixels that differ. Freed: b. */
static int pixels_unlike(const struct fixture *fixture, const float *a, float *b)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    int unlike = 0;
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        double off = 0.0;
        for (int c = 0; c < 4; c++)
            off = worse_of(off, fabs((double)a[4 * i + c] - (double)b[4 * i + c]));
        unlike += !(off <= bar);
    }
    free(b);
    return unlike;
}

static float *reference_of(const struct fixture *fixture, const struct cupola_filter *filter)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *atlas = fixture_atlas(fixture);
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    assert_int_equal(cupola_reference_filter(fixture->plan, 0, filter, atlas, NULL, image),
                     CUPOLA_OK);
    free(atlas);
    return image;
}

/* As in filter_reference.c: where a number is rounded either may be right. */
static const int tolerated = 2 + 128 * 128 / 2000;

static void check_move(const struct eye_theatre *theatre, struct fixture *fixture,
                       const struct cupola_filter *filter, enum cupola_table stage,
                       const double eye_m[3])
{
    struct cupola_gl_params params = {
        .format = CUPOLA_FORMAT_RGBA32F, .filter = *filter, .table = stage};
    assert_int_equal(cupola_plan_set_eye(fixture->plan, theatre->rig.eye_m, NULL), CUPOLA_OK);
    fixture_replace_gl(fixture, &params);
    float *before = noise_shown(fixture);
    assert_int_equal(cupola_gl_set_eye(fixture->gl, eye_m, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_set_eye(fixture->plan, eye_m, NULL), CUPOLA_OK);
    float *moved = noise_shown(fixture);
    int from_reference = pixels_unlike(fixture, moved, reference_of(fixture, filter));
    fixture_replace_gl(fixture, &params);
    int from_fresh = pixels_unlike(fixture, moved, noise_shown(fixture));
    if (from_reference > tolerated || from_fresh > tolerated)
        fail_msg("%s, %s: %d pixels unlike the reference, %d unlike a fresh gl",
                 filter_text(filter), cupola_table_name((int)stage), from_reference, from_fresh);
    /* The control: what was shown from the old place. */
    check_at_least(pixels_unlike(fixture, moved, before), 100 * tolerated);
    free(moved);
}

static void a_moved_eye_is_like_one_that_was_there_from_the_start(void **state)
{
    (void)state;
    uint64_t seed = 4105;
    if (!context_has_floats())
        skip();
    for (int number = 0; number < 2; number++) {
        const struct eye_theatre theatre = eye_theatre(3 * number);
        struct fixture fixture;
        fixture_make(&theatre.rig, &theatre.params, NULL, &fixture);
        for (int k = 0; k < 2; k++) {
            double eye_m[3];
            eye_place(&theatre, &seed, true, eye_m);
            check_move(&theatre, &fixture, &moved_filters[2 * number + k], filter_stages[k], eye_m);
        }
        fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_moved_eye_is_like_one_that_was_there_from_the_start),
    };
    return run_gpu_group("filter_eye", tests);
}
