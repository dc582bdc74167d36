/*
 * The mask of the views: whatever a pixel's filter may touch is left free, guard band included, and
 * little more is.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "geometry/mask.h"
#include "rig_random.h"

enum { RIGS = 36, HEADS = 6, EYES = 2, PLACES = 5 };

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 9301 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, number % 2 ? 0.5 : 0.0);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    double fov_deg =
        model == CUPOLA_LENS_HEMISPHERIC ? 178.0 : (double[]){140, 180, 220}[number % 3];
    rig.output_count = number % 5 == 4 ? 2 : 1;
    for (int i = 0; i < rig.output_count; i++) {
        rig.outputs[i].lens = random_lens(&seed, model, radians(fov_deg));
        rig.outputs[i].width_px = 203;
        rig.outputs[i].height_px = 157;
        rig.outputs[i].circle = (struct cupola_circle){100.0, 80.0, number % 3 ? 77.0 : 120.0};
    }
    rig.screen.cap_rad = number % 4 == 3 ? radians(70.0) : 0.0;
    return rig;
}

static cupola_plan *plan_of_rig(const struct cupola_rig *rig,
                                const struct cupola_plan_params *params)
{
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_dome_create(rig, &dome, &error) < 0)
        fail_msg("%s", error.message);
    cupola_plan_create(dome, params, &plan, NULL); /* a few have nothing lit, or are too steep */
    cupola_dome_destroy(&dome);
    return plan;
}

/* ---- the shapes by an own rasteriser ---- */

/* Whether a place is in a triangle or on its edge. */
static bool in_triangle(const struct mask_vertex *v, double x, double y)
{
    int sides[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        const struct mask_vertex *a = &v[i], *b = &v[(i + 1) % 3];
        double cross = ((double)b->x - (double)a->x) * (y - (double)a->y) -
                       ((double)b->y - (double)a->y) * (x - (double)a->x);
        sides[0] += cross > 0;
        sides[1] += cross < 0;
    }
    return sides[0] == 0 || sides[1] == 0;
}

static double edge(const struct mask_vertex *v, int axis, bool most)
{
    double found = axis ? (double)v[0].y : (double)v[0].x;
    for (int i = 1; i < 3; i++) {
        double at = axis ? (double)v[i].y : (double)v[i].x;
        found = most ? fmax(found, at) : fmin(found, at);
    }
    return found;
}

/* Whether the shapes cover the middle of each texel of a view, or any of many places in it. */
static unsigned char *covered(const struct mask *mask, int view)
{
    const struct mask_texels *texels = &mask->texels[view];
    static const double spread[PLACES] = {0.001, 0.25, 0.5, 0.75, 0.999};
    int width = texels->width, height = texels->height;
    int places = mask->middles ? 1 : 1 + PLACES * PLACES;
    unsigned char *found = calloc((size_t)width * (size_t)height, 1);
    assert_non_null(found);
    for (int i = 0; i < mask->count[view]; i += 3) {
        const struct mask_vertex *v = &mask->vertices[mask->first[view] + i];
        int left = (int)fmax(edge(v, 0, false) - texels->x, 0);
        int right = (int)fmin(edge(v, 0, true) - texels->x, width - 1);
        int bottom = (int)fmax(edge(v, 1, false) - texels->y, 0);
        int top = (int)fmin(edge(v, 1, true) - texels->y, height - 1);
        for (int y = bottom; y <= top; y++)
            for (int x = left; x <= right; x++)
                for (int k = 0; k < places && !found[y * width + x]; k++)
                    found[y * width + x] =
                        in_triangle(v, texels->x + x + (k ? spread[(k - 1) % PLACES] : 0.5),
                                    texels->y + y + (k ? spread[(k - 1) / PLACES] : 0.5));
    }
    return found;
}

/* ---- what pixels need ---- */

struct findings {
    long pixels, needed, marked, left, all;
    int missing; /* texels that are needed and not marked */
    int covered; /* or are not left free */
};

/* All texels whose middles are within `reach` of a place. */
static void need_round(const struct mask_texels *texels, const double texel[2], double reach,
                       unsigned char *needed)
{
    int bottom = (int)ceil(texel[1] - reach - 0.5), top = (int)floor(texel[1] + reach - 0.5);
    int left = (int)ceil(texel[0] - reach - 0.5), right = (int)floor(texel[0] + reach - 0.5);
    for (int y = bottom < 0 ? 0 : bottom; y <= top && y < texels->height; y++)
        for (int x = left < 0 ? 0 : left; x <= right && x < texels->width; x++)
            needed[y * texels->width + x] = 1;
}

static void need_pixels(const cupola_plan *plan, const struct mask *mask, double reach,
                        unsigned char *needed[CUPOLA_VIEWS_MAX], struct findings *findings)
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    for (int o = 0; o < rig->output_count; o++)
        for (int i = 0; i < rig->outputs[o].width_px * rig->outputs[o].height_px; i++) {
            struct cupola_ray ray;
            double texel[2];
            int width = rig->outputs[o].width_px;
            if (cupola_dome_ray(dome, o, NULL, i % width + 0.5, i / width + 0.5, &ray) != 1)
                continue;
            findings->pixels++;
            int view = cupola_plan_select(plan, ray.direction);
            const struct cupola_rect *rect = &cupola_plan_view(plan, view)->rect;
            assert_int_equal(cupola_plan_texel(plan, view, ray.direction, texel), 1);
            texel[0] -= rect->x;
            texel[1] -= rect->y;
            need_round(&mask->texels[view], texel, reach, needed[view]);
        }
}

