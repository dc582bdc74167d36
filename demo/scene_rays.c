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
#include "scene_views.h"

struct rays_scene {
    struct scene scene;
    double to_output[9]; /* rotation from the host's camera frame to that of the colours; rows */
    struct scene_programs programs;
    GLuint vertex_array; /* without any attribute: core profiles draw nothing without one */
};

static void rays_draw(struct scene *scene, const struct scene_camera *camera)
{
    struct rays_scene *rays = (struct rays_scene *)scene;
    GLuint program = scene_program(&rays->programs, camera);

    glUseProgram(program);
    if (!scene_set_rays(program, camera, false, rays->to_output))
        return;
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    scene_fill(camera, rays->vertex_array);
    glBindVertexArray(0);
    glUseProgram(0);
}

static void rays_destroy(struct scene *scene)
{
    struct rays_scene *rays = (struct rays_scene *)scene;
    scene_programs_destroy(&rays->programs);
    glDeleteVertexArrays(1, &rays->vertex_array);
    free(rays);
}

static struct rays_scene *rays_create(const char *name, const char *fragment_source,
                                      const double to_output[9], int way, char *message,
                                      size_t message_size)
{
    struct rays_scene *rays = calloc(1, sizeof *rays);
    if (!rays) {
        snprintf(message, message_size, "scene '%s': out of memory", name);
        return NULL;
    }
    if (!scene_backdrop_create(&rays->programs, name, fragment_source, way, message,
                               message_size)) {
        free(rays);
        return NULL;
    }
    rays->scene.draw = rays_draw;
    rays->scene.destroy = rays_destroy;
    rays->scene.needs_float = true;
    for (int i = 0; i < 9; i++)
        rays->to_output[i] = to_output[i];
    glGenVertexArrays(1, &rays->vertex_array);
    return rays;
}

struct scene *scene_directions_create(int way, char *message, size_t message_size)
{
    static const double none[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    struct rays_scene *rays =
        rays_create("directions", shader_directions_frag, none, way, message, message_size);
    return rays ? &rays->scene : NULL;
}

struct scene *scene_screen_create(const double camera_to_dome[9], const double eye_m[3],
                                  double radius_m, int way, char *message, size_t message_size)
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
        rays_create("screen", shader_screen_frag, camera_to_dome, way, message, message_size);
    if (!rays)
        return NULL;
    const GLuint made[2] = {rays->programs.one_view, rays->programs.all_views};
    for (int i = 0; i < 2 && made[i]; i++) {
        glUseProgram(made[i]);
        glUniform3f(glGetUniformLocation(made[i], "eye_m"), (float)eye_m[0], (float)eye_m[1],
                    (float)eye_m[2]);
        glUniform1f(glGetUniformLocation(made[i], "power_m2"), (float)power_m2);
    }
    glUseProgram(0);
    return &rays->scene;
}
