/* A host with a scene of confetti. */
#include "confetti.h"

#include "check.h"
#include "context.h"
#include "host_depth.h"
#include "paint_shaders.h"

/* World to the host's camera frame: a rotation about the vertical axis, and a step. */
static const float world[16] = {0.8f, 0, -0.6f, 0, 0,    1,     0,    0,
                                0.6f, 0, 0.8f,  0, 0.1f, -0.2f, 0.3f, 1};

static const char looped_place[] =
    "uniform mat4 clip_from_world;\n"
    "int host_instance() { return gl_InstanceID; }\n"
    "void place_vertex(vec4 p) { gl_Position = clip_from_world * p; }\n";
static const char passed_place[] =
    "int host_instance() { return cupola_instance(); }\n"
    "void place_vertex(vec4 p) { cupola_place(p, cupola_view()); }\n";
static const char wrong_place[] =
    "int host_instance() { return cupola_instance(); }\n"
    "void place_vertex(vec4 p) { cupola_send(cupola_clip[cupola_view()] "
    "* p, (cupola_view() + 1) % cupola_view_count); }\n";

static const char *pass_version(void)
{
    return context_is_es() ? "#version 320 es\n" : "#version 330 core\n";
}

static void attach(GLuint program, GLenum kind, const char *const *texts, int count)
{
    assert_true(context_attach(program, kind, texts, count));
}

static const char *const *fragment_texts(const char *version, const char *texts[3])
{
    texts[0] = version;
    texts[1] = context_is_es() ? "precision highp float;\nprecision highp int;\n" : "";
    texts[2] = shader_confetti_frag;
    return texts;
}

GLuint confetti_program(enum cupola_pass_way way, GLenum mode, const char *place)
{
    static const char *const varyings[] = {"vec3 shade", "flat int kind"};
    struct cupola_pass_shader wished = {way, CUPOLA_PASS_STAGE_VERTEX, varyings, 2,
                                        mode == GL_POINTS  ? CUPOLA_PASS_POINTS
                                        : mode == GL_LINES ? CUPOLA_PASS_LINES
                                                           : CUPOLA_PASS_TRIANGLES};
    struct cupola_error error = {CUPOLA_OK, ""};
    char text[8192];
    const char *fragment[3];
    GLuint program = glCreateProgram();
    if (cupola_pass_glsl(&wished, text, sizeof text, &error) < 0)
        fail_msg("%s", error.message);
    attach(program, GL_VERTEX_SHADER,
           (const char *const[]){pass_version(), text, place, shader_confetti_vert}, 4);
    if (way == CUPOLA_PASS_GEOMETRY) {
        wished.stage = CUPOLA_PASS_STAGE_GEOMETRY;
        if (cupola_pass_glsl(&wished, text, sizeof text, &error) < 0)
            fail_msg("%s", error.message);
        attach(program, GL_GEOMETRY_SHADER, (const char *const[]){pass_version(), text}, 2);
    }
    attach(program, GL_FRAGMENT_SHADER, fragment_texts(pass_version(), fragment), 3);
    context_link(program);
    glUniformBlockBinding(program, glGetUniformBlockIndex(program, "cupola_pass"),
                          CONFETTI_BINDING);
    return program;
}

void confetti_create(struct confetti *confetti, enum cupola_pass_way way, GLenum mode)
{
    const char *fragment[3];
    *confetti = (struct confetti){.mode = mode, .point_size = 1};
    confetti->looped = glCreateProgram();
    attach(confetti->looped, GL_VERTEX_SHADER,
           (const char *const[]){context_shader_head(), looped_place, shader_confetti_vert}, 3);
    attach(confetti->looped, GL_FRAGMENT_SHADER, fragment_texts(context_shader_head(), fragment),
           3);
    context_link(confetti->looped);
    confetti->passed = confetti_program(way, mode, passed_place);
    confetti->wrong = confetti_program(way, mode, wrong_place);
    glGenVertexArrays(1, &confetti->vertex_array);
}

void confetti_destroy(struct confetti *confetti)
{
    glDeleteProgram(confetti->looped);
    glDeleteProgram(confetti->passed);
    glDeleteProgram(confetti->wrong);
    glDeleteVertexArrays(1, &confetti->vertex_array);
}

/* projection view world, in double as Cupola has it. */
static void clip_from_world(const struct cupola_camera *camera, GLfloat clip[16])
{
    double from_camera[16];
    for (int i = 0; i < 16; i++) {
        from_camera[i] = 0;
        for (int k = 0; k < 4; k++)
            from_camera[i] +=
                (double)camera->projection[4 * k + i % 4] * (double)camera->view[i / 4 * 4 + k];
    }
    for (int i = 0; i < 16; i++) {
        double sum = 0;
        for (int k = 0; k < 4; k++)
            sum += from_camera[4 * k + i % 4] * (double)world[i / 4 * 4 + k];
        clip[i] = (GLfloat)sum;
    }
}

static void begin(const struct fixture *fixture, const struct cupola_frame *frame)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_gl_frame_begin(fixture->gl, frame, &error) < 0)
        fail_msg("%s", error.message);
}

/* All of it, in every view: Cupola may have left another one. */
static void set_state(const struct confetti *confetti, const struct cupola_frame *frame,
                      GLuint program)
{
    host_depth(&frame->depth);
    context_depth_range(0, 1);
    if (!context_is_es())
        glEnable(GL_PROGRAM_POINT_SIZE);
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "point_size"), confetti->point_size);
    glBindVertexArray(confetti->vertex_array);
}

static void end(void)
{
    glBindVertexArray(0);
    glUseProgram(0);
    if (!context_is_es())
        glDisable(GL_PROGRAM_POINT_SIZE);
    host_depth_reset();
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

void confetti_loop(const struct confetti *confetti, const struct fixture *fixture,
                   const struct cupola_frame *frame)
{
    begin(fixture, frame);
    for (int i = 0; i < cupola_plan_view_count(fixture->plan); i++) {
        struct cupola_gl_view view;
        GLfloat clip[16];
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        set_state(confetti, frame, confetti->looped);
        clip_from_world(&view.camera, clip);
        glUniformMatrix4fv(glGetUniformLocation(confetti->looped, "clip_from_world"), 1, GL_FALSE,
                           clip);
        glDrawArraysInstanced(confetti->mode, 0, CONFETTI_VERTICES, CONFETTI_INSTANCES);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    end();
}

void confetti_pass(const struct confetti *confetti, const struct fixture *fixture,
                   const struct cupola_frame *frame, GLuint program)
{
    struct cupola_gl_pass pass;
    struct cupola_error error = {CUPOLA_OK, ""};
    begin(fixture, frame);
    if (cupola_gl_pass_begin(fixture->gl, world, &pass, &error) < 0)
        fail_msg("%s", error.message);
    set_state(confetti, frame, program);
    glBindBufferBase(GL_UNIFORM_BUFFER, CONFETTI_BINDING, pass.buffer);
    glDrawArraysInstanced(confetti->mode, 0, CONFETTI_VERTICES,
                          CONFETTI_INSTANCES * pass.view_count);
    assert_int_equal(cupola_gl_pass_end(fixture->gl, NULL), CUPOLA_OK);
    glBindBufferBase(GL_UNIFORM_BUFFER, CONFETTI_BINDING, 0);
    end();
}
