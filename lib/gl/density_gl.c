/* The density map of an output: drawn by the GL, computed by the C functions where it cannot. */
#include <stdlib.h>

#include "cupola/resolution.h"
#include "error.h"
#include "gl_objects.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"

static GLuint program_make(const cupola_gl *gl, int output, struct cupola_error *error)
{
    static const struct shader_file files[] = {
        {"varying.glsl", shader_varying_glsl},
        {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},
        {"density.frag", shader_density_frag},
    };
    char defines[PROGRAM_DEFINES_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, CUPOLA_TABLE_NONE, defines);
    GLuint program = program_create(defines, files, 4, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    return program;
}

/* With the program in use and the framebuffer bound. */
static void draw_entries(const cupola_gl *gl, int output)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    host_set_area(&gl->features, 0, 0, size->width_px, size->height_px);
    draw_fullscreen(gl->vertex_array);
}

/* Draws the map into a texture; what does that is kept where the eye may move. */
static int draw(const cupola_gl *gl, int output, GLuint texture, struct table_pass *redraw,
                struct cupola_error *error)
{
    GLuint program = program_make(gl, output, error);
    GLuint framebuffer =
        program ? framebuffer_create(texture, "a density map of floats", error) : 0;
    if (framebuffer)
        draw_entries(gl, output);
    if (framebuffer && gl->plan.head_radius_m > 0) {
        guest_name(&gl->guest, GL_PROGRAM, program, "density of output %d for an eye that moves",
                   output);
        guest_name(&gl->guest, GL_FRAMEBUFFER, framebuffer, "density of output %d", output);
        *redraw =
            (struct table_pass){program, framebuffer, glGetUniformLocation(program, "eye"), -1};
        return CUPOLA_OK;
    }
    glDeleteFramebuffers(1, &framebuffer);
    glUseProgram(0);
    glDeleteProgram(program);
    return framebuffer ? CUPOLA_OK : (int)error->status;
}

/* With the texture bound. */
static int upload(const cupola_gl *gl, int output, struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    float *map = malloc((size_t)size->width_px * (size_t)size->height_px * sizeof *map);
    if (!map)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a density map of %d x %d px",
                         size->width_px, size->height_px);
    int status = cupola_density_map(&gl->plan.dome, output, NULL, map, error);
    if (status == CUPOLA_OK)
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size->width_px, size->height_px, GL_RED, GL_FLOAT,
                        map);
    free(map);
    return status;
}

static int make(const cupola_gl *gl, int output, struct density_pass *pass,
                struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    GLuint texture = texture_create(GL_R32F, size->width_px, size->height_px, GL_NEAREST, error);
    if (!texture)
        return (int)error->status;
    guest_name(&gl->guest, GL_TEXTURE, texture, "density of output %d, %d x %d px", output,
               size->width_px, size->height_px);
    if (!gl->features.float_targets)
        guest_tell(&gl->guest, CUPOLA_LOG_WARNING, CUPOLA_LOG_TABLE_ON_CPU,
                   "the density map of output %d is computed on the CPU: this GL cannot draw into "
                   "floats",
                   output);
    int status = gl->features.float_targets ? draw(gl, output, texture, &pass->redraw, error)
                                            : upload(gl, output, error);
    if (status == CUPOLA_OK)
        pass->texture = texture;
    else
        glDeleteTextures(1, &texture);
    return status;
}

/* For the eye as it is now. */
static int follow(const cupola_gl *gl, int output, const struct density_pass *pass,
                  struct cupola_error *error)
{
    if (!pass->redraw.program) {
        glBindTexture(GL_TEXTURE_2D, pass->texture);
        return upload(gl, output, error);
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, pass->redraw.framebuffer);
    glUseProgram(pass->redraw.program);
    program_place_eye(pass->redraw.eye, &gl->plan.dome);
    draw_entries(gl, output);
    return CUPOLA_OK;
}

static int density(cupola_gl *gl, int output, unsigned int *texture, struct cupola_error *error)
{
    int status = output_check(gl, output, error);
    if (status != CUPOLA_OK)
        return status;
    if (!texture)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "texture is NULL");
    struct density_pass *pass = &gl->passes[output].density;
    struct guest_work work;
    if (!pass->texture || pass->moves != gl->moves) {
        guest_errors_drop(&gl->guest);
        guest_begin_making(&gl->guest, &work, "density of output %d", output);
        status = pass->texture ? follow(gl, output, pass, error) : make(gl, output, pass, error);
        if (status != CUPOLA_OK)
            gl_errors_drop();
        guest_end(&gl->guest, &work);
    }
    if (status != CUPOLA_OK)
        return status;
    pass->moves = gl->moves;
    *texture = pass->texture;
    return CUPOLA_OK;
}

int cupola_gl_density(cupola_gl *gl, int output, unsigned int *texture, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, density(gl, output, texture, error), error);
}

void density_pass_destroy(struct density_pass *pass)
{
    table_pass_destroy(&pass->redraw);
    glDeleteTextures(1, &pass->texture);
    *pass = (struct density_pass){0};
}
