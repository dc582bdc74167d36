/* Overlays over an output's image. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "error.h"
#include "geometry/overlay.h"
#include "gl_objects.h"
#include "instance.h"
#include "program.h"
#include "sampled.h"
#include "shaders.h"
#include "target_color.h"
#include "target_gl.h"

enum { OVERLAY_LINES_MAX = 120, SAMPLED_AT_ONCE = 32 };

static const double half_max = 3.7320508075688773; /* the tangent of 75 degrees */

/*
 * As uniforms, as all that is no integer: printed into the shader it would have the decimal comma
 * of some hosts' locales.
 */
static void set_measures(GLuint program)
{
    const double ring_inner = OVERLAY_RING_INNER, dot_radius = OVERLAY_DOT_RADIUS;
    program_set_vector(program, "ring_inner", &ring_inner, 1);
    program_set_vector(program, "dot_radius", &dot_radius, 1);
    program_set_vector(program, "half_max", &half_max, 1);
}

int overlay_program_create(const cupola_gl *gl, int output, bool gained,
                           struct overlay_program *made, struct cupola_error *error)
{
    static const struct shader_file files[] = {
        {"varying.glsl", shader_varying_glsl}, {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},   {"overlay.glsl", shader_overlay_glsl},
        {"light.glsl", shader_light_glsl},     {"overlay.frag", shader_overlay_frag},
    };
    char defines[PROGRAM_DEFINES_MAX + WARP_LINES_MAX + OVERLAY_LINES_MAX];
    if (!gl->params.overlays)
        return CUPOLA_OK;
    program_defines(&gl->plan.dome, output, gl->plan.view_count, CUPOLA_TABLE_NONE, defines);
    light_lines(gl->params.encoding, true, gained, false, defines + strlen(defines));
    snprintf(defines + strlen(defines), OVERLAY_LINES_MAX,
             "#define KIND_PICTURE %d\n#define KIND_CURSOR %d\n#define KIND_DISC %d\n"
             "#define PARTS %d\n",
             CUPOLA_OVERLAY_PICTURE, CUPOLA_OVERLAY_CURSOR, CUPOLA_OVERLAY_DISC, OVERLAY_PARTS);
    GLuint program = program_create(defines, files, 6, error);
    if (!program)
        return error->status;
    guest_name(&gl->guest, GL_PROGRAM, program, "overlays of output %d%s", output,
               gained ? ", with gain" : "");
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    set_measures(program);
    glUniform1i(glGetUniformLocation(program, "picture"), UNIT_IMAGE);
    glUniform1i(glGetUniformLocation(program, "gain"), gain_unit(gl));
    *made = (struct overlay_program){
        .program = program,
        .target_corner = glGetUniformLocation(program, "target_corner"),
        .encoded = glGetUniformLocation(program, "encoded"),
        .kind = glGetUniformLocation(program, "overlay_kind"),
        .axes = glGetUniformLocation(program, "overlay_axes"),
        .half = glGetUniformLocation(program, "overlay_half"),
        .color = glGetUniformLocation(program, "overlay_color"),
        .eye = glGetUniformLocation(program, "eye"),
    };
    return CUPOLA_OK;
}

void overlay_program_destroy(struct overlay_program *program)
{
    glDeleteProgram(program->program);
    *program = (struct overlay_program){0};
}

static int check_arguments(const cupola_gl *gl, const struct cupola_overlay *overlays, int count,
                           struct cupola_error *error)
{
    if (!gl->params.overlays)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made without overlays; allowed: one of which params.overlays was "
                         "true");
    if (count < 0)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "count of overlays is %d; allowed: 0 or "
                         "more",
                         count);
    if (count > 0 && !overlays)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "overlays is NULL");
    for (int i = 0; i < count; i++) {
        int status = overlay_check(&overlays[i], error);
        if (status != CUPOLA_OK) {
            error_context(error, "overlay %d", i);
            return status;
        }
    }
    return CUPOLA_OK;
}

/* The name of the texture that an overlay samples; 0 for none. */
static GLuint texture_of(const struct cupola_overlay *overlay)
{
    return overlay->kind == CUPOLA_OVERLAY_PICTURE ? overlay->texture : 0;
}

static int check_textures(const cupola_gl *gl, const struct cupola_overlay *overlays, int count,
                          struct cupola_error *error)
{
    for (int i = 0; i < count; i++) {
        GLint size[3];
        if (overlays[i].kind != CUPOLA_OVERLAY_PICTURE)
            continue;
        if (!texture_found(&gl->guest, GL_TEXTURE_2D, overlays[i].texture))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "overlay %d: texture is %u; allowed: the name of a GL_TEXTURE_2D", i,
                             overlays[i].texture);
        int status = sampled_check_in_frame(&gl->guest, GL_TEXTURE_2D, overlays[i].texture,
                                            overlays[i].mipmaps, error);
        if (status == CUPOLA_OK && !gl->guest.leaves_state &&
            texture_size(&gl->features, GL_TEXTURE_2D, size))
            status = overlay_check_height(&overlays[i], size[0], size[1], error);
        if (status != CUPOLA_OK) {
            error_context(error, "overlay %d", i);
            return status;
        }
    }
    return CUPOLA_OK;
}

/* No more than some textures at once: a count of overlays has no limit, and memory is not asked. */
static int check_sampled(GLuint framebuffer, const struct cupola_overlay *overlays, int count,
                         struct cupola_error *error)
{
    GLuint sampled[SAMPLED_AT_ONCE];
    int status = CUPOLA_OK;
    for (int first = 0; status == CUPOLA_OK && first < count; first += SAMPLED_AT_ONCE) {
        int together = count - first < SAMPLED_AT_ONCE ? count - first : SAMPLED_AT_ONCE;
        for (int i = 0; i < together; i++)
            sampled[i] = texture_of(&overlays[first + i]);
        status = target_check_sampled(framebuffer, sampled, together, error);
    }
    return status;
}

