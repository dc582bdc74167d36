/*
 * Several samples per texel: what view_end leaves in the atlas is their mean, in linear light, and
 * the warp shows that atlas as the C reference does.
 *
 * An edge cuts every view at an odd angle. A texel's expected value is the part of it that lies on
 * the white side. N samples tell it in steps of 1/N; where they stand in a texel is the GL's
 * choice, by which a straight edge errs by up to 1/N more.
 */
#include <stdio.h>
#include <stdlib.h>

#include "atlas_decode.h"
#include "group.h"
#include "rig_random.h"
#include "triangles.h"

enum { SIZE = 96 };

static const char *const format_names[] = {"rgba8", "rgba16f", "rgba32f", "srgb8"};

static const struct cupola_rig *round_rig(void)
{
    static struct cupola_rig rig;
    rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    return &rig;
}

/* The most samples that this GL has of a format: what the message of a refusal says. */
static int most_samples(const cupola_plan *plan, enum cupola_format format)
{
    const struct cupola_gl_params params = {.format = format, .samples = 1 << 20};
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_gl *gl = NULL;
    int status = cupola_gl_create(plan, &params, &gl, &error);
    if (status == CUPOLA_ERROR_GL)
        return 0; /* not at all */
    assert_int_equal(status, CUPOLA_ERROR_ARGUMENT);
    const char *allowed = strstr(error.message, ": 0 to ");
    assert_non_null(allowed);
    return atoi(allowed + 7);
}

/* The white side of the edge, 1 px along the normal being 1: x cos + y sin > offset, from a view's
 * centre. */
struct edge {
    double normal[2], offset_px;
};

static struct edge edge_of_view(int view)
{
    double angle = 0.4 + 1.1 * view;
    return (struct edge){{cos(angle), sin(angle)}, 0.37 * view - 0.6};
}

/* A rectangle at distance 1 that ends at the edge and else reaches far beyond the view. */
static void white_side(const cupola_plan *plan, int index, float points[6][3])
{
    static const int corners[6][2] = {{-1, 0}, {1, 0}, {1, 1}, {-1, 0}, {1, 1}, {-1, 1}};
    const struct cupola_view *view = cupola_plan_view(plan, index);
    struct edge edge = edge_of_view(index);
    double far_px = 2.0 * (view->rect.width + view->rect.height);
    for (int i = 0; i < 6; i++) {
        double along = far_px * corners[i][0], across = edge.offset_px + far_px * corners[i][1];
        double x = along * -edge.normal[1] + across * edge.normal[0] + 0.5 * view->rect.width;
        double y = along * edge.normal[0] + across * edge.normal[1] + 0.5 * view->rect.height;
        double a = view->left + x * (view->right - view->left) / view->rect.width;
        double b = view->bottom + y * (view->top - view->bottom) / view->rect.height;
        for (int k = 0; k < 3; k++)
            points[i][k] =
                (float)(a * view->rotation[k] + b * view->rotation[3 + k] - view->rotation[6 + k]);
    }
}

/* The part of a texel on the white side, by many points in it. */
static double white_part(const struct cupola_view *view, int index, int x, int y)
{
    enum { FINE = 32 };
    struct edge edge = edge_of_view(index);
    int inside = 0;
    for (int j = 0; j < FINE; j++)
        for (int i = 0; i < FINE; i++) {
            double px = x + (i + 0.5) / FINE - 0.5 * view->rect.width;
            double py = y + (j + 0.5) / FINE - 0.5 * view->rect.height;
            inside += px * edge.normal[0] + py * edge.normal[1] > edge.offset_px;
        }
    return inside / (double)(FINE * FINE);
}

