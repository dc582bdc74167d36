/*
 * The host's own words round the text of a pass: its #extension lines before it, and clip distances
 * through a geometry shader.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "rig_random.h"

enum { TEXT = 16384, BINDING = 2, CLIPPED = 1, DISTANCES = 2 };

static const char *version(void)
{
    return context_is_es() ? "#version 320 es\n" : "#version 330 core\n";
}

/* One that is known wherever there is a pass. */
static const char *extension(void)
{
    return context_is_es() ? "#extension GL_EXT_clip_cull_distance : enable\n"
                           : "#extension GL_ARB_explicit_attrib_location : require\n";
}

/* A triangle over all of each view, of which the second distance clips the left half away. */
static const char host_vertex[] =
    "uniform bool clipped;\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_ClipDistance[0] = 1.0;\n"
    "    gl_ClipDistance[1] = clipped ? corner.x : 1.0;\n"
    "    cupola_send(vec4(corner, 0.0, 1.0), cupola_view());\n"
    "}\n";

static const char host_fragment[] = "precision highp float;\n"
                                    "out vec4 color;\n"
                                    "void main() { color = vec4(1.0, 0.0, 0.0, 1.0); }\n";

static void write_text(enum cupola_pass_way way, enum cupola_pass_stage stage, char text[TEXT])
{
    const struct cupola_pass_shader wish = {
        .way = way, .stage = stage, .clip_distances = DISTANCES};
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_pass_glsl(&wish, text, TEXT, &error) < 0)
        fail_msg("%s", error.message);
}

static GLuint program_of(enum cupola_pass_way way)
{
    char text[TEXT];
    GLuint program = glCreateProgram();
    write_text(way, CUPOLA_PASS_STAGE_VERTEX, text);
    assert_true(context_attach(program, GL_VERTEX_SHADER,
                               (const char *const[]){version(), extension(), text, host_vertex},
                               4));
    if (way == CUPOLA_PASS_GEOMETRY) {
        write_text(way, CUPOLA_PASS_STAGE_GEOMETRY, text);
        assert_true(
            context_attach(program, GL_GEOMETRY_SHADER, (const char *const[]){version(), text}, 2));
    }
    assert_true(context_attach(program, GL_FRAGMENT_SHADER,
                               (const char *const[]){version(), host_fragment}, 2));
    context_link(program);
    glUniformBlockBinding(program, glGetUniformBlockIndex(program, "cupola_pass"), BINDING);
    return program;
}

/* Red texels of the views' left halves, and of the right ones; both of all of them. */
struct halves {
    int left, right, all;
};

static struct halves draw(const struct fixture *fixture, GLuint program, bool clipped)
{
    struct halves count = {0, 0, 0};
    struct cupola_gl_pass pass;
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    check_at_least(cupola_gl_frame_begin(fixture->gl, NULL, NULL), 2);
    assert_int_equal(cupola_gl_pass_begin(fixture->gl, NULL, &pass, NULL), CUPOLA_OK);
    glUseProgram(program);
    glBindBufferBase(GL_UNIFORM_BUFFER, BINDING, pass.buffer);
    glUniform1i(glGetUniformLocation(program, "clipped"), clipped);
    glEnable(GL_CLIP_DISTANCE0 + CLIPPED);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, pass.view_count);
    glDisable(GL_CLIP_DISTANCE0 + CLIPPED);
    glUseProgram(0);
    assert_int_equal(cupola_gl_pass_end(fixture->gl, NULL), CUPOLA_OK);
    float *atlas = fixture_atlas(fixture);
    for (int v = 0; v < pass.view_count; v++)
        for (int i = 0; i < pass.views[v].rect.width * pass.views[v].rect.height; i++) {
            const struct cupola_rect *rect = &pass.views[v].rect;
            int x = i % rect->width, y = i / rect->width;
            bool red = atlas[4 * ((rect->y + y) * width + rect->x + x)] > 0.9f;
            count.left += red && 2 * x + 2 <= rect->width;
            count.right += red && 2 * x >= rect->width;
            count.all += 2 * x >= rect->width;
        }
    free(atlas);
    return count;
}

static void check_way(enum cupola_pass_way way)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    const struct cupola_gl_params params = {
        .one_pass = true, .table = CUPOLA_TABLE_NONE, .mask = CUPOLA_MASK_NONE};
    struct fixture fixture;
    GLuint vertex_array;
    fixture_make(&rig, NULL, &params, &fixture);
    GLuint program = program_of(way);
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    struct halves clipped = draw(&fixture, program, true);
    struct halves whole = draw(&fixture, program, false); /* the control */
    assert_int_equal(clipped.left, 0);
    assert_int_equal(clipped.right, clipped.all);
    assert_int_equal(whole.right, whole.all);
    check_at_least(whole.left, 0.9 * whole.all);
    glDeleteVertexArrays(1, &vertex_array);
    glDeleteProgram(program);
    fixture_release(&fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static bool has_clip_distances(void)
{
    return context_has(33, NULL, 1000, "GL_EXT_clip_cull_distance");
}

static void clip_distances_reach_the_clipping_either_way(void **state)
{
    (void)state;
    if (cupola_pass_way(NULL) < 0 || !has_clip_distances())
        skip();
    if (cupola_pass_way(NULL) == CUPOLA_PASS_VERTEX)
        check_way(CUPOLA_PASS_VERTEX);
    check_way(CUPOLA_PASS_GEOMETRY);
}

static void numbers_of_clip_distances_that_no_gl_has_are_refused(void **state)
{
    static const int wrong[] = {-1, CUPOLA_PASS_CLIP_DISTANCES_MAX + 1};
    char text[TEXT];
    (void)state;
    if (cupola_pass_way(NULL) < 0)
        skip();
    for (int i = 0; i < 2; i++) {
        const struct cupola_pass_shader wish = {.way = CUPOLA_PASS_GEOMETRY,
                                                .clip_distances = wrong[i]};
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(cupola_pass_glsl(&wish, text, sizeof text, &error), CUPOLA_ERROR_ARGUMENT);
        assert_non_null(strstr(error.message, "clip_distances is"));
    }
    const struct cupola_pass_shader one = {.way = CUPOLA_PASS_GEOMETRY, .clip_distances = 1};
    assert_int_equal(cupola_pass_glsl(&one, text, sizeof text, NULL) > 0, has_clip_distances());
}

/* Where a GLSL is strict: there the other order would be a mistake of the host's. */
static void extensions_of_the_host_stand_before_the_text(void **state)
{
    char text[TEXT];
    (void)state;
    if (cupola_pass_way(NULL) < 0 || !has_clip_distances())
        skip();
    write_text(CUPOLA_PASS_GEOMETRY, CUPOLA_PASS_STAGE_VERTEX, text);
    for (int behind = 0; behind < 2; behind++) {
        GLuint program = glCreateProgram();
        const char *const texts[] = {version(), behind ? text : extension(),
                                     behind ? extension() : text, host_vertex};
        bool compiled = context_attach(program, GL_VERTEX_SHADER, texts, 4);
        assert_true(compiled || behind);
        if (behind)
            printf("  behind the text they are %s here\n", compiled ? "allowed" : "refused");
        glDeleteProgram(program);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clip_distances_reach_the_clipping_either_way),
        cmocka_unit_test(numbers_of_clip_distances_that_no_gl_has_are_refused),
        cmocka_unit_test(extensions_of_the_host_stand_before_the_text),
    };
    return run_gpu_group("pass_shaders", tests);
}
