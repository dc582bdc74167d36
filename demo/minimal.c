/*
 * The smallest host: a ring of coloured cubes on a dome. Only the lines with cupola_ in them are
 * about the dome; the rest is what any OpenGL program does. An argument ends it after so many
 * frames.
 */
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cupola/cupola.h>

/* 16 cubes of 36 vertices each, made from nothing but their numbers. */
static const char *const vertex_source =
    "#version 330 core\n"
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
static const char *const fragment_source = "#version 330 core\n"
                                           "in vec3 color;\n"
                                           "out vec4 result;\n"
                                           "void main() { result = vec4(color, 1); }\n";

static GLuint make_program(void)
{
    GLuint program = glCreateProgram();
    const char *const sources[] = {vertex_source, fragment_source};
    const GLenum kinds[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};

    for (int i = 0; i < 2; i++) {
        GLuint shader = glCreateShader(kinds[i]);
        glShaderSource(shader, 1, &sources[i], NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    return program;
}

static void draw_scene(GLuint program, const struct cupola_camera *camera)
{
    glEnable(GL_DEPTH_TEST);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE,
                       camera->projection);
    glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, camera->view);
    glDrawArrays(GL_TRIANGLES, 0, 16 * 36);
}

int main(int argc, char **argv)
{
    int status = 1, frames = argc > 1 ? atoi(argv[1]) : -1, views;
    GLFWwindow *window = NULL;
    GLuint program, vertex_array;
    struct cupola_error error = {0};
    struct cupola_rig rig;
    struct cupola_gl_view view;
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    /* The scene's colours are those of the screen: mixed in linear light, and encoded again. */
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_SRGB8,
                                            .encoding = CUPOLA_ENCODING_SRGB,
                                            .table = CUPOLA_TABLE_TILES};
    cupola_gl *gl = NULL;

    if (cupola_rig_preset("visionstation", &rig, &error) < 0 ||
        cupola_dome_create(&rig, &dome, &error) < 0 ||
        cupola_plan_create(dome, NULL, &plan, &error) < 0)
        goto fail;

    if (!glfwInit())
        goto fail;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    window =
        glfwCreateWindow(rig.outputs[0].width_px, rig.outputs[0].height_px, "minimal", NULL, NULL);
    if (!window)
        goto fail;
    glfwMakeContextCurrent(window);
    program = make_program();
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);

    if (cupola_gl_create(plan, &params, &gl, &error) < 0)
        goto fail;
    while (!glfwWindowShouldClose(window) && frames-- != 0) {
        if ((views = cupola_gl_frame_begin(gl, NULL, &error)) < 0)
            goto fail;
        for (int i = 0; i < views; i++) {
            if (cupola_gl_view_begin(gl, i, &view, &error) < 0)
                goto fail;
            draw_scene(program, &view.camera);
            cupola_gl_view_end(gl, NULL);
        }
        if (cupola_gl_warp(gl, 0, NULL, NULL, &error) < 0)
            goto fail;
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    status = 0;
fail:
    if (status)
        fprintf(stderr, "cupola-minimal: %s\n",
                error.status ? error.message : "no window with OpenGL 3.3");
    cupola_gl_destroy(&gl);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    glfwTerminate();
    return status;
}
