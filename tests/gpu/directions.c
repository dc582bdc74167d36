/*
 * Every pixel shows the direction that it should: colour = direction, warped, against the rays of
 * the dome in double precision.
 *
 * The default form covers every pair of properties of a theatre (see cases.h). The long form, all
 * combinations of lens, fov, layout, views, size and eye (some thousands of theatres, the better
 * part of an hour), runs where the environment has CUPOLA_LONG=1.
 *
 * Bars, of docs/geometry.md: 0.01 degrees and 0.05 px. What is left below them is the bilinear mixing
 * of unit vectors that are not linear in the texture: a texel of t rad bends by at most t^2 / 8 in
 * each direction.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"
#include "check.h"
#include "context.h"
#include "direction_error.h"

static const double bar_deg = 0.01, bar_px = 0.05;

struct worst {
    struct direction_error error;
    double border_ratio;
    int failures;
};

static void visit_directions(const struct theatre_case *theatre, cupola_plan *plan, void *user)
{
    struct worst *worst = user;
    struct fixture fixture;
    struct cupola_gl_params params = {CUPOLA_FORMAT_RGBA32F, theatre->stage, {0}};
    fixture_make_of_plan(plan, &params, &fixture);
    fixture_paint(&fixture, PAINT_DIRECTIONS);
    for (int output = 0; output < theatre->rig.output_count; output++) {
        float *image = fixture_warp(&fixture, output);
        struct direction_error error = direction_error_of(&fixture, output, image, fixture.dome);
        free(image);
        if (getenv("SHOW")) printf("%g deg %g px in %g border %g: %s\n", error.deg, error.px, error.interior_px, error.border_px, theatre->text);
        if (!(error.deg <= bar_deg && error.px <= bar_px)) {
            print_error("output %d: %g deg at (%d, %d), %g px at (%d, %d): %s\n", output, error.deg,
                        error.deg_at[0], error.deg_at[1], error.px, error.px_at[0], error.px_at[1],
                        theatre->text);
            worst->failures++;
        }
    }
    fixture_release(&fixture);
}

static void every_pixel_shows_its_direction(void **state)
{
    (void)state;
    struct worst worst = {0};
    const char *wish = getenv("CUPOLA_LONG");
    bool all = wish && strcmp(wish, "1") == 0;
    struct case_count count = all ? cases_matrix(2001, visit_directions, &worst)
                                  : cases_pairwise(2001, visit_directions, &worst);
    printf("%d theatres, %d pairs, %d of them refused\n", count.cases, count.pairs,
           count.refused_pairs);
    assert_int_equal(worst.failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_shows_its_direction),
    };
    context_open();
    int failures = cmocka_run_group_tests_name("directions", tests, NULL, NULL);
    fixture_forget_programs();
    context_close();
    return failures;
}
