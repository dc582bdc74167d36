/*
 * What moving samples does and leaves alone: what is refused changes nothing, a pass over all views
 * has the cameras of each, pictures are moved too, and the mean of a ramp is the ramp.
 */
#include <stdlib.h>
#include <string.h>

#include "cupola/one_pass.h"
#include "eye_theatres.h"
#include "gl/instance.h"
#include "group.h"
#include "message.h"
#include "picture_fixture.h"
#include "worse.h"

static const double half[2] = {0.5, 0.5}, some[2] = {0.25, -0.375};

enum { SIDE_PX = 48 };

static struct cupola_rig small_rig(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 160.0, SIDE_PX);
    rig.eye_m[1] = 0.1 * rig.screen.radius_m;
    return rig;
}

static void make(const struct cupola_gl_params *params, struct fixture *fixture)
{
    const struct cupola_rig rig = small_rig();
    fixture_make(&rig, NULL, params, fixture);
}

static struct cupola_error refusal(cupola_gl *gl, const double texels[2], const double pixels[2],
                                   int expected)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_gl_set_jitter(gl, texels, pixels, &error), expected);
    assert_int_equal(error.status, expected);
    assert_int_equal(cupola_gl_set_jitter(gl, texels, pixels, NULL), expected);
    return error;
}

static void what_is_refused_changes_nothing(void **state)
{
    (void)state;
    const struct cupola_gl_params params = {.table = CUPOLA_TABLE_TILES, .jitters = true};
    const double far[2] = {0.1, -0.75}, nowhere[2] = {(double)NAN, 0};
    struct fixture fixture;
    make(&params, &fixture);
    assert_int_equal(cupola_gl_set_jitter(fixture.gl, some, half, NULL), CUPOLA_OK);
    fixture_paint(&fixture, PAINT_NOISE);
    float *before = fixture_warp(&fixture, 0);
    struct cupola_error error = refusal(fixture.gl, far, half, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, -0.75);
    error = refusal(fixture.gl, half, far, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, -0.75);
    error = refusal(fixture.gl, nowhere, NULL, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, (double)NAN);
    refusal(NULL, NULL, NULL, CUPOLA_ERROR_ARGUMENT);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
    error = refusal(fixture.gl, half, half, CUPOLA_ERROR_ORDER);
    assert_non_null(strstr(error.message, "view"));
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    fixture_paint(&fixture, PAINT_NOISE);
    float *after = fixture_warp(&fixture, 0);
    size_t bytes = 4 * sizeof *after * SIDE_PX * SIDE_PX;
    assert_memory_equal(before, after, bytes);
    assert_int_equal(cupola_gl_set_jitter(fixture.gl, NULL, NULL, NULL), CUPOLA_OK);
    float *still = fixture_warp(&fixture, 0); /* the control */
    assert_memory_not_equal(before, still, bytes);
    free(still);
    free(after);
    free(before);
    fixture_release(&fixture);
}

static void refuse(const struct fixture *fixture, const struct cupola_gl_params *params,
                   const char *named)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_gl *gl = NULL;
    assert_int_equal(cupola_gl_create(fixture->plan, params, &gl, &error), CUPOLA_ERROR_ARGUMENT);
    assert_null(gl);
    assert_non_null(strstr(error.message, named));
    assert_non_null(strstr(error.message, "allowed"));
}

static void jitters_are_for_some_tables_and_guard_bands(void **state)
{
    (void)state;
    static const enum cupola_table refused[] = {CUPOLA_TABLE_POINTS, CUPOLA_TABLE_ANGLES,
                                                CUPOLA_TABLE_SINES, CUPOLA_TABLE_COORDINATES};
    struct cupola_gl_params params = {.table = CUPOLA_TABLE_NONE};
    const struct cupola_plan_params narrow = {.guard_px = 1};
    const struct cupola_rig rig = small_rig();
    struct fixture fixture;
    make(&params, &fixture);
    struct cupola_error error = refusal(fixture.gl, NULL, NULL, CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "without jitters"));
    params.jitters = true;
    for (int i = 0; i < 4; i++) {
        params.table = refused[i];
        refuse(&fixture, &params, cupola_table_name((int)refused[i]));
    }
    params.table = CUPOLA_TABLE_AUTO;
    fixture_replace_gl(&fixture, &params);
    int stage = cupola_gl_table(fixture.gl, 0);
    assert_true(stage == CUPOLA_TABLE_TILES || stage == CUPOLA_TABLE_NONE);
    params.storage = CUPOLA_STORAGE_TEXTURES;
    fixture_replace_gl(&fixture, &params);
    error = refusal(fixture.gl, some, half, CUPOLA_ERROR_ARGUMENT);
    check_message(&error, 0.25);
    assert_int_equal(cupola_gl_set_jitter(fixture.gl, NULL, half, NULL), CUPOLA_OK);
    params.storage = CUPOLA_STORAGE_ATLAS;
    fixture_release(&fixture);
    fixture_make(&rig, &narrow, &(struct cupola_gl_params){.table = CUPOLA_TABLE_NONE}, &fixture);
    params.table = CUPOLA_TABLE_NONE;
    refuse(&fixture, &params, "guard band is 1");
    fixture_release(&fixture);
}