static void judge(const cupola_plan *plan, const struct mask *mask, double reach,
                  struct findings *findings)
{
    unsigned char *needed[CUPOLA_VIEWS_MAX] = {NULL};
    for (int v = 0; v < cupola_plan_view_count(plan); v++) {
        needed[v] = calloc((size_t)mask->texels[v].width * (size_t)mask->texels[v].height, 1);
        assert_non_null(needed[v]);
    }
    need_pixels(plan, mask, reach, needed, findings);
    for (int v = 0; v < cupola_plan_view_count(plan); v++) {
        const struct mask_texels *texels = &mask->texels[v];
        unsigned char *shapes = covered(mask, v);
        for (int i = 0; i < texels->width * texels->height; i++) {
            bool marked = mask_needs(texels, i % texels->width, i / texels->width);
            findings->all++;
            findings->needed += needed[v][i];
            findings->marked += marked;
            findings->left += !shapes[i];
            findings->missing += needed[v][i] && !marked;
            findings->covered += (needed[v][i] || marked) && shapes[i] > 0;
        }
        free(shapes);
        free(needed[v]);
    }
}

static struct cupola_plan_params wishes_number(int number)
{
    return (struct cupola_plan_params){
        .layout = number % 9 == 8 ? CUPOLA_LAYOUT_AUTO : CUPOLA_LAYOUT_ROTATED,
        .guard_px = 1 + number % 4,
        .density = number % 7 == 6 ? 2.5 : 0,
    };
}

static void masks_leave_free_what_any_pixel_needs(void **state)
{
    (void)state;
    struct findings sum = {0};
    int tried = 0;
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(number);
        struct cupola_plan_params params = wishes_number(number);
        struct cupola_error error;
        struct mask mask;
        cupola_plan *plan = plan_of_rig(&rig, &params);
        if (!plan)
            continue;
        assert_int_equal(mask_create(plan, number % 2, &mask, &error), CUPOLA_OK);
        judge(plan, &mask, params.guard_px, &sum);
        if (sum.missing || sum.covered)
            fail_msg("rig %d: %d texels are not marked, %d are covered", number, sum.missing,
                     sum.covered);
        mask_destroy(&mask);
        cupola_plan_destroy(&plan);
        tried++;
    }
    printf("  %d rigs, %ld pixels: of %ld texels %ld are needed and %ld left\n", tried, sum.pixels,
           sum.all, sum.needed, sum.left);
    check_at_least(tried, RIGS - 6);
    check_at_most((double)sum.left, 0.85 * (double)sum.all);
}

static void an_eye_that_moves_is_followed_to_the_texel(void **state)
{
    (void)state;
    uint64_t seed = 9777;
    int missed = 0;
    for (int number = 0; number < HEADS; number++) {
        struct cupola_rig rig = rig_number(3 * number + 1);
        struct cupola_plan_params params = wishes_number(number);
        struct cupola_error error = {CUPOLA_OK, ""};
        struct mask mask;
        params.head_radius_m = 0.2 * rig.screen.radius_m;
        cupola_plan *plan = plan_of_rig(&rig, &params);
        if (!plan)
            continue;
        assert_int_equal(mask_create(plan, number % 2, &mask, &error), CUPOLA_OK);
        for (int eye = 0; eye < EYES; eye++) {
            double place[3];
            struct findings findings = {0}, stale = {0};
            random_in_ball(&seed, params.head_radius_m, place);
            for (int i = 0; i < 3; i++)
                place[i] += rig.eye_m[i];
            assert_int_equal(cupola_plan_set_eye(plan, place, &error), CUPOLA_OK);
            judge(plan, &mask, params.guard_px, &stale);
            mask_refit(plan, &mask);
            judge(plan, &mask, params.guard_px, &findings);
            assert_int_equal(findings.missing + findings.covered, 0);
            missed += stale.missing;
        }
        mask_destroy(&mask);
        cupola_plan_destroy(&plan);
    }
    check_at_least(missed, 1000); /* the control: the masks of other eyes */
}

/* With all that is needed moved by some texels, or widened by less. */
static void masks_that_are_shifted_or_not_widened_are_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 256);
    struct cupola_error error;
    for (int wrong = 0; wrong < 3; wrong++) {
        struct findings findings = {0};
        struct mask mask;
        cupola_plan *plan = plan_of_rig(&rig, NULL);
        assert_non_null(plan);
        plan->guard_px -= wrong == 1;
        for (int v = 0; v < plan->view_count && wrong == 2; v++) {
            double texel = (plan->views[v].right - plan->views[v].left) / plan->views[v].rect.width;
            plan->views[v].left += texel;
            plan->views[v].right += texel;
        }
        assert_int_equal(mask_create(plan, true, &mask, &error), CUPOLA_OK);
        cupola_plan_destroy(&plan);
        plan = plan_of_rig(&rig, NULL);
        judge(plan, &mask, plan->guard_px, &findings);
        if (wrong)
            check_at_least(findings.missing, 100);
        else
            assert_int_equal(findings.missing + findings.covered, 0);
        mask_destroy(&mask);
        cupola_plan_destroy(&plan);
    }
}

