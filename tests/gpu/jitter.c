/*
 * Samples beside the middles of texels and pixels: views show the directions of the moved texels,
 * pixels those of the moved rays, and the mean of many frames is what box filters make of a scene.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "eye_theatres.h"
#include "gl/instance.h"
#include "group.h"
#include "worse.h"

static const double bar_px = 0.05, bar_texels = 0.01;

/* Rays not quite at the edge of their pixel: it may be that of the frame buffer. */
static const double jitters[][4] = {
    {0.5, 0.5, 0.49, 0.49},     {-0.5, 0.5, -0.49, 0.49}, {0.31, -0.5, 0.49, -0.22},
    {-0.5, -0.5, -0.49, -0.49}, {0, 0, 0.49, -0.49},      {0.5, -0.5, 0, 0},
};

enum { JITTERS = sizeof jitters / sizeof jitters[0] };

static const enum cupola_table stages[] = {CUPOLA_TABLE_TILES, CUPOLA_TABLE_NONE};

static void set_jitter(const struct fixture *fixture, const double jitter[4])
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_gl_set_jitter(fixture->gl, jitter, jitter + 2, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
}

/* Every other one without a head that moves. */
static void make(int number, enum cupola_table stage, struct fixture *fixture)
{
    struct eye_theatre theatre = eye_theatre(number);
    const struct cupola_gl_params params = {
        .format = CUPOLA_FORMAT_RGBA32F, .table = stage, .jitters = true};
    if (number % 2 == 0)
        theatre.params.head_radius_m = 0;
    fixture_make(&theatre.rig, &theatre.params, &params, fixture);
    if (number % 2 == 0)
        return;
    uint64_t seed = (uint64_t)(5100 + number);
    double eye[3];
    eye_place(&theatre, &seed, true, eye);
    assert_int_equal(cupola_plan_set_eye(fixture->plan, eye, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_eye(fixture->gl, eye, NULL), CUPOLA_OK);
}

/* How far pixels show a place beside theirs that is not the wished one, px. */
struct beside {
    double whole; /* where all of the pixel is lit, from the wished place */
    double cut;   /* where an edge cuts it: beyond the pixel's own square */
    int wholes, cuts;
};

static void look(const cupola_dome *dome, int output, const int at[2], const double wished[2],
                 const float *color, struct beside *beside)
{
    struct cupola_ray ray;
    double place[2] = {(double)NAN, (double)NAN},
           shown[3] = {(double)color[0], (double)color[1], (double)color[2]};
    double middle[2] = {at[0] + 0.5, at[1] + 0.5};
    cupola_dome_ray(dome, output, NULL, middle[0], middle[1], &ray);
    if (!(ray.coverage > 0.1))
        return;
    bool there = cupola_dome_pixel(dome, output, NULL, shown, place) == 1;
    double x = place[0] - middle[0], y = place[1] - middle[1];
    if (ray.coverage == 1) {
        beside->whole = worse_of(beside->whole, hypot(x - wished[0], y - wished[1]));
        beside->wholes++;
    } else if (there) { /* the last bits may carry it beyond a rim */
        beside->cut = worse_of(beside->cut, fmax(fabs(x), fabs(y)) - 0.5);
        beside->cuts++;
    }
}

static struct beside warped(const struct fixture *fixture, int output, const double wished[2])
{
    const struct cupola_output *size = fixture_output(fixture, output);
    const cupola_dome *dome = cupola_plan_dome(fixture->plan);
    float *image = fixture_warp(fixture, output);
    struct beside beside = {.whole = 0};
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++)
            look(dome, output, (const int[2]){i, j}, wished, image + 4 * (j * size->width_px + i),
                 &beside);
    free(image);
    return beside;
}

static void every_pixel_shows_the_direction_of_its_moved_place(void **state)
{
    (void)state;
    double worst = 0, worst_cut = 0;
    for (int number = 0; number < EYE_THEATRES; number++)
        for (int stage = 0; stage < 2; stage++) {
            struct fixture fixture;
            make(number, stages[stage], &fixture);
            for (int i = 0; i < JITTERS; i++) {
                const double *wished = jitters[i] + 2, back[2] = {-wished[0], -wished[1]};
                set_jitter(&fixture, jitters[i]);
                fixture_paint(&fixture, PAINT_DIRECTIONS);
                for (int k = 0; k < fixture.plan->dome.rig.output_count; k++) {
                    struct beside beside = warped(&fixture, k, wished);
                    check_at_least(beside.wholes, 2000);
                    check_at_most(beside.whole, bar_px);
                    check_at_most(beside.cut, bar_px);
                    worst = worse_of(worst, beside.whole);
                    worst_cut = worse_of(worst_cut, beside.cut);
                }
                if (i == 0) /* the control */
                    check_at_least(warped(&fixture, 0, back).whole, 10 * bar_px);
            }
            fixture_release(&fixture);
        }
    printf("  at most %.4f px; %.4f px beyond a pixel that is cut\n", worst, worst_cut);
}

