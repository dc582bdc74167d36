/*
 * The mask of what no pixel samples, in theatres of every kind: of views that are drawn red all
 * over, with the test of depth, every texel that a pixel's filter may touch is red, guard band
 * included, and so is all of the dome's image; the others are shaded by nobody.
 */
#include <stdio.h>

#include "cases.h"
#include "group.h"
#include "mask_left.h"
#include "rig_random.h"

/* Every which theatre of the matrix is tried, and how many at most in OpenGL ES. */
enum { EVERY = 4, ES_THEATRES = 8, EYES = 3 };

static const struct cupola_depth plain = {.near_distance = 0};
static struct triangles triangles;

struct sums {
    int visited, tried, failures;
    double left, all;
};

/* The lit pixels of an image that are not red. */
static int pixels_missing(const struct fixture *fixture, int output, const float *image)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    int missing = 0;
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        struct cupola_ray ray;
        if (cupola_dome_ray(cupola_plan_dome(fixture->plan), output, NULL, i % size->width_px + 0.5,
                            i / size->width_px + 0.5, &ray) == 1 &&
            ray.coverage > 0.01)
            missing += fabs((double)image[4 * i] - ray.coverage) > 0.02;
    }
    return missing;
}

static int images_missing(const struct fixture *fixture)
{
    int missing = 0;
    for (int o = 0; o < cupola_dome_rig(fixture->dome)->output_count; o++) {
        float *image = fixture_warp(fixture, o);
        missing += pixels_missing(fixture, o, image);
        free(image);
    }
    return missing;
}

static bool visit(const struct theatre_case *theatre, cupola_plan *plan, void *user)
{
    struct sums *sums = user;
    struct cupola_gl_params params = {.table = theatre->stage};
    struct fixture fixture;
    if (sums->visited++ % EVERY) {
        cupola_plan_destroy(&plan);
        return true;
    }
    fixture_make_of_plan(plan, &params, &fixture);
    draw_red_views(&triangles, fixture.gl, plan, &plain, CUPOLA_MASK_DEPTH);
    float *atlas = fixture_atlas(&fixture);
    struct texels_left count = texels_count(plan, atlas);
    int missing = images_missing(&fixture);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    sums->left += count.left;
    sums->all += report->texels_shaded_per_pixel * report->pixels;
    if (count.missing || missing || count.needed == 0) {
        print_error("%d of %d texels and %d pixels are missing: %s\n", count.missing, count.needed,
                    missing, theatre->text);
        sums->failures++;
    }
    free(atlas);
    fixture_release(&fixture);
    return ++sums->tried < ES_THEATRES || !context_is_es();
}

static void no_mask_takes_what_a_pixel_samples(void **state)
{
    (void)state;
    struct sums sums = {0};
    cases_pairwise(2101, visit, &sums);
    printf("%d theatres: %.3f of the texels of views are left\n", sums.tried, sums.left / sums.all);
    assert_int_equal(sums.failures, 0);
    check_at_most(sums.left / sums.all, 0.9);
}

static void make_moving(struct fixture *fixture)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, 160);
    const struct cupola_plan_params params = {.head_radius_m = 0.25};
    const struct cupola_gl_params gl_params = {.table = CUPOLA_TABLE_NONE};
    rig.screen.radius_m = 1;
    fixture_make(&rig, &params, &gl_params, fixture);
}

/* The eye of both, and of the rays that are asked for. */
static void move_eye(struct fixture *fixture, const double eye_m[3], bool stale)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_plan_set_eye(fixture->plan, eye_m, &error) < 0 ||
        (!stale && cupola_gl_set_eye(fixture->gl, eye_m, &error) < 0))
        fail_msg("%s", error.message);
}

static void masks_follow_an_eye_that_moves(void **state)
{
    (void)state;
    uint64_t seed = 2102;
    struct fixture fixture;
    int stale_missing = 0;
    make_moving(&fixture);
    for (int stale = 1; stale >= 0; stale--)
        for (int eye = 0; eye < EYES; eye++) {
            double place[3];
            random_in_ball(&seed, fixture.plan->head_radius_m, place);
            move_eye(&fixture, place, stale);
            draw_red_views(&triangles, fixture.gl, fixture.plan, &plain, CUPOLA_MASK_DEPTH);
            float *atlas = fixture_atlas(&fixture);
            struct texels_left count = texels_count(fixture.plan, atlas);
            free(atlas);
            if (stale) { /* the control: of the eye before */
                stale_missing += count.missing;
                continue;
            }
            assert_int_equal(count.missing, 0);
            assert_int_equal(images_missing(&fixture), 0);
            check_at_most(count.left, 1.15 * count.needed);
        }
    check_at_least(stale_missing, 500);
    fixture_release(&fixture);
}

/* In the middle of a frame, where the first view has masked them all. */
static void masks_follow_an_eye_that_moves_from_view_to_view(void **state)
{
    (void)state;
    struct fixture fixture;
    make_moving(&fixture);
    int views = cupola_gl_frame_begin(fixture.gl, NULL, NULL);
    int width = cupola_plan_report(fixture.plan)->atlas_width_px;
    for (int i = 0; i < views; i++) {
        const struct cupola_rect *rect = &cupola_plan_view(fixture.plan, i)->rect;
        const double place[3] = {0.15 * (i % 3 - 1), 0.1 * (i % 2), 0.02 * i};
        int missing = 0;
        move_eye(&fixture, place, false);
        assert_int_equal(cupola_gl_view_begin(fixture.gl, i, NULL, NULL), CUPOLA_OK);
        draw_red(&triangles, fixture.plan, i, &plain, CUPOLA_MASK_DEPTH);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        unsigned char *needed = texels_needed(fixture.plan);
        float *atlas = fixture_atlas(&fixture);
        for (int t = 0; t < rect->width * rect->height; t++) {
            int at = (rect->y + t / rect->width) * width + rect->x + t % rect->width;
            missing += needed[at] && !(atlas[4 * at] > 0.999f);
        }
        assert_int_equal(missing, 0);
        free(needed);
        free(atlas);
    }
    fixture_release(&fixture);
}

/* A view that begins twice in a frame has its mask again. */
static void a_view_that_begins_again_is_masked_again(void **state)
{
    (void)state;
    struct fixture fixture;
    int left[2];
    make_moving(&fixture);
    draw_red_views(&triangles, fixture.gl, fixture.plan, &plain, CUPOLA_MASK_DEPTH);
    for (int again = 0; again < 2; again++) {
        float *atlas = fixture_atlas(&fixture);
        left[again] = texels_count(fixture.plan, atlas).left;
        free(atlas);
        for (int i = 0; i < cupola_plan_view_count(fixture.plan); i++) {
            assert_int_equal(cupola_gl_view_begin(fixture.gl, i, NULL, NULL), CUPOLA_OK);
            draw_red(&triangles, fixture.plan, i, &plain, CUPOLA_MASK_DEPTH);
            assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        }
    }
    assert_int_equal(left[0], left[1]);
    fixture_release(&fixture);
}

static int open_all(void **state)
{
    (void)state;
    triangles = triangles_create();
    return 0;
}

static int close_all(void **state)
{
    (void)state;
    triangles_release(&triangles);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_mask_takes_what_a_pixel_samples),
        cmocka_unit_test(masks_follow_an_eye_that_moves),
        cmocka_unit_test(masks_follow_an_eye_that_moves_from_view_to_view),
        cmocka_unit_test(a_view_that_begins_again_is_masked_again),
    };
    context_open();
    return group_close(cmocka_run_group_tests_name("masks", tests, open_all, close_all));
}
