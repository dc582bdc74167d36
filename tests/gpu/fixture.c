/* Fixtures: see fixture.h. */
#include "fixture.h"

#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "gl/instance.h"
#include "paint_shaders.h"

static const char *const paint_sources[] = {
    [PAINT_DIRECTIONS] = shader_directions_frag, [PAINT_SCREEN] = shader_screen_frag,
    [PAINT_NOISE] = shader_noise_frag,           [PAINT_ROOM] = shader_room_frag,
    [PAINT_CHECKER] = shader_checker_frag,
};

enum { PAINT_COUNT = sizeof paint_sources / sizeof paint_sources[0] };

static GLuint programs[PAINT_COUNT];

enum cupola_table fixture_stage(enum cupola_table wished)
{
    const char *name = getenv("CUPOLA_TEST_TABLE");
    return name ? (enum cupola_table)cupola_table_find(name) : wished;
}

const struct cupola_gl_params *fixture_with_stage(const struct cupola_gl_params *wished,
                                                  struct cupola_gl_params *params)
{
    if (wished && wished->table)
        return wished;
    *params = wished ? *wished : (struct cupola_gl_params){.border = {0}};
    params->table = fixture_stage(CUPOLA_TABLE_POINTS);
    return params;
}

void fixture_make_of_plan(cupola_plan *plan, const struct cupola_gl_params *gl_params,
                          struct fixture *fixture)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_params params;
    *fixture = (struct fixture){.plan = plan};
    if (cupola_dome_create(cupola_dome_rig(cupola_plan_dome(plan)), &fixture->dome, &error) < 0 ||
        cupola_gl_create(plan, fixture_with_stage(gl_params, &params), &fixture->gl, &error) < 0)
        fail_msg("%s", error.message);
}

void fixture_make(const struct cupola_rig *rig, const struct cupola_plan_params *params,
                  const struct cupola_gl_params *gl_params, struct fixture *fixture)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    if (cupola_dome_create(rig, &dome, &error) < 0 ||
        cupola_plan_create(dome, params, &plan, &error) < 0)
        fail_msg("%s", error.message);
    cupola_dome_destroy(&dome);
    fixture_make_of_plan(plan, gl_params, fixture);
}

void fixture_replace_gl(struct fixture *fixture, const struct cupola_gl_params *gl_params)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_params params;
    cupola_gl_destroy(&fixture->gl);
    if (cupola_gl_create(fixture->plan, fixture_with_stage(gl_params, &params), &fixture->gl,
                         &error) < 0)
        fail_msg("%s", error.message);
}

cupola_plan *fixture_wrong_plan(const struct fixture *fixture, const struct cupola_rig *wrong)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    cupola_plan *plan = malloc(sizeof *plan);
    assert_non_null(plan);
    if (cupola_dome_create(wrong, &dome, &error) < 0)
        fail_msg("%s", error.message);
    assert_int_equal(plan_copy(fixture->plan, plan, NULL), CUPOLA_OK);
    plan->dome = *dome;
    cupola_dome_destroy(&dome);
    return plan;
}

void fixture_release(struct fixture *fixture)
{
    cupola_gl_destroy(&fixture->gl);
    cupola_plan_destroy(&fixture->plan);
    cupola_dome_destroy(&fixture->dome);
}

const struct cupola_output *fixture_output(const struct fixture *fixture, int output)
{
    return &cupola_dome_rig(fixture->dome)->outputs[output];
}

GLuint fixture_table(const struct fixture *fixture, int output)
{
    return fixture->gl->passes[output].table;
}

GLuint fixture_table_by_cpu(const struct fixture *fixture, int output, enum cupola_table stage)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    GLuint table = table_upload(fixture->gl, output, stage, &error);
    if (!table)
        fail_msg("%s", error.message);
    return table;
}

static GLuint program_of(enum paint paint)
{
    if (!programs[paint])
        programs[paint] = context_program(shader_paint_vert, paint_sources[paint]);
    return programs[paint];
}

void fixture_forget_programs(void)
{
    for (int i = 0; i < PAINT_COUNT; i++) {
        glDeleteProgram(programs[i]);
        programs[i] = 0;
    }
}

