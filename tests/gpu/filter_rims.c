/*
 * Rims with every filter: of a scene of one colour, drawn where the mask lets it and with all else
 * in the atlas far too bright, each pixel is the mixture of border and scene by its coverage, at
 * the rim of the image circle, at that of a screen, where the frame cuts both, and where views
 * meet.
 */
#include <stdio.h>
#include <string.h>

#include "filter_cases.h"
#include "group.h"
#include "rig_random.h"
#include "triangles.h"
#include "worse.h"

static const float border[4] = {0.1f, 0.9f, 0.3f, 0.6f};
static const float scene[4] = {0.8f, 0.2f, 0.5f, 1.0f};

/* Floats know coverages within 1e-4. */
static const double bar = 2e-4;

enum { RIGS = 5, SIDE = 96 };

static struct triangles triangles;

static struct cupola_rig rig_number(int number)
{
    static const enum cupola_lens_model models[RIGS] = {
        CUPOLA_LENS_HEMISPHERIC, CUPOLA_LENS_ANGULAR, CUPOLA_LENS_STEREOGRAPHIC,
        CUPOLA_LENS_EQUISOLID, CUPOLA_LENS_HEMISPHERIC};
    static const double fovs[RIGS] = {180.0, 180.0, 150.0, 200.0, 170.0};
    static const double caps[RIGS] = {0.0, 65.0, 50.0, 80.0, 60.0};
    struct cupola_rig rig = plain_rig(models[number], fovs[number], SIDE);
    rig.outputs[0].width_px = SIDE + 5;
    rig.screen.radius_m = 1.0;
    rig.screen.cap_rad = radians(caps[number]);
    rig.eye_m[0] = number % 2 ? -0.3 : 0.1;
    rig.eye_m[2] = -0.05;
    if (number == 2)
        rig.outputs[0].circle = (struct cupola_circle){40.0, 52.0, 57.0};
    if (number >= 2)
        rig.outputs[0].position_m[1] = 0.25;
    return rig;
}

/* As a host draws, with its test of depth. */
static void draw_scene(const struct fixture *fixture)
{
    static const double nearness[3] = {0.5, 0.0, 0.0};
    const struct cupola_frame frame = {.clear_color = {1000.0f, 1000.0f, 1000.0f, 1000.0f}};
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        float points[6][3];
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        plane_over_view(fixture->plan, i, nearness, points);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        triangles_draw(&triangles, &view.camera, scene, points, 6);
        glDisable(GL_DEPTH_TEST);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
}

struct off {
    double worst;
    int rim; /* pixels that are lit in part */
};

/* `scale` times the coverages: other than 1 is wrong. */
static struct off off_of(const struct fixture *fixture, double scale)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *image = fixture_warp(fixture, 0);
    struct off off = {0.0, 0};
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        struct cupola_ray ray;
        cupola_dome_ray(fixture->dome, 0, NULL, i % size->width_px + 0.5, i / size->width_px + 0.5,
                        &ray);
        double coverage = scale * ray.coverage;
        off.rim += ray.coverage > 0.0 && ray.coverage < 1.0;
        for (int c = 0; c < 4; c++) {
            double from = (double)border[c], to = (double)scene[c];
            double wish = from + coverage * (to - from);
            off.worst = worse_of(off.worst, fabs((double)image[4 * i + c] - wish));
        }
    }
    free(image);
    return off;
}

static void set_gl(struct fixture *fixture, const struct cupola_filter *filter,
                   enum cupola_table stage)
{
    struct cupola_gl_params params = {
        .format = CUPOLA_FORMAT_RGBA32F, .filter = *filter, .table = stage};
    memcpy(params.border, border, sizeof border);
    fixture_replace_gl(fixture, &params);
    draw_scene(fixture);
}

/* Texels of views that the mask has kept from being drawn. */
static int texels_masked(const struct fixture *fixture)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    float *atlas = fixture_atlas(fixture);
    int masked = 0;
    for (int v = 0; v < cupola_plan_view_count(fixture->plan); v++) {
        const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, v)->rect;
        for (int i = 0; i < rect->width * rect->height; i++) {
            int x = rect->x + i % rect->width, y = rect->y + i / rect->width;
            masked += atlas[4 * (y * report->atlas_width_px + x)] > 999.0f;
        }
    }
    free(atlas);
    return masked;
}

static void check_filter(struct fixture *fixture, const struct cupola_filter *filter,
                         enum cupola_table stage)
{
    set_gl(fixture, filter, stage);
    check_at_least(texels_masked(fixture), 50);
    spoil_beyond_views(fixture, 0);
    struct off off = off_of(fixture, 1.0);
    if (!(off.worst <= bar))
        fail_msg("%s, %s: %g off", filter_text(filter), cupola_table_name((int)stage), off.worst);
    check_at_least(off.rim, 100);
}

static void rims_are_as_clean_as_the_inside(void **state)
{
    (void)state;
    if (!context_has_floats())
        skip();
    triangles = triangles_create();
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(number);
        /* The least guard band for what asks for four texels. */
        struct cupola_plan_params wish = {.guard_px = number == 3 ? 1 : 2};
        struct fixture fixture;
        fixture_make(&rig, &wish, NULL, &fixture);
        for (int i = 0; i < FILTERS; i++)
            if ((i + number) % RIGS < 2) /* each filter in two rigs, by one stage each */
                check_filter(&fixture, &filters[i], filter_stages[(i + number) % RIGS]);
        fixture_release(&fixture);
    }
    triangles_release(&triangles);
}

/* A coverage that is off by a thousandth, and a texel too much at the borders of views. */
static void what_is_not_clean_is_caught(void **state)
{
    (void)state;
    if (!context_has_floats())
        skip();
    triangles = triangles_create();
    for (int number = 0; number < RIGS; number += 2) {
        struct cupola_rig rig = rig_number(number);
        struct fixture fixture;
        fixture_make(&rig, NULL, NULL, &fixture);
        set_gl(&fixture, &filters[number], CUPOLA_TABLE_NONE);
        check_at_least(off_of(&fixture, 0.999).worst, 2.0 * bar);
        spoil_beyond_views(&fixture, 5);
        check_at_least(off_of(&fixture, 1.0).worst, 1.0);
        fixture_release(&fixture);
    }
    triangles_release(&triangles);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rims_are_as_clean_as_the_inside),
        cmocka_unit_test(what_is_not_clean_is_caught),
    };
    return run_gpu_group("filter_rims", tests);
}