static void a_pass_has_the_cameras_of_moved_views(void **state)
{
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    const struct cupola_gl_params params = {
        .table = CUPOLA_TABLE_TILES, .jitters = true, .one_pass = true};
    struct fixture fixture;
    struct cupola_gl_pass pass, still;
    make(&params, &fixture);
    check_at_least(cupola_gl_frame_begin(fixture.gl, NULL, NULL), 1);
    assert_int_equal(cupola_gl_pass_begin(fixture.gl, NULL, &still, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_pass_end(fixture.gl, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_jitter(fixture.gl, some, half, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_pass_begin(fixture.gl, NULL, &pass, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_jitter(fixture.gl, some, half, NULL), CUPOLA_ERROR_ORDER);
    assert_int_equal(cupola_gl_pass_end(fixture.gl, NULL), CUPOLA_OK);
    for (int i = 0; i < pass.view_count; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture.gl, i, &view, NULL), CUPOLA_OK);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        assert_memory_equal(pass.views[i].camera.projection, view.camera.projection,
                            sizeof view.camera.projection);
        assert_memory_not_equal(still.views[i].camera.projection, view.camera.projection,
                                sizeof view.camera.projection);
    }
    fixture_release(&fixture);
}

/* ---- colours that are directions ---- */

/* The largest distance of what whole pixels show from the wished place beside theirs, px. */
static double beside(const struct fixture *fixture, const float *image, const double wished[2])
{
    double worst = 0;
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++) {
        double x = i % SIDE_PX + 0.5, y = (double)(i / SIDE_PX) + 0.5, place[2], shown[3];
        struct cupola_ray ray;
        cupola_dome_ray(fixture->dome, 0, NULL, x, y, &ray);
        if (ray.coverage < 1)
            continue;
        for (int k = 0; k < 3; k++)
            shown[k] = (double)image[4 * i + k];
        if (cupola_dome_pixel(fixture->dome, 0, NULL, shown, place) == 1)
            worst = worse_of(worst, hypot(place[0] - x - wished[0], place[1] - y - wished[1]));
        else
            worst = HUGE_VAL;
    }
    return worst;
}

static void pictures_are_seen_by_moved_rays(void **state)
{
    (void)state;
    enum { FACE = 64 };
    const struct cupola_gl_params params = {.sources = 1u << CUPOLA_SOURCE_CUBE, .jitters = true};
    struct cupola_source source = {.kind = CUPOLA_SOURCE_CUBE};
    float *picture = malloc(6 * 4 * sizeof *picture * FACE * FACE);
    struct fixture fixture;
    assert_non_null(picture);
    for (int i = 0; i < 6 * FACE * FACE; i++) {
        float s = ((float)(i % FACE) + 0.5f) * 2 / FACE - 1;
        float t = ((float)(i / FACE % FACE) + 0.5f) * 2 / FACE - 1;
        /* As GL has its faces: +X -X +Y -Y +Z -Z. */
        const float to[6][3] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                                {s, -1, -t}, {s, -t, 1},  {-s, -t, -1}};
        memcpy(picture + 4 * i, to[i / FACE / FACE], 3 * sizeof *picture);
    }
    make(&params, &fixture);
    picture_upload(&source, picture, FACE);
    assert_int_equal(cupola_gl_set_jitter(fixture.gl, some, some, NULL), CUPOLA_OK);
    float *image = picture_shown(&fixture, &source);
    check_at_most(beside(&fixture, image, some), 0.1);
    check_at_least(beside(&fixture, image, (const double[2]){0, 0}), 0.4);
    free(image);
    free(picture);
    glDeleteTextures(1, &source.texture);
    fixture_release(&fixture);
}

/* How far the mean of some frames is from the ray of the pixel's middle; every `step` of them. */
static double ramp_error(const struct fixture *fixture, int step)
{
    enum { FRAMES = 16 };
    static float mean[4 * SIDE_PX * SIDE_PX];
    memset(mean, 0, sizeof mean);
    for (int frame = 0; frame < FRAMES; frame += step) {
        double texels[2], pixels[2];
        assert_int_equal(cupola_jitter_place(frame, texels, pixels), CUPOLA_OK);
        assert_int_equal(cupola_gl_set_jitter(fixture->gl, texels, pixels, NULL), CUPOLA_OK);
        fixture_paint(fixture, PAINT_DIRECTIONS);
        float *image = fixture_warp(fixture, 0);
        for (int i = 0; i < 4 * SIDE_PX * SIDE_PX; i++)
            mean[i] += image[i];
        free(image);
    }
    return beside(fixture, mean, (const double[2]){0, 0});
}

static void the_mean_of_a_ramp_is_the_ramp(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F,
                                                .table = i ? CUPOLA_TABLE_TILES : CUPOLA_TABLE_NONE,
                                                .jitters = true};
        struct fixture fixture;
        make(&params, &fixture);
        check_at_most(ramp_error(&fixture, 1), 0.01);
        check_at_least(ramp_error(&fixture, 2), 0.03); /* the control: without mirror images */
        fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_refused_changes_nothing),
        cmocka_unit_test(jitters_are_for_some_tables_and_guard_bands),
        cmocka_unit_test(a_pass_has_the_cameras_of_moved_views),
        cmocka_unit_test(pictures_are_seen_by_moved_rays),
        cmocka_unit_test(the_mean_of_a_ramp_is_the_ramp),
    };
    return run_gpu_group("jitter_manners", tests);
}
