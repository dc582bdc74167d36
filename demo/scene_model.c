/* A model from a file: exactly as its materials say (flat), or in sunlight under a sky. */
#include "scene.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "model.h"
#include "scene_matrix.h"
#include "shading.h"
#include "short_path.h"

struct model_scene {
    struct scene scene;
    struct model *model;
    struct scene_programs programs;
    struct scene_programs backdrop; /* 0 where drawn flat */
    GLuint vertex_array;            /* of the model */
    GLuint no_vertices;             /* vertex array without any attribute, for the backdrop */
    GLuint vertices;
    GLuint indices;
    GLuint *pictures; /* one per picture of the model; 0: none */
};

static void draw_batches(const struct model_scene *scene, GLuint program, int views)
{
    GLint vertex_colored = glGetUniformLocation(program, "vertex_colored");
    GLint pictured = glGetUniformLocation(program, "pictured");
    glActiveTexture(GL_TEXTURE0);
    for (int i = 0; i < scene->model->batch_count; i++) {
        const struct model_batch *batch = &scene->model->batches[i];
        GLuint picture = batch->picture >= 0 ? scene->pictures[batch->picture] : 0;
        glUniform1i(vertex_colored, batch->vertex_colored);
        glUniform1i(pictured, picture != 0);
        glBindTexture(GL_TEXTURE_2D, picture);
        glDrawElementsInstanced(GL_TRIANGLES, (GLsizei)batch->count, GL_UNSIGNED_INT,
                                (const void *)((size_t)batch->first * sizeof(uint32_t)), views);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

static void model_scene_draw(struct scene *base, const struct scene_camera *camera)
{
    struct model_scene *scene = (struct model_scene *)base;
    GLuint program = scene_program(&scene->programs, camera);
    int views = scene_view_count(camera);

    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (scene->backdrop.one_view)
        scene_backdrop_draw(&scene->backdrop, camera, scene->no_vertices);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(camera->reversed_depth ? GL_GREATER : GL_LESS);
    glDepthMask(GL_TRUE);
    glUseProgram(program);
    if (!scene_set_camera(program, camera))
        return;
    glBindVertexArray(scene->vertex_array);
    draw_batches(scene, program, views);
    glBindVertexArray(0);
    glUseProgram(0);
    base->drawn.triangles += views * base->whole.triangles;
    base->drawn.instances += views * base->whole.instances;
}

static void model_scene_destroy(struct scene *base)
{
    struct model_scene *scene = (struct model_scene *)base;
    scene_programs_destroy(&scene->programs);
    scene_programs_destroy(&scene->backdrop);
    glDeleteVertexArrays(1, &scene->vertex_array);
    glDeleteVertexArrays(1, &scene->no_vertices);
    glDeleteBuffers(1, &scene->vertices);
    glDeleteBuffers(1, &scene->indices);
    if (scene->pictures)
        glDeleteTextures(scene->model->picture_count, scene->pictures);
    free(scene->pictures);
    model_destroy(scene->model);
    free(scene);
}

static double model_scene_distance(const struct scene *base, const double place[3])
{
    return model_distance(((const struct model_scene *)base)->model, place);
}

static void create_buffers(struct model_scene *scene)
{
    static const struct {
        size_t offset;
        GLint size;
    } attributes[5] = {{offsetof(struct model_vertex, position), 3},
                       {offsetof(struct model_vertex, normal), 3},
                       {offsetof(struct model_vertex, base), 3},
                       {offsetof(struct model_vertex, color), 3},
                       {offsetof(struct model_vertex, texcoord), 2}};
    const struct model *model = scene->model;
    glGenVertexArrays(1, &scene->no_vertices);
    glGenVertexArrays(1, &scene->vertex_array);
    glBindVertexArray(scene->vertex_array);
    glGenBuffers(1, &scene->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, scene->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(model->vertex_count * sizeof *model->vertices),
                 model->vertices, GL_STATIC_DRAW);
    glGenBuffers(1, &scene->indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, scene->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(model->index_count * sizeof *model->indices),
                 model->indices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 5; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, attributes[i].size, GL_FLOAT, GL_FALSE,
                              sizeof(struct model_vertex), (const void *)attributes[i].offset);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

/* A picture that is larger than this GL's textures counts as missing. */
static bool create_pictures(struct model_scene *scene)
{
    struct model *model = scene->model;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (model->picture_count == 0)
        return true;
    scene->pictures = calloc((size_t)model->picture_count, sizeof *scene->pictures);
    if (!scene->pictures)
        return false;
    glActiveTexture(GL_TEXTURE0);
    for (int i = 0; i < model->picture_count; i++) {
        struct model_picture *picture = &model->pictures[i];
        if (!picture->rgba)
            continue;
        if (picture->width > most || picture->height > most) {
            model->missing_pictures++;
            continue;
        }
        glGenTextures(1, &scene->pictures[i]);
        glBindTexture(GL_TEXTURE_2D, scene->pictures[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, picture->rgba);
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        free(picture->rgba);
        picture->rgba = NULL;
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    return true;
}

/* 1, 2 or 5 times a power of ten, near a quarter of the model. */
static double round_step(double radius)
{
    double wished = radius / 4, power = pow(10, floor(log10(wished)));
    double digit = wished / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

static void set_backdrop(const struct model_scene *scene, GLuint program)
{
    const struct model *model = scene->model;
    float center[3], half_size[3] = {0};
    scene_to_float(scene->scene.center, 3, center);
    for (uint32_t i = 0; i < model->vertex_count; i++)
        for (int k = 0; k < 3; k++)
            half_size[k] = fmaxf(half_size[k], fabsf(model->vertices[i].position[k] - center[k]));
    glUseProgram(program);
    glUniform3fv(glGetUniformLocation(program, "center"), 1, center);
    glUniform3fv(glGetUniformLocation(program, "half_size"), 1, half_size);
    glUniform3fv(glGetUniformLocation(program, "sun"), 1, shading_sun);
    glUniform1f(glGetUniformLocation(program, "grid_step"), (float)round_step(scene->scene.radius));
    glUseProgram(0);
}

/* Whoever gave no place stands in the middle of a room, and before anything else. */
static void set_place(struct scene *scene, const struct model *model)
{
    model_bounds(model, scene->center, &scene->radius);
    scene->radius = fmax(scene->radius, (double)FLT_MIN);
    for (int k = 0; k < 3; k++)
        scene->suggested[k] = scene->center[k];
    if (!model_is_room(model, scene->center))
        scene->suggested[2] += 1.6 * scene->radius;
}

static bool create_programs(struct model_scene *scene, const struct scene_wishes *wishes,
                            char *message, size_t message_size)
{
    const double *center = scene->scene.center, radius = scene->scene.radius;
    const struct shading_lamps lamps = {.center = {center[0], center[1], center[2]},
                                        .radius = 1.8 * radius,
                                        .lowest = 0.1,
                                        .bump_size = (float)(radius / 20)};
    static const char *const varyings[] = {"vec3 surface_place", "vec3 surface_normal",
                                           "flat vec3 surface_base", "vec3 surface_color",
                                           "vec2 surface_texcoord"};
    const struct program_source source = {.name = "model",
                                          .vertex = shader_model_vert,
                                          .varyings = varyings,
                                          .varying_count = 5,
                                          .functions = shader_sunlight_glsl,
                                          .fragment = shader_model_frag};
    if (!shading_programs_create(&scene->programs, &source, &lamps, wishes, message, message_size))
        return false;
    const GLuint made[2] = {scene->programs.one_view, scene->programs.all_views};
    for (int i = 0; i < 2 && made[i]; i++) {
        glUseProgram(made[i]);
        glUniform1i(glGetUniformLocation(made[i], "picture"), 0);
    }
    glUseProgram(0);
    if (wishes->shading == SCENE_FLAT)
        return true;
    if (!scene_backdrop_create(&scene->backdrop, "backdrop", shader_backdrop_frag, wishes->way,
                               message, message_size))
        return false;
    set_backdrop(scene, scene->backdrop.one_view);
    if (wishes->way)
        set_backdrop(scene, scene->backdrop.all_views);
    return true;
}

struct scene *scene_model_create(const char *path, const struct scene_wishes *wishes, char *message,
                                 size_t message_size)
{
    struct model *model = model_load(path, wishes->shading != SCENE_FLAT, message, message_size);
    if (!model)
        return NULL;
    struct model_scene *scene = calloc(1, sizeof *scene);
    if (!scene) {
        snprintf(message, message_size, "%s: out of memory", short_path(path).text);
        model_destroy(model);
        return NULL;
    }
    scene->model = model;
    scene->scene.contents = model_contents(model);
    scene->scene.draw = model_scene_draw;
    scene->scene.destroy = model_scene_destroy;
    scene->scene.distance = model_scene_distance;
    scene->scene.whole = (struct scene_counts){(long)(model->index_count / 3), 1};
    set_place(&scene->scene, model);
    if (!create_programs(scene, wishes, message, message_size))
        goto fail;
    while (glGetError() != GL_NO_ERROR)
        continue;
    create_buffers(scene);
    if (!create_pictures(scene) || glGetError() != GL_NO_ERROR) {
        snprintf(message, message_size, "%s: too large for the memory of this machine",
                 short_path(path).text);
        goto fail;
    }
    return &scene->scene;

fail:
    model_scene_destroy(&scene->scene);
    return NULL;
}
