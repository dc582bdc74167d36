/* Tables of an output, drawn by the GL; table_upload.c has them where it cannot. */
#include "table_gl.h"
#include "error.h"
#include "gl_objects.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"

static bool depends_on_eye(enum cupola_table stage)
{
    return stage == CUPOLA_TABLE_ANGLES || stage == CUPOLA_TABLE_SINES ||
           stage == CUPOLA_TABLE_COORDINATES;
}

GLuint table_program_create(const cupola_dome *dome, int output, int view_count,
                            enum cupola_table stage, struct cupola_error *error)
{
    static const struct shader_file files[] = {
        {"varying.glsl", shader_varying_glsl}, {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},   {"views.glsl", shader_views_glsl},
        {"table.frag", shader_table_frag},
    };
    char defines[PROGRAM_DEFINES_MAX];
    program_defines(dome, output, view_count, (int)stage, defines);
    return program_create(defines, files, 5, error);
}

/* With its program in use and its framebuffer bound. */
static void draw_entries(const cupola_gl *gl, int output)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    host_set_area(&gl->features, 0, 0, size->width_px, size->height_px);
    draw_fullscreen(gl->vertex_array);
}

static void keep_for_redraw(const cupola_gl *gl, int output, GLuint program, GLuint framebuffer,
                            struct table_pass *redraw)
{
    guest_name(&gl->guest, GL_PROGRAM, program, "table of output %d for an eye that moves", output);
    guest_name(&gl->guest, GL_FRAMEBUFFER, framebuffer, "table of output %d", output);
    *redraw = (struct table_pass){program, framebuffer, glGetUniformLocation(program, "eye"),
                                  glGetUniformLocation(program, "view_base")};
}

/* Draws a stage's table of one output into a new texture. 0 on failure. */
static GLuint table_draw(const cupola_gl *gl, int output, enum cupola_table stage,
                         struct table_pass *redraw, struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    GLuint program =
        table_program_create(&gl->plan.dome, output, gl->plan.view_count, stage, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    program_set_views(program, &gl->plan);
    GLuint table = texture_create(GL_RGBA32F, size->width_px, size->height_px, GL_NEAREST, error);
    GLuint framebuffer = table ? framebuffer_create(table, "a table of floats", error) : 0;
    if (framebuffer)
        draw_entries(gl, output);
    if (framebuffer && redraw) {
        keep_for_redraw(gl, output, program, framebuffer, redraw);
        return table;
    }
    if (!framebuffer)
        glDeleteTextures(1, &table);
    glDeleteFramebuffers(1, &framebuffer);
    glUseProgram(0);
    glDeleteProgram(program);
    return framebuffer ? table : 0;
}

void table_pass_destroy(struct table_pass *redraw)
{
    glDeleteFramebuffers(1, &redraw->framebuffer);
    glDeleteProgram(redraw->program);
    *redraw = (struct table_pass){0};
}

void table_redraw(const cupola_gl *gl, int output)
{
    const struct table_pass *redraw = &gl->passes[output].redraw;
    if (!redraw->program)
        return;
    bool grouped = guest_group_open(&gl->guest, "table %s of output %d",
                                    cupola_table_name((int)gl->passes[output].stage), output);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, redraw->framebuffer);
    glUseProgram(redraw->program);
    program_place_eye(redraw->eye, &gl->plan.dome);
    program_place_bases(redraw->bases, &gl->plan);
    draw_entries(gl, output);
    guest_group_close(&gl->guest, grouped);
}

/* On the CPU a table would take many frames. */
static int check_moving(const cupola_gl *gl, enum cupola_table stage, struct cupola_error *error)
{
    if (gl->features.float_targets)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_GL,
                     "table stage %s depends on the eye, which the plan lets move by %g m, and "
                     "this GL cannot draw it anew: it draws into no floats; allowed: points, none, "
                     "tiles",
                     cupola_table_name((int)stage), gl->plan.head_radius_m);
}

GLuint table_create(const cupola_gl *gl, int output, enum cupola_table stage,
                    struct table_pass *redraw, struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    const char *name = cupola_table_name((int)stage);
    bool moving = depends_on_eye(stage) && gl->plan.head_radius_m > 0;
    if (moving && check_moving(gl, stage, error) != CUPOLA_OK)
        return 0;
    bool grouped = guest_group_open(&gl->guest, "table %s of output %d", name, output);
    if (!gl->features.float_targets)
        guest_tell(&gl->guest, CUPOLA_LOG_WARNING, CUPOLA_LOG_TABLE_ON_CPU,
                   "table %s of output %d is computed on the CPU: this GL cannot draw into floats",
                   name, output);
    GLuint table = gl->features.float_targets
                       ? table_draw(gl, output, stage, moving ? redraw : NULL, error)
                       : table_upload(gl, output, stage, error);
    if (table)
        guest_name(&gl->guest, GL_TEXTURE, table, "table %s of output %d, %d x %d px", name, output,
                   size->width_px, size->height_px);
    guest_group_close(&gl->guest, grouped);
    return table;
}

static int points(cupola_gl *gl, int output, unsigned int *texture, struct cupola_error *error)
{
    int status = output_check(gl, output, error);
    if (status != CUPOLA_OK)
        return status;
    if (!texture)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "texture is NULL");
    struct warp_pass *pass = &gl->passes[output];
    if (!pass->points) {
        struct guest_work work;
        guest_errors_drop(&gl->guest);
        guest_begin_making(&gl->guest, &work, "points of output %d", output);
        pass->points = table_create(gl, output, CUPOLA_TABLE_POINTS, NULL, error);
        if (!pass->points)
            gl_errors_drop();
        guest_end(&gl->guest, &work);
        if (!pass->points)
            return error->status;
    }
    *texture = pass->points;
    return CUPOLA_OK;
}

int cupola_gl_points(cupola_gl *gl, int output, unsigned int *texture, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, points(gl, output, texture, error), error);
}
