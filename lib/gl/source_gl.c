/* Existing pictures in the warp: one program for each kind that was asked for. */
#include <stdio.h>
#include <string.h>

#include "error.h"
#include "host_cube.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"

enum { SOURCE_DEFINES_MAX = PROGRAM_DEFINES_MAX + 160 };

static GLuint source_program_create(const cupola_gl *gl, int output, int kind,
                                    struct cupola_error *error)
{
    static const struct shader_file files[] = {
        {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},
        {"source.glsl", shader_source_glsl},
        {"source.frag", shader_source_frag},
    };
    char defines[SOURCE_DEFINES_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, CUPOLA_TABLE_NONE, defines);
    size_t length = strlen(defines);
    snprintf(defines + length, sizeof defines - length,
             "#define SOURCE_DOMEMASTER %d\n#define SOURCE_EQUIRECTANGULAR %d\n"
             "#define SOURCE_CUBE %d\n#define SOURCE %d\n",
             CUPOLA_SOURCE_DOMEMASTER, CUPOLA_SOURCE_EQUIRECTANGULAR, CUPOLA_SOURCE_CUBE, kind);
    GLuint program = program_create(defines, files, 4, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    glUniform4fv(glGetUniformLocation(program, "border"), 1, gl->params.border);
    glUniform1i(glGetUniformLocation(program, "picture"), 0);
    return program;
}

int source_programs_create(cupola_gl *gl, int output, struct cupola_error *error)
{
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind < SOURCE_KINDS; kind++) {
        struct source_program *made = &gl->passes[output].sources[kind];
        if (!shows_source(gl, (enum cupola_source_kind)kind))
            continue;
        made->program = source_program_create(gl, output, kind, error);
        if (!made->program)
            return error->status;
        made->target_corner = glGetUniformLocation(made->program, "target_corner");
        made->rotation = glGetUniformLocation(made->program, "source_rotation");
        made->center = glGetUniformLocation(made->program, "source_center");
        made->half_fov = glGetUniformLocation(made->program, "source_half_fov");
        made->mipmaps = glGetUniformLocation(made->program, "source_mipmaps");
    }
    return CUPOLA_OK;
}

bool texture_bind(GLenum target, GLuint name)
{
    GLint bound = 0;
    if (!name || !glIsTexture(name))
        return false;
    glBindTexture(target, name);
    glGetIntegerv(target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_CUBE_MAP,
                  &bound);
    if ((GLuint)bound == name)
        return true;
    glGetError(); /* of that binding */
    return false;
}

static int check_texture(const struct cupola_source *source, struct cupola_error *error)
{
    bool cube = source->kind == CUPOLA_SOURCE_CUBE, found;
    struct host_cube host;
    if (cube)
        host_cube_save(&host);
    found = texture_bind(cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D, source->texture);
    if (cube)
        host_cube_restore(&host);
    if (found)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "source's texture is %u; allowed for kind %s: the name of a %s",
                     source->texture, cupola_source_name((int)source->kind),
                     cube ? "GL_TEXTURE_CUBE_MAP" : "GL_TEXTURE_2D");
}

int source_check_gl(const cupola_gl *gl, const struct cupola_source *source,
                    struct cupola_error *error)
{
    int status = source_check(source, error);
    if (status != CUPOLA_OK)
        return status;
    if (!shows_source(gl, source->kind))
        return error_set(
            error, CUPOLA_ERROR_ARGUMENT, "source is of kind %s (%d); gl was made for sources 0x%x",
            cupola_source_name((int)source->kind), (int)source->kind, gl->params.sources);
    return source->kind == CUPOLA_SOURCE_VIEWS ? CUPOLA_OK : check_texture(source, error);
}

/*
 * The picture's filter: not the one that its texture happens to have. Not anisotropic: a pixel's
 * footprint is long only near the rims of some lenses, and llvmpipe was seen to fetch places half a
 * picture away where footprints lie askew.
 */
static void set_sampler(GLuint sampler, const struct cupola_source *source)
{
    bool round_about = source->kind == CUPOLA_SOURCE_EQUIRECTANGULAR;
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER,
                        source->mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, round_about ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindSampler(0, sampler);
}

static void set_frame(const struct source_program *shown, const struct source_frame *frame)
{
    GLfloat rotation[9], center[3];
    for (int i = 0; i < 9; i++)
        rotation[i] = (GLfloat)frame->rotation[i];
    for (int i = 0; i < 3; i++)
        center[i] = (GLfloat)frame->center_m[i];
    glUniformMatrix3fv(shown->rotation, 1, GL_TRUE, rotation);
    glUniform3fv(shown->center, 1, center);
    glUniform1f(shown->half_fov, (GLfloat)frame->half_fov);
}

void source_draw(const cupola_gl *gl, int output, const struct cupola_source *source,
                 const struct cupola_target *place)
{
    const struct source_program *shown = &gl->passes[output].sources[source->kind];
    bool cube = source->kind == CUPOLA_SOURCE_CUBE;
    struct source_frame frame;
    struct host_cube host;
    source_frame_prepare(&gl->plan.dome, source, &frame);
    glActiveTexture(GL_TEXTURE0);
    if (cube)
        host_cube_save(&host);
    glBindTexture(cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D, source->texture);
    set_sampler(gl->sampler, source);
    glUseProgram(shown->program);
    glUniform2f(shown->target_corner, (GLfloat)place->x, (GLfloat)place->y);
    glUniform1i(shown->mipmaps, source->mipmaps);
    set_frame(shown, &frame);
    draw_fullscreen(gl->vertex_array);
    if (cube)
        host_cube_restore(&host);
}
