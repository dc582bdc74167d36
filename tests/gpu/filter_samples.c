/*
 * Views of several samples per texel with every filter: the image is that of the C reference over
 * the resolved views, and of a star of straight edges it is nearer to the truth than with one
 * sample.
 */
#include <stdio.h>
#include <stdlib.h>

#include "filter_cases.h"
#include "group.h"
#include "rig_random.h"
#include "triangles.h"
#include "worse.h"

enum { SIDE = 96, SECTORS = 14, TRUE_RAYS = 6, SAMPLES = 4 };

static const double half_star = 55.0 * (pi / 180.0), far_off = 100.0;

static struct triangles triangles;

static struct cupola_rig star_rig(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIDE);
    rig.screen.radius_m = 1.0;
    rig.eye_m[1] = 0.2;
    return rig;
}

/* White sectors round the camera's axis, as one plane far ahead of it, wherever the eye is. */
static void draw_star(const struct fixture *fixture)
{
    static const float white[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    const struct cupola_frame frame = {.clear_color = {0.0f, 0.0f, 0.0f, 1.0f}};
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);
    float points[3 * SECTORS][3] = {{0.0f}};
    for (int k = 0; k < 3 * SECTORS; k++) {
        double turn = 2.0 * pi * (k / 3 + (k % 3 == 2 ? 0.5 : 0.0)) / SECTORS;
        points[k][0] = k % 3 ? (float)(far_off * tan(half_star) * cos(turn)) : 0.0f;
        points[k][1] = k % 3 ? (float)(far_off * tan(half_star) * sin(turn)) : 0.0f;
        points[k][2] = (float)-far_off;
    }
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        triangles_draw(&triangles, &view.camera, white, points, 3 * SECTORS);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* Whether a ray meets a sector's triangle, whose outer edge is a chord. */
static bool in_star(const double ray[3])
{
    double turn = atan2(ray[1], ray[0]) * (SECTORS / (2.0 * pi));
    double part = turn - floor(turn), half = pi / SECTORS;
    if (part >= 0.5 || !(ray[2] < 0.0))
        return false;
    double off = (part - 0.25) * 2.0 * half, chord = tan(half_star) * cos(0.5 * half);
    return hypot(ray[0], ray[1]) / -ray[2] * cos(off) < chord;
}

/* By many rays in a pixel; -1 where not all of it is lit. */
static double truth_of(const struct fixture *fixture, int x, int y)
{
    int white = 0;
    for (int k = 0; k < TRUE_RAYS * TRUE_RAYS; k++) {
        struct cupola_ray ray;
        cupola_dome_ray(fixture->dome, 0, NULL, x + (k % TRUE_RAYS + 0.5) / TRUE_RAYS,
                        y + (k / TRUE_RAYS + 0.5) / TRUE_RAYS, &ray);
        if (ray.coverage < 1.0)
            return -1.0;
        white += in_star(ray.direction);
    }
    return white / (double)(TRUE_RAYS * TRUE_RAYS);
}

static void set_gl(struct fixture *fixture, const struct cupola_filter *filter, int number,
                   int samples)
{
    static const enum cupola_format formats[] = {CUPOLA_FORMAT_RGBA8, CUPOLA_FORMAT_RGBA16F};
    struct cupola_gl_params params = {.format = formats[context_has_floats() ? number % 2 : 0],
                                      .samples = samples,
                                      .filter = *filter,
                                      .table = filter_stages[number % 2]};
    fixture_replace_gl(fixture, &params);
    draw_star(fixture);
}

/* Root mean square. */
static double error_of(const float *image, const double *truth)
{
    double sum = 0.0;
    int pixels = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        if (truth[i] >= 0.0) {
            sum += pow((double)image[4 * i] - truth[i], 2.0);
            pixels++;
        }
    return sqrt(sum / pixels);
}

/* How many pixels are not the reference's; bars as in warp_reference.c. */
static int unlike_reference(const struct fixture *fixture, const struct cupola_filter *filter,
                            const float *atlas, const float *image)
{
    static float expected[4 * SIDE * SIDE];
    int unlike = 0;
    assert_int_equal(cupola_reference_filter(fixture->plan, 0, filter, atlas, NULL, expected),
                     CUPOLA_OK);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double off = 0.0;
        for (int c = 0; c < 4; c++)
            off = worse_of(off, fabs((double)image[4 * i + c] - (double)expected[4 * i + c]));
        unlike += !(off <= 0.012);
    }
    return unlike;
}

/* As in filter_reference.c: where a number is rounded either may be right. */
static const int tolerated = 2 + SIDE * SIDE / 2000;

static void check_filter(struct fixture *fixture, int number, const double *truth)
{
    const struct cupola_filter *filter = &filters[number];
    double errors[2];
    float *atlases[2];
    for (int several = 0; several < 2; several++) {
        set_gl(fixture, filter, number, several ? SAMPLES : 1);
        atlases[several] = fixture_atlas(fixture);
        float *image = fixture_warp(fixture, 0);
        errors[several] = error_of(image, truth);
        check_at_most(unlike_reference(fixture, filter, atlases[several], image), tolerated);
        if (several) /* the control: the views as they were with one sample */
            check_at_least(unlike_reference(fixture, filter, atlases[0], image), 200);
        free(image);
    }
    printf("%s: %.4f off with one sample, %.4f with %d\n", filter_text(filter), errors[0],
           errors[1], SAMPLES);
    /* Nine texels blur more than samples mend. */
    check_at_most(errors[1], (filter->samples == 9 ? 0.97 : 0.85) * errors[0]);
    free(atlases[0]);
    free(atlases[1]);
}

static void several_samples_and_any_filter_go_together(void **state)
{
    (void)state;
    static double truth[SIDE * SIDE];
    struct cupola_rig rig = star_rig();
    struct fixture fixture;
    fixture_make(&rig, NULL, NULL, &fixture);
    triangles = triangles_create();
    for (int i = 0; i < SIDE * SIDE; i++)
        truth[i] = truth_of(&fixture, i % SIDE, i / SIDE);
    for (int i = 0; i < FILTERS; i++)
        if (!filters[i].turned)
            check_filter(&fixture, i, truth);
    triangles_release(&triangles);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(several_samples_and_any_filter_go_together),
    };
    return run_gpu_group("filter_samples", tests);
}
