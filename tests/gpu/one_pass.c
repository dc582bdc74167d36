/*
 * All views in one pass: whatever plan, format, depth and primitive, and whichever shader chooses
 * the view, the atlas is what a host that draws view by view gets from the same matrices.
 *
 * To the bit, but for what a GL may round otherwise in another program or for another viewport
 * (products fused or not, the division by w: the software rasteriser does that division elsewhere
 * for vertices with a viewport of their own): in floats a last digit, and single texels at outlines
 * where a vertex lies on the border between two subpixels. Of those, one in a hundred for lines,
 * whose rasterisation leaves more to such borders, and one in a thousand for triangles (up to one
 * in six thousand on the software rasteriser).
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "confetti.h"
#include "group.h"
#include "host_depth.h"
#include "rig_random.h"

struct plan_wish {
    const char *name;
    enum cupola_lens_model lens;
    double fov_deg;
    struct cupola_plan_params params;
};

static const struct plan_wish plans[] = {
    {"one view", CUPOLA_LENS_ANGULAR, 60, {.views = 1}},
    {"asymmetric", CUPOLA_LENS_ANGULAR, 140, {.layout = CUPOLA_LAYOUT_ASYMMETRIC, .views = 3}},
    {"rotated", CUPOLA_LENS_HEMISPHERIC, 180, {.layout = CUPOLA_LAYOUT_ROTATED, .views = 5}},
    {"eight", CUPOLA_LENS_ANGULAR, 220, {.layout = CUPOLA_LAYOUT_ROTATED, .views = 8}},
    {"auto", CUPOLA_LENS_ANGULAR, 180, {.rotation_in_projection = true}},
    {"an eye that has moved", CUPOLA_LENS_ANGULAR, 150, {.head_radius_m = 0.2}},
};

enum { PLANS = sizeof plans / sizeof plans[0], SIZE = 96 };

static bool context_has_way(enum cupola_pass_way way)
{
    int best = cupola_pass_way(NULL);
    return best > 0 && (way == CUPOLA_PASS_GEOMETRY || best == CUPOLA_PASS_VERTEX);
}

static int atlas_texels(const struct fixture *fixture)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    return report->atlas_width_px * report->atlas_height_px;
}

/* By more than a last digit. */
static int differing(const float *a, const float *b, int texels)
{
    int count = 0;
    for (int i = 0; i < texels; i++) {
        bool same = true;
        for (int k = 4 * i; k < 4 * i + 4; k++)
            same = same && fabsf(a[k] - b[k]) <= 1e-5f;
        count += !same;
    }
    return count;
}

/* Texels unlike the one to the left: confetti, and not an empty atlas. */
static int outlines(const struct fixture *fixture, const float *atlas)
{
    int count = 0;
    for (int i = 1; i < atlas_texels(fixture); i++)
        count += memcmp(atlas + 4 * i, atlas + 4 * (i - 1), 4 * sizeof *atlas) != 0;
    return count;
}

static void make(struct fixture *fixture, const struct plan_wish *wish,
                 const struct cupola_gl_params *params)
{
    struct cupola_rig rig = plain_rig(wish->lens, wish->fov_deg, SIZE);
    struct cupola_gl_params passing = *params;
    passing.one_pass = true;
    rig.eye_m[0] = 0.1;
    rig.tilt_rad = 0.3;
    fixture_make(&rig, &wish->params, &passing, fixture);
    if (wish->params.head_radius_m > 0)
        assert_int_equal(cupola_gl_set_eye(fixture->gl, (double[3]){0.15, 0.1, -0.1}, NULL),
                         CUPOLA_OK);
}

static void check_same(const struct fixture *fixture, const struct confetti *confetti,
                       const struct cupola_frame *frame, const char *name)
{
    confetti_loop(confetti, fixture, frame);
    float *looped = fixture_atlas(fixture), *warped = fixture_warp(fixture, 0);
    confetti_pass(confetti, fixture, frame, confetti->passed);
    float *passed = fixture_atlas(fixture), *warped_again = fixture_warp(fixture, 0);
    int texels = atlas_texels(fixture), drawn = outlines(fixture, looped);
    int count = differing(looped, passed, texels);
    int allowed = drawn / (confetti->mode == GL_LINES ? 100 : 1000);
    if (count > allowed)
        fail_msg("%s: %d of %d texels differ, of %d at outlines", name, count, texels, drawn);
    check_at_least(drawn, texels / 50);
    if (count == 0)
        assert_int_equal(differing(warped, warped_again, SIZE * SIZE), 0);
    if (cupola_plan_view_count(fixture->plan) > 1) { /* the control: in the wrong viewport */
        confetti_pass(confetti, fixture, frame, confetti->wrong);
        float *wrong = fixture_atlas(fixture);
        check_at_least(differing(looped, wrong, texels), texels / 50);
        free(wrong);
    }
    free(looped);
    free(warped);
    free(passed);
    free(warped_again);
}

/* The ways that the context has, one after the other. */
static void for_each_way(void (*check)(enum cupola_pass_way way))
{
    if (cupola_pass_way(NULL) < 0)
        skip();
    for (int way = CUPOLA_PASS_VERTEX; way <= CUPOLA_PASS_GEOMETRY; way++)
        if (context_has_way((enum cupola_pass_way)way))
            check((enum cupola_pass_way)way);
}

static void check_plans(enum cupola_pass_way way)
{
    const struct cupola_frame frame = {.clear_color = {0.1f, 0.2f, 0.3f, 1}};
    struct confetti confetti;
    confetti_create(&confetti, way, GL_TRIANGLES);
    for (int i = 0; i < PLANS; i++) {
        struct fixture fixture;
        make(&fixture, &plans[i], &(struct cupola_gl_params){.samples = 0});
        check_same(&fixture, &confetti, &frame, plans[i].name);
        printf("  %s: %d views, way %d\n", plans[i].name, cupola_plan_view_count(fixture.plan),
               (int)way);
        fixture_release(&fixture);
    }
    confetti_destroy(&confetti);
}

