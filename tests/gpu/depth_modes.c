/*
 * Depth: whichever way it runs, and in whatever format it is kept, the nearer of two surfaces is
 * seen at every pixel of every view, however they are drawn one after the other.
 *
 * The surfaces are planes that cross in the middle of each view. Their nearness (1 / distance) is
 * linear over a view, so which one is nearer is known at every pixel; where they are so alike that
 * depth cannot tell, either may win: 1e-5 of the range, many steps of 24 bits. Masks, which would
 * hide parts of them, are the test mask_modes'.
 */
#include <stdio.h>
#include <stdlib.h>

#include "host_depth.h"
#include "rig_random.h"
#include "triangles_group.h"

enum { MODES = 8, DEPTHS = CUPOLA_DEPTH_NONE + 1 };

static const double near_distance = 0.5, far_distance = 80;
static const float red[4] = {1, 0, 0, 1}, green[4] = {0, 1, 0, 1};

static struct cupola_depth mode_of(int mode)
{
    return (struct cupola_depth){near_distance, far_distance, mode & 1, mode & 2, mode & 4};
}

static void make(struct fixture *fixture, enum cupola_depth_format format)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, 48);
    const struct cupola_gl_params params = {
        .depth = format, .table = CUPOLA_TABLE_NONE, .mask = CUPOLA_MASK_NONE};
    rig.eye_m[0] = 0.2;
    fixture_make(&rig, NULL, &params, fixture);
}

/* Red crosses green along a slanted line through the middle of a view. */
static const double nearness_red[3] = {0.3, 0.2, 0.05}, nearness_green[3] = {0.3, -0.15, 0.1};

static double nearness_at(const double nearness[3], double x, double y)
{
    return nearness[0] + nearness[1] * x + nearness[2] * y;
}

static void draw_plane(const cupola_plan *plan, int index, const struct cupola_camera *camera,
                       const double nearness[3], const float color[4])
{
    float points[6][3];
    plane_over_view(plan, index, nearness, points);
    triangles_draw(&triangles, camera, color, points, 6);
}

/* Both planes in every view, red first or last. `told` is what the host believes of the depth. */
static void draw_crossing(const struct fixture *fixture, const struct cupola_depth *depth,
                          const struct cupola_depth *told, bool red_first)
{
    const struct cupola_frame frame = {.depth = *depth};
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);
    assert_int_equal(views, cupola_plan_view_count(fixture->plan));
    host_depth(told);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        for (int pass = 0; pass < 2; pass++) {
            bool is_red = (pass == 0) == red_first;
            draw_plane(fixture->plan, i, &view.camera, is_red ? nearness_red : nearness_green,
                       is_red ? red : green);
        }
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    host_depth_reset();
}

struct winners {
    int red, green; /* pixels that show what must be seen there */
    int wrong;      /* pixels that do not */
    int undecided;
};

static struct winners count_winners(const struct fixture *fixture)
{
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    float *atlas = fixture_atlas(fixture);
    struct winners found = {0, 0, 0, 0};
    for (int k = 0; k < cupola_plan_view_count(fixture->plan); k++) {
        const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, k)->rect;
        for (int i = 0; i < rect->width * rect->height; i++) {
            int column = i % rect->width, row = i / rect->width;
            double x = 2 * (column + 0.5) / rect->width - 1;
            double y = 2 * (row + 0.5) / rect->height - 1;
            double ahead = nearness_at(nearness_red, x, y) - nearness_at(nearness_green, x, y);
            const float *texel = atlas + 4 * ((rect->y + row) * width + rect->x + column);
            bool right = ahead > 0 ? texel[0] > 0.9f : texel[1] > 0.9f;
            if (fabs(ahead) < 1e-5 / near_distance)
                found.undecided++;
            else if (!right)
                found.wrong++;
            else
                ahead > 0 ? found.red++ : found.green++;
        }
    }
    free(atlas);
    return found;
}

