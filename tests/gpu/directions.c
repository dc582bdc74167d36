/*
 * Every pixel shows the direction that it should: colour = direction, warped, against the rays of
 * the dome in double precision.
 *
 * The default form covers every pair of properties of a theatre (see cases.h). The long form, all
 * combinations of lens, fov, layout, views, size and eye, some thousands of theatres, runs where
 * the environment has CUPOLA_LONG=1.
 *
 * Bars: 0.01 degrees and 0.05 px everywhere. What is left below them is the bilinear mixing of unit
 * vectors that are not linear in the texture: between texels t rad apart they bend by up to 0.65
 * t^2 / 8 rad each way, so the coarse pixels of an eye close to the screen have most. GPUs that
 * filter with weights of 8 bits add 1/512 px.
 */
#include <stdio.h>
#include <stdlib.h>

#include "cases.h"
#include "context.h"
#include "direction_error.h"
#include "group.h"
#include "rig_random.h"

static const double bar_deg = 0.01, bar_px = 0.05;
/* The two differ by chance, too: where the largest of few pixels is compared with that of many. */
static const double bar_border_ratio = 1.2, border_floor_px = 0.0005;

struct worst {
    double deg, px, border_ratio;
    long pixels;
    int failures;
    int visited;
};

/* The geometry is the same in both: OpenGL ES sees the first theatres. */
enum { ES_THEATRES = 16 };

static void judge(const struct theatre_case *theatre, int output,
                  const struct direction_error *error, struct worst *worst)
{
    double ratio = error->border_px / fmax(error->interior_px, border_floor_px);
    worst->deg = fmax(worst->deg, error->deg);
    worst->px = fmax(worst->px, error->px);
    worst->border_ratio = fmax(worst->border_ratio, ratio);
    worst->pixels += error->pixels;
    if (error->deg <= bar_deg && error->px <= bar_px && ratio <= bar_border_ratio &&
        error->pixels > 0)
        return;
    print_error("output %d: %g deg at (%d, %d), %g px at (%d, %d), %g px at view borders, %g px "
                "elsewhere, %d pixels: %s\n",
                output, error->deg, error->deg_at[0], error->deg_at[1], error->px, error->px_at[0],
                error->px_at[1], error->border_px, error->interior_px, error->pixels,
                theatre->text);
    worst->failures++;
}

static bool visit_directions(const struct theatre_case *theatre, cupola_plan *plan, void *user)
{
    struct worst *worst = user;
    struct fixture fixture;
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F, .table = theatre->stage};
    fixture_make_of_plan(plan, &params, &fixture);
    fixture_paint(&fixture, PAINT_DIRECTIONS);
    for (int output = 0; output < theatre->rig.output_count; output++) {
        float *image = fixture_warp(&fixture, output);
        struct direction_error error = direction_error_of(&fixture, output, image, fixture.dome);
        free(image);
        judge(theatre, output, &error, worst);
    }
    fixture_release(&fixture);
    return !context_is_es() || ++worst->visited < ES_THEATRES;
}

static void every_pixel_shows_its_direction_at_view_borders_as_elsewhere(void **state)
{
    (void)state;
    struct worst worst = {0};
    const char *wish = getenv("CUPOLA_LONG");
    bool all = wish && strcmp(wish, "1") == 0;
    struct case_count count = all ? cases_matrix(2001, visit_directions, &worst)
                                  : cases_pairwise(2001, visit_directions, &worst);
    printf(
        "%d theatres, %d pairs of properties, %d refused; %ld pixels: at most %.3g deg, %.3g px, "
        "at view borders %.3g of that elsewhere\n",
        count.cases, count.pairs, count.refused_pairs, worst.pixels, worst.deg, worst.px,
        worst.border_ratio);
    assert_int_equal(worst.failures, 0);
    if (!all && !context_is_es())
        assert_int_equal(count.refused_pairs, 1); /* hemispheric with 220 degrees */
}

/* The metric of an image of `rig` by the rays of another one. */
static struct direction_error error_against(const struct fixture *fixture, const float *image,
                                            const struct cupola_rig *wrong)
{
    struct cupola_error refusal = {CUPOLA_OK, ""};
    cupola_dome *oracle = NULL;
    if (cupola_dome_create(wrong, &oracle, &refusal) < 0)
        fail_msg("%s", refusal.message);
    struct direction_error error = direction_error_of(fixture, 0, image, oracle);
    cupola_dome_destroy(&oracle);
    return error;
}

static void a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 2002;
    for (int model = 0; cupola_lens_model_name(model); model++) {
        struct fixture fixture;
        struct cupola_rig rig = random_rig(&seed, 0.3), wrong;
        struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F};
        rig.outputs[0].width_px = 317;
        rig.outputs[0].height_px = 241;
        rig.outputs[0].circle = (struct cupola_circle){158.5, 120.5, 120.5};
        rig.outputs[0].lens = random_lens(&seed, (enum cupola_lens_model)model, radians(150.0));
        fixture_make(&rig, NULL, &params, &fixture);
        fixture_paint(&fixture, PAINT_DIRECTIONS);
        float *image = fixture_warp(&fixture, 0);
        struct direction_error error = error_against(&fixture, image, &rig);
        check_at_most(error.deg, bar_deg);
        check_at_most(error.px, bar_px);

        wrong = rig;
        wrong.outputs[0].aim.yaw_rad += radians(0.1);
        error = error_against(&fixture, image, &wrong);
        check_at_least(error.deg, 2.0 * bar_deg);
        check_at_least(error.px, 2.0 * bar_px);
        wrong = rig;
        wrong.tilt_rad += radians(0.1);
        check_at_least(error_against(&fixture, image, &wrong).deg, 2.0 * bar_deg);
        wrong = rig;
        wrong.outputs[0].circle.center_x_px += 1.0;
        check_at_least(error_against(&fixture, image, &wrong).px, 2.0 * bar_px);
        wrong = rig;
        wrong.outputs[0].circle.radius_px += 1.0;
        check_at_least(error_against(&fixture, image, &wrong).px, 2.0 * bar_px);
        wrong = rig;
        wrong.eye_m[1] += 0.002 * rig.screen.radius_m; /* seen under 0.1 degrees from 1.15 R */
        check_at_least(error_against(&fixture, image, &wrong).deg, 2.0 * bar_deg);
        if (model != CUPOLA_LENS_TABLE) {
            wrong = rig;
            wrong.outputs[0].lens.fov_rad += radians(0.1);
            check_at_least(error_against(&fixture, image, &wrong).deg, 2.0 * bar_deg);
        }
        free(image);
        fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_shows_its_direction_at_view_borders_as_elsewhere),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught),
    };
    return run_gpu_group("directions", tests);
}
