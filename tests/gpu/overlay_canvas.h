/* A target to lay overlays over, and overlays in random places of random theatres. */
#ifndef OVERLAY_CANVAS_H
#define OVERLAY_CANVAS_H

#include <stdlib.h>
#include <string.h>

#include "cupola/reference.h"
#include "group.h"
#include "oracle.h"
#include "rig_random.h"
#include "worse.h"

/* The image does not begin at the target's corner, nor does it end at its other one. */
enum { CORNER_X = 7, CORNER_Y = 3, REST = 5 };

struct canvas {
    GLuint texture;
    struct cupola_target target;
    int width_px, height_px; /* of the output's image */
};

static inline size_t canvas_values(const struct canvas *canvas)
{
    return 4 * (size_t)canvas->width_px * (size_t)canvas->height_px;
}

/* `format` 0: floats where they can be drawn into and blended, else bytes. */
static inline struct canvas canvas_make(const struct fixture *fixture, GLenum format)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    struct canvas canvas = {.target = {0, CORNER_X, CORNER_Y},
                            .width_px = size->width_px,
                            .height_px = size->height_px};
    bool floats = context_has_floats() && context_has(33, NULL, 32, "GL_EXT_float_blend");
    if (format == 0)
        format = floats ? GL_RGBA32F : GL_RGBA8;
    glGenTextures(1, &canvas.texture);
    glBindTexture(GL_TEXTURE_2D, canvas.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, canvas.width_px + CORNER_X + REST,
                 canvas.height_px + CORNER_Y + REST, 0, GL_RGBA,
                 format == GL_RGBA32F ? GL_FLOAT : GL_UNSIGNED_BYTE, NULL);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &canvas.target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, canvas.texture, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return canvas;
}

static inline void canvas_release(struct canvas *canvas)
{
    glDeleteFramebuffers(1, &canvas->target.framebuffer);
    glDeleteTextures(1, &canvas->texture);
}

static inline void canvas_fill(const struct canvas *canvas, const float color[4])
{
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->target.framebuffer);
    glClearBufferfv(GL_COLOR, 0, color);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

/* Of the output's image, freed by the caller. */
static inline float *canvas_read(const struct canvas *canvas)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    float *image = malloc(sizeof *image * canvas_values(canvas));
    assert_non_null(image);
    if (cupola_gl_capture(&canvas->target, canvas->width_px, canvas->height_px, image, &error) < 0)
        fail_msg("%s", error.message);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return image;
}

static inline void canvas_lay(const struct fixture *fixture, const struct canvas *canvas,
                              const struct cupola_overlay *overlays, int count)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_gl_overlay(fixture->gl, 0, overlays, count, &canvas->target, &error) < 0)
        fail_msg("%s", error.message);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

/* For overlays alone: of what the warp could show no more is made than what there must be. */
static inline void make_for_overlays(const struct cupola_rig *rig, enum cupola_encoding encoding,
                                     struct fixture *fixture)
{
    const struct cupola_gl_params params = {
        .sources = 1u << CUPOLA_SOURCE_DOMEMASTER, .encoding = encoding, .overlays = true};
    fixture_make(rig, NULL, &params, fixture);
}

/* A texture of premultiplied floats, rounded to bytes. */
static inline GLuint overlay_texture(const float *picture, int width, int height)
{
    GLuint texture = 0;
    size_t values = 4 * (size_t)width * (size_t)height;
    unsigned char *bytes = malloc(values);
    assert_non_null(bytes);
    for (size_t i = 0; i < values; i++)
        bytes[i] = (unsigned char)lround((double)picture[i] * 255.0);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture); /* its filter stays GL's default, which wants mipmaps */
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    free(bytes);
    return texture;
}

/* A lens well inside of its rim's steepness, on a screen of any size, seen from anywhere. */
static inline struct cupola_rig overlay_rig(uint64_t *seed, int number, int size_px)
{
    struct cupola_rig rig = random_rig(seed, 0.4);
    struct cupola_output *output = &rig.outputs[0];
    output->lens = random_lens(seed, (enum cupola_lens_model)(number % 6), radians(150.0));
    output->width_px = size_px;
    output->height_px = size_px - 9;
    output->circle = (struct cupola_circle){0.47 * size_px, 0.5 * size_px, 0.5 * size_px};
    output->flip = number % 4;
    if (number % 3 == 1) { /* a planetarium */
        rig.tilt_rad = radians(90.0);
        output->aim = (struct cupola_aim){0.0, 0.0, 0.0};
    }
    return rig;
}

/* The ray of a random place of the image that is at least so far from all edges. */
static inline void random_sight(uint64_t *seed, const cupola_dome *dome, double margin_px,
                                double place[2], struct cupola_ray *ray)
{
    const struct cupola_output *output = &cupola_dome_rig(dome)->outputs[0];
    double rim;
    do {
        place[0] = random_between(seed, margin_px, output->width_px - margin_px);
        place[1] = random_between(seed, margin_px, output->height_px - margin_px);
        rim = hypot(place[0] - output->circle.center_x_px, place[1] - output->circle.center_y_px);
    } while (rim > output->circle.radius_px - margin_px);
    assert_int_equal(cupola_dome_ray(dome, 0, NULL, place[0], place[1], ray), 1);
}

#endif