static void check_mode(const struct fixture *fixture, int mode)
{
    const struct cupola_depth depth = mode_of(mode);
    for (int red_first = 0; red_first < 2; red_first++) {
        draw_crossing(fixture, &depth, &depth, red_first);
        struct winners found = count_winners(fixture);
        assert_int_equal(found.wrong, 0);
        check_at_least(found.red, 500);
        check_at_least(found.green, 500);
        check_at_most(found.undecided, 100);
    }
    /* The control: a host that tests the other way round. */
    struct cupola_depth told = depth;
    told.reversed = !told.reversed;
    draw_crossing(fixture, &depth, &told, true);
    check_at_least(count_winners(fixture).wrong, 1000);
}

static void the_nearer_surface_is_seen_in_all_formats_and_ways(void **state)
{
    int tried = 0;
    (void)state;
    for (int format = 0; format < CUPOLA_DEPTH_NONE; format++) {
        struct fixture fixture;
        make(&fixture, (enum cupola_depth_format)format);
        for (int mode = 0; mode < MODES; mode++) {
            if ((mode & 4) && !has_clip_control())
                continue;
            check_mode(&fixture, mode);
            tried++;
        }
        fixture_release(&fixture);
    }
    printf("%d ways tried\n", tried);
    assert_int_equal(tried, has_clip_control() ? 32 : 16);
}

static void without_depth_the_last_drawn_is_seen(void **state)
{
    const struct cupola_depth plain = mode_of(0);
    struct fixture fixture;
    (void)state;
    make(&fixture, CUPOLA_DEPTH_NONE);
    draw_crossing(&fixture, &plain, &plain, true);
    struct winners found = count_winners(&fixture);
    check_at_least(found.green, 500);
    assert_int_equal(found.red, 0);
    check_at_least(found.wrong, 500);
    fixture_release(&fixture);
}

/* Pixels of all views that show red: a plane there is all over each of them. */
static int red_pixels(const struct fixture *fixture)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    float *atlas = fixture_atlas(fixture);
    int count = 0;
    for (int i = 0; i < report->atlas_width_px * report->atlas_height_px; i++)
        count += atlas[4 * i] > 0.9f;
    free(atlas);
    return count;
}

/* Two surfaces a thousandth apart at a million units; red is nearer, and drawn first or last. */
static int red_at_a_million(enum cupola_depth_format format, bool reversed, bool red_first)
{
    const double nearness[2][3] = {{1 / 1.001e6, 0, 0}, {1e-6, 0, 0}};
    const struct cupola_frame frame = {
        .depth = {.infinite = true, .reversed = reversed, .zero_to_one = reversed}};
    struct fixture fixture;
    make(&fixture, format);
    int views = cupola_gl_frame_begin(fixture.gl, &frame, NULL);
    host_depth(&frame.depth);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture.gl, i, &view, NULL), CUPOLA_OK);
        for (int pass = 0; pass < 2; pass++) {
            int is_red = (pass == 0) == red_first;
            draw_plane(fixture.plan, i, &view.camera, nearness[is_red], is_red ? red : green);
        }
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    }
    host_depth_reset();
    int count = red_pixels(&fixture);
    fixture_release(&fixture);
    return count;
}

static int pixels_of_views(void)
{
    struct fixture fixture;
    int pixels = 0;
    make(&fixture, CUPOLA_DEPTH_NONE);
    for (int i = 0; i < cupola_plan_view_count(fixture.plan); i++) {
        const struct cupola_rect *rect = &cupola_plan_view(fixture.plan, i)->rect;
        pixels += rect->width * rect->height;
    }
    fixture_release(&fixture);
    return pixels;
}

static void reversed_floats_tell_surfaces_apart_at_a_million_units(void **state)
{
    (void)state;
    if (!has_clip_control())
        skip();
    int pixels = pixels_of_views();
    assert_int_equal(red_at_a_million(CUPOLA_DEPTH_32F, true, true), pixels);
    assert_int_equal(red_at_a_million(CUPOLA_DEPTH_32F, true, false), pixels);
    assert_int_equal(red_at_a_million(CUPOLA_DEPTH_32F_STENCIL_8, true, false), pixels);
    /* The control: 24 bits from near to far cannot. */
    check_at_most(red_at_a_million(CUPOLA_DEPTH_24, false, false), pixels / 2);
}

