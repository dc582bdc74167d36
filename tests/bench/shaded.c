/* A rectangle over each view, as near as can be, under an occlusion query. */
#include "shaded.h"

#include <stdio.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "program.h"
#include "setting.h"

/* Behind the nearest distance, of the depth's range: of 24 bits some. */
static const GLfloat just_behind = 1e-6f;

static void draw_whole(GLuint program, GLuint vertex_array)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthRangef(just_behind, just_behind);
    glUseProgram(program);
    glBindVertexArray(vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    glDepthRangef(0, 1);
    glDisable(GL_DEPTH_TEST);
}

double shaded_texels(cupola_gl *gl, char *message)
{
    int views = cupola_gl_frame_begin(gl, NULL, NULL);
    GLuint query, vertex_array, passed = 0, program;
    double texels = views > 0 ? 0 : -1;

    program = program_create("count", shader_whole_vert, shader_blit_frag, message, MESSAGE_SIZE);
    if (!program)
        return -1;
    glGenQueries(1, &query);
    glGenVertexArrays(1, &vertex_array);
    for (int i = 0; i < views && texels >= 0; i++) {
        if (cupola_gl_view_begin(gl, i, NULL, NULL) < 0) {
            texels = -1;
            break;
        }
        glBeginQuery(GL_SAMPLES_PASSED, query);
        draw_whole(program, vertex_array);
        glEndQuery(GL_SAMPLES_PASSED);
        cupola_gl_view_end(gl, NULL);
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
        texels += passed;
    }
    glDeleteQueries(1, &query);
    glDeleteVertexArrays(1, &vertex_array);
    glDeleteProgram(program);
    if (texels < 0)
        snprintf(message, MESSAGE_SIZE, "the shaded texels cannot be counted");
    return texels;
}
