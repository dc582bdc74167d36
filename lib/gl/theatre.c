/* The simulated theatre: one pass per output, added up. */
#include "cupola/theatre.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "geometry/angle.h"
#include "geometry/vector.h"
#include "gl_objects.h"
#include "instance.h"
#include "light_sum.h"
#include "program.h"
#include "sampled.h"
#include "shaders.h"
#include "target_color.h"
#include "target_gl.h"

/* Of products of rows: a rotation made in single precision still is one. */
static const double rotation_slack = 1e-6;

struct cupola_theatre {
    struct cupola_dome dome;
    struct host_features features;
    struct guest guest; /* of the context with these features */
    GLuint vertex_array;
    GLuint sampler; /* of the images: their own settings are not touched */
    GLuint programs[CUPOLA_OUTPUTS_MAX];
    struct light_sum sum; /* where several projectors' light is encoded */
};

/* What stays the same for every spectator. */
static void set_furniture(GLuint program, const cupola_dome *dome)
{
    const double forward[3] = {0, 0, -1};
    double gaze[3];
    cupola_dome_from_camera(dome, forward, gaze);
    program_set_vector(program, "gaze", gaze, 3);
    glUniform1i(glGetUniformLocation(program, "projector_count"), dome->rig.output_count);
    for (int i = 0; i < dome->rig.output_count; i++) {
        char name[48];
        double axis[3];
        transform3(dome->projectors[i].aim, forward, axis);
        snprintf(name, sizeof name, "projector_positions[%d]", i);
        program_set_vector(program, name, dome->projectors[i].position_m, 3);
        snprintf(name, sizeof name, "projector_axes[%d]", i);
        program_set_vector(program, name, axis, 3);
    }
    glUniform1i(glGetUniformLocation(program, "image"), 0);
}

static int create_programs(cupola_theatre *theatre, struct cupola_error *error)
{
    static const struct shader_file files[] = {
        {"varying.glsl", shader_varying_glsl}, {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},   {"light.glsl", shader_light_glsl},
        {"theatre.frag", shader_theatre_frag},
    };
    char lines[WARP_LINES_MAX];
    light_lines(CUPOLA_ENCODING_SRGB, true, false, false, lines);
    for (int i = 0; i < theatre->dome.rig.output_count; i++) {
        char defines[PROGRAM_DEFINES_MAX + WARP_LINES_MAX];
        program_defines(&theatre->dome, i, 1, 0, defines);
        strcat(defines, lines);
        GLuint program = program_create(defines, files, 5, error);
        if (!program)
            return error->status;
        guest_name(&theatre->guest, GL_PROGRAM, program, "theatre of output %d", i);
        glUseProgram(program);
        program_set_projector(program, &theatre->dome, i);
        set_furniture(program, &theatre->dome);
        theatre->programs[i] = program;
    }
    return CUPOLA_OK;
}

static void destroy_objects(cupola_theatre *theatre)
{
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        glDeleteProgram(theatre->programs[i]);
    light_sum_destroy(&theatre->sum);
    glDeleteSamplers(1, &theatre->sampler);
    glDeleteVertexArrays(1, &theatre->vertex_array);
}

static int create_objects(cupola_theatre *theatre, struct cupola_error *error)
{
    theatre->vertex_array = vertex_array_create(&theatre->guest, "full screen", error);
    if (!theatre->vertex_array)
        return error->status;
    theatre->sampler = sampler_create(&theatre->guest, "theatre", error);
    int status = theatre->sampler ? create_programs(theatre, error) : (int)error->status;
    if (status == CUPOLA_OK && theatre->dome.rig.output_count > 1)
        status = light_sum_create(&theatre->guest, &theatre->sum, error);
    return status;
}

