/*
 * The scene of the example hosts in this folder, in place of yours: the ring of cubes of minimal.c,
 * made from nothing but vertex numbers. C and C++. There is nothing about domes in it, apart from
 * the matrices that it is drawn with.
 */
#ifndef CUBES_H
#define CUBES_H

#include <epoxy/gl.h>
#include <stdbool.h>

#include <cupola/cupola.h>

/* Which of GLSL's versions is put before these is the caller's matter. */
static const char *const cubes_vertex_source =
    "uniform mat4 projection, view;\n"
    "out vec3 color;\n"
    "const int corners[36] = int[](0,1,3,0,3,2, 5,4,6,5,6,7, 4,0,2,4,2,6,\n"
    "                              1,5,7,1,7,3, 2,3,7,2,7,6, 4,5,1,4,1,0);\n"
    "void main() {\n"
    "    int corner = corners[gl_VertexID % 36];\n"
    "    float angle = 0.3927 * float(gl_VertexID / 36);\n"
    "    vec3 cube = 0.5 * vec3(corner & 1, corner >> 1 & 1, corner >> 2) - 0.25;\n"
    "    vec3 place = 3.0 * vec3(sin(angle), 0.2 * sin(3.0 * angle), -cos(angle));\n"
    "    color = 0.5 + 0.5 * cos(angle + vec3(0, 2.1, 4.2)) - 0.1 * float(gl_VertexID / 6 % 3);\n"
    "    gl_Position = projection * view * vec4(place + cube, 1);\n"
    "}\n";
static const char *const cubes_fragment_source = "in vec3 color;\n"
                                                 "out vec4 result;\n"
                                                 "void main() { result = vec4(color, 1); }\n";

struct cubes {
    GLuint program;
    GLuint vertex_array;
};

static inline struct cubes cubes_create(void)
{
    struct cubes cubes = {glCreateProgram(), 0};
    const char *const vertex[] = {"#version 330 core\n", cubes_vertex_source};
    const char *const fragment[] = {"#version 330 core\n", cubes_fragment_source};

    for (int i = 0; i < 2; i++) {
        GLuint shader = glCreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        glShaderSource(shader, 2, i == 0 ? vertex : fragment, NULL);
        glCompileShader(shader);
        glAttachShader(cubes.program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(cubes.program);
    glGenVertexArrays(1, &cubes.vertex_array);
    return cubes;
}

static inline void cubes_destroy(struct cubes cubes)
{
    glDeleteVertexArrays(1, &cubes.vertex_array);
    glDeleteProgram(cubes.program);
}

static inline void cubes_draw(struct cubes cubes, const struct cupola_camera *camera)
{
    glEnable(GL_DEPTH_TEST);
    glBindVertexArray(cubes.vertex_array);
    glUseProgram(cubes.program);
    glUniformMatrix4fv(glGetUniformLocation(cubes.program, "projection"), 1, GL_FALSE,
                       camera->projection);
    glUniformMatrix4fv(glGetUniformLocation(cubes.program, "view"), 1, GL_FALSE, camera->view);
    glDrawArrays(GL_TRIANGLES, 0, 16 * 36);
}

/*
 * What makes an example's exit status mean something: the cube straight ahead is red, and the
 * middle of the visionstation's image shows it, while a place just above shows no cube.
 */
static inline bool cubes_seen(unsigned int framebuffer, const struct cupola_output *output)
{
    float ahead[4], above[4];
    struct cupola_target middle = {framebuffer, output->width_px / 2, output->height_px / 2};

    if (cupola_gl_capture(&middle, 1, 1, ahead, NULL) < 0)
        return false;
    middle.y += output->height_px / 4;
    if (cupola_gl_capture(&middle, 1, 1, above, NULL) < 0)
        return false;
    return ahead[0] > 0.6f && ahead[1] < 0.4f && ahead[2] < 0.4f && above[0] < 0.1f;
}

#endif
