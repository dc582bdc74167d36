/* Existing pictures in the warp: one program for each kind that was asked for. */
#include <stdio.h>
#include <string.h>

#include "error.h"
#include "gl_objects.h"
#include "instance.h"
#include "program.h"
#include "sampled.h"
#include "shaders.h"

enum { SOURCE_LINES_MAX = 160 };

GLuint source_program_create(const cupola_gl *gl, int output, int kind, const char *lines,
                             struct cupola_error *error)
{
    const struct shader_file files[] = {
        {"varying.glsl", shader_varying_glsl}, {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},   {"source.glsl", shader_source_glsl},
        {"light.glsl", shader_light_glsl},     {"jitter.glsl", shader_jitter_glsl},
        {"places", gl->filter_places},         {"filter.glsl", shader_filter_glsl},
        {"source.frag", shader_source_frag},
    };
    char defines[PROGRAM_DEFINES_MAX + WARP_LINES_MAX + SOURCE_LINES_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, CUPOLA_TABLE_NONE, defines);
    strcat(defines, lines);
    size_t length = strlen(defines);
    snprintf(defines + length, sizeof defines - length,
             "#define SOURCE_DOMEMASTER %d\n#define SOURCE_EQUIRECTANGULAR %d\n"
             "#define SOURCE_CUBE %d\n#define SOURCE %d\n#define RIM 1\n",
             CUPOLA_SOURCE_DOMEMASTER, CUPOLA_SOURCE_EQUIRECTANGULAR, CUPOLA_SOURCE_CUBE, kind);
    GLuint program = program_create(defines, files, 9, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    glUniform1i(glGetUniformLocation(program, "picture"), UNIT_IMAGE);
    return program;
}

static int check_texture(const struct guest *guest, const struct cupola_source *source,
                         struct cupola_error *error)
{
    bool cube = source->kind == CUPOLA_SOURCE_CUBE;
    GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    if (texture_found(guest, target, source->texture)) {
        int status = sampled_check_in_frame(guest, target, source->texture, source->mipmaps, error);
        if (status != CUPOLA_OK)
            error_context(error, "source");
        return status;
    }
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
    return source->kind == CUPOLA_SOURCE_VIEWS ? CUPOLA_OK
                                               : check_texture(&gl->guest, source, error);
}

/*
 * The picture's filter: not the one that its texture happens to have. Not anisotropic: with that,
 * llvmpipe (Mesa 22.3) passes over the gradients of textureGrad and takes differences of places
 * between neighbouring pixels instead, which jump behind the viewer and come to nothing beyond the
 * rim; there it was seen to fetch places half a picture away. docs/geometry.md says what is lost.
 * What never differs stands since sampler_create.
 */
void picture_sampler_bind(const cupola_gl *gl, bool mipmaps, bool round_about, bool nearest)
{
    GLint one = nearest ? GL_NEAREST : GL_LINEAR;
    GLint levels = nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR;
    glSamplerParameteri(gl->sampler, GL_TEXTURE_MIN_FILTER, mipmaps ? levels : one);
    glSamplerParameteri(gl->sampler, GL_TEXTURE_MAG_FILTER, one);
    glSamplerParameteri(gl->sampler, GL_TEXTURE_WRAP_S, round_about ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    glBindSampler(UNIT_IMAGE, gl->sampler);
}

static void set_frame(const struct warp_program *program, const struct source_frame *frame)
{
    GLfloat rotation[9], center[3];
    for (int i = 0; i < 9; i++)
        rotation[i] = (GLfloat)frame->rotation[i];
    for (int i = 0; i < 3; i++)
        center[i] = (GLfloat)frame->center_m[i];
    glUniformMatrix3fv(program->rotation, 1, GL_TRUE, rotation);
    glUniform3fv(program->center, 1, center);
    glUniform1f(program->half_fov, (GLfloat)frame->half_fov);
}

void source_bind(const cupola_gl *gl, const struct warp_program *program,
                 const struct cupola_source *source)
{
    struct source_frame frame;
    source_frame_prepare(&gl->plan.dome, source, &frame);
    glBindTexture(source->kind == CUPOLA_SOURCE_CUBE ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D,
                  source->texture);
    picture_sampler_bind(gl, source->mipmaps, source->kind == CUPOLA_SOURCE_EQUIRECTANGULAR,
                         gl->params.filter.method == CUPOLA_ANTIALIASING_NONE);
    glUniform1i(program->mipmaps, source->mipmaps);
    set_frame(program, &frame);
}
