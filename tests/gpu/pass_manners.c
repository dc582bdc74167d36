/* What a pass over all views answers at wrong moments and to wrong wishes; its shader text. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "confetti.h"
#include "group.h"
#include "rig_random.h"

enum { TEXT = 16384 };

static void make(struct fixture *fixture, bool one_pass)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 32);
    const struct cupola_gl_params params = {.one_pass = one_pass, .table = CUPOLA_TABLE_NONE};
    fixture_make(&rig, NULL, &params, fixture);
}

/* Says so, in words. */
static void refuses(int status, int expected, const struct cupola_error *error, const char *words)
{
    if (status != expected || error->status != (enum cupola_status)expected)
        fail_msg("status %d instead of %d: %s", status, expected, error->message);
    if (!strstr(error->message, words))
        fail_msg("'%s' is not in: %s", words, error->message);
}

static void contexts_that_cannot_say_what_is_missing(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 32);
    const struct cupola_gl_params params = {.one_pass = true};
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture = {NULL, NULL, NULL};
    char text[TEXT] = "as it was";
    (void)state;
    if (cupola_pass_way(&error) > 0)
        skip();
    refuses(cupola_pass_way(&error), CUPOLA_ERROR_GL, &error, "viewport_array");
    refuses(cupola_pass_glsl(NULL, text, sizeof text, &error), CUPOLA_ERROR_GL, &error, "view by");
    assert_string_equal(text, "as it was");
    assert_int_equal(cupola_dome_create(&rig, &fixture.dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(fixture.dome, NULL, &fixture.plan, NULL), CUPOLA_OK);
    refuses(cupola_gl_create(fixture.plan, &params, &fixture.gl, &error), CUPOLA_ERROR_GL, &error,
            "one pass");
    assert_null(fixture.gl);
    fixture_release(&fixture);
    make(&fixture, false); /* the control: all else is there */
    refuses(cupola_gl_pass_begin(fixture.gl, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
            "one_pass");
    fixture_release(&fixture);
}

static void wishes_that_do_not_go_together_are_refused(void **state)
{
    const struct cupola_gl_params wishes[] = {
        {.one_pass = true, .storage = CUPOLA_STORAGE_TEXTURES},
        {.one_pass = true, .storage = CUPOLA_STORAGE_LAYERS},
        {.one_pass = true, .sources = 1u << CUPOLA_SOURCE_DOMEMASTER},
    };
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture;
    (void)state;
    make(&fixture, false);
    for (int i = 0; i < 3; i++) {
        cupola_gl *gl = NULL;
        refuses(cupola_gl_create(fixture.plan, &wishes[i], &gl, &error), CUPOLA_ERROR_ARGUMENT,
                &error, "one_pass");
        assert_null(gl);
    }
    assert_true(cupola_gl_frame_begin(fixture.gl, NULL, NULL) > 0);
    refuses(cupola_gl_pass_begin(fixture.gl, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error,
            "one_pass");
    refuses(cupola_gl_pass_begin(NULL, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT, &error, "NULL");
    refuses(cupola_gl_pass_end(NULL, &error), CUPOLA_ERROR_ARGUMENT, &error, "NULL");
    refuses(cupola_gl_pass_end(fixture.gl, &error), CUPOLA_ERROR_ORDER, &error, "pass");
    fixture_release(&fixture);
}

static void a_pass_has_its_time(void **state)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_pass pass = {.view_count = 77};
    float world[16] = {[7] = NAN};
    unsigned int points = 0;
    struct fixture fixture;
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    make(&fixture, true);
    cupola_gl *gl = fixture.gl;
    refuses(cupola_gl_pass_begin(gl, NULL, &pass, &error), CUPOLA_ERROR_ORDER, &error, "frame");
    assert_true(cupola_gl_frame_begin(gl, NULL, NULL) > 0);
    refuses(cupola_gl_pass_begin(gl, world, &pass, &error), CUPOLA_ERROR_ARGUMENT, &error,
            "world[7]");
    assert_int_equal(cupola_gl_view_begin(gl, 0, NULL, NULL), CUPOLA_OK);
    refuses(cupola_gl_pass_begin(gl, NULL, &pass, &error), CUPOLA_ERROR_ORDER, &error, "a view");
    refuses(cupola_gl_pass_end(gl, &error), CUPOLA_ERROR_ORDER, &error, "outside of a pass");
    assert_int_equal(cupola_gl_view_end(gl, NULL), CUPOLA_OK);
    assert_int_equal(pass.view_count, 77);
    for (int twice = 0; twice < 2; twice++) {
        assert_int_equal(cupola_gl_pass_begin(gl, NULL, &pass, NULL), CUPOLA_OK);
        assert_int_equal(pass.view_count, cupola_plan_view_count(fixture.plan));
        refuses(cupola_gl_pass_begin(gl, NULL, NULL, &error), CUPOLA_ERROR_ORDER, &error, "a pass");
        refuses(cupola_gl_view_begin(gl, 0, NULL, &error), CUPOLA_ERROR_ORDER, &error, "a pass");
        refuses(cupola_gl_view_end(gl, &error), CUPOLA_ERROR_ORDER, &error, "outside of a view");
        refuses(cupola_gl_frame_begin(gl, NULL, &error), CUPOLA_ERROR_ORDER, &error, "a pass");
        refuses(cupola_gl_warp(gl, 0, NULL, NULL, &error), CUPOLA_ERROR_ORDER, &error, "a pass");
        refuses(cupola_gl_points(gl, 0, &points, &error), CUPOLA_ERROR_ORDER, &error, "a pass");
        refuses(cupola_gl_density(gl, 0, &points, &error), CUPOLA_ERROR_ORDER, &error, "a pass");
        assert_int_equal(cupola_gl_pass_end(gl, NULL), CUPOLA_OK);
    }
    assert_int_equal(cupola_gl_pass_begin(gl, NULL, NULL, NULL), CUPOLA_OK);
    fixture_release(&fixture); /* in a pass: it is ended */
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* What the host culls by is what it would be told view by view. */
static void views_are_those_of_view_begin(void **state)
{
    const struct cupola_frame frame = {.depth = {0.5, 70, .reversed = true}};
    struct cupola_gl_pass pass;
    struct fixture fixture;
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    make(&fixture, true);
    assert_true(cupola_gl_frame_begin(fixture.gl, &frame, NULL) > 0);
    assert_int_equal(cupola_gl_pass_begin(fixture.gl, NULL, &pass, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_pass_end(fixture.gl, NULL), CUPOLA_OK);
    check_at_least(pass.view_count, 2);
    for (int i = 0; i < pass.view_count; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture.gl, i, &view, NULL), CUPOLA_OK);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        assert_memory_equal(&view.rect, &pass.views[i].rect, sizeof view.rect);
        assert_memory_equal(view.camera.projection, pass.views[i].camera.projection,
                            sizeof view.camera.projection);
        assert_memory_equal(view.camera.planes, pass.views[i].camera.planes,
                            sizeof view.camera.planes);
        assert_int_equal(view.framebuffer, pass.framebuffer);
        if (i > 0) /* the control */
            assert_memory_not_equal(view.camera.planes, pass.views[0].camera.planes,
                                    sizeof view.camera.planes);
    }
    fixture_release(&fixture);
}

static int glsl(struct cupola_pass_shader shader, char text[TEXT], struct cupola_error *error)
{
    snprintf(text, TEXT, "as it was");
    return cupola_pass_glsl(&shader, text, TEXT, error);
}

static void wrong_wishes_for_text_are_refused(void **state)
{
    static const char *const wrong[] = {"normal",
                                        "",
                                        "vec3 gl_Color",
                                        "vec3 2nd",
                                        "vec3 normal[2]",
                                        "vec3 a;",
                                        "flat normal",
                                        "vec3 cupola_x",
                                        "vec3\nnormal",
                                        NULL,
                                        "out vec3 a",
                                        "vec3 a b c",
                                        "struct x",
                                        "vec3 main",
                                        "vec3 out",
                                        "centroid noperspective vec2",
                                        "flat smooth vec3 a",
                                        "invariant vec3 zz",
                                        "centroid centroid vec3 a",
                                        "flat centroid flat vec3 a",
                                        "sampler2D a",
                                        "vec5 a",
                                        "highp lowp vec3 a",
                                        "vec3 highp a",
                                        "vec3 vec2",
                                        "bool b",
                                        "vec3 1"};
    struct cupola_error error = {CUPOLA_OK, ""};
    char text[TEXT];
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        struct cupola_pass_shader shader = {
            .way = CUPOLA_PASS_GEOMETRY, .varyings = &wrong[i], .varying_count = 1};
        refuses(glsl(shader, text, &error), CUPOLA_ERROR_ARGUMENT, &error, "varying 0");
        assert_string_equal(text, "as it was");
    }
    const struct {
        struct cupola_pass_shader shader;
        const char *words;
    } others[] = {
        {{.way = (enum cupola_pass_way)3}, "way"},
        {{.way = CUPOLA_PASS_GEOMETRY, .stage = (enum cupola_pass_stage)2}, "stage"},
        {{.way = CUPOLA_PASS_GEOMETRY, .primitive = (enum cupola_pass_primitive)3}, "primitive"},
        {{.way = CUPOLA_PASS_GEOMETRY, .varying_count = 1}, "varyings is NULL"},
        {{.way = CUPOLA_PASS_GEOMETRY, .varying_count = -1}, "varying_count"},
        {{.way = CUPOLA_PASS_GEOMETRY, .varying_count = CUPOLA_PASS_VARYINGS_MAX + 1}, "allowed"},
    };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        refuses(glsl(others[i].shader, text, &error), CUPOLA_ERROR_ARGUMENT, &error,
                others[i].words);
    refuses(cupola_pass_glsl(NULL, NULL, TEXT, &error), CUPOLA_ERROR_ARGUMENT, &error, "NULL");
    if (cupola_pass_way(NULL) == CUPOLA_PASS_VERTEX)
        refuses(
            glsl((struct cupola_pass_shader){.stage = CUPOLA_PASS_STAGE_GEOMETRY}, text, &error),
            CUPOLA_ERROR_ARGUMENT, &error, "no geometry shader");
    else
        refuses(glsl((struct cupola_pass_shader){.way = CUPOLA_PASS_VERTEX}, text, &error),
                CUPOLA_ERROR_GL, &error, "geometry shader");
}

static void text_fits_to_the_byte(void **state)
{
    static const char *const varyings[] = {"vec3 normal", " flat  highp ivec4 mark ", "vec2 uv"};
    struct cupola_error error = {CUPOLA_OK, ""};
    char text[TEXT], exact[TEXT];
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    for (int stage = 0; stage < 2; stage++) {
        struct cupola_pass_shader shader = {.way = CUPOLA_PASS_GEOMETRY,
                                            .stage = (enum cupola_pass_stage)stage,
                                            .varyings = varyings,
                                            .varying_count = 3};
        int length = glsl(shader, text, &error);
        assert_int_equal(length, (int)strlen(text));
        assert_int_equal(text[length - 1], '\n');
        memset(exact, 'x', sizeof exact);
        refuses(cupola_pass_glsl(&shader, exact, (size_t)length, &error), CUPOLA_ERROR_ARGUMENT,
                &error, "size");
        assert_int_equal(exact[0], 'x');
        assert_int_equal(cupola_pass_glsl(&shader, exact, (size_t)length + 1, &error), length);
        assert_string_equal(exact, text);
        assert_int_equal(exact[length + 1], 'x');
        assert_non_null(strstr(text, "cupola_to_mark"));
        if (stage == 1)
            assert_non_null(strstr(text, "flat out highp ivec4 mark;"));
    }
}

/* What declares a varying is taken as it is: the control of those refused. */
static void declarations_are_taken(void **state)
{
    static const char *const right[] = {"float a",
                                        "centroid vec2 b_2",
                                        "flat uint _c",
                                        "smooth centroid mat4x3 d",
                                        "centroid smooth mediump vec4 Main",
                                        "  flat   highp   ivec3   outer  ",
                                        "vec3 flatness"};
    struct cupola_error error = {CUPOLA_OK, ""};
    char text[TEXT];
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    struct cupola_pass_shader shader = {.way = CUPOLA_PASS_GEOMETRY,
                                        .varyings = right,
                                        .varying_count = sizeof right / sizeof right[0]};
    if (glsl(shader, text, &error) < 0)
        fail_msg("%s", error.message);
    assert_non_null(strstr(text, "#define outer cupola_to_outer\n"));
}

/* The most that is promised to fit, and what a GL compiles. */
static void text_of_many_varyings_fits(void **state)
{
    static char words[CUPOLA_PASS_VARYINGS_MAX][61];
    static const char *varyings[CUPOLA_PASS_VARYINGS_MAX];
    char text[TEXT];
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    for (int i = 0; i < CUPOLA_PASS_VARYINGS_MAX; i++) {
        snprintf(words[i], sizeof words[i], "centroid flat vec4 %040d", i);
        words[i][19] = 'n';
        varyings[i] = words[i];
    }
    for (int stage = 0; stage < 2; stage++) {
        struct cupola_pass_shader shader = {CUPOLA_PASS_GEOMETRY, (enum cupola_pass_stage)stage,
                                            varyings, CUPOLA_PASS_VARYINGS_MAX,
                                            CUPOLA_PASS_TRIANGLES};
        if (glsl(shader, text, &error) < 0)
            fail_msg("%s", error.message);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contexts_that_cannot_say_what_is_missing),
        cmocka_unit_test(wishes_that_do_not_go_together_are_refused),
        cmocka_unit_test(a_pass_has_its_time),
        cmocka_unit_test(views_are_those_of_view_begin),
        cmocka_unit_test(wrong_wishes_for_text_are_refused),
        cmocka_unit_test(text_fits_to_the_byte),
        cmocka_unit_test(declarations_are_taken),
        cmocka_unit_test(text_of_many_varyings_fits),
    };
    return run_gpu_group("pass_manners", tests);
}
