/* What the scenes do alike for one view and for all views in one pass. */
#include "scene_views.h"

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "scene_matrix.h"

bool scene_backdrop_create(struct scene_programs *programs, const char *name, const char *fragment,
                           int way, char *message, size_t message_size)
{
    static const char *const varyings[] = {"vec3 ray"};
    const struct program_source source = {.name = name,
                                          .vertex = shader_rays_vert,
                                          .varyings = varyings,
                                          .varying_count = 1,
                                          .fragment = fragment};

    programs->one_view = program_create_of(0, &source, message, message_size);
    programs->all_views = way ? program_create_of(way, &source, message, message_size) : 0;
    if (programs->one_view && (!way || programs->all_views))
        return true;
    scene_programs_destroy(programs);
    *programs = (struct scene_programs){0, 0};
    return false;
}

void scene_programs_destroy(struct scene_programs *programs)
{
    glDeleteProgram(programs->one_view);
    glDeleteProgram(programs->all_views);
}

unsigned int scene_program(const struct scene_programs *programs, const struct scene_camera *camera)
{
    return camera->pass ? programs->all_views : programs->one_view;
}

int scene_view_count(const struct scene_camera *camera)
{
    return camera->pass ? camera->pass->view_count : 1;
}

const struct cupola_camera *scene_view(const struct scene_camera *camera, int index)
{
    return camera->pass ? &camera->pass->views[index].camera : camera->view;
}

void scene_fill(const struct scene_camera *camera, unsigned int vertex_array)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(camera->reversed_depth ? GL_GREATER : GL_LESS);
    glDepthMask(GL_FALSE);
    glBindVertexArray(vertex_array);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, scene_view_count(camera));
    glDepthMask(GL_TRUE);
}

void scene_backdrop_draw(const struct scene_programs *backdrop, const struct scene_camera *camera,
                         unsigned int vertex_array)
{
    GLuint program = scene_program(backdrop, camera);

    glUseProgram(program);
    if (scene_set_camera(program, camera) && scene_set_rays(program, camera, true, NULL))
        scene_fill(camera, vertex_array);
}

/* The same camera with one view of its own. */
static struct scene_camera camera_of_view(const struct scene_camera *camera, int index)
{
    return (struct scene_camera){scene_view(camera, index), camera->host, camera->reversed_depth};
}

bool scene_set_camera(unsigned int program, const struct scene_camera *camera)
{
    struct scene_camera first = camera_of_view(camera, 0);
    double clip[16], basis[9], eye[3];
    float numbers[16];

    scene_clip_from_world(&first, clip);
    if (!scene_rays(clip, basis, eye))
        return false;
    scene_to_float(camera->eye ? camera->eye : eye, 3, numbers);
    glUniform3fv(glGetUniformLocation(program, "eye"), 1, numbers);
    scene_to_float(clip, 16, numbers);
    if (!camera->pass) /* there it is in the uniform block */
        glUniformMatrix4fv(glGetUniformLocation(program, "clip_from_world"), 1, GL_FALSE, numbers);
    return true;
}

static void turn_basis(const double turn[9], const double basis[9], float turned[9])
{
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++) {
            double sum = 0;
            for (int k = 0; k < 3; k++)
                sum += turn[row * 3 + k] * basis[column * 3 + k];
            turned[column * 3 + row] = (float)sum;
        }
}

bool scene_set_rays(unsigned int program, const struct scene_camera *camera, bool of_world,
                    const double turn[9])
{
    float turned[CUPOLA_VIEWS_MAX * 9];
    int count = scene_view_count(camera);

    for (int i = 0; i < count; i++) {
        struct scene_camera view = camera_of_view(camera, i);
        double clip[16], basis[9], eye[3];
        if (of_world)
            scene_clip_from_world(&view, clip);
        else
            scene_clip_from_camera(&view, clip);
        if (!scene_rays(clip, basis, eye))
            return false;
        if (turn)
            turn_basis(turn, basis, turned + 9 * i);
        else
            scene_to_float(basis, 9, turned + 9 * i);
    }
    glUniformMatrix3fv(glGetUniformLocation(program, "ray_basis"), count, GL_FALSE, turned);
    return true;
}