static void draw_edges(const struct fixture *fixture)
{
    const float white[4] = {1, 1, 1, 1};
    struct triangles triangles = triangles_create();
    struct cupola_frame frame = {.clear_color = {0, 0, 0, 1}};
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        float points[6][3];
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        white_side(fixture->plan, i, points);
        triangles_draw(&triangles, &view.camera, white, points, 6);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    triangles_release(&triangles);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

struct edges {
    double off_step; /* from the nearest multiple of 1/samples, at most */
    double off_part; /* from the part of the texel, at most */
    int between;     /* texels neither black nor white */
};

static struct edges measure_edges(const struct fixture *fixture, const float *atlas, int samples)
{
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    struct edges found = {0, 0, 0};
    for (int k = 0; k < cupola_plan_view_count(fixture->plan); k++) {
        const struct cupola_view *view = cupola_plan_view(fixture->plan, k);
        for (int y = 0; y < view->rect.height; y++)
            for (int x = 0; x < view->rect.width; x++) {
                double value = (double)atlas[4 * ((view->rect.y + y) * width + view->rect.x + x)];
                double step = round(value * samples) / samples;
                found.off_step = fmax(found.off_step, fabs(value - step));
                found.off_part = fmax(found.off_part, fabs(value - white_part(view, k, x, y)));
                found.between += value > 0.01 && value < 0.99;
            }
    }
    return found;
}

static void make(struct fixture *fixture, enum cupola_format format, int samples)
{
    const struct cupola_gl_params params = {.format = format, .samples = samples};
    fixture_make(round_rig(), NULL, &params, fixture);
}

static void check_warp(const struct fixture *fixture, enum cupola_format format)
{
    struct warp_error error = warp_error_of(fixture, format);
    printf("%s: warp %.4f apart, %d of %d pixels at borders of views\n", format_names[format],
           error.worst, error.skipped, error.lit);
    check_at_least(error.lit, SIZE * SIZE / 2);
    check_at_most(error.skipped, SIZE);
    check_at_most(error.worst, bar_of_format(format));
}

static void edges_are_averaged_in_linear_light_and_warp_so(void **state)
{
    struct fixture fixture;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8, 1);
    for (int format = 0; format < 4; format++) {
        int most = most_samples(fixture.plan, (enum cupola_format)format);
        if (most < 2)
            continue;
        const struct cupola_gl_params params = {.format = (enum cupola_format)format,
                                                .samples = most};
        fixture_replace_gl(&fixture, &params);
        draw_edges(&fixture);
        float *atlas = fixture_atlas(&fixture);
        decode_atlas(&fixture, (enum cupola_format)format, atlas);
        struct edges edges = measure_edges(&fixture, atlas, most);
        printf("%s, %d samples: %.4f off a step, %.3f off the area, %d texels between\n",
               format_names[format], most, edges.off_step, edges.off_part, edges.between);
        check_at_most(edges.off_step, 0.006); /* a byte's half step, decoded near white */
        check_at_most(edges.off_part, 2.0 / most);
        check_at_least(edges.between, 100);
        check_warp(&fixture, (enum cupola_format)format);
        free(atlas);
    }
    fixture_release(&fixture);
}

static void one_sample_knows_nothing_in_between(void **state)
{
    struct fixture fixture;
    (void)state;
    for (int samples = 0; samples < 2; samples++) {
        make(&fixture, CUPOLA_FORMAT_RGBA8, samples);
        draw_edges(&fixture);
        float *atlas = fixture_atlas(&fixture);
        struct edges edges = measure_edges(&fixture, atlas, 1);
        assert_int_equal(edges.between, 0);
        check_at_least(edges.off_part, 0.3);
        free(atlas);
        fixture_release(&fixture);
    }
}

/* A mean of encoded values is what the check of steps is there to find. */
static void a_mean_of_encoded_values_would_be_caught(void **state)
{
    (void)state;
    double worst = 0;
    for (int step = 1; step < 4; step++) {
        double value = srgb_decoded(step / 4.0);
        worst = fmax(worst, fabs(value - round(value * 4) / 4));
    }
    check_at_least(worst, 0.03);
}

static int differing_texels(const float *a, const float *b, int count)
{
    int differing = 0;
    for (int i = 0; i < 4 * count; i++)
        differing += fabs((double)a[i] - (double)b[i]) > 1e-6;
    return differing;
}

/* What is drawn into one view, or left over there, is not in another one's texels. */
static void only_the_view_that_ends_is_resolved(void **state)
{
    struct fixture fixture;
    const struct cupola_frame red = {.clear_color = {1, 0, 0, 1}};
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8, 2);
    const struct cupola_plan_report *report = cupola_plan_report(fixture.plan);
    int width = report->atlas_width_px, texels = width * report->atlas_height_px;
    draw_edges(&fixture);
    float *before = fixture_atlas(&fixture);
    assert_true(cupola_gl_frame_begin(fixture.gl, &red, NULL) > 1);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 1, NULL, NULL), CUPOLA_OK);
    float *during = fixture_atlas(&fixture);
    assert_int_equal(differing_texels(before, during, texels), 0);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    float *after = fixture_atlas(&fixture);
    const struct cupola_rect *rect = &cupola_plan_view(fixture.plan, 1)->rect;
    for (int i = 0; i < texels; i++) {
        int x = i % width - rect->x, y = i / width - rect->y;
        bool inside = x >= 0 && y >= 0 && x < rect->width && y < rect->height;
        check_near(after[4 * i], inside ? 1 : before[4 * i], 1e-6);
        check_near(after[4 * i + 1], inside ? 0 : before[4 * i + 1], 1e-6);
    }
    free(before);
    free(during);
    free(after);
    fixture_release(&fixture);
}

