/* The mean of many frames. */
#include "truth.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/jitter.h>
#include <epoxy/gl.h>

#include "frame.h"

struct truth {
    const struct setting *setting;
    cupola_gl *gl;
    struct target target;
    float *frame; /* RGBA */
};

/* Nearest texels, which the jitter makes a box filter over texels and pixels. */
static bool make_gl(struct truth *truth, double density, char *message)
{
    const struct cupola_plan_params plan_wishes = {.density = density};
    struct cupola_gl_params params = truth->setting->gl;
    struct cupola_error error = {0};
    cupola_plan *plan = NULL;

    params.format = CUPOLA_FORMAT_SRGB8; /* as those that are judged; no more encoding than that */
    params.table = CUPOLA_TABLE_TILES;   /* whatever is judged: tables have one ray for a pixel */
    params.filter.method = CUPOLA_ANTIALIASING_NONE;
    params.jitters = true;
    if (cupola_plan_create(truth->setting->dome, &plan_wishes, &plan, &error) < 0 ||
        cupola_gl_create(plan, &params, &truth->gl, &error) < 0)
        snprintf(message, MESSAGE_SIZE, "the reference: %.900s", error.message);
    cupola_plan_destroy(&plan);
    return truth->gl;
}

struct truth *truth_create(const struct setting *setting, double density, char *message)
{
    size_t pixels = (size_t)setting->size_px * (size_t)setting->size_px;
    struct truth *truth = calloc(1, sizeof *truth);

    if (truth)
        truth->frame = malloc(4 * pixels * sizeof(float));
    if (!truth || !truth->frame) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        free(truth);
        return NULL;
    }
    truth->setting = setting;
    if (make_gl(truth, density, message) &&
        target_create(&truth->target, setting->size_px, setting->size_px, TARGET_FLOATS, message,
                      MESSAGE_SIZE))
        return truth;
    truth_destroy(truth);
    return NULL;
}

void truth_destroy(struct truth *truth)
{
    if (!truth)
        return;
    cupola_gl_destroy(&truth->gl);
    target_destroy(&truth->target);
    free(truth->frame);
    free(truth);
}

static bool add_frame(struct truth *truth, int index, float *light, char *message)
{
    int size_px = truth->setting->size_px;
    const struct cupola_target target = {.framebuffer = truth->target.framebuffer};
    struct cupola_error error = {0};
    double texels[2], pixels[2];

    cupola_jitter_place(index, texels, pixels);
    if (cupola_gl_set_jitter(truth->gl, texels, pixels, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "the reference: %.900s", error.message);
        return false;
    }
    if (!frame_draw(truth->gl, truth->setting, &target, message))
        return false;
    glBindFramebuffer(GL_FRAMEBUFFER, truth->target.framebuffer);
    glReadPixels(0, 0, size_px, size_px, GL_RGBA, GL_FLOAT, truth->frame);
    for (size_t i = 0; i < (size_t)size_px * (size_t)size_px; i++)
        for (size_t k = 0; k < 3; k++)
            light[3 * i + k] += truth->frame[4 * i + k];
    return true;
}

bool truth_draw(struct truth *truth, int rays, float *light, char *message)
{
    size_t numbers = 3 * (size_t)truth->setting->size_px * (size_t)truth->setting->size_px;

    memset(light, 0, numbers * sizeof *light);
    for (int index = 0; index < rays; index++)
        if (!add_frame(truth, index, light, message))
            return false;
    for (size_t i = 0; i < numbers; i++)
        light[i] /= (float)rays;
    return true;
}
