/* The forest: of its instances those that each view may see, in a buffer filled for each draw. */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "forest.h"
#include "shading.h"

/* What the ground is made of and each kind of tree. */
struct part {
    GLuint vertex_array;
    GLuint vertices;
    GLuint indices;
};

struct forest_scene {
    struct scene scene;
    struct forest forest;
    struct scene_programs programs;
    struct scene_programs backdrop; /* the sky */
    GLuint no_vertices;
    struct part ground;
    struct part kinds[FOREST_KINDS];
    GLuint view_numbers;   /* 0, 1, ...: the views of the ground's instances */
    GLuint instances;      /* of the kind that is drawn */
    struct instance *seen; /* room for as many as there are of any kind, in all views */
};

struct instance {
    struct forest_tree tree;
    GLint view;
};

/* Adds the trees that a view may see. */
static void cull(struct forest_scene *scene, int kind, const struct scene_camera *camera, int view,
                 int *seen)
{
    const struct forest_tree *trees = scene->forest.trees[kind];
    const struct cupola_camera *seer = scene_view(camera, view);
    const float *m = camera->host;

    for (int i = 0; i < scene->forest.tree_count[kind]; i++) {
        const float *p = trees[i].place;
        float center[3];
        for (int k = 0; k < 3; k++)
            center[k] = m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k];
        if (cupola_camera_sees_sphere(seer, center, trees[i].radius) == 1)
            scene->seen[(*seen)++] = (struct instance){trees[i], view};
    }
}

/* One call for each kind, of the trees of one view or of all. */
static void draw_trees(struct forest_scene *scene, const struct scene_camera *camera)
{
    glBindBuffer(GL_ARRAY_BUFFER, scene->instances);
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        int count = 0, indices = scene->forest.kinds[kind].index_count;
        for (int view = 0; view < scene_view_count(camera); view++)
            cull(scene, kind, camera, view, &count);
        if (count == 0)
            continue;
        /* New storage each time: what is still being drawn keeps the old one. */
        glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)count * sizeof *scene->seen),
                     scene->seen, GL_STREAM_DRAW);
        glBindVertexArray(scene->kinds[kind].vertex_array);
        glDrawElementsInstanced(GL_TRIANGLES, indices, GL_UNSIGNED_INT, NULL, count);
        scene->scene.drawn.triangles += (long)count * (indices / 3);
        scene->scene.drawn.instances += count;
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static void draw_ground(struct forest_scene *scene, int views)
{
    int indices = scene->forest.ground.index_count;

    glBindVertexArray(scene->ground.vertex_array);
    glVertexAttrib4f(3, 0, 0, 0, 1);
    glVertexAttrib3f(4, 1, 0, 0.5f);
    glDrawElementsInstanced(GL_TRIANGLES, indices, GL_UNSIGNED_INT, NULL, views);
    scene->scene.drawn.triangles += (long)views * (indices / 3);
    scene->scene.drawn.instances += views;
}

static void forest_scene_draw(struct scene *base, const struct scene_camera *camera)
{
    struct forest_scene *scene = (struct forest_scene *)base;
    GLuint program = scene_program(&scene->programs, camera);

    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    scene_backdrop_draw(&scene->backdrop, camera, scene->no_vertices);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(camera->reversed_depth ? GL_GREATER : GL_LESS);
    glDepthMask(GL_TRUE);
    glUseProgram(program);
    if (!scene_set_camera(program, camera))
        return;
    draw_trees(scene, camera);
    draw_ground(scene, scene_view_count(camera));
    glBindVertexArray(0);
    glUseProgram(0);
}

static void destroy_part(struct part *part)
{
    glDeleteVertexArrays(1, &part->vertex_array);
    glDeleteBuffers(1, &part->vertices);
    glDeleteBuffers(1, &part->indices);
}

static void forest_scene_destroy(struct scene *base)
{
    struct forest_scene *scene = (struct forest_scene *)base;

    scene_programs_destroy(&scene->programs);
    scene_programs_destroy(&scene->backdrop);
    glDeleteVertexArrays(1, &scene->no_vertices);
    glDeleteBuffers(1, &scene->view_numbers);
    glDeleteBuffers(1, &scene->instances);
    destroy_part(&scene->ground);
    for (int kind = 0; kind < FOREST_KINDS; kind++)
        destroy_part(&scene->kinds[kind]);
    forest_destroy(&scene->forest);
    free(scene->seen);
    free(scene);
}

static double forest_scene_distance(const struct scene *base, const double place[3])
{
    return forest_distance(&((const struct forest_scene *)base)->forest, place);
}

static void attribute(GLuint index, GLint size, size_t stride, size_t offset, GLuint divisor)
{
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void *)offset);
    glVertexAttribDivisor(index, divisor);
}

/* An integer for each instance. */
static void number_attribute(GLuint index, size_t stride, size_t offset)
{
    glEnableVertexAttribArray(index);
    glVertexAttribIPointer(index, 1, GL_INT, (GLsizei)stride, (const void *)offset);
    glVertexAttribDivisor(index, 1);
}

