/*
 * What the warp must show of an atlas of any format: the C reference of its texels in linear light.
 * sRGB is decoded here by its own definition (IEC 61966-2-1).
 */
#ifndef ATLAS_DECODE_H
#define ATLAS_DECODE_H

#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "fixture.h"

static inline double srgb_decoded(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

static inline double srgb_encoded(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/* Red, green and blue of what fixture_atlas has read become linear light. */
static inline void decode_atlas(const struct fixture *fixture, enum cupola_format format,
                                float *atlas)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    if (format != CUPOLA_FORMAT_SRGB8)
        return;
    for (int i = 0; i < 4 * report->atlas_width_px * report->atlas_height_px; i++)
        if (i % 4 != 3)
            atlas[i] = (float)srgb_decoded((double)atlas[i]);
}

/* As in warp_reference.c: formats of 8 bits may be filtered by weights of 8 bits. */
static inline double bar_of_format(enum cupola_format format)
{
    bool bytes = format == CUPOLA_FORMAT_RGBA8 || format == CUPOLA_FORMAT_SRGB8;
    return bytes || !context_has_floats() ? 0.012 : 0.004;
}

/* Whether two views have the same claim to a ray, so that it may fall to either. */
static inline bool ray_on_border(const cupola_plan *plan, const double direction[3])
{
    double own = 0;
    int selected = cupola_plan_select(plan, direction), others = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < cupola_plan_view_count(plan); k++) {
            const double *s = cupola_plan_view(plan, k)->selector;
            double claim = s[0] * direction[0] + s[1] * direction[1] + s[2] * direction[2];
            if (pass == 0 && k == selected)
                own = claim;
            others += pass == 1 && k != selected && claim > own - 1e-6;
        }
    return others > 0;
}

struct warp_error {
    double worst;
    int lit, skipped; /* pixels; those on borders of views are skipped */
};

/* `told` is the format that the atlas is taken for. */
static inline struct warp_error warp_error_of(const struct fixture *fixture,
                                              enum cupola_format told)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    int pixels = size->width_px * size->height_px;
    struct warp_error error = {0, 0, 0};
    float *atlas = fixture_atlas(fixture), *shown = fixture_warp(fixture, 0);
    float *expected = malloc(4 * sizeof *expected * (size_t)pixels);
    assert_non_null(expected);
    decode_atlas(fixture, told, atlas);
    assert_int_equal(cupola_reference_warp(fixture->plan, 0, atlas, NULL, expected), CUPOLA_OK);
    for (int i = 0; i < pixels; i++) {
        struct cupola_ray ray;
        cupola_dome_ray(fixture->dome, 0, NULL, i % size->width_px + 0.5, i / size->width_px + 0.5,
                        &ray);
        bool lit = ray.coverage > 0, border = lit && ray_on_border(fixture->plan, ray.direction);
        error.lit += lit;
        error.skipped += border;
        for (int c = 0; c < 4 && !border; c++) {
            double off = fabs((double)shown[4 * i + c] - (double)expected[4 * i + c]);
            error.worst = off <= error.worst ? error.worst : off;
        }
    }
    free(atlas);
    free(shown);
    free(expected);
    return error;
}

#endif