static int check_blending(const cupola_gl *gl, GLuint framebuffer, struct cupola_error *error)
{
    if (gl->features.float_blend || !target_is_float32(&gl->features))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_GL,
                     "overlays over a target of 32 bit floats (framebuffer %u) need "
                     "GL_EXT_float_blend, which this OpenGL ES lacks; allowed: RGBA8 or RGBA16F",
                     framebuffer);
}

/* With the host's state saved. */
static int prepare_target(const cupola_gl *gl, int output, const struct cupola_overlay *overlays,
                          int count, const struct cupola_target *place, struct cupola_error *error)
{
    const GLuint framebuffer = place->framebuffer;
    const GLuint gain = gl->passes[output].gain;
    int status = check_textures(gl, overlays, count, error);
    if (status == CUPOLA_OK && gain)
        status = gain_check(gl, output, error);
    if (status == CUPOLA_OK)
        status = target_bind(&gl->guest, place, error);
    if (status != CUPOLA_OK || gl->guest.leaves_state)
        return status; /* what is attached to the target would have to be asked for */
    status = target_check_color(framebuffer, error);
    if (status == CUPOLA_OK)
        status = check_sampled(framebuffer, overlays, count, error);
    if (status == CUPOLA_OK)
        status = target_check_sampled(framebuffer, &gain, 1, error);
    if (status == CUPOLA_OK)
        status = target_check_encoding(&gl->features, framebuffer, gl->params.encoding, error);
    if (status == CUPOLA_OK)
        status = check_blending(gl, framebuffer, error);
    return status;
}

/* Its own filter and wrap parameters do not count. Returns width by height; 0: not known. */
static double bind_picture(const cupola_gl *gl, const struct cupola_overlay *overlay)
{
    GLint size[3];
    glActiveTexture(GL_TEXTURE0 + UNIT_IMAGE);
    glBindTexture(GL_TEXTURE_2D, overlay->texture);
    picture_sampler_bind(gl, overlay->mipmaps, false, false);
    if (gl->guest.leaves_state)
        return 0; /* the shader can tell */
    return texture_size(&gl->features, GL_TEXTURE_2D, size) ? (double)size[0] / size[1] : 0;
}

static void draw_overlay(const cupola_gl *gl, int output, const struct overlay_program *program,
                         const struct cupola_overlay *overlay, const struct cupola_target *place)
{
    bool picture = overlay->kind == CUPOLA_OVERLAY_PICTURE;
    double aspect = picture ? bind_picture(gl, overlay) : 0;
    bool height_unknown = picture && overlay->height_rad == 0 && aspect == 0;
    struct overlay_frame frame;
    overlay_frame_prepare(overlay, aspect, &frame);
    struct overlay_area area = overlay_area_find(&gl->plan.dome, output, &frame);
    if (area.width == 0)
        return;
    GLfloat axes[9], color[4];
    for (int i = 0; i < 9; i++)
        axes[i] = (GLfloat)frame.axes[i];
    overlay_color(overlay, color);
    glUniform1i(program->kind, (GLint)overlay->kind);
    glUniformMatrix3fv(program->axes, 1, GL_TRUE, axes);
    glUniform2f(program->half, (GLfloat)frame.half[0],
                height_unknown ? 0.0f : (GLfloat)frame.half[1]);
    glUniform4fv(program->color, 1, color);
    host_set_area(&gl->features, place->x + area.x, place->y + area.y, area.width, area.height);
    draw_fullscreen(gl->vertex_array);
}

static void draw_all(const cupola_gl *gl, int output, const struct cupola_overlay *overlays,
                     int count, const struct cupola_target *place)
{
    const struct warp_pass *pass = &gl->passes[output];
    const struct overlay_program *program = &pass->overlays[pass->gain != 0];
    bool linear = gl->params.encoding == CUPOLA_ENCODING_SRGB && target_is_srgb(&gl->features);
    host_set_over(&gl->features, linear);
    glUseProgram(program->program);
    glUniform2f(program->target_corner, (GLfloat)place->x, (GLfloat)place->y);
    program_place_eye(program->eye, &gl->plan.dome);
    if (program->encoded >= 0)
        glUniform1i(program->encoded, !linear);
    if (pass->gain)
        gain_bind(gl, output);
    for (int i = 0; i < count; i++)
        draw_overlay(gl, output, program, &overlays[i], place);
}

static int overlay(cupola_gl *gl, int output, const struct cupola_overlay *overlays, int count,
                   const struct cupola_target *target, struct cupola_error *error)
{
    int status = output_check(gl, output, error);
    if (status == CUPOLA_OK)
        status = check_arguments(gl, overlays, count, error);
    if (status != CUPOLA_OK)
        return status;
    struct cupola_target place = target ? *target : (struct cupola_target){0};
    struct guest_work work;
    guest_begin(&gl->guest, &work, "overlays of output %d", output);
    status = prepare_target(gl, output, overlays, count, &place, error);
    if (status == CUPOLA_OK)
        draw_all(gl, output, overlays, count, &place);
    guest_end(&gl->guest, &work);
    return status;
}

int cupola_gl_overlay(cupola_gl *gl, int output, const struct cupola_overlay *overlays, int count,
                      const struct cupola_target *target, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, overlay(gl, output, overlays, count, target, error), error);
}