/* Marks the part of each view where red is nearer than green, then paints where it is marked. */
static int paint_marked(const struct fixture *fixture, bool mark)
{
    int views = cupola_gl_frame_begin(fixture->gl, NULL, NULL);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        glStencilMask(0x5a); /* the host's: neither a clear's business nor lost by one */
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        GLint mask = 0;
        glGetIntegerv(GL_STENCIL_WRITEMASK, &mask);
        assert_int_equal(mask, 0x5a);
        glStencilMask(0xff);
        host_depth(&(struct cupola_depth){0});
        draw_plane(fixture->plan, i, &view.camera, nearness_green, green);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 0xff, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        if (mark)
            draw_plane(fixture->plan, i, &view.camera, nearness_red, green);
        glStencilFunc(GL_EQUAL, 0xff, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        host_depth_reset();
        draw_plane(fixture->plan, i, &view.camera, nearness_green, red);
        glDisable(GL_STENCIL_TEST);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    return red_pixels(fixture);
}

static void a_stencil_marks_and_every_view_begins_without_marks(void **state)
{
    (void)state;
    for (int format = CUPOLA_DEPTH_32F_STENCIL_8; format <= CUPOLA_DEPTH_24_STENCIL_8; format++) {
        struct fixture fixture;
        make(&fixture, (enum cupola_depth_format)format);
        int marked = paint_marked(&fixture, true);
        struct winners found = count_winners(&fixture);
        assert_int_equal(found.wrong, 0);
        check_at_least(marked, 500);
        check_at_least(found.green, 500);
        assert_int_equal(paint_marked(&fixture, false), 0);
        fixture_release(&fixture);
    }
}

static GLint attached(GLenum attachment, GLenum what)
{
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
    return value;
}

static void the_framebuffer_has_what_was_wished(void **state)
{
    static const struct {
        GLint bits, type, stencil_bits;
    } expected[DEPTHS] = {
        [CUPOLA_DEPTH_32F] = {32, GL_FLOAT, 0},
        [CUPOLA_DEPTH_24] = {24, GL_UNSIGNED_NORMALIZED, 0},
        [CUPOLA_DEPTH_32F_STENCIL_8] = {32, GL_FLOAT, 8},
        [CUPOLA_DEPTH_24_STENCIL_8] = {24, GL_UNSIGNED_NORMALIZED, 8},
        [CUPOLA_DEPTH_NONE] = {0, GL_NONE, 0},
    };
    (void)state;
    for (int format = 0; format < DEPTHS; format++) {
        struct fixture fixture;
        make(&fixture, (enum cupola_depth_format)format);
        assert_true(cupola_gl_frame_begin(fixture.gl, NULL, NULL) > 0);
        assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
        GLint kind = attached(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
        GLint stencil = attached(GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
        assert_int_equal(kind, expected[format].bits ? GL_RENDERBUFFER : GL_NONE);
        assert_int_equal(stencil, expected[format].stencil_bits ? GL_RENDERBUFFER : GL_NONE);
        if (kind != GL_NONE) {
            assert_int_equal(attached(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE),
                             expected[format].bits);
            assert_int_equal(
                attached(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE),
                expected[format].type);
        }
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        fixture_release(&fixture);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearer_surface_is_seen_in_all_formats_and_ways),
        cmocka_unit_test(without_depth_the_last_drawn_is_seen),
        cmocka_unit_test(reversed_floats_tell_surfaces_apart_at_a_million_units),
        cmocka_unit_test(a_stencil_marks_and_every_view_begins_without_marks),
        cmocka_unit_test(the_framebuffer_has_what_was_wished),
    };
    return run_triangles_group("depth_modes", tests);
}