/* Bars of what is left, at 140 degrees, angular, 1024 x 1024 px, guard band of 2. */
static void little_more_is_left_than_what_is_needed(void **state)
{
    static const struct {
        int views;
        double bar;
    } bars[] = {{3, 1.61}, {5, 1.36}, {0, 1.22}};
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 1024);
    for (int i = 0; i < 3; i++) {
        struct cupola_plan_params params = {.views = bars[i].views};
        struct findings findings = {0};
        struct cupola_error error;
        struct mask mask;
        cupola_plan *plan = plan_of_rig(&rig, &params);
        assert_non_null(plan);
        assert_int_equal(mask_create(plan, true, &mask, &error), CUPOLA_OK);
        judge(plan, &mask, params.guard_px, &findings);
        const struct cupola_plan_report *report = cupola_plan_report(plan);
        double left = (double)findings.left / report->pixels;
        printf("  %d views: %.4f texels per pixel are left, %.4f reported, of %.4f; %d triangles\n",
               report->views, left, report->texels_masked_per_pixel,
               report->texels_shaded_per_pixel, mask.vertex_count / 3);
        check_at_most(left, bars[i].bar);
        check_at_most(fabs(left / report->texels_masked_per_pixel - 1), 0.02);
        check_at_most(mask.vertex_count / 3, 1500);
        mask_destroy(&mask);
        cupola_plan_destroy(&plan);
    }
}

/* Any theatre, its image of that width. */
static struct cupola_rig rig_of_width(int number, int width_px)
{
    uint64_t seed = 3000 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, number % 2 ? 0.5 : 0.0);
    struct cupola_output *output = &rig.outputs[0];
    int height_px = (int)((double)output->height_px * width_px / output->width_px);
    assert_int_equal(cupola_output_resize(output, width_px, height_px, NULL), CUPOLA_OK);
    rig.screen.cap_rad = number % 4 == 3 ? radians(100.0) : 0.0;
    return rig;
}

static long texels_left(const struct mask *mask, const cupola_plan *plan)
{
    long left = 0;
    for (int v = 0; v < cupola_plan_view_count(plan); v++) {
        const struct mask_texels *texels = &mask->texels[v];
        for (int i = 0; i < texels->width * texels->height; i++)
            left += mask_needs(texels, i % texels->width, i / texels->width);
    }
    return left;
}

/* By how much more is left than a plan says; all that is sampled alone is far less. */
static double left_beyond_report(int number, int width_px)
{
    struct cupola_rig rig = rig_of_width(number, width_px);
    const struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ROTATED};
    struct cupola_error error;
    struct mask mask;
    cupola_plan *plan = plan_of_rig(&rig, &params);
    assert_non_null(plan);
    assert_int_equal(mask_create(plan, true, &mask, &error), CUPOLA_OK);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    double left = (double)texels_left(&mask, plan) / report->pixels;
    check_at_least(left / report->texels_sampled_per_pixel - 1, 0.025); /* the control */
    double beyond = left / report->texels_masked_per_pixel - 1;
    mask_destroy(&mask);
    cupola_plan_destroy(&plan);
    return beyond;
}

/* Squares' boxes are wide beside small images. */
static void a_plan_says_how_much_masks_leave(void **state)
{
    static const int numbers[] = {3, 11, 19, 27, 35}; /* off axis, with a cap */
    enum { TRIED = sizeof numbers / sizeof numbers[0] };
    double worst = 0, worst_small = 0, mean_small = 0;
    (void)state;
    for (int i = 0; i < TRIED; i++) {
        double beyond = left_beyond_report(numbers[i], 1024);
        double small = left_beyond_report(numbers[i], 128);
        check_at_least(fmin(beyond, small), -0.005);
        worst = fmax(worst, beyond);
        worst_small = fmax(worst_small, small);
        mean_small += small / TRIED;
    }
    printf("  %.1f %% more at most in 1024 px; %.1f in 128 px, %.1f in the mean\n", 100 * worst,
           100 * worst_small, 100 * mean_small);
    check_at_most(worst, 0.02);
    check_at_most(worst_small, 0.12);
    check_at_most(mean_small, 0.06);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(masks_leave_free_what_any_pixel_needs),
        cmocka_unit_test(an_eye_that_moves_is_followed_to_the_texel),
        cmocka_unit_test(masks_that_are_shifted_or_not_widened_are_caught),
        cmocka_unit_test(little_more_is_left_than_what_is_needed),
        cmocka_unit_test(a_plan_says_how_much_masks_leave),
    };
    return cmocka_run_group_tests_name("mask", tests, NULL, NULL);
}