/* Rows x and y and the last one of a column-major product of projection and view, 3 x 4. */
static void clip_rows(const struct cupola_camera *camera, double rows[3][4])
{
    static const int wanted[3] = {0, 1, 3};
    for (int i = 0; i < 3; i++)
        for (int column = 0; column < 4; column++) {
            rows[i][column] = 0.0;
            for (int k = 0; k < 4; k++)
                rows[i][column] += (double)camera->projection[4 * k + wanted[i]] *
                                   (double)camera->view[4 * column + k];
        }
}

/* Inverse of the left 3 x 3 part, by cofactors; row-major. */
static void invert(double m[3][4], double inverse[3][3])
{
    double determinant = 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            inverse[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
        }
    for (int j = 0; j < 3; j++)
        determinant += m[0][j] * inverse[j][0];
    for (int i = 0; i < 9; i++)
        inverse[i / 3][i % 3] /= determinant;
}

/*
 * What a host's matrices say about rays. With A the 3 x 3 part of clip space's x, y and w rows, the
 * point E + t d is seen at (A d).xy / (A d).z for every t, where A E cancels the fourth column; so
 * d = A^-1 (x, y, 1), linear in x and y.
 */
static void set_camera(GLuint program, const struct cupola_camera *camera, double units_per_metre)
{
    double rows[3][4], inverse[3][3];
    GLfloat rays[9], eye[3];
    clip_rows(camera, rows);
    invert(rows, inverse);
    for (int i = 0; i < 3; i++) {
        double place = 0.0;
        for (int j = 0; j < 3; j++) {
            rays[3 * i + j] = (GLfloat)inverse[i][j];
            place -= inverse[i][j] * rows[j][3];
        }
        eye[i] = (GLfloat)(place / units_per_metre);
    }
    glUniformMatrix3fv(glGetUniformLocation(program, "ray_of_place"), 1, GL_TRUE, rays);
    glUniform3fv(glGetUniformLocation(program, "eye"), 1, eye);
}

void fixture_paint(const struct fixture *fixture, enum paint paint)
{
    const struct cupola_rig *rig = cupola_dome_rig(fixture->dome);
    struct cupola_error error = {CUPOLA_OK, ""};
    GLuint program = program_of(paint), vertex_array = 0;
    int views = cupola_gl_frame_begin(fixture->gl, NULL, &error);
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "screen_radius"), (GLfloat)rig->screen.radius_m);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        if (cupola_gl_view_begin(fixture->gl, i, &view, &error) < 0)
            fail_msg("%s", error.message);
        set_camera(program, &view.camera, rig->units_per_metre);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        assert_int_equal(cupola_gl_view_end(fixture->gl, &error), CUPOLA_OK);
    }
    glUseProgram(0);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &vertex_array);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(views, cupola_plan_view_count(fixture->plan));
}

static float *image_of_size(int width_px, int height_px)
{
    float *image = malloc(4 * sizeof *image * (size_t)width_px * (size_t)height_px);
    assert_non_null(image);
    return image;
}

static GLuint target_of(GLuint texture)
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return framebuffer;
}

static float *capture(const struct cupola_target *target, int width_px, int height_px)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    float *image = image_of_size(width_px, height_px);
    if (cupola_gl_capture(target, width_px, height_px, image, &error) < 0)
        fail_msg("%s", error.message);
    return image;
}

float *texture_read(GLuint texture, int width_px, int height_px)
{
    GLuint framebuffer = target_of(texture);
    float *image = capture(&(struct cupola_target){framebuffer, 0, 0}, width_px, height_px);
    glDeleteFramebuffers(1, &framebuffer);
    return image;
}

float *fixture_atlas(const struct fixture *fixture)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    return texture_read(cupola_gl_atlas(fixture->gl), report->atlas_width_px,
                        report->atlas_height_px);
}

float *fixture_warp(const struct fixture *fixture, int output)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    const int corner[2] = {7, 3}; /* the image does not start at the target's corner */
    struct cupola_error error = {CUPOLA_OK, ""};
    GLuint texture = 0;
    bool floats = context_has_floats();
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, floats ? GL_RGBA32F : GL_RGBA8, size->width_px + corner[0],
                 size->height_px + corner[1], 0, GL_RGBA, floats ? GL_FLOAT : GL_UNSIGNED_BYTE,
                 NULL);
    struct cupola_target target = {target_of(texture), corner[0], corner[1]};
    if (cupola_gl_warp(fixture->gl, output, NULL, &target, &error) < 0)
        fail_msg("%s", error.message);
    float *image = capture(&target, size->width_px, size->height_px);
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &texture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return image;
}
