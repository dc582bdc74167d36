/* See light_sum.h. */
#include "light_sum.h"

#include <stdio.h>

#include "error.h"
#include "gl_objects.h"
#include "program.h"
#include "shaders.h"

int light_sum_create(const struct guest *guest, struct light_sum *sum, struct cupola_error *error)
{
    static const struct shader_file files[] = {{"light.glsl", shader_light_glsl},
                                               {"encode.frag", shader_encode_frag}};
    char lines[WARP_LINES_MAX];
    light_lines(CUPOLA_ENCODING_SRGB, false, false, false, lines);
    sum->program = program_create(lines, files, 2, error);
    if (!sum->program)
        return error->status;
    guest_name(guest, GL_PROGRAM, sum->program, "theatre's encoding");
    sum->target_corner = glGetUniformLocation(sum->program, "target_corner");
    glUseProgram(sum->program);
    glUniform1i(glGetUniformLocation(sum->program, "sum"), 0);
    return CUPOLA_OK;
}

static void destroy_texture(struct light_sum *sum)
{
    glDeleteFramebuffers(1, &sum->framebuffer);
    glDeleteTextures(1, &sum->texture);
    sum->framebuffer = sum->texture = 0;
}

void light_sum_destroy(struct light_sum *sum)
{
    destroy_texture(sum);
    glDeleteProgram(sum->program);
    sum->program = 0;
}

static int create_texture(const struct guest *guest, struct light_sum *sum, int width, int height,
                          struct cupola_error *error)
{
    GLenum format = guest->features->half_float_targets ? GL_RGBA16F : GL_SRGB8_ALPHA8;
    destroy_texture(sum);
    sum->texture = texture_create(format, width, height, GL_NEAREST, error);
    if (!sum->texture)
        return error->status;
    guest_name(guest, GL_TEXTURE, sum->texture, "theatre's light, %d x %d px", width, height);
    sum->framebuffer = framebuffer_create(sum->texture, "the theatre's light", error);
    if (!sum->framebuffer) {
        destroy_texture(sum);
        return error->status;
    }
    sum->width = width;
    sum->height = height;
    return CUPOLA_OK;
}

int light_sum_begin(const struct guest *guest, struct light_sum *sum, int width, int height,
                    struct cupola_error *error)
{
    if (!sum->texture || sum->width != width || sum->height != height) {
        int status = create_texture(guest, sum, width, height, error);
        if (status != CUPOLA_OK)
            return status;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, sum->framebuffer);
    host_set_encoding(guest->features, true);
    return CUPOLA_OK;
}

void light_sum_end(const struct guest *guest, const struct light_sum *sum, GLuint vertex_array,
                   struct cupola_target place)
{
    glBindFramebuffer(GL_FRAMEBUFFER, place.framebuffer);
    host_set_encoding(guest->features, false);
    host_set_adding(guest->features, false);
    host_set_area(guest->features, place.x, place.y, sum->width, sum->height);
    glUseProgram(sum->program);
    glUniform2f(sum->target_corner, (GLfloat)place.x, (GLfloat)place.y);
    glBindTexture(GL_TEXTURE_2D, sum->texture);
    draw_fullscreen(vertex_array);
}
