/* The room of the paper's figure 3: the inside of a cube, made for judging a dome by eye. */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "scene_cube_picture.h"
#include "shading.h"

/* From the middle to each face; a dome of 1 m fits in with its viewer anywhere. */
static const float half_side = 2;

struct cube_scene {
    struct scene scene;
    struct scene_programs programs;
    GLuint vertex_array;
    GLuint vertices;
    GLuint pictures;
};

struct corner {
    float position[3];
    float texcoord[3];
    float inward[3];
};

static void cube_draw(struct scene *scene, const struct scene_camera *camera)
{
    struct cube_scene *cube = (struct cube_scene *)scene;
    GLuint program = scene_program(&cube->programs, camera);
    int views = scene_view_count(camera);

    glUseProgram(program);
    if (!scene_set_camera(program, camera))
        return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(camera->reversed_depth ? GL_GREATER : GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, cube->pictures);
    glBindVertexArray(cube->vertex_array);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * CUBE_FACES, views);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    glUseProgram(0);
    scene->drawn.triangles += views * scene->whole.triangles;
    scene->drawn.instances += views * scene->whole.instances;
}

static void cube_destroy(struct scene *scene)
{
    struct cube_scene *cube = (struct cube_scene *)scene;
    scene_programs_destroy(&cube->programs);
    glDeleteVertexArrays(1, &cube->vertex_array);
    glDeleteBuffers(1, &cube->vertices);
    glDeleteTextures(1, &cube->pictures);
    free(cube);
}

/* To the six squares, from inside or outside. */
static double cube_distance(const struct scene *scene, const double place[3])
{
    (void)scene;
    double half = (double)half_side, nearest = HUGE_VAL;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double squared = pow(place[axis] - sign * half, 2);
            for (int other = 0; other < 3; other++)
                if (other != axis)
                    squared += pow(fmax(fabs(place[other]) - half, 0), 2);
            nearest = fmin(nearest, sqrt(squared));
        }
    return nearest;
}

static void create_walls(struct cube_scene *cube)
{
    static const int order[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    struct corner corners[CUBE_FACES][6];
    for (int f = 0; f < CUBE_FACES; f++)
        for (int c = 0; c < 6; c++) {
            const struct cube_face *face = &cube_faces[f];
            struct corner *corner = &corners[f][c];
            float right = (float)(2 * order[c][0] - 1), up = (float)(2 * order[c][1] - 1);
            for (int k = 0; k < 3; k++) {
                corner->position[k] =
                    half_side * (face->outward[k] + right * face->right[k] + up * face->up[k]);
                corner->inward[k] = -face->outward[k];
            }
            corner->texcoord[0] = (float)order[c][0];
            corner->texcoord[1] = (float)order[c][1];
            corner->texcoord[2] = (float)f;
        }

    glGenVertexArrays(1, &cube->vertex_array);
    glBindVertexArray(cube->vertex_array);
    glGenBuffers(1, &cube->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, cube->vertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    const size_t offsets[3] = {offsetof(struct corner, position), offsetof(struct corner, texcoord),
                               offsetof(struct corner, inward)};
    for (GLuint i = 0; i < 3; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(struct corner),
                              (const void *)offsets[i]);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static bool create_pictures(struct cube_scene *cube, const struct scene_wishes *wishes)
{
    const int size = CUBE_PICTURE_SIZE_PX, anisotropy = wishes->anisotropy ? wishes->anisotropy : 8;
    unsigned char *picture = malloc((size_t)size * (size_t)size * 4);
    if (!picture)
        return false;
    glGenTextures(1, &cube->pictures);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, cube->pictures);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, size, size, CUBE_FACES, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, NULL);
    for (int f = 0; f < CUBE_FACES; f++) {
        cube_picture_paint(f, picture);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, f, size, size, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                        picture);
    }
    free(picture);
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER,
                    wishes->one_level ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") ||
        epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic")) {
        float most = 1;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
        glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        fminf(most, (float)anisotropy));
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return true;
}

static bool create_program(struct cube_scene *cube, const struct scene_wishes *wishes,
                           char *message, size_t message_size)
{
    const struct shading_lamps lamps = {
        .radius = 0.6 * (double)half_side, .lowest = -0.9, .bump_size = 0.12f};
    static const char *const varyings[] = {"vec3 wall_place", "vec3 wall_texcoord",
                                           "flat vec3 wall_inward"};
    const struct program_source source = {.name = "cube",
                                          .vertex = shader_cube_vert,
                                          .varyings = varyings,
                                          .varying_count = 3,
                                          .functions = shader_lamp_glsl,
                                          .fragment = shader_cube_frag};
    const GLuint *made[2] = {&cube->programs.one_view, &cube->programs.all_views};
    if (!shading_programs_create(&cube->programs, &source, &lamps, wishes, message, message_size))
        return false;
    for (int i = 0; i < 2 && *made[i]; i++) {
        glUseProgram(*made[i]);
        glUniform1i(glGetUniformLocation(*made[i], "pictures"), 0);
    }
    glUseProgram(0);
    return true;
}

struct scene *scene_cube_create(const struct scene_wishes *wishes, char *message,
                                size_t message_size)
{
    struct cube_scene *cube = calloc(1, sizeof *cube);
    if (!cube) {
        snprintf(message, message_size, "scene 'cube': out of memory");
        return NULL;
    }
    cube->scene.draw = cube_draw;
    cube->scene.destroy = cube_destroy;
    cube->scene.distance = cube_distance;
    cube->scene.radius = (double)half_side * sqrt(3);
    cube->scene.whole = (struct scene_counts){2L * CUBE_FACES, 1};
    if (!create_program(cube, wishes, message, message_size))
        goto fail;
    if (!create_pictures(cube, wishes)) {
        snprintf(message, message_size, "scene 'cube': out of memory");
        goto fail;
    }
    create_walls(cube);
    return &cube->scene;

fail:
    cube_destroy(&cube->scene);
    return NULL;
}