static void keep_created(int level, int id, const char *text, void *told)
{
    (void)level;
    if (id == CUPOLA_LOG_CREATED)
        snprintf(told, 1200, "%s", text);
}

static void a_number_of_samples_that_is_not_to_be_had_is_refused(void **state)
{
    static const int bad[] = {-1, 1000, 1 << 30};
    struct fixture fixture;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8, 1);
    for (int i = 0; i < 3; i++) {
        const struct cupola_gl_params params = {.samples = bad[i], .depth = CUPOLA_DEPTH_24};
        struct cupola_error error = {CUPOLA_OK, ""};
        char number[32];
        cupola_gl *gl = NULL;
        assert_int_equal(cupola_gl_create(fixture.plan, &params, &gl, &error),
                         CUPOLA_ERROR_ARGUMENT);
        snprintf(number, sizeof number, "samples is %d; allowed", bad[i]);
        assert_non_null(strstr(error.message, number));
        assert_non_null(strstr(error.message, "RGBA8 with depth 24"));
        assert_null(gl);
    }
    for (int samples = 0; samples <= most_samples(fixture.plan, CUPOLA_FORMAT_RGBA8); samples++) {
        const struct cupola_gl_params params = {.samples = samples};
        fixture_replace_gl(&fixture, &params);
    }
    fixture_release(&fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* The GL may round a wish up. */
static void the_number_of_samples_is_told(void **state)
{
    struct fixture fixture;
    GLint samples = 0;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8, 1);
    for (int wish = 0; wish <= most_samples(fixture.plan, CUPOLA_FORMAT_RGBA8); wish++) {
        char told[1200] = "", number[32];
        struct cupola_gl_view view;
        const struct cupola_gl_params params = {.samples = wish,
                                                .log = {keep_created, told, CUPOLA_LOG_INFO}};
        fixture_replace_gl(&fixture, &params);
        check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
        assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, &view, NULL), CUPOLA_OK);
        glGetIntegerv(GL_SAMPLES, &samples);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        check_at_least(samples, wish > 1 ? wish : 0);
        snprintf(number, sizeof number, "samples %d,", samples > 1 ? samples : 1);
        if (!strstr(told, number))
            fail_msg("'%s' does not say '%s'", told, number);
    }
    fixture_release(&fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void every_format_goes_with_every_depth_and_number_of_samples(void **state)
{
    struct fixture fixture;
    int made = 0;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_RGBA8, 1);
    for (int format = 0; format < 4; format++) {
        int most = most_samples(fixture.plan, (enum cupola_format)format);
        for (int depth = 0; depth <= CUPOLA_DEPTH_NONE; depth++)
            for (int samples = 1; samples <= most; samples++) {
                const struct cupola_gl_params params = {.format = (enum cupola_format)format,
                                                        .depth = (enum cupola_depth_format)depth,
                                                        .samples = samples,
                                                        .table = CUPOLA_TABLE_NONE};
                fixture_replace_gl(&fixture, &params);
                draw_edges(&fixture);
                made++;
            }
    }
    printf("%d made\n", made);
    check_at_least(made, 10);
    fixture_release(&fixture);
}

/* The view is resolved, and the host has its framebuffer again. */
static void destroying_ends_an_open_view(void **state)
{
    struct fixture fixture;
    GLint framebuffer = -1;
    (void)state;
    make(&fixture, CUPOLA_FORMAT_SRGB8, 2);
    assert_true(cupola_gl_frame_begin(fixture.gl, NULL, NULL) > 0);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
    cupola_gl_destroy(&fixture.gl);
    assert_null(fixture.gl);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    assert_int_equal(framebuffer, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_are_averaged_in_linear_light_and_warp_so),
        cmocka_unit_test(one_sample_knows_nothing_in_between),
        cmocka_unit_test(a_mean_of_encoded_values_would_be_caught),
        cmocka_unit_test(only_the_view_that_ends_is_resolved),
        cmocka_unit_test(a_number_of_samples_that_is_not_to_be_had_is_refused),
        cmocka_unit_test(the_number_of_samples_is_told),
        cmocka_unit_test(every_format_goes_with_every_depth_and_number_of_samples),
        cmocka_unit_test(destroying_ends_an_open_view),
    };
    return run_gpu_group("multisample", tests);
}
