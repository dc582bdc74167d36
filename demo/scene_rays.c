/*
 * Scenes whose colours are numbers: the direction of each ray, and the point of the screen that it
 * meets. A world that is known at every pixel without drawing anything.
 */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "program.h"
#include "scene_matrix.h"

struct rays_scene {
    struct scene scene;
    double to_output[9]; /* rotation from the host's camera frame to that of the colours; rows */
    GLuint program;
    GLuint vertex_array; /* without any attribute: core profiles draw nothing without one */
    GLint ray_basis;
};

static void rays_draw(struct scene *scene, const struct scene_camera *camera)
{
    struct rays_scene *rays = (struct rays_scene *)scene;
    double clip[16], basis[9], eye[3];
    scene_clip_from_camera(camera, clip);
    if (!scene_rays(clip, basis, eye))
        return;
    float turned[9];
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) {
            double sum = 0;
            for (int k = 0; k < 3; k++)
                sum += rays->to_output[row * 3 + k] * basis[column * 3 + k];
            turned[column * 3 + row] = (float)sum;
        }

    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glUseProgram(rays->program);
    glUniformMatrix3fv(rays->ray_basis, 1, GL_FALSE, turned);
    glBindVertexArray(rays->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
}

static void rays_destroy(struct scene *scene)
{
    struct rays_scene *rays = (struct rays_scene *)scene;
    glDeleteProgram(rays->program);
    glDeleteVertexArrays(1, &rays->vertex_array);
    free(rays);
}

static struct rays_scene *rays_create(const char *name, const char *fragment_source,
                                      const double to_output[9], char *message, size_t message_size)
{
    struct rays_scene *rays = calloc(1, sizeof *rays);
    if (!rays) {
        snprintf(message, message_size, "scene '%s': out of memory", name);
        return NULL;
    }
    rays->program = program_create(name, shader_rays_vert, fragment_source, message, message_size);
    if (!rays->program) {
        free(rays);
        return NULL;
    }
    rays->scene.draw = rays_draw;
    rays->scene.destroy = rays_destroy;
    rays->scene.needs_float = true;
    for (int i = 0; i < 9; i++)
        rays->to_output[i] = to_output[i];
    rays->ray_basis = glGetUniformLocation(rays->program, "ray_basis");
    glGenVertexArrays(1, &rays->vertex_array);
    return rays;
}

struct scene *scene_directions_create(char *message, size_t message_size)
{
    static const double none[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    struct rays_scene *rays =
        rays_create("directions", shader_directions_frag, none, message, message_size);
    return rays ? &rays->scene : NULL;
}

struct scene *scene_screen_create(const double camera_to_dome[9], const double eye_m[3],
                                  double radius_m, char *message, size_t message_size)
{
    double power_m2 = radius_m * radius_m;
    for (int k = 0; k < 3; k++)
        power_m2 -= eye_m[k] * eye_m[k];
    if (!(power_m2 > 0)) {
        snprintf(message, message_size,
                 "scene 'screen': the eye is at (%g, %g, %g) m; allowed: inside of the screen, "
                 "whose radius is %g m",
                 eye_m[0], eye_m[1], eye_m[2], radius_m);
        return NULL;
    }
    struct rays_scene *rays =
        rays_create("screen", shader_screen_frag, camera_to_dome, message, message_size);
    if (!rays)
        return NULL;
    glUseProgram(rays->program);
    glUniform3f(glGetUniformLocation(rays->program, "eye_m"), (float)eye_m[0], (float)eye_m[1],
                (float)eye_m[2]);
    glUniform1f(glGetUniformLocation(rays->program, "power_m2"), (float)power_m2);
    glUseProgram(0);
    return &rays->scene;
}
