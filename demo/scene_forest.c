/* The forest: of its instances those that a view may see, in a buffer filled for each view. */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "forest.h"
#include "program.h"
#include "scene_matrix.h"
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
    GLuint program;
    GLuint backdrop; /* program: the sky */
    GLuint no_vertices;
    struct part ground;
    struct part kinds[FOREST_KINDS];
    GLuint instances;         /* of the kind and view that is drawn */
    struct forest_tree *seen; /* room for as many as there are of any kind */
};

/* Copies the trees that the view may see; how many. */
static int cull(const struct forest_scene *scene, int kind, const struct scene_camera *camera)
{
    const struct forest_tree *trees = scene->forest.trees[kind];
    const float *m = camera->host;
    int seen = 0;

    for (int i = 0; i < scene->forest.tree_count[kind]; i++) {
        const float *p = trees[i].place;
        float center[3];
        for (int k = 0; k < 3; k++)
            center[k] = m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k];
        if (cupola_camera_sees_sphere(camera->view, center, trees[i].radius) == 1)
            scene->seen[seen++] = trees[i];
    }
    return seen;
}

static void draw_sky(const struct forest_scene *scene, const double basis[9], const float eye[3])
{
    float float_basis[9];

    scene_to_float(basis, 9, float_basis);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(scene->backdrop);
    glUniformMatrix3fv(glGetUniformLocation(scene->backdrop, "ray_basis"), 1, GL_FALSE,
                       float_basis);
    glUniform3fv(glGetUniformLocation(scene->backdrop, "eye"), 1, eye);
    glBindVertexArray(scene->no_vertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void draw_trees(struct forest_scene *scene, const struct scene_camera *camera)
{
    glBindBuffer(GL_ARRAY_BUFFER, scene->instances);
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        int count = cull(scene, kind, camera), indices = scene->forest.kinds[kind].index_count;
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

static void draw_ground(struct forest_scene *scene)
{
    int indices = scene->forest.ground.index_count;

    glBindVertexArray(scene->ground.vertex_array);
    glVertexAttrib4f(3, 0, 0, 0, 1);
    glVertexAttrib3f(4, 1, 0, 0.5f);
    glDrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_INT, NULL);
    scene->scene.drawn.triangles += indices / 3;
    scene->scene.drawn.instances++;
}

static void forest_scene_draw(struct scene *base, const struct scene_camera *camera)
{
    struct forest_scene *scene = (struct forest_scene *)base;
    double clip[16], basis[9], eye[3];
    float matrix[16], float_eye[3];

    scene_clip_from_world(camera, clip);
    if (!scene_rays(clip, basis, eye))
        return;
    scene_to_float(clip, 16, matrix);
    scene_to_float(eye, 3, float_eye);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    draw_sky(scene, basis, float_eye);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(camera->reversed_depth ? GL_GREATER : GL_LESS);
    glDepthMask(GL_TRUE);
    glUseProgram(scene->program);
    glUniformMatrix4fv(glGetUniformLocation(scene->program, "clip_from_world"), 1, GL_FALSE,
                       matrix);
    glUniform3fv(glGetUniformLocation(scene->program, "eye"), 1, float_eye);
    draw_trees(scene, camera);
    draw_ground(scene);
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

    glDeleteProgram(scene->program);
    glDeleteProgram(scene->backdrop);
    glDeleteVertexArrays(1, &scene->no_vertices);
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
    const size_t stride = sizeof(struct forest_tree);

    glGenVertexArrays(1, &scene->no_vertices);
    glGenBuffers(1, &scene->instances);
    create_part(&scene->ground, &scene->forest.ground);
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        create_part(&scene->kinds[kind], &scene->forest.kinds[kind]);
        glBindBuffer(GL_ARRAY_BUFFER, scene->instances);
        attribute(3, 4, stride, offsetof(struct forest_tree, place), 1);
        attribute(4, 3, stride, offsetof(struct forest_tree, turn), 1);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static bool create_programs(struct forest_scene *scene, const struct scene_wishes *wishes,
                            char *message, size_t message_size)
{
    const struct shading_lamps lamps = {
        .radius = 700, .lowest = 0.15, .light = 0.45, .bump_size = 0.3f, .smoothest = 0.55f};

    scene->program =
        shading_program_create("forest", shader_forest_vert, shader_forest_frag,
                               shader_sunlight_glsl, &lamps, wishes, message, message_size);
    scene->backdrop =
        program_create("backdrop", shader_rays_vert, shader_backdrop_frag, message, message_size);
    if (!scene->program || !scene->backdrop)
        return false;
    glUseProgram(scene->backdrop);
    glUniform3fv(glGetUniformLocation(scene->backdrop, "sun"), 1, shading_sun);
    /* The backdrop's own ground lies above every eye, where it is not drawn. */
    glUniform3f(glGetUniformLocation(scene->backdrop, "center"), 0, 1e9f, 0);
    glUniform3f(glGetUniformLocation(scene->backdrop, "half_size"), 1, 1, 1);
    glUniform1f(glGetUniformLocation(scene->backdrop, "grid_step"), 1);
    glUseProgram(0);
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
    scene->seen = malloc((size_t)most * sizeof *scene->seen);
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
