/* The test grid. */
#include "grid.h"

#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "overlay_shaders.h"
#include "program.h"

struct grid {
    GLuint program;
    GLuint vertex_array; /* empty: core profiles want one */
    GLint rays;
    GLint eye;
    GLint radius;
};

struct grid *grid_create(char *message, size_t message_size)
{
    struct grid *grid = calloc(1, sizeof *grid);

    if (!grid) {
        snprintf(message, message_size, "test grid: out of memory");
        return NULL;
    }
    grid->program =
        program_create("test grid", shader_grid_vert, shader_grid_frag, message, message_size);
    if (!grid->program) {
        free(grid);
        return NULL;
    }
    grid->rays = glGetUniformLocation(grid->program, "rays");
    grid->eye = glGetUniformLocation(grid->program, "eye_m");
    grid->radius = glGetUniformLocation(grid->program, "radius_m");
    glGenVertexArrays(1, &grid->vertex_array);
    return grid;
}

void grid_destroy(struct grid *grid)
{
    if (!grid)
        return;
    glDeleteVertexArrays(1, &grid->vertex_array);
    glDeleteProgram(grid->program);
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

void grid_draw(struct grid *grid, const cupola_dome *dome, const struct cupola_view *view)
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    const double across[3] = {view->right - view->left, 0, 0};
    const double upwards[3] = {0, view->top - view->bottom, 0};
    const double corner[3] = {view->left, view->bottom, -1};
    float rays[9]; /* columns: a place (u, v) of the base rectangle is seen along rays (u, v, 1) */

    to_dome(dome, view, across, rays);
    to_dome(dome, view, upwards, rays + 3);
    to_dome(dome, view, corner, rays + 6);

    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(grid->program);
    glUniformMatrix3fv(grid->rays, 1, GL_FALSE, rays);
    glUniform3f(grid->eye, (float)rig->eye_m[0], (float)rig->eye_m[1], (float)rig->eye_m[2]);
    glUniform1f(grid->radius, (float)rig->screen.radius_m);
    glBindVertexArray(grid->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_BLEND);
}
