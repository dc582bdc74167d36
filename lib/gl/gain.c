/* What each pixel of an output is multiplied by. */
#include <string.h>

#include "error.h"
#include "gl_objects.h"
#include "instance.h"
#include "sampled.h"

GLint gain_unit(const cupola_gl *gl)
{
    return gl->params.storage == CUPOLA_STORAGE_TEXTURES ? UNIT_TABLE + gl->plan.view_count
                                                         : UNIT_TABLE + 1;
}

static int refuse_texture(int output, GLuint texture, struct cupola_error *error)
{
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "gain of output %d is texture %u; allowed: the name of a GL_TEXTURE_2D, or 0 "
                     "for none",
                     output, texture);
}

/* Of the texture that is bound: size and format. OpenGL ES 3.0 cannot be asked. */
static int check_bound(const cupola_gl *gl, int output, GLuint texture, struct cupola_error *error)
{
    const struct cupola_output *wish = &gl->plan.dome.rig.outputs[output];
    GLint size[3];
    int status = sampled_check(&gl->features, GL_TEXTURE_2D, texture, false, error);
    if (status != CUPOLA_OK) {
        error_context(error, "gain of output %d", output);
        return status;
    }
    if (!texture_size(&gl->features, GL_TEXTURE_2D, size) ||
        (size[0] == wish->width_px && size[1] == wish->height_px))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "gain of output %d is texture %u of %d x %d texels; allowed: %d x %d, the "
                     "output's size",
                     output, texture, size[0], size[1], wish->width_px, wish->height_px);
}

/* With the host's state saved. */
static int prepare(cupola_gl *gl, int output, GLuint texture, struct cupola_error *error)
{
    struct warp_pass *pass = &gl->passes[output];
    struct warp_program made[WARP_PROGRAMS] = {{0}};
    if (!texture_bind(GL_TEXTURE_2D, texture))
        return refuse_texture(output, texture, error);
    int status = check_bound(gl, output, texture, error);
    if (status != CUPOLA_OK || pass->gained)
        return status;
    status = warp_programs_create(gl, output, true, made, error);
    if (status != CUPOLA_OK)
        return status;
    status = overlay_program_create(gl, output, true, &pass->overlays[true], error);
    if (status != CUPOLA_OK) {
        warp_programs_destroy(made);
        return status;
    }
    if (!gl->gain_sampler) { /* texels are fetched one by one, from formats without a filter, too */
        gl->gain_sampler = sampler_create(&gl->guest, "gain", error);
        if (!gl->gain_sampler) {
            warp_programs_destroy(made);
            overlay_program_destroy(&pass->overlays[true]);
            return error->status;
        }
        glSamplerParameteri(gl->gain_sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glSamplerParameteri(gl->gain_sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    memcpy(pass->programs[true], made, sizeof made);
    pass->gained = true;
    return CUPOLA_OK;
}

static int set_gain(cupola_gl *gl, int output, unsigned int texture, struct cupola_error *error)
{
    int status = output_check(gl, output, error);
    if (status != CUPOLA_OK)
        return status;
    if (texture) {
        struct guest_work work;
        guest_begin_making(&gl->guest, &work, "gain of output %d", output);
        status = prepare(gl, output, texture, error);
        guest_end(&gl->guest, &work);
    }
    if (status != CUPOLA_OK)
        return status;
    gl->passes[output].gain = texture;
    gl->features.texture_units = gain_unit(gl);
    for (int i = 0; i < gl->plan.dome.rig.output_count; i++)
        if (gl->passes[i].gain)
            gl->features.texture_units = gain_unit(gl) + 1;
    return CUPOLA_OK;
}

int cupola_gl_set_gain(cupola_gl *gl, int output, unsigned int texture, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, set_gain(gl, output, texture, error), error);
}

int gain_check(const cupola_gl *gl, int output, struct cupola_error *error)
{
    GLuint texture = gl->passes[output].gain;
    if (!texture_found(&gl->guest, GL_TEXTURE_2D, texture))
        return refuse_texture(output, texture, error);
    return gl->guest.leaves_state ? CUPOLA_OK : check_bound(gl, output, texture, error);
}

void gain_bind(const cupola_gl *gl, int output)
{
    GLuint unit = (GLuint)gain_unit(gl);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, gl->passes[output].gain);
    glBindSampler(unit, gl->gain_sampler);
}