/* What a texel of a view that is moved by `texels` should show. */
static void direction_of(const struct cupola_view *view, int x, int y, const double texels[2],
                         double direction[3])
{
    double u = (x + 0.5 + texels[0]) / view->rect.width;
    double v = (y + 0.5 + texels[1]) / view->rect.height;
    double base[3] = {view->left + u * (view->right - view->left),
                      view->bottom + v * (view->top - view->bottom), -1};
    double length = sqrt(base[0] * base[0] + base[1] * base[1] + 1);
    for (int i = 0; i < 3; i++)
        direction[i] = (view->rotation[i] * base[0] + view->rotation[3 + i] * base[1] +
                        view->rotation[6 + i] * base[2]) /
                       length;
}

/* The largest distance of a texel of a view from what it should show, in texels. */
static double view_error(const struct fixture *fixture, const float *atlas, int index,
                         const double texels[2])
{
    const struct cupola_view *view = cupola_plan_view(fixture->plan, index);
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    double worst = 0;
    for (int y = 0; y < view->rect.height; y++)
        for (int x = 0; x < view->rect.width; x++) {
            const float *color = atlas + 4 * ((view->rect.y + y) * width + view->rect.x + x);
            double wished[3], next[3], far = 0, step = 0;
            if (!(color[3] > 0.0f))
                continue; /* masked */
            direction_of(view, x, y, texels, wished);
            direction_of(view, x + 1, y, texels, next);
            for (int i = 0; i < 3; i++) {
                far = hypot(far, (double)color[i] - wished[i]);
                step = hypot(step, next[i] - wished[i]);
            }
            worst = worse_of(worst, far / step);
        }
    return worst;
}

static void every_texel_shows_the_direction_of_its_moved_place(void **state)
{
    (void)state;
    for (int number = 0; number < EYE_THEATRES; number++) {
        struct fixture fixture;
        double worst = 0;
        make(number, CUPOLA_TABLE_NONE, &fixture);
        for (int i = 0; i < JITTERS; i++) {
            static const double still[2] = {0, 0};
            set_jitter(&fixture, jitters[i]);
            fixture_paint(&fixture, PAINT_DIRECTIONS);
            float *atlas = fixture_atlas(&fixture);
            for (int v = 0; v < cupola_plan_view_count(fixture.plan); v++)
                worst = worse_of(worst, view_error(&fixture, atlas, v, jitters[i]));
            if (i == 0)
                check_at_least(view_error(&fixture, atlas, 0, still), 0.4);
            free(atlas);
        }
        check_at_most(worst, bar_texels);
        fixture_release(&fixture);
    }
}

static float *picture(const struct fixture *fixture, enum paint paint)
{
    fixture_paint(fixture, paint);
    return fixture_warp(fixture, 0);
}

static size_t bytes_of(const struct fixture *fixture)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    return 4 * sizeof(float) * (size_t)size->width_px * (size_t)size->height_px;
}

static void no_jitter_is_as_before_and_an_eye_keeps_the_jitter(void **state)
{
    (void)state;
    static const double none[4] = {0, 0, 0, 0};
    for (int number = 1; number < EYE_THEATRES; number += 2) {
        struct eye_theatre theatre = eye_theatre(number);
        struct fixture fixture;
        double eye[3];
        uint64_t seed = 5200;
        make(number, stages[number / 2 % 2], &fixture);
        float *first = picture(&fixture, PAINT_NOISE);
        set_jitter(&fixture, jitters[2]);
        float *moved = picture(&fixture, PAINT_NOISE);
        assert_memory_not_equal(first, moved, bytes_of(&fixture));
        set_jitter(&fixture, none);
        float *again = picture(&fixture, PAINT_NOISE);
        assert_memory_equal(first, again, bytes_of(&fixture));
        eye_place(&theatre, &seed, true, eye);
        set_jitter(&fixture, jitters[2]);
        assert_int_equal(cupola_gl_set_eye(fixture.gl, eye, NULL), CUPOLA_OK);
        float *one = picture(&fixture, PAINT_DIRECTIONS);
        set_jitter(&fixture, none);
        set_jitter(&fixture, jitters[2]);
        float *other = picture(&fixture, PAINT_DIRECTIONS);
        assert_memory_equal(one, other, bytes_of(&fixture));
        float *images[] = {first, moved, again, one, other};
        for (int i = 0; i < 5; i++)
            free(images[i]);
        fixture_release(&fixture);
    }
}

