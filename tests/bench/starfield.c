/* Points of light on black that are smaller than a pixel. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "probe.h"
#include "scene_views.h"

enum { CORNERS = 6, NUMBERS = 4 }; /* two triangles; place and light */

static const double distance = 50; /* world units: no eye is ever far from the middle */

struct starfield {
    struct scene scene;
    struct scene_programs programs;
    GLuint vertex_array;
    GLuint corners;
    int stars;
};

static void starfield_draw(struct scene *base, const struct scene_camera *camera)
{
    struct starfield *field = (struct starfield *)base;
    GLuint program = scene_program(&field->programs, camera);

    glUseProgram(program);
    if (!scene_set_camera(program, camera))
        return;
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(camera->reversed_depth ? GL_GREATER : GL_LESS);
    glDepthMask(GL_TRUE);
    glBindVertexArray(field->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, CORNERS * field->stars);
    glBindVertexArray(0);
    glUseProgram(0);
}

static void starfield_destroy(struct scene *base)
{
    struct starfield *field = (struct starfield *)base;

    scene_programs_destroy(&field->programs);
    glDeleteVertexArrays(1, &field->vertex_array);
    glDeleteBuffers(1, &field->corners);
    free(field);
}

/* splitmix64, Steele et al. 2014: 0 to 1. */
static double random_part(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-53;
}

/* One star anywhere on the sphere, turned anyhow. */
static void put_star(uint64_t *state, double width_rad, float numbers[CORNERS][NUMBERS])
{
    static const int corners[CORNERS][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    const double pi = 3.14159265358979323846;
    double z = 2 * random_part(state) - 1, round = 2 * pi * random_part(state);
    double turn = 2 * pi * random_part(state), light = 0.3 + 0.7 * random_part(state);
    double across = sqrt(1 - z * z), half = distance * width_rad / 2;
    const double axis[3] = {across * cos(round), across * sin(round), z};
    const double east[3] = {-sin(round), cos(round), 0};
    const double north[3] = {-z * cos(round), -z * sin(round), across};

    for (int i = 0; i < CORNERS; i++) {
        double x = corners[i][0] * cos(turn) - corners[i][1] * sin(turn);
        double y = corners[i][0] * sin(turn) + corners[i][1] * cos(turn);
        for (int k = 0; k < 3; k++)
            numbers[i][k] = (float)(distance * axis[k] + half * (x * east[k] + y * north[k]));
        numbers[i][3] = (float)light;
    }
}

static bool fill_buffer(struct starfield *field, double width_rad)
{
    float(*numbers)[CORNERS][NUMBERS] = malloc((size_t)field->stars * sizeof *numbers);
    uint64_t state = 1;

    if (!numbers)
        return false;
    for (int i = 0; i < field->stars; i++)
        put_star(&state, width_rad, numbers[i]);
    glGenVertexArrays(1, &field->vertex_array);
    glBindVertexArray(field->vertex_array);
    glGenBuffers(1, &field->corners);
    glBindBuffer(GL_ARRAY_BUFFER, field->corners);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)field->stars * sizeof *numbers), numbers,
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, NUMBERS * sizeof(float), NULL);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, NUMBERS * sizeof(float),
                          (const void *)(3 * sizeof(float)));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    free(numbers);
    return true;
}

struct scene *starfield_create(int stars, double width_rad, char *message)
{
    static const char *const varyings[] = {"flat float star_light"};
    const struct program_source source = {.name = "starfield",
                                          .vertex = shader_starfield_vert,
                                          .varyings = varyings,
                                          .varying_count = 1,
                                          .fragment = shader_starfield_frag};
    struct starfield *field = calloc(1, sizeof *field);

    if (!field) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    field->stars = stars;
    field->scene = (struct scene){.draw = starfield_draw,
                                  .destroy = starfield_destroy,
                                  .whole = {2L * stars, stars},
                                  .radius = 1.01 * distance,
                                  .clear_color = {0, 0, 0, 1}};
    field->programs.one_view = program_create_of(0, &source, message, MESSAGE_SIZE);
    if (field->programs.one_view && fill_buffer(field, width_rad))
        return &field->scene;
    starfield_destroy(&field->scene);
    return NULL;
}