/* With the context's features found. All or nothing, and the host's state as it was. */
static int make_objects(cupola_theatre *theatre, struct cupola_error *error)
{
    struct guest_work work;
    int status = guest_check(&theatre->guest, error);
    if (status != CUPOLA_OK)
        return status;
    guest_begin_making(&theatre->guest, &work, "theatre");
    status = create_objects(theatre, error);
    if (status != CUPOLA_OK) {
        destroy_objects(theatre);
        gl_errors_drop();
    }
    guest_end(&theatre->guest, &work);
    return guest_reason(&theatre->guest, status, error);
}

int cupola_theatre_create(const cupola_dome *dome, cupola_theatre **theatre,
                          struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    if (!dome || !theatre)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", dome ? "theatre" : "dome");
    int status = context_check(error);
    if (status != CUPOLA_OK)
        return status;
    cupola_theatre *made = calloc(1, sizeof *made);
    if (!made)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a theatre (%zu bytes)",
                         sizeof *made);
    made->dome = *dome;
    host_features_find(&made->features);
    made->guest.features = &made->features;
    status = make_objects(made, error);
    if (status != CUPOLA_OK) {
        free(made);
        return status;
    }
    *theatre = made;
    return CUPOLA_OK;
}

void cupola_theatre_destroy(cupola_theatre **theatre)
{
    if (!theatre || !*theatre)
        return;
    if (guest_check(&(*theatre)->guest, NULL) == CUPOLA_OK)
        destroy_objects(*theatre);
    free(*theatre);
    *theatre = NULL;
}

void cupola_spectator_at_eye(const cupola_dome *dome, struct cupola_spectator *spectator)
{
    if (!dome || !spectator)
        return;
    *spectator = (struct cupola_spectator){.fov_rad = pi / 3};
    memcpy(spectator->position_m, dome->rig.eye_m, sizeof spectator->position_m);
    /* The camera's axes in the dome frame are the rows of the rotation from dome to camera. */
    memcpy(spectator->rotation, dome->tilt, sizeof spectator->rotation);
}

void cupola_spectator_outside(const cupola_dome *dome, struct cupola_spectator *spectator)
{
    if (!dome || !spectator)
        return;
    /* To the right of the viewer, above and behind, looking at the middle of the sphere; all in the
     * host's camera frame, so that up is up for every tilt. */
    double back[3] = {0.62, 0.5, 0.9}, right[3], up[3] = {0, 1, 0}, camera[9];
    *spectator = (struct cupola_spectator){.fov_rad = pi / 4, .furniture = true};
    for (int i = 0; i < 3; i++)
        spectator->ambient_rgb[i] = 0.0134f; /* 0.12 of what a screen shows */
    scale3(back, 1 / length3(back));
    cross3(up, back, right);
    scale3(right, 1 / length3(right));
    cross3(back, right, up);
    memcpy(camera, right, sizeof right);
    memcpy(camera + 3, up, sizeof up);
    memcpy(camera + 6, back, sizeof back);
    multiply3(camera, dome->tilt, spectator->rotation);
    cupola_dome_from_camera(dome, back, spectator->position_m);
    scale3(spectator->position_m, 3.2 * dome->rig.screen.radius_m);
}

static bool rotation_is_zero(const double rotation[9])
{
    for (int i = 0; i < 9; i++)
        if (rotation[i] != 0)
            return false;
    return true;
}

static int check_rotation(const double rotation[9], struct cupola_error *error)
{
    double determinant, cross[3];
    for (int i = 0; i < 9; i++)
        if (!isfinite(rotation[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "spectator's rotation[%d] is %g; allowed: any finite number", i,
                             rotation[i]);
    for (int row = 0; row < 3; row++)
        for (int other = row; other < 3; other++) {
            double product = dot3(rotation + 3 * row, rotation + 3 * other);
            if (!(fabs(product - (row == other)) <= rotation_slack))
                return error_set(error, CUPOLA_ERROR_ARGUMENT,
                                 "spectator's rotation has rows %d and %d whose product is %.9g; "
                                 "allowed: %d within %g, or a rotation that is all zero",
                                 row, other, product, row == other, rotation_slack);
        }
    cross3(rotation, rotation + 3, cross);
    determinant = dot3(cross, rotation + 6);
    if (determinant < 0)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "spectator's rotation has determinant %g, a mirror image; allowed: 1",
                         determinant);
    return CUPOLA_OK;
}

static int check_encoding(enum cupola_encoding encoding, struct cupola_error *error)
{
    if (encoding == CUPOLA_ENCODING_LINEAR || encoding == CUPOLA_ENCODING_SRGB)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "spectator's encoding is %d; allowed: %d to %d",
                     (int)encoding, CUPOLA_ENCODING_LINEAR, CUPOLA_ENCODING_SRGB);
}

