/*
 * A viewer who moves: after cupola_gl_set_eye every stage of tables shows what the reference does
 * by a plan that has been moved, and each pixel the direction that the moved eye should see there.
 * The bars are those of directions.c and warp_reference.c.
 */
#include <stdio.h>
#include <stdlib.h>

#include "direction_error.h"
#include "eye_theatres.h"
#include "gl/instance.h"
#include "group.h"
#include "plan_pixels.h"
#include "reference_error.h"
#include "worse.h"

static const double bar_deg = 0.01, bar_px = 0.05, bar_color = 0.004, bar_edge = 1e-4;
static const float border[4] = {0.1f, 0.9f, 0.3f, 0.6f};

enum { STAGES = CUPOLA_TABLE_TILES + 1, EYES = 2 };

static cupola_plan *plans[EYE_THEATRES];

/* A plan of one's own: they take long to make. */
static cupola_plan *plan_for(int number, const struct eye_theatre *theatre)
{
    cupola_plan *plan = malloc(sizeof *plan);
    assert_non_null(plan);
    if (!plans[number])
        plans[number] = plan_of(&theatre->rig, &theatre->params);
    assert_int_equal(plan_copy(plans[number], plan, NULL), CUPOLA_OK);
    return plan;
}

static int forget_plans(void **state)
{
    (void)state;
    for (int i = 0; i < EYE_THEATRES; i++)
        cupola_plan_destroy(&plans[i]);
    return 0;
}

static void make(int number, const struct eye_theatre *theatre, struct fixture *fixture)
{
    const struct cupola_gl_params params = {.table = CUPOLA_TABLE_NONE};
    fixture_make_of_plan(plan_for(number, theatre), &params, fixture);
}

/* A gl for a plan whose eye is in the middle again. */
static void set_stage(const struct eye_theatre *theatre, int stage, bool with_border,
                      struct fixture *fixture)
{
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F,
                                      .table = (enum cupola_table)stage};
    if (with_border)
        memcpy(params.border, border, sizeof params.border);
    assert_int_equal(cupola_plan_set_eye(fixture->plan, theatre->rig.eye_m, NULL), CUPOLA_OK);
    fixture_replace_gl(fixture, &params);
}

/* gl and, by itself, the plan that the oracles use. */
static void move_both(struct fixture *fixture, const double eye_m[3])
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_gl_set_eye(fixture->gl, eye_m, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    assert_int_equal(cupola_plan_set_eye(fixture->plan, eye_m, NULL), CUPOLA_OK);
}

static struct direction_error direction_error(const struct fixture *fixture, int output)
{
    float *image = fixture_warp(fixture, output);
    struct direction_error error =
        direction_error_of(fixture, output, image, cupola_plan_dome(fixture->plan));
    free(image);
    return error;
}

static struct image_error image_error(const struct fixture *fixture, int output)
{
    float *atlas = fixture_atlas(fixture), *shown = fixture_warp(fixture, output);
    const struct compared compared = {fixture->plan, atlas, border};
    float *expected = reference_image(&compared, output);
    struct image_error error = image_error_of(&compared, output, shown, expected);
    free(expected);
    free(shown);
    free(atlas);
    return error;
}

static void every_stage_shows_what_the_moved_reference_does(void **state)
{
    (void)state;
    double worst[STAGES] = {0.0};
    uint64_t seed = 4101;
    for (int number = 0; number < EYE_THEATRES; number++) {
        const struct eye_theatre theatre = eye_theatre(number);
        struct fixture fixture;
        make(number, &theatre, &fixture);
        for (int stage = 0; stage < STAGES; stage++) {
            set_stage(&theatre, stage, true, &fixture);
            for (int i = 0; i < EYES; i++) {
                double eye[3];
                eye_place(&theatre, &seed, i % 2 == 0, eye);
                move_both(&fixture, eye);
                fixture_paint(&fixture, PAINT_NOISE);
                for (int output = 0; output < theatre.rig.output_count; output++) {
                    struct image_error error = image_error(&fixture, output);
                    check_at_least(error.lit_pixels, 2000);
                    check_at_most(error.inside, bar_color);
                    check_at_most(error.edge, bar_color + bar_edge);
                    worst[stage] = worse_of(worst[stage], fmax(error.inside, error.edge));
                }
            }
        }
        fixture_release(&fixture);
    }
    for (int stage = 0; stage < STAGES; stage++)
        printf("  %s: at most %.2g apart\n", cupola_table_name(stage), worst[stage]);
}

