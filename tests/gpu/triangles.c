/* Triangles: see triangles.h. */
#include "triangles.h"

#include "context.h"
#include "paint_shaders.h"

struct triangles triangles_create(void)
{
    struct triangles made = {context_program(shader_triangle_vert, shader_flat_frag), 0, 0};
    glGenVertexArrays(1, &made.vertex_array);
    glGenBuffers(1, &made.buffer);
    return made;
}

void triangles_release(const struct triangles *triangles)
{
    glUseProgram(0);
    glDeleteProgram(triangles->program);
    glDeleteVertexArrays(1, &triangles->vertex_array);
    glDeleteBuffers(1, &triangles->buffer);
}

void triangles_draw(const struct triangles *triangles, const struct cupola_camera *camera,
                    const float color[4], float (*points)[3], int count)
{
    GLuint program = triangles->program;
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE,
                       camera->projection);
    glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, camera->view);
    glUniform4fv(glGetUniformLocation(program, "flat_color"), 1, color);
    glBindVertexArray(triangles->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, triangles->buffer);
    glBufferData(GL_ARRAY_BUFFER, count * (GLsizeiptr)sizeof *points, points, GL_STREAM_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    glEnableVertexAttribArray(0);
    glDrawArrays(GL_TRIANGLES, 0, count);
}

void plane_over_view(const cupola_plan *plan, int view, const double nearness[3],
                     float points[6][3])
{
    static const int corners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    const struct cupola_view *v = cupola_plan_view(plan, view);
    const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(plan));
    double eye[3];
    cupola_dome_to_camera(cupola_plan_dome(plan), rig->eye_m, eye);
    for (int i = 0; i < 6; i++) {
        int x = corners[i][0], y = corners[i][1];
        double d = 1 / (nearness[0] + nearness[1] * x + nearness[2] * y);
        double a = d * (x < 0 ? v->left : v->right), b = d * (y < 0 ? v->bottom : v->top);
        for (int k = 0; k < 3; k++)
            points[i][k] = (float)(rig->units_per_metre * eye[k] + a * v->rotation[k] +
                                   b * v->rotation[3 + k] - d * v->rotation[6 + k]);
    }
}