/* ---- means of many frames ---- */

enum { SIDE_PX = 64, RAYS = 16 };

static void make_dome(struct fixture *fixture)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 170.0, SIDE_PX);
    const struct cupola_plan_params plan = {.density = 2};
    const struct cupola_gl_params params = {
        .table = CUPOLA_TABLE_TILES, .jitters = true, .filter.method = CUPOLA_ANTIALIASING_NONE};
    rig.eye_m[0] = 0.2 * rig.screen.radius_m;
    fixture_make(&rig, &plan, &params, fixture);
}

/* Which of the two are moved. */
struct moved {
    bool texels, pixels;
};

static double *mean_of(const struct fixture *fixture, enum paint paint, int frames,
                       struct moved moved)
{
    double *sum = calloc(4 * SIDE_PX * SIDE_PX, sizeof *sum);
    assert_non_null(sum);
    for (int frame = 0; frame < frames; frame++) {
        double jitter[4];
        assert_int_equal(cupola_jitter_place(frame, jitter, jitter + 2), CUPOLA_OK);
        if (!moved.texels)
            jitter[0] = jitter[1] = 0;
        if (!moved.pixels)
            jitter[2] = jitter[3] = 0;
        set_jitter(fixture, jitter);
        float *image = picture(fixture, paint);
        for (int i = 0; i < 4 * SIDE_PX * SIDE_PX; i++)
            sum[i] += (double)image[i] / frames;
        free(image);
    }
    return sum;
}

/* The scene of shaders/checker.frag. */
static double checker(const double direction[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += floor(9 * direction[i]);
    return sum - 2 * floor(0.5 * sum);
}

/* The box filter over a pixel, by rays of their own; below 0 where not all of it is lit. */
static double truth_of(const cupola_dome *dome, int x, int y)
{
    struct cupola_ray ray;
    double sum = 0;
    cupola_dome_ray(dome, 0, NULL, x + 0.5, y + 0.5, &ray);
    if (ray.coverage < 1)
        return -1;
    for (int k = 0; k < RAYS * RAYS; k++) {
        double right = (k % RAYS + 0.5) / RAYS, up = ((double)(k / RAYS) + 0.5) / RAYS;
        cupola_dome_ray(dome, 0, NULL, x + right, y + up, &ray);
        sum += checker(ray.direction) / (RAYS * RAYS);
    }
    return sum;
}

static double rms_error(const double *mean, const double *truth)
{
    double squares = 0;
    int count = 0;
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++) {
        if (truth[i] < 0)
            continue;
        squares += (mean[4 * i] - truth[i]) * (mean[4 * i] - truth[i]);
        count++;
    }
    return sqrt(squares / count);
}

static double error_of(const struct fixture *fixture, const double *truth, int frames,
                       struct moved moved)
{
    double *mean = mean_of(fixture, PAINT_CHECKER, frames, moved);
    double error = rms_error(mean, truth);
    free(mean);
    return error;
}

static void means_come_to_the_box_filter_if_both_are_moved(void **state)
{
    (void)state;
    static const int frames[] = {1, 8, 64};
    static double truth[SIDE_PX * SIDE_PX];
    struct fixture fixture;
    double both[3];
    make_dome(&fixture);
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++)
        truth[i] = truth_of(fixture.dome, i % SIDE_PX, i / SIDE_PX);
    for (int i = 0; i < 3; i++) {
        both[i] = error_of(&fixture, truth, frames[i], (struct moved){true, true});
        printf("  %d frames: %.4f\n", frames[i], both[i]);
    }
    double texels = error_of(&fixture, truth, 64, (struct moved){true, false});
    double pixels = error_of(&fixture, truth, 64, (struct moved){false, true});
    printf("  64 frames, texels alone %.4f, rays alone %.4f\n", texels, pixels);
    check_at_most(both[1], 0.6 * both[0]);
    check_at_most(both[2], 0.7 * both[1]);
    check_at_least(texels, 1.5 * both[2]);
    check_at_least(pixels, 1.5 * both[2]);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_shows_the_direction_of_its_moved_place),
        cmocka_unit_test(every_texel_shows_the_direction_of_its_moved_place),
        cmocka_unit_test(no_jitter_is_as_before_and_an_eye_keeps_the_jitter),
        cmocka_unit_test(means_come_to_the_box_filter_if_both_are_moved),
    };
    return run_gpu_group("jitter", tests);
}
