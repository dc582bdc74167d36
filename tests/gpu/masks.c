/*
 * The mask of what no pixel samples, in theatres of every kind: of views that are drawn all over,
 * each in a colour of its own, with the test of depth, every texel that a pixel's filter may touch
 * has its view's colour, guard band included, and so has all of the dome's image; the others are
 * shaded by nobody. CUPOLA_LONG=1: all theatres of the matrix, where else there is one of four that
 * cover every pair.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"
#include "geometry/vector.h"
#include "mask_left.h"
#include "rig_random.h"
#include "triangles_group.h"

/* Every which theatre of the matrix is tried, and how many at most in OpenGL ES. */
enum { EVERY = 4, ES_THEATRES = 8, EYES = 3 };

static const struct cupola_depth plain = {.near_distance = 0};

struct sums {
    bool all_theatres;
    int visited, tried, failures;
    double left, all;
};

/*
 * Whether a pixel has the colour of the view that its ray falls to, or of one to which it falls as
 * good as that.
 */
static bool has_view_color(const cupola_plan *plan, const struct cupola_ray *ray,
                           const float *pixel)
{
    static const double as_good = 1e-4;
    double most = -2;
    for (int pass = 0; pass < 2; pass++)
        for (int v = 0; v < cupola_plan_view_count(plan); v++) {
            double nearness = dot3(cupola_plan_view(plan, v)->selector, ray->direction);
            float color[4];
            bool same = true;
            most = fmax(most, nearness);
            view_color(v, color);
            for (int k = 0; k < 3; k++)
                same = same && fabs((double)pixel[k] - ray->coverage * (double)color[k]) <= 0.02;
            if (pass && same && nearness >= most - as_good)
                return true;
        }
    return false;
}

/* The lit pixels of an image that do not have their view's colour. */
static int pixels_missing(const struct fixture *fixture, int output, const float *image)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    int missing = 0;
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        struct cupola_ray ray;
        if (cupola_dome_ray(cupola_plan_dome(fixture->plan), output, NULL, i % size->width_px + 0.5,
                            i / size->width_px + 0.5, &ray) == 1 &&
            ray.coverage > 0.01)
            missing += !has_view_color(fixture->plan, &ray, image + 4 * i);
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
    if (!sums->all_theatres && sums->visited++ % EVERY) {
        cupola_plan_destroy(&plan);
        return true;
    }
    fixture_make_of_plan(plan, &params, &fixture);
    draw_views_from(&triangles, fixture.gl, plan, &plain, 0);
    float *atlas = fixture_atlas(&fixture);
    struct texels_left count = texels_count(plan, atlas, true);
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
    const char *wish = getenv("CUPOLA_LONG");
    struct sums sums = {.all_theatres = wish && strcmp(wish, "1") == 0};
    if (sums.all_theatres)
        cases_matrix(2101, visit, &sums);
    else
        cases_pairwise(2101, visit, &sums);
    printf("%d theatres: %.3f of the texels of views are left\n", sums.tried, sums.left / sums.all);
    assert_int_equal(sums.failures, 0);
    check_at_most(sums.left / sums.all, 0.9);
}

/* In the middle of its dome, or off axis in every way. */
static void make_moving(struct fixture *fixture, bool off_axis)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, 160);
    const struct cupola_plan_params params = {.head_radius_m = 0.25};
    const struct cupola_gl_params gl_params = {.table = CUPOLA_TABLE_NONE};
    rig.screen.radius_m = 1;
    if (off_axis) {
        rig.tilt_rad = radians(25);
        memcpy(rig.eye_m, (double[]){0.25, -0.2, 0.15}, sizeof rig.eye_m);
        memcpy(rig.outputs[0].position_m, (double[]){-0.3, 0.2, 0.1}, sizeof rig.eye_m);
        rig.outputs[0].aim = (struct cupola_aim){radians(12), radians(-9), radians(40)};
    }
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

static void check_moving(bool off_axis)
{
    uint64_t seed = 2102;
    struct fixture fixture;
    int stale_missing = 0;
    double rest_m[3];
    make_moving(&fixture, off_axis);
    memcpy(rest_m, cupola_dome_rig(fixture.dome)->eye_m, sizeof rest_m);
    for (int stale = 1; stale >= 0; stale--)
        for (int eye = 0; eye < EYES; eye++) {
            double place[3];
            random_in_ball(&seed, fixture.plan->head_radius_m, place);
            for (int i = 0; i < 3; i++)
                place[i] += rest_m[i];
            move_eye(&fixture, place, stale);
            draw_views_from(&triangles, fixture.gl, fixture.plan, &plain, 0);
            float *atlas = fixture_atlas(&fixture);
            struct texels_left count = texels_count(fixture.plan, atlas, true);
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

static void masks_follow_an_eye_that_moves(void **state)
{
    (void)state;
    check_moving(false);
    check_moving(true);
}

/* The control of colours: a view's texels in another's colour are seen, and so are its pixels. */
static void a_view_in_the_colour_of_another_is_seen(void **state)
{
    (void)state;
    struct fixture fixture;
    make_moving(&fixture, true);
    draw_views_from(&triangles, fixture.gl, fixture.plan, &plain, 1);
    float *atlas = fixture_atlas(&fixture);
    struct texels_left count = texels_count(fixture.plan, atlas, true);
    check_at_least(count.missing, 0.99 * count.needed);
    check_at_least(images_missing(&fixture), 1000);
    free(atlas);
    fixture_release(&fixture);
}

/* In the middle of a frame, where the first view has masked them all. */
static void masks_follow_an_eye_that_moves_from_view_to_view(void **state)
{
    (void)state;
    struct fixture fixture;
    make_moving(&fixture, false);
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
    make_moving(&fixture, false);
    draw_red_views(&triangles, fixture.gl, fixture.plan, &plain, CUPOLA_MASK_DEPTH);
    for (int again = 0; again < 2; again++) {
        float *atlas = fixture_atlas(&fixture);
        left[again] = texels_count(fixture.plan, atlas, false).left;
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_mask_takes_what_a_pixel_samples),
        cmocka_unit_test(masks_follow_an_eye_that_moves),
        cmocka_unit_test(a_view_in_the_colour_of_another_is_seen),
        cmocka_unit_test(masks_follow_an_eye_that_moves_from_view_to_view),
        cmocka_unit_test(a_view_that_begins_again_is_masked_again),
    };
    return run_triangles_group("masks", tests);
}