static void create_part(struct part *part, const struct forest_mesh *mesh)
{
    glGenVertexArrays(1, &part->vertex_array);
    glBindVertexArray(part->vertex_array);
    glGenBuffers(1, &part->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, part->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)mesh->vertex_count * sizeof *mesh->vertices),
                 mesh->vertices, GL_STATIC_DRAW);
    glGenBuffers(1, &part->indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, part->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 (GLsizeiptr)((size_t)mesh->index_count * sizeof *mesh->indices), mesh->indices,
                 GL_STATIC_DRAW);
    attribute(0, 3, sizeof *mesh->vertices, offsetof(struct forest_vertex, position), 0);
    attribute(1, 3, sizeof *mesh->vertices, offsetof(struct forest_vertex, normal), 0);
    attribute(2, 3, sizeof *mesh->vertices, offsetof(struct forest_vertex, color), 0);
}

static void create_parts(struct forest_scene *scene)
{
    static const GLint numbers[CUPOLA_VIEWS_MAX] = {0, 1, 2, 3, 4, 5, 6, 7};
    const size_t stride = sizeof(struct instance);

    glGenVertexArrays(1, &scene->no_vertices);
    glGenBuffers(1, &scene->instances);
    create_part(&scene->ground, &scene->forest.ground);
    glGenBuffers(1, &scene->view_numbers);
    glBindBuffer(GL_ARRAY_BUFFER, scene->view_numbers);
    glBufferData(GL_ARRAY_BUFFER, sizeof numbers, numbers, GL_STATIC_DRAW);
    number_attribute(5, sizeof *numbers, 0);
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        create_part(&scene->kinds[kind], &scene->forest.kinds[kind]);
        glBindBuffer(GL_ARRAY_BUFFER, scene->instances);
        attribute(3, 4, stride, offsetof(struct instance, tree.place), 1);
        attribute(4, 3, stride, offsetof(struct instance, tree.turn), 1);
        number_attribute(5, stride, offsetof(struct instance, view));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static void set_sky(GLuint program)
{
    glUseProgram(program);
    glUniform3fv(glGetUniformLocation(program, "sun"), 1, shading_sun);
    /* The backdrop's own ground lies above every eye, where it is not drawn. */
    glUniform3f(glGetUniformLocation(program, "center"), 0, 1e9f, 0);
    glUniform3f(glGetUniformLocation(program, "half_size"), 1, 1, 1);
    glUniform1f(glGetUniformLocation(program, "grid_step"), 1);
    glUseProgram(0);
}

static bool create_programs(struct forest_scene *scene, const struct scene_wishes *wishes,
                            char *message, size_t message_size)
{
    const struct shading_lamps lamps = {
        .radius = 700, .lowest = 0.15, .light = 0.45, .bump_size = 0.3f, .smoothest = 0.55f};

    static const char *const varyings[] = {"vec3 surface_place", "vec3 surface_normal",
                                           "vec3 surface_base"};
    const struct program_source source = {.name = "forest",
                                          .vertex = shader_forest_vert,
                                          .varyings = varyings,
                                          .varying_count = 3,
                                          .functions = shader_sunlight_glsl,
                                          .fragment = shader_forest_frag};

    if (!shading_programs_create(&scene->programs, &source, &lamps, wishes, message,
                                 message_size) ||
        !scene_backdrop_create(&scene->backdrop, "backdrop", shader_backdrop_frag, wishes->way,
                               message, message_size))
        return false;
    set_sky(scene->backdrop.one_view);
    if (wishes->way)
        set_sky(scene->backdrop.all_views);
    return true;
}

/* The sphere round everything, and the counts. */
static void set_extent(struct forest_scene *scene)
{
    const struct forest *forest = &scene->forest;
    double most = 0;

    for (int i = 0; i < forest->ground.vertex_count; i++) {
        const float *p = forest->ground.vertices[i].position;
        most = fmax(most, sqrt((double)(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])));
    }
    scene->scene.whole = (struct scene_counts){forest_triangles(forest), 1};
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        scene->scene.whole.instances += forest->tree_count[kind];
        for (int i = 0; i < forest->tree_count[kind]; i++) {
            const struct forest_tree *tree = &forest->trees[kind][i];
            const float *p = tree->place;
            most = fmax(most, sqrt((double)(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])) +
                                  (double)tree->radius);
        }
    }
    scene->scene.radius = most;
}

static bool create_room(struct forest_scene *scene, const struct scene_wishes *wishes)
{
    const struct forest *forest = &scene->forest;
    int most = 1;

    if (!forest_create(&scene->forest, wishes->triangles ? wishes->triangles : SCENE_TRIANGLES,
                       wishes->seed))
        return false;
    for (int kind = 0; kind < FOREST_KINDS; kind++)
        if (forest->tree_count[kind] > most)
            most = forest->tree_count[kind];
    scene->seen = malloc((size_t)most * (wishes->way ? CUPOLA_VIEWS_MAX : 1) * sizeof *scene->seen);
    return scene->seen != NULL;
}

struct scene *scene_forest_create(const struct scene_wishes *wishes, char *message,
                                  size_t message_size)
{
    struct forest_scene *scene = calloc(1, sizeof *scene);

    snprintf(message, message_size, "scene 'forest': out of memory");
    if (!scene)
        return NULL;
    scene->scene.draw = forest_scene_draw;
    scene->scene.destroy = forest_scene_destroy;
    scene->scene.distance = forest_scene_distance;
    if (!create_room(scene, wishes) || !create_programs(scene, wishes, message, message_size)) {
        forest_scene_destroy(&scene->scene);
        return NULL;
    }
    create_parts(scene);
    set_extent(scene);
    return &scene->scene;
}
