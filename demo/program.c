/* Compiling and linking of the scenes' GL programs. */
#include "program.h"

#include <stdio.h>
#include <string.h>

#include <epoxy/gl.h>

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

static GLuint compile(GLenum kind, const char *name, const char *first, const char *second,
                      char *message, size_t message_size)
{
    const char *const sources[] = {first, second};
    GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 2, sources, NULL);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    char log[1024] = "no reason given";
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    join_lines(log);
    snprintf(message, message_size, "the %s shader of '%s' does not compile: %s",
             kind == GL_VERTEX_SHADER ? "vertex" : "fragment", name, log);
    glDeleteShader(shader);
    return 0;
}

unsigned int program_create(const char *name, const char *vertex_source,
                            const char *fragment_source, char *message, size_t message_size)
{
    return program_create_of(name, vertex_source, fragment_source, "", message, message_size);
}

unsigned int program_create_of(const char *name, const char *vertex_source,
                               const char *fragment_functions, const char *fragment_main,
                               char *message, size_t message_size)
{
    GLuint vertex = compile(GL_VERTEX_SHADER, name, vertex_source, "", message, message_size);
    if (!vertex)
        return 0;
    GLuint fragment =
        compile(GL_FRAGMENT_SHADER, name, fragment_functions, fragment_main, message, message_size);
    if (!fragment) {
        glDeleteShader(vertex);
        return 0;
    }
    GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDetachShader(program, vertex);
    glDetachShader(program, fragment);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    char log[1024] = "no reason given";
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    join_lines(log);
    snprintf(message, message_size, "the program '%s' does not link: %s", name, log);
    glDeleteProgram(program);
    return 0;
}
