/*
 * Masks where rays turn far from pixel to pixel: images and circles of a few pixels, of every lens,
 * with eye and projector off axis. Of views in one colour every texel that a pixel's filter may
 * touch has been drawn, and no image shows that there is a mask.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "geometry/vector.h"
#include "mask_left.h"
#include "rig_random.h"
#include "triangles_group.h"

enum { RIGS = 36, SIZE_MOST_PX = 8 };

static const struct cupola_depth plain = {.near_distance = 0};

struct sums {
    int tried, failures, seen;
    double left, all;
};

static double most_fov_deg(enum cupola_lens_model model)
{
    switch (model) {
    case CUPOLA_LENS_HEMISPHERIC:
        return 178;
    case CUPOLA_LENS_POLYNOMIAL:
        return 220; /* to where random ones increase */
    default:
        return 320;
    }
}

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 4401 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, 0.7);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    struct cupola_output *output = &rig.outputs[0];
    double most_deg = most_fov_deg(model), radius_px = 0;
    double fov_deg = random_between(&seed, 0.6 * most_deg, most_deg);
    rig.screen.cap_rad = number % 4 == 3 ? radians(random_between(&seed, 40, 170)) : 0;
    rig.output_count = 1;
    output->lens = random_lens(&seed, model, radians(fov_deg));
    output->width_px = random_int(&seed, 1, number % 7 ? SIZE_MOST_PX : 70);
    output->height_px = random_int(&seed, 1, SIZE_MOST_PX);
    memset(&output->circle, 0, sizeof output->circle);
    if (number % 3) {
        double span = number % 3 == 1 ? -1.5 : 1.0; /* tiny, or of the image's size */
        radius_px = pow(10, random_between(&seed, span - 0.5, 0.5));
        output->circle = (struct cupola_circle){
            .center_x_px = random_between(&seed, 0, output->width_px),
            .center_y_px = random_between(&seed, 0, output->height_px),
            .radius_px = radius_px,
        };
    }
    return rig;
}

static cupola_plan *plan_number(int number)
{
    struct cupola_rig rig = rig_number(number);
    struct cupola_plan_params params = {
        .guard_px = 1 + number % 2,
        .density = number % 5 == 4 ? 2.3 : 0,
        .head_radius_m = number % 5 == 2 ? 0.1 * rig.screen.radius_m : 0,
    };
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    if (cupola_dome_create(&rig, &dome, NULL) == CUPOLA_OK)
        cupola_plan_create(dome, &params, &plan, NULL); /* some are too steep, or have no light */
    cupola_dome_destroy(&dome);
    return plan;
}

/*
 * Whether every pixel's ray falls into its view's rectangle. Of pixels that a cap's edge cuts the
 * middle may lie far beyond it, where views need not reach.
 */
static bool reaches_all(const cupola_plan *plan)
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_output *output = &cupola_dome_rig(dome)->outputs[0];
    for (int i = 0; i < output->width_px * output->height_px; i++) {
        struct cupola_ray ray;
        double texel[2], x_px = i % output->width_px + 0.5,
                         y_px = i / output->width_px + 0.5; /* whole rows */
        if (cupola_dome_ray(dome, 0, NULL, x_px, y_px, &ray) != 1)
            continue;
        int view = cupola_plan_select(plan, ray.direction);
        const struct cupola_rect *rect = &cupola_plan_view(plan, view)->rect;
        if (cupola_plan_texel(plan, view, ray.direction, texel) != 1 || texel[0] < rect->x + 0.5 ||
            texel[1] < rect->y + 0.5 || texel[0] > rect->x + rect->width - 0.5 ||
            texel[1] > rect->y + rect->height - 0.5)
            return false;
    }
    return true;
}

/* The greatest difference of two images. */
static double apart(const float *a, const float *b, int count)
{
    double most = 0;
    for (int i = 0; i < count; i++)
        most = fmax(most, fabs((double)a[i] - (double)b[i]));
    return most;
}

/* Another eye, where the head may move. */
static void move(struct fixture *fixture, int number)
{
    uint64_t seed = 4471 + (uint64_t)number;
    double eye_m[3];
    random_in_ball(&seed, fixture->plan->head_radius_m, eye_m);
    for (int i = 0; i < 3; i++)
        eye_m[i] += cupola_dome_rig(fixture->dome)->eye_m[i];
    assert_int_equal(cupola_plan_set_eye(fixture->plan, eye_m, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_eye(fixture->gl, eye_m, NULL), CUPOLA_OK);
}

/* All views of a GL side in one colour, without those that are left out. */
static float *draw(struct fixture *fixture, int number, enum cupola_mask mask, bool without_first,
                   struct texels_left *count)
{
    static const enum cupola_table stages[] = {CUPOLA_TABLE_NONE, CUPOLA_TABLE_TILES,
                                               CUPOLA_TABLE_POINTS};
    const struct cupola_gl_params params = {.mask = mask, .table = stages[number % 3]};
    fixture_replace_gl(fixture, &params);
    if (fixture->plan->head_radius_m > 0)
        move(fixture, number);
    draw_red_views(&triangles, fixture->gl, fixture->plan, &plain, CUPOLA_MASK_DEPTH);
    if (without_first) {
        assert_int_equal(cupola_gl_view_begin(fixture->gl, 0, NULL, NULL), CUPOLA_OK);
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    float *atlas = fixture_atlas(fixture);
    *count = texels_count(fixture->plan, atlas, false);
    free(atlas);
    return fixture_warp(fixture, 0);
}

static void check_rig(struct fixture *fixture, int number, struct sums *sums)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    int values = 4 * size->width_px * size->height_px;
    struct texels_left masked, all, control;
    float *image = draw(fixture, number, CUPOLA_MASK_DEPTH, false, &masked);
    float *whole = draw(fixture, number, CUPOLA_MASK_NONE, false, &all);
    float *wrong = draw(fixture, number, CUPOLA_MASK_NONE, true, &control);
    double difference = apart(image, whole, values);
    if (masked.missing || difference > 1e-5) {
        print_error("rig %d: %d of %d texels are missing, images are %g apart\n", number,
                    masked.missing, masked.needed, difference);
        sums->failures++;
    }
    sums->seen += control.missing > 0 || apart(wrong, whole, values) > 1e-3;
    sums->left += masked.left;
    sums->all += all.left;
    sums->tried++;
    free(image);
    free(whole);
    free(wrong);
}

static void no_mask_takes_what_coarse_pixels_sample(void **state)
{
    const char *wish = getenv("CUPOLA_LONG");
    int rigs = wish && strcmp(wish, "1") == 0 ? 20 * RIGS : RIGS;
    struct sums sums = {.tried = 0};
    (void)state;
    for (int number = 0; number < rigs; number++) {
        struct fixture fixture;
        cupola_plan *plan = plan_number(number);
        if (!plan || !reaches_all(plan)) {
            cupola_plan_destroy(&plan);
            continue;
        }
        fixture_make_of_plan(plan, NULL, &fixture);
        check_rig(&fixture, number, &sums);
        fixture_release(&fixture);
    }
    printf("%d rigs: %.3f of the texels are left; a view that is not drawn is seen in %d\n",
           sums.tried, sums.left / sums.all, sums.seen);
    assert_int_equal(sums.failures, 0);
    check_at_least(sums.tried, 0.5 * rigs);
    check_at_least(sums.seen, 0.75 * sums.tried);
    check_at_most(sums.left / sums.all, 0.95);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_mask_takes_what_coarse_pixels_sample),
    };
    return run_triangles_group("mask_coarse", tests);
}
