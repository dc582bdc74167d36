/* Compiling and linking of the scenes' GL programs. */
#include "program.h"

#include <stdio.h>
#include <string.h>

#include <cupola/one_pass.h>
#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "scene_views.h"

enum { PASS_TEXT = 16384 };

/* A driver's log has many lines; a message has one. */
static void join_lines(char *text)
{
    size_t length = strlen(text);
    while (length > 0 && strchr("\r\n \t", text[length - 1]))
        text[--length] = '\0';
    for (size_t i = 0; i < length; i++)
        if (text[i] == '\n' || text[i] == '\r')
            text[i] = ' ';
}

static const char *kind_name(GLenum kind)
{
    return kind == GL_VERTEX_SHADER     ? "vertex"
           : kind == GL_GEOMETRY_SHADER ? "geometry"
                                        : "fragment";
}

/* Adds a shader to a program. */
static bool add(GLuint program, GLenum kind, const char *name, const char *const sources[],
                int count, char *message, size_t message_size)
{
    GLuint shader = glCreateShader(kind);
    GLint compiled = 0;
    glShaderSource(shader, count, sources, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) {
        glAttachShader(program, shader);
    } else {
        char log[1024] = "no reason given";
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        join_lines(log);
        snprintf(message, message_size, "the %s shader of '%s' does not compile: %s",
                 kind_name(kind), name, log);
    }
    glDeleteShader(shader);
    return compiled;
}

static bool link(GLuint program, const char *name, char *message, size_t message_size)
{
    GLint linked = 0;
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return true;
    char log[1024] = "no reason given";
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    join_lines(log);
    snprintf(message, message_size, "the program '%s' does not link: %s", name, log);
    return false;
}

unsigned int program_create(const char *name, const char *vertex_source,
                            const char *fragment_source, char *message, size_t message_size)
{
    GLuint program = glCreateProgram();
    if (add(program, GL_VERTEX_SHADER, name, &vertex_source, 1, message, message_size) &&
        add(program, GL_FRAGMENT_SHADER, name, &fragment_source, 1, message, message_size) &&
        link(program, name, message, message_size))
        return program;
    glDeleteProgram(program);
    return 0;
}

/* Cupola's text for a stage of a pass. */
static bool pass_text(int way, enum cupola_pass_stage stage, const struct program_source *source,
                      char text[PASS_TEXT], char *message, size_t message_size)
{
    struct cupola_error error = {0};
    const struct cupola_pass_shader shader = {.way = (enum cupola_pass_way)way,
                                              .stage = stage,
                                              .varyings = source->varyings,
                                              .varying_count = source->varying_count};
    if (cupola_pass_glsl(&shader, text, PASS_TEXT, &error) >= 0)
        return true;
    snprintf(message, message_size, "%s", error.message);
    return false;
}

static bool add_stages(GLuint program, int way, const struct program_source *source, char *message,
                       size_t message_size)
{
    static const char version[] = "#version 330 core\n";
    char text[PASS_TEXT] = "";
    const char *const vertex[] = {version, text, way ? shader_all_views_glsl : shader_one_view_glsl,
                                  source->vertex};
    const char *const geometry[] = {version, text};
    const char *const fragment[] = {source->functions ? source->functions : "", source->fragment};
    const char *name = source->name;

    if (way && !pass_text(way, CUPOLA_PASS_STAGE_VERTEX, source, text, message, message_size))
        return false;
    if (!add(program, GL_VERTEX_SHADER, name, vertex, 4, message, message_size) ||
        !add(program, GL_FRAGMENT_SHADER, name, fragment, 2, message, message_size))
        return false;
    return way != CUPOLA_PASS_GEOMETRY ||
           (pass_text(way, CUPOLA_PASS_STAGE_GEOMETRY, source, text, message, message_size) &&
            add(program, GL_GEOMETRY_SHADER, name, geometry, 2, message, message_size));
}

unsigned int program_create_of(int way, const struct program_source *source, char *message,
                               size_t message_size)
{
    GLuint program = glCreateProgram();
    if (!add_stages(program, way, source, message, message_size) ||
        !link(program, source->name, message, message_size)) {
        glDeleteProgram(program);
        return 0;
    }
    if (way)
        glUniformBlockBinding(program, glGetUniformBlockIndex(program, "cupola_pass"),
                              SCENE_PASS_BINDING);
    return program;
}
