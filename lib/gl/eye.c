/*
 * A viewer who moves. The plan's views follow at once; what the GL has of them, uniforms, tables
 * and tiles, when it is needed, so that an output that is not shown costs nothing.
 */
#include <string.h>

#include "error.h"
#include "instance.h"
#include "program.h"

static int set_eye(cupola_gl *gl, const double eye_m[3], struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (open_kind(gl))
        return error_set(error, CUPOLA_ERROR_ORDER, "set_eye inside of a %s; end it first",
                         open_kind(gl));
    const double *here_m = gl->plan.dome.rig.eye_m;
    if (eye_m && memcmp(eye_m, here_m, sizeof gl->plan.dome.rig.eye_m) == 0)
        return CUPOLA_OK;
    jitter_lift(gl);
    int status = cupola_plan_set_eye(&gl->plan, eye_m, error);
    jitter_lay(gl);
    if (status == CUPOLA_OK)
        gl->moves++;
    return status;
}

int cupola_gl_set_eye(cupola_gl *gl, const double eye_m[3], struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, set_eye(gl, eye_m, error), error);
}

static void programs_follow(const cupola_gl *gl, const struct warp_pass *pass)
{
    for (int gained = 0; gained < 2; gained++) {
        const struct warp_program *program = &pass->programs[gained][CUPOLA_SOURCE_VIEWS];
        if (!program->program)
            continue;
        glUseProgram(program->program);
        program_place_eye(program->eye, &gl->plan.dome);
        program_place_bases(program->bases, &gl->plan);
    }
}

void eye_follow(cupola_gl *gl, int output, GLuint framebuffer)
{
    struct warp_pass *pass = &gl->passes[output];
    if (pass->moves == gl->moves)
        return;
    programs_follow(gl, pass);
    if (pass->stage == CUPOLA_TABLE_TILES)
        tile_pass_refit(gl, output);
    table_redraw(gl, output);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    pass->moves = gl->moves;
}
