/* What comes out of the hosts of host_state.c, to be compared bit by bit. */
#ifndef HOST_RESULTS_H
#define HOST_RESULTS_H

#include <stdlib.h>

#include "check.h"
#include "host_objects.h"

enum { RESULTS_MAX = 1 << 20 };

/* All that was drawn, as one row of numbers. */
struct results {
    int count;
    float *values;
};

static bool depth_is_readable(void)
{
    return context_has(33, NULL, NO_VERSION, "GL_NV_read_depth");
}

/* Depth as whatever number of 32 bits it is; results are compared bit by bit. */
static void read_depth(int width, int height, float *values)
{
    GLint type = GL_FLOAT;
    if (!depth_is_readable())
        return;
    if (context_is_es())
        glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT,
                 type == GL_FLOAT ? GL_FLOAT : GL_UNSIGNED_INT, values);
}

static void add_pixels(struct results *results, GLuint framebuffer, GLenum format, int width,
                       int height)
{
    int channels = format == GL_RGBA ? 4 : 1;
    float *values = results->values + results->count;
    assert_true(results->count + channels * width * height <= RESULTS_MAX);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (format == GL_RGBA)
        context_read_pixels(width, height, values);
    else
        read_depth(width, height, values);
    results->count += channels * width * height;
}

static void add_targets(struct results *results)
{
    for (int i = 0; i < TARGETS; i++)
        add_pixels(results, target_resolved(i), GL_RGBA, TARGET_WIDTH, TARGET_HEIGHT);
}

static void add_sampled(struct results *results)
{
    const struct cupola_plan_report *report = cupola_plan_report(sampled.plan);
    int values = 4 * report->atlas_width_px * report->atlas_height_px;
    float *atlas = fixture_atlas(&sampled);
    assert_true(results->count + values <= RESULTS_MAX);
    memcpy(results->values + results->count, atlas, (size_t)values * sizeof *atlas);
    results->count += values;
    free(atlas);
}

static struct results results_create(void)
{
    struct results results = {0, calloc(RESULTS_MAX, sizeof(float))};
    assert_non_null(results.values);
    return results;
}

static bool results_equal(const struct results *a, const struct results *b)
{
    return a->count == b->count &&
           memcmp(a->values, b->values, (size_t)a->count * sizeof(float)) == 0;
}

#endif