static int check_spectator(const struct cupola_spectator *spectator, int width, int height,
                           struct cupola_error *error)
{
    if (!spectator)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "spectator is NULL");
    if (!(spectator->fov_rad >= 0 && spectator->fov_rad < pi))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "spectator's field of view is %g rad (%g degrees); allowed: above 0 and "
                         "below %g rad (180 degrees)",
                         RAD_AND_DEG(spectator->fov_rad), pi);
    for (int i = 0; i < 3; i++)
        if (!isfinite(spectator->position_m[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "spectator's position_m[%d] is %g; allowed: any finite number", i,
                             spectator->position_m[i]);
    for (int i = 0; i < 3; i++)
        if (!isfinite(spectator->ambient_rgb[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "spectator's ambient_rgb[%d] is %g; allowed: any finite number", i,
                             (double)spectator->ambient_rgb[i]);
    if (width < 1 || height < 1 || width > 32768 || height > 32768)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "picture of the theatre is %d x %d px; allowed: 1 to 32768 each way",
                         width, height);
    if (!rotation_is_zero(spectator->rotation) &&
        check_rotation(spectator->rotation, error) != CUPOLA_OK)
        return CUPOLA_ERROR_ARGUMENT;
    return check_encoding(spectator->encoding, error);
}

static void set_spectator(GLuint program, const cupola_dome *dome,
                          const struct cupola_spectator *spectator, struct cupola_target place,
                          int width, int height)
{
    double fov = spectator->fov_rad == 0 ? pi / 3 : spectator->fov_rad;
    double axes[9], size[2] = {width, height}, corner[2] = {place.x, place.y};
    double half[2] = {tan(0.5 * fov) * width / height, tan(0.5 * fov)};
    double ambient[3];
    for (int i = 0; i < 3; i++)
        ambient[i] = (double)spectator->ambient_rgb[i];
    bool as_camera = rotation_is_zero(spectator->rotation);
    transpose3(as_camera ? dome->tilt : spectator->rotation, axes);
    program_set_vector(program, "target_corner", corner, 2);
    program_set_vector(program, "target_size", size, 2);
    program_set_vector(program, "half_opening", half, 2);
    program_set_vector(program, "spectator", spectator->position_m, 3);
    program_set_rotation(program, "spectator_axes", axes);
    program_set_vector(program, "ambient", ambient, 3);
    glUniform1i(glGetUniformLocation(program, "furniture"), spectator->furniture);
}

/* Into the framebuffer that is bound. */
static void draw_outputs(const cupola_theatre *theatre, const unsigned int *images,
                         const struct cupola_spectator *spectator, int width, int height,
                         struct cupola_target place, bool encoded)
{
    glBindSampler(0, theatre->sampler);
    host_set_area(&theatre->features, place.x, place.y, width, height);
    for (int i = 0; i < theatre->dome.rig.output_count; i++) {
        GLuint program = theatre->programs[i];
        if (i == 1)
            host_set_adding(&theatre->features, true);
        glUseProgram(program);
        set_spectator(program, &theatre->dome, spectator, place, width, height);
        glUniform1i(glGetUniformLocation(program, "first_output"), i == 0);
        glUniform1i(glGetUniformLocation(program, "encoded"), encoded);
        glBindTexture(GL_TEXTURE_2D, images[i]);
        draw_fullscreen(theatre->vertex_array);
    }
}

/* The images of projectors after the first are added by blending. */
static int check_blending(const cupola_theatre *theatre, GLuint framebuffer,
                          struct cupola_error *error)
{
    if (theatre->features.float_blend || theatre->dome.rig.output_count < 2 ||
        !target_is_float32(&theatre->features))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_GL,
                     "several projectors in a target of 32 bit floats (framebuffer %u) need "
                     "GL_EXT_float_blend, which this OpenGL ES lacks; allowed: RGBA8 or RGBA16F",
                     framebuffer);
}

/* By way of a sum only where codes would be added. */
static int draw(cupola_theatre *theatre, const unsigned int *images,
                const struct cupola_spectator *spectator, int width, int height,
                struct cupola_target place, struct cupola_error *error)
{
    bool encoded =
        spectator->encoding == CUPOLA_ENCODING_SRGB && !target_encodes(&theatre->features);
    if (!encoded || theatre->dome.rig.output_count < 2) {
        int status = check_blending(theatre, place.framebuffer, error);
        if (status == CUPOLA_OK)
            draw_outputs(theatre, images, spectator, width, height, place, encoded);
        return status;
    }
    int status = light_sum_begin(&theatre->guest, &theatre->sum, width, height, error);
    if (status != CUPOLA_OK)
        return status;
    draw_outputs(theatre, images, spectator, width, height, (struct cupola_target){0}, false);
    light_sum_end(&theatre->guest, &theatre->sum, theatre->vertex_array, place);
    return CUPOLA_OK;
}

/* With the host's state saved. */
static int check_images(const cupola_theatre *theatre, const unsigned int *images,
                        struct cupola_error *error)
{
    for (int i = 0; i < theatre->dome.rig.output_count; i++) {
        if (!texture_bind(GL_TEXTURE_2D, images[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "image %d is texture %u; allowed: the name of a GL_TEXTURE_2D", i,
                             images[i]);
        int status = sampled_check(&theatre->features, GL_TEXTURE_2D, images[i], false, error);
        if (status != CUPOLA_OK) {
            error_context(error, "image %d", i);
            return status;
        }
    }
    return CUPOLA_OK;
}

static int theatre_draw(cupola_theatre *theatre, const unsigned int *images,
                        const struct cupola_spectator *spectator, int width, int height,
                        const struct cupola_target *target, struct cupola_error *error)
{
    if (!theatre || !images)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL",
                         theatre ? "images" : "theatre");
    struct cupola_error unwanted;
    error = error ? error : &unwanted; /* what is made further down answers by the error's status */
    int status = guest_check_seen(&theatre->guest, error);
    if (status != CUPOLA_OK ||
        (status = check_spectator(spectator, width, height, error)) != CUPOLA_OK ||
        (status = guest_check(&theatre->guest, error)) != CUPOLA_OK)
        return status;
    struct cupola_target place = target ? *target : (struct cupola_target){0};
    struct guest_work work;
    guest_begin(&theatre->guest, &work, "theatre");
    status = check_images(theatre, images, error);
    if (status == CUPOLA_OK)
        status = target_bind(&theatre->guest, &place, error);
    if (status == CUPOLA_OK)
        status = target_check_color(place.framebuffer, error);
    if (status == CUPOLA_OK)
        status =
            target_check_sampled(place.framebuffer, images, theatre->dome.rig.output_count, error);
    if (status == CUPOLA_OK)
        status = target_check_encoding(&theatre->features, place.framebuffer, spectator->encoding,
                                       error);
    if (status == CUPOLA_OK)
        status = draw(theatre, images, spectator, width, height, place, error);
    guest_end(&theatre->guest, &work);
    return status;
}

int cupola_theatre_draw(cupola_theatre *theatre, const unsigned int *images,
                        const struct cupola_spectator *spectator, int width, int height,
                        const struct cupola_target *target, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    int status = theatre_draw(theatre, images, spectator, width, height, target, error);
    return theatre ? guest_ended(&theatre->guest, __func__, status, error) : status;
}
