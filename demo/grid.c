/* The test grid. */
#include "grid.h"

#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "overlay_shaders.h"
#include "scene_views.h"

struct grid {
    struct scene_programs programs;
    GLuint vertex_array; /* empty: core profiles want one */
};

struct grid *grid_create(int way, char *message, size_t message_size)
{
    static const char *const varyings[] = {"vec3 dome_ray"};
    const struct program_source source = {.name = "test grid",
                                          .vertex = shader_grid_vert,
                                          .varyings = varyings,
                                          .varying_count = 1,
                                          .fragment = shader_grid_frag};
    struct grid *grid = calloc(1, sizeof *grid);

    if (!grid) {
        snprintf(message, message_size, "test grid: out of memory");
        return NULL;
    }
    grid->programs.one_view = program_create_of(0, &source, message, message_size);
    if (grid->programs.one_view && way)
        grid->programs.all_views = program_create_of(way, &source, message, message_size);
    if (!grid->programs.one_view || (way && !grid->programs.all_views)) {
        grid_destroy(grid);
        return NULL;
    }
    glGenVertexArrays(1, &grid->vertex_array);
    return grid;
}

void grid_destroy(struct grid *grid)
{
    if (!grid)
        return;
    glDeleteVertexArrays(1, &grid->vertex_array);
    scene_programs_destroy(&grid->programs);
    free(grid);
}

/* A vector of the view's own frame in the dome frame. */
static void to_dome(const cupola_dome *dome, const struct cupola_view *view, const double v[3],
                    float dome_vector[3])
{
    double camera_vector[3], turned[3];

    for (int i = 0; i < 3; i++)
        camera_vector[i] =
            view->rotation[i] * v[0] + view->rotation[3 + i] * v[1] + view->rotation[6 + i] * v[2];
    cupola_dome_from_camera(dome, camera_vector, turned);
    for (int i = 0; i < 3; i++)
        dome_vector[i] = (float)turned[i];
}

/* Columns: a place (u, v) of the base rectangle is seen along rays (u, v, 1). */
static void view_rays(const cupola_dome *dome, const struct cupola_view *view, float rays[9])
{
    const double across[3] = {view->right - view->left, 0, 0};
    const double upwards[3] = {0, view->top - view->bottom, 0};
    const double corner[3] = {view->left, view->bottom, -1};

    to_dome(dome, view, across, rays);
    to_dome(dome, view, upwards, rays + 3);
    to_dome(dome, view, corner, rays + 6);
}

void grid_draw(struct grid *grid, const cupola_dome *dome, const cupola_plan *plan, int first,
               int count)
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    GLuint program = count > 1 ? grid->programs.all_views : grid->programs.one_view;
    float rays[9 * CUPOLA_VIEWS_MAX];

    for (int i = 0; i < count; i++)
        view_rays(dome, cupola_plan_view(plan, first + i), rays + 9 * i);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program);
    glUniformMatrix3fv(glGetUniformLocation(program, "rays"), count, GL_FALSE, rays);
    glUniform3f(glGetUniformLocation(program, "eye_m"), (float)rig->eye_m[0], (float)rig->eye_m[1],
                (float)rig->eye_m[2]);
    glUniform1f(glGetUniformLocation(program, "radius_m"), (float)rig->screen.radius_m);
    glBindVertexArray(grid->vertex_array);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 3, count);
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_BLEND);
}
