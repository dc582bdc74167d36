/* The places of the marks on the simulated screen. */
#include "tool/stickers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "calib_shaders.h"
#include "program.h"

enum { STICKERS_MAX = 1000 }; /* that are drawn; nobody steers to more by hand */

static const float RADIUS_PX = 6;

struct stickers {
    GLuint program;
    GLuint vertex_array; /* empty: core profiles want one */
};

struct stickers *stickers_create(char *message)
{
    struct stickers *stickers = calloc(1, sizeof *stickers);

    if (!stickers) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    glGenVertexArrays(1, &stickers->vertex_array);
    stickers->program =
        program_create("stickers", shader_stage_vert, shader_sticker_frag, message, MESSAGE_SIZE);
    if (stickers->program)
        return stickers;
    stickers_destroy(stickers);
    return NULL;
}

void stickers_destroy(struct stickers *stickers)
{
    if (!stickers)
        return;
    glDeleteProgram(stickers->program);
    glDeleteVertexArrays(1, &stickers->vertex_array);
    free(stickers);
}

bool sticker_place(const struct cupola_spectator *spectator, const double point_m[3],
                   const int rectangle[4], double place_px[2])
{
    double seen[3] = {0}, per_unit = 0.5 * rectangle[3] / tan(0.5 * spectator->fov_rad);

    for (int row = 0; row < 3; row++)
        for (int i = 0; i < 3; i++)
            seen[row] += spectator->rotation[3 * row + i] * (point_m[i] - spectator->position_m[i]);
    if (!(seen[2] < 0))
        return false;
    for (int i = 0; i < 2; i++) {
        double off = seen[i] / -seen[2] * per_unit;
        if (!(fabs(off) < 0.5 * rectangle[2 + i]))
            return false;
        place_px[i] = rectangle[i] + 0.5 * rectangle[2 + i] + off;
    }
    return true;
}

static void draw_sticker(const struct stickers *stickers, const double place_px[2], bool current)
{
    int side = 2 * (int)RADIUS_PX + 6;

    glScissor((int)place_px[0] - side / 2, (int)place_px[1] - side / 2, side, side);
    glUniform2f(glGetUniformLocation(stickers->program, "place_px"), (float)place_px[0],
                (float)place_px[1]);
    glUniform3f(glGetUniformLocation(stickers->program, "ink"), current ? 1.0f : 0.6f,
                current ? 0.35f : 0.25f, current ? 1.0f : 0.6f);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void stickers_draw(const struct stickers *stickers, const struct tool *tool,
                   const struct cupola_spectator *spectator, unsigned int framebuffer,
                   const int rectangle[4])
{
    double scale = tool->marks.kind == MARKS_DIRECTIONS ? tool->theatre.screen.radius_m : 1;

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(stickers->program);
    glUniform1f(glGetUniformLocation(stickers->program, "radius_px"), RADIUS_PX);
    glBindVertexArray(stickers->vertex_array);
    for (int i = 0; i < tool->marks.count && i < STICKERS_MAX; i++) {
        const double *place = tool->marks.list[i].place;
        double point_m[3] = {scale * place[0], scale * place[1], scale * place[2]}, place_px[2];
        if (sticker_place(spectator, point_m, rectangle, place_px))
            draw_sticker(stickers, place_px, i == tool->mark);
    }
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
}