static void every_pixel_shows_the_direction_that_the_moved_eye_sees(void **state)
{
    (void)state;
    double worst_deg[STAGES] = {0.0}, worst_px = 0.0;
    uint64_t seed = 4102;
    for (int number = 0; number < EYE_THEATRES; number++) {
        const struct eye_theatre theatre = eye_theatre(number);
        struct fixture fixture;
        make(number, &theatre, &fixture);
        for (int stage = 0; stage < STAGES; stage++) {
            set_stage(&theatre, stage, false, &fixture);
            for (int i = 0; i < EYES; i++) {
                double eye[3];
                eye_place(&theatre, &seed, i % 2 == 1, eye);
                move_both(&fixture, eye);
                fixture_paint(&fixture, PAINT_DIRECTIONS);
                for (int output = 0; output < theatre.rig.output_count; output++) {
                    struct direction_error error = direction_error(&fixture, output);
                    check_at_least(error.pixels, 2000);
                    check_at_most(error.deg, bar_deg);
                    check_at_most(error.px, bar_px);
                    worst_deg[stage] = worse_of(worst_deg[stage], error.deg);
                    worst_px = worse_of(worst_px, error.px);
                }
            }
        }
        fixture_release(&fixture);
    }
    for (int stage = 0; stage < STAGES; stage++)
        printf("  %s: at most %.4f degrees\n", cupola_table_name(stage), worst_deg[stage]);
    printf("  at most %.4f px\n", worst_px);
}

/* The controls: what stays behind is seen, the views, the warp of each stage, or all of it. */
static void what_does_not_move_is_seen(void **state)
{
    (void)state;
    uint64_t seed = 4103;
    for (int number = 0; number < EYE_THEATRES; number += 3) {
        const struct eye_theatre theatre = eye_theatre(number);
        struct fixture fixture;
        double eye[3];
        make(number, &theatre, &fixture);
        for (int stage = 0; stage < STAGES; stage++) {
            set_stage(&theatre, stage, false, &fixture);
            eye_place(&theatre, &seed, true, eye);
            fixture_paint(&fixture, PAINT_DIRECTIONS);
            move_both(&fixture, eye);
            check_at_least(direction_error(&fixture, 0).deg, 2.0 * bar_deg); /* old views */
            set_stage(&theatre, stage, false, &fixture);
            move_both(&fixture, eye);
            fixture_paint(&fixture, PAINT_DIRECTIONS);
            fixture.gl->passes[0].moves = fixture.gl->moves;
            check_at_least(direction_error(&fixture, 0).deg, 2.0 * bar_deg); /* old warp */
            fixture.gl->passes[0].moves--;
            check_at_most(direction_error(&fixture, 0).deg, bar_deg);
            set_stage(&theatre, stage, false, &fixture);
            assert_int_equal(cupola_plan_set_eye(fixture.plan, eye, NULL), CUPOLA_OK);
            fixture_paint(&fixture, PAINT_DIRECTIONS);
            check_at_least(direction_error(&fixture, 0).deg, 2.0 * bar_deg); /* old both */
        }
        fixture_release(&fixture);
    }
}

static void look(const cupola_plan *plan, const struct plan_pixel *pixel, void *user)
{
    double *least = user;
    (void)plan;
    *least = fmin(*least, smaller_singular_value(pixel->jacobian));
}

/* By the cameras that the host draws with; the plan that gl was made from is gone by then. */
static void no_pixel_gets_less_than_a_texel_wherever_the_eye_is(void **state)
{
    (void)state;
    uint64_t seed = 4104;
    for (int number = 0; number < EYE_THEATRES; number++) {
        const struct eye_theatre theatre = eye_theatre(number);
        struct fixture fixture;
        cupola_plan *plan = plan_for(number, &theatre);
        make(number, &theatre, &fixture);
        cupola_plan_destroy(&fixture.plan);
        for (int i = 0; i < EYES; i++) {
            double eye[3], least = 1e9;
            eye_place(&theatre, &seed, true, eye);
            assert_int_equal(cupola_gl_set_eye(fixture.gl, eye, NULL), CUPOLA_OK);
            assert_int_equal(cupola_plan_set_eye(plan, eye, NULL), CUPOLA_OK);
            visit_pixels(&fixture.gl->plan, look, &least);
            check_at_least(least, 1.0 - 1e-3);
            int views = cupola_gl_frame_begin(fixture.gl, NULL, NULL);
            for (int v = 0; v < views; v++) {
                struct cupola_gl_view view;
                struct cupola_camera camera;
                assert_int_equal(cupola_gl_view_begin(fixture.gl, v, &view, NULL), CUPOLA_OK);
                assert_int_equal(cupola_plan_camera(plan, v, NULL, &camera, NULL), CUPOLA_OK);
                assert_memory_equal(camera.view, view.camera.view, sizeof camera.view);
                assert_memory_equal(camera.projection, view.camera.projection,
                                    sizeof camera.projection);
                assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
            }
        }
        cupola_plan_destroy(&plan);
        fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_stage_shows_what_the_moved_reference_does),
        cmocka_unit_test(every_pixel_shows_the_direction_that_the_moved_eye_sees),
        cmocka_unit_test(what_does_not_move_is_seen),
        cmocka_unit_test_setup_teardown(no_pixel_gets_less_than_a_texel_wherever_the_eye_is, NULL,
                                        forget_plans),
    };
    return run_gpu_group("moving_eye", tests);
}