static void every_plan_is_drawn_alike(void **state)
{
    (void)state;
    for_each_way(check_plans);
}

static void check_formats(enum cupola_pass_way way)
{
    static const struct cupola_gl_params wishes[] = {
        {.samples = 4},
        {.format = CUPOLA_FORMAT_SRGB8, .samples = 2, .depth = CUPOLA_DEPTH_24_STENCIL_8},
        {.format = CUPOLA_FORMAT_RGBA32F, .depth = CUPOLA_DEPTH_24},
        {.depth = CUPOLA_DEPTH_NONE},
        {.mask = CUPOLA_MASK_NONE},
        {.mask = CUPOLA_MASK_STENCIL, .depth = CUPOLA_DEPTH_32F_STENCIL_8},
        {.leaves_state = true, .samples = 4},
    };
    const struct cupola_frame frame = {.clear_color = {0.1f, 0.2f, 0.3f, 1}};
    struct confetti confetti;
    confetti_create(&confetti, way, GL_TRIANGLES);
    for (size_t i = 0; i < sizeof wishes / sizeof wishes[0]; i++) {
        struct fixture fixture;
        if (wishes[i].format == CUPOLA_FORMAT_RGBA32F && !context_has_floats())
            continue;
        make(&fixture, &plans[2], &wishes[i]);
        char name[32];
        snprintf(name, sizeof name, "format %zu, way %d", i, (int)way);
        check_same(&fixture, &confetti, &frame, name);
        fixture_release(&fixture);
    }
    confetti_destroy(&confetti);
}

static void every_format_is_drawn_alike(void **state)
{
    (void)state;
    for_each_way(check_formats);
}

static void check_depths(enum cupola_pass_way way)
{
    struct confetti confetti;
    struct fixture fixture;
    confetti_create(&confetti, way, GL_TRIANGLES);
    make(&fixture, &plans[1], &(struct cupola_gl_params){.samples = 0});
    for (int mode = 0; mode < 8; mode++) {
        const struct cupola_frame frame = {.depth = {0.2, 50, mode & 1, mode & 2, mode & 4}};
        if (!frame.depth.zero_to_one || has_clip_control())
            check_same(&fixture, &confetti, &frame, "depth");
    }
    fixture_release(&fixture);
    confetti_destroy(&confetti);
}

static void every_depth_is_drawn_alike(void **state)
{
    (void)state;
    for_each_way(check_depths);
}

/* Points of many texels cross the views' borders, where only the scissor rectangles hold them. */
static void check_primitives(enum cupola_pass_way way)
{
    const struct cupola_frame frame = {.clear_color = {0, 0, 0, 1}};
    const GLenum modes[] = {GL_LINES, GL_POINTS};
    for (int i = 0; i < (context_is_es() && way == CUPOLA_PASS_GEOMETRY ? 1 : 2); i++)
        for (int samples = 1; samples <= 4; samples += 3) {
            struct confetti confetti;
            struct fixture fixture;
            confetti_create(&confetti, way, modes[i]);
            confetti.point_size = 40;
            make(&fixture, &plans[2], &(struct cupola_gl_params){.samples = samples});
            check_same(&fixture, &confetti, &frame, i ? "points" : "lines");
            fixture_release(&fixture);
            confetti_destroy(&confetti);
        }
}

static void wide_points_stay_in_their_view(void **state)
{
    (void)state;
    for_each_way(check_primitives);
}

/* The control to that: without scissor tests they do not. */
static void without_scissors_they_would_not(void **state)
{
    const struct cupola_frame frame = {.clear_color = {0, 0, 0, 1}};
    struct cupola_gl_pass pass;
    struct confetti confetti;
    struct fixture fixture;
    (void)state;
    if (!context_has_way(CUPOLA_PASS_VERTEX))
        skip();
    confetti_create(&confetti, CUPOLA_PASS_VERTEX, GL_POINTS);
    confetti.point_size = 40;
    make(&fixture, &plans[2], &(struct cupola_gl_params){.samples = 0});
    confetti_pass(&confetti, &fixture, &frame, confetti.passed);
    float *held = fixture_atlas(&fixture);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glUseProgram(confetti.passed);
    glBindVertexArray(confetti.vertex_array);
    assert_int_equal(cupola_gl_pass_begin(fixture.gl, NULL, &pass, NULL), CUPOLA_OK);
    glDisable(GL_SCISSOR_TEST);
    glBindBufferBase(GL_UNIFORM_BUFFER, CONFETTI_BINDING, pass.buffer);
    glDrawArraysInstanced(GL_POINTS, 0, CONFETTI_VERTICES, CONFETTI_INSTANCES * pass.view_count);
    assert_int_equal(cupola_gl_pass_end(fixture.gl, NULL), CUPOLA_OK);
    float *spilled = fixture_atlas(&fixture);
    check_at_least(differing(held, spilled, atlas_texels(&fixture)), 500);
    free(held);
    free(spilled);
    glDisable(GL_PROGRAM_POINT_SIZE);
    fixture_release(&fixture);
    confetti_destroy(&confetti);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_plan_is_drawn_alike),
        cmocka_unit_test(every_format_is_drawn_alike),
        cmocka_unit_test(every_depth_is_drawn_alike),
        cmocka_unit_test(wide_points_stay_in_their_view),
        cmocka_unit_test(without_scissors_they_would_not),
    };
    return run_gpu_group("one_pass", tests);
}
