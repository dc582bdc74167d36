/*
 * Masks in every way of depth and stencil, in every format and with several samples. Each view is
 * drawn red all over, tested.
 */
#include <stdio.h>

#include "mask_left.h"
#include "rig_random.h"
#include "triangles_group.h"

enum { SIZE = 96, MODES = 8 };

static const struct cupola_depth plain = {.near_distance = 0};

static struct cupola_depth mode_of(int mode)
{
    return (struct cupola_depth){0.05, 80, mode & 1, mode & 2, mode & 4};
}

static void make(struct fixture *fixture, const struct cupola_gl_params *wished)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    struct cupola_gl_params params = *wished;
    params.table = CUPOLA_TABLE_NONE;
    rig.eye_m[0] = 0.2;
    fixture_make(&rig, NULL, &params, fixture);
}

static int texels_of_views(const cupola_plan *plan)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    return (int)lround(report->texels_shaded_per_pixel * report->pixels);
}

static struct texels_left count_left(const struct fixture *fixture)
{
    float *atlas = fixture_atlas(fixture);
    struct texels_left count = texels_count(fixture->plan, atlas, false);
    free(atlas);
    return count;
}

static struct texels_left draw(const struct fixture *fixture, const struct cupola_depth *depth,
                               enum cupola_mask mask)
{
    draw_red_views(&triangles, fixture->gl, fixture->plan, depth, mask);
    return count_left(fixture);
}

static void check(const struct fixture *fixture, const struct texels_left *count)
{
    assert_int_equal(count->missing, 0);
    check_at_least(count->needed, 1000);
    check_at_most(count->left, 0.8 * texels_of_views(fixture->plan));
}

static void all_ways_of_depth_mask_alike(void **state)
{
    int tried = 0, left = 0;
    (void)state;
    for (int format = 0; format < CUPOLA_DEPTH_NONE; format++) {
        struct fixture fixture;
        make(&fixture, &(struct cupola_gl_params){.depth = (enum cupola_depth_format)format});
        for (int mode = 0; mode < MODES; mode++) {
            const struct cupola_depth depth = mode_of(mode);
            if (depth.zero_to_one && !has_clip_control())
                continue;
            struct texels_left count = draw(&fixture, &depth, CUPOLA_MASK_DEPTH);
            check(&fixture, &count);
            left = tried++ ? left : count.left;
            assert_int_equal(count.left, left);
        }
        fixture_release(&fixture);
    }
    printf("%d ways, %d texels left\n", tried, left);
    assert_int_equal(tried, has_clip_control() ? 32 : 16);
}

static void stencils_mask_as_depth_does(void **state)
{
    (void)state;
    for (int format = CUPOLA_DEPTH_32F_STENCIL_8; format <= CUPOLA_DEPTH_24_STENCIL_8; format++)
        for (int mode = 0; mode < 4; mode++) {
            const struct cupola_depth depth = mode_of(mode);
            struct fixture fixture;
            struct texels_left counts[2];
            for (int stencil = 0; stencil < 2; stencil++) {
                enum cupola_mask mask = stencil ? CUPOLA_MASK_STENCIL : CUPOLA_MASK_DEPTH;
                make(&fixture, &(struct cupola_gl_params){.depth = (enum cupola_depth_format)format,
                                                          .mask = mask});
                counts[stencil] = draw(&fixture, &depth, mask);
                check(&fixture, &counts[stencil]);
                fixture_release(&fixture);
            }
            assert_int_equal(counts[0].left, counts[1].left);
        }
}

static void all_samples_of_needed_texels_are_free(void **state)
{
    (void)state;
    for (int stencil = 0; stencil < 2; stencil++) {
        enum cupola_mask mask = stencil ? CUPOLA_MASK_STENCIL : CUPOLA_MASK_DEPTH;
        struct fixture fixture;
        make(&fixture, &(struct cupola_gl_params){
                           .samples = 4, .depth = CUPOLA_DEPTH_24_STENCIL_8, .mask = mask});
        struct texels_left count = draw(&fixture, &plain, mask);
        check(&fixture, &count);
        fixture_release(&fixture);
    }
}

static void without_masks_or_tests_all_is_shaded(void **state)
{
    static const struct cupola_gl_params wishes[] = {
        {.mask = CUPOLA_MASK_NONE},
        {.depth = CUPOLA_DEPTH_NONE},
        {.depth = CUPOLA_DEPTH_24_STENCIL_8, .mask = CUPOLA_MASK_STENCIL},
    };
    struct fixture fixture;
    (void)state;
    for (int i = 0; i < 3; i++) {
        make(&fixture, &wishes[i]);
        int left = draw(&fixture, &plain, CUPOLA_MASK_DEPTH).left; /* does not test stencil */
        assert_int_equal(left, texels_of_views(fixture.plan));
        fixture_release(&fixture);
    }
    const struct cupola_plan_params unmasked = {.unmasked = true};
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    fixture_make(&rig, &unmasked, NULL, &fixture);
    assert_int_equal(draw(&fixture, &plain, CUPOLA_MASK_DEPTH).left, texels_of_views(fixture.plan));
    fixture_release(&fixture);
}

/* What is shaded is what is left: no mask needs more than its test. */
static void masked_texels_are_not_shaded(void **state)
{
    struct fixture fixture;
    GLuint query, passed = 0;
    (void)state;
    if (context_is_es())
        skip(); /* counts no samples */
    make(&fixture, &(struct cupola_gl_params){.depth = CUPOLA_DEPTH_24});
    int views = cupola_gl_frame_begin(fixture.gl, NULL, NULL), left = 0;
    glGenQueries(1, &query);
    for (int i = 0; i < views; i++) {
        assert_int_equal(cupola_gl_view_begin(fixture.gl, i, NULL, NULL), CUPOLA_OK);
        glBeginQuery(GL_SAMPLES_PASSED, query);
        draw_red(&triangles, fixture.plan, i, &plain, CUPOLA_MASK_DEPTH);
        glEndQuery(GL_SAMPLES_PASSED);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
        left += (int)passed;
    }
    glDeleteQueries(1, &query);
    const struct cupola_plan_report *report = cupola_plan_report(fixture.plan);
    struct texels_left count = count_left(&fixture);
    printf("%.3f texels per pixel are shaded, %.3f were estimated, %.3f without a mask\n",
           left / report->pixels, report->texels_masked_per_pixel, report->texels_shaded_per_pixel);
    assert_int_equal(left, count.left);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_ways_of_depth_mask_alike),
        cmocka_unit_test(stencils_mask_as_depth_does),
        cmocka_unit_test(all_samples_of_needed_texels_are_free),
        cmocka_unit_test(without_masks_or_tests_all_is_shaded),
        cmocka_unit_test(masked_texels_are_not_shaded),
    };
    return run_triangles_group("mask_modes", tests);
}
