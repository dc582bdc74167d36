/* Tables and the warp itself. */
#include "error.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"

/* Draws a stage's table of one output into a new texture. 0 on failure. */
static GLuint table_create(const cupola_gl *gl, int output, enum cupola_table stage,
                           struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    static const struct shader_file files[] = {
        {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},
        {"views.glsl", shader_views_glsl},
        {"table.frag", shader_table_frag},
    };
    if (!gl->features.float_targets)
        return table_upload(gl, output, stage, error);
    char defines[PROGRAM_DEFINES_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, (int)stage, defines);
    GLuint program = program_create(defines, files, 4, error);
    if (!program)
        return 0;
    GLuint table = texture_create(GL_RGBA32F, size->width_px, size->height_px, GL_NEAREST, error);
    GLuint framebuffer = table ? framebuffer_create(table) : 0;
    if (framebuffer) {
        host_set_area(&gl->features, 0, 0, size->width_px, size->height_px);
        glUseProgram(program);
        program_set_projector(program, &gl->plan.dome, output);
        program_set_views(program, &gl->plan);
        draw_fullscreen(gl->vertex_array);
        glDeleteFramebuffers(1, &framebuffer);
    } else if (table) {
        error_set(error, CUPOLA_ERROR_GL, "the GL cannot draw into a table of %d x %d px",
                  size->width_px, size->height_px);
        glDeleteTextures(1, &table);
        table = 0;
    }
    glUseProgram(0);
    glDeleteProgram(program);
    return table;
}

static GLuint warp_program_create(const cupola_gl *gl, int output, struct cupola_error *error)
{
    static const struct shader_file files[] = {
        {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},
        {"views.glsl", shader_views_glsl},
        {"warp.frag", shader_warp_frag},
    };
    char defines[PROGRAM_DEFINES_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, (int)gl->params.table, defines);
    GLuint program = program_create(defines, files, 4, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    program_set_views(program, &gl->plan);
    glUniform4fv(glGetUniformLocation(program, "border"), 1, gl->params.border);
    glUniform1i(glGetUniformLocation(program, "atlas"), 0);
    glUniform1i(glGetUniformLocation(program, "table"), 1);
    return program;
}

int warp_pass_create(cupola_gl *gl, int output, struct cupola_error *error)
{
    struct warp_pass *pass = &gl->passes[output];
    int status = source_programs_create(gl, output, error);
    if (status != CUPOLA_OK || !shows_source(gl, CUPOLA_SOURCE_VIEWS))
        return status;
    if (gl->params.table != CUPOLA_TABLE_NONE) {
        pass->table = table_create(gl, output, gl->params.table, error);
        if (!pass->table)
            return error->status;
    }
    if (gl->params.table == CUPOLA_TABLE_POINTS)
        pass->points = pass->table;
    pass->program = warp_program_create(gl, output, error);
    if (!pass->program)
        return error->status;
    pass->target_corner = glGetUniformLocation(pass->program, "target_corner");
    return CUPOLA_OK;
}

void warp_pass_destroy(struct warp_pass *pass)
{
    glDeleteProgram(pass->program);
    for (int kind = 0; kind < SOURCE_KINDS; kind++)
        glDeleteProgram(pass->sources[kind].program);
    glDeleteTextures(1, &pass->table);
    if (pass->points != pass->table)
        glDeleteTextures(1, &pass->points);
    *pass = (struct warp_pass){0};
}

static int check_output(const cupola_gl *gl, int output, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (gl->view_open)
        return error_set(error, CUPOLA_ERROR_ORDER, "a view is open; end it first");
    if (output < 0 || output >= gl->plan.dome.rig.output_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "output is %d; allowed: 0 to %d", output,
                         gl->plan.dome.rig.output_count - 1);
    return context_check(error);
}

static void views_draw(const cupola_gl *gl, int output, const struct cupola_target *place)
{
    const struct warp_pass *pass = &gl->passes[output];
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, pass->table);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, gl->atlas);
    glUseProgram(pass->program);
    glUniform2f(pass->target_corner, (GLfloat)place->x, (GLfloat)place->y);
    draw_fullscreen(gl->vertex_array);
}

int cupola_gl_warp(cupola_gl *gl, int output, const struct cupola_source *source,
                   const struct cupola_target *target, struct cupola_error *error)
{
    int status = check_output(gl, output, error);
    if (status != CUPOLA_OK)
        return status;
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    struct cupola_target place = target ? *target : (struct cupola_target){0};
    struct cupola_source shown = source ? *source : (struct cupola_source){.texture = 0};
    bool views = shown.kind == CUPOLA_SOURCE_VIEWS;
    const GLuint sampled[2] = {views ? gl->atlas : shown.texture,
                               views ? gl->passes[output].table : 0};
    struct host_state state;
    host_state_save(&state, &gl->features);
    status = source_check_gl(gl, &shown, error);
    if (status == CUPOLA_OK)
        status = target_bind(place.framebuffer, error);
    if (status == CUPOLA_OK)
        status = target_check_sampled(place.framebuffer, sampled, 2, error);
    if (status == CUPOLA_OK) {
        host_set_area(&gl->features, place.x, place.y, size->width_px, size->height_px);
        if (views)
            views_draw(gl, output, &place);
        else
            source_draw(gl, output, &shown, &place);
    }
    host_state_restore(&state);
    return status;
}

int cupola_gl_points(cupola_gl *gl, int output, unsigned int *texture, struct cupola_error *error)
{
    struct cupola_error unwanted;
    if (!error)
        error = &unwanted;
    int status = check_output(gl, output, error);
    if (status != CUPOLA_OK)
        return status;
    if (!texture)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "texture is NULL");
    struct warp_pass *pass = &gl->passes[output];
    if (!pass->points) {
        struct host_state state;
        host_state_save(&state, &gl->features);
        pass->points = table_create(gl, output, CUPOLA_TABLE_POINTS, error);
        host_state_restore(&state);
        if (!pass->points)
            return error->status;
    }
    *texture = pass->points;
    return CUPOLA_OK;
}
