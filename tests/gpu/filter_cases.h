/* Every method of antialiasing, for tests of what holds for all of them. */
#ifndef FILTER_CASES_H
#define FILTER_CASES_H

#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "fixture.h"

enum { FILTERS = 7, FILTER_STAGES = 2 };

static const struct cupola_filter filters[FILTERS] = {
    {.method = CUPOLA_ANTIALIASING_TEXTURE},
    {.method = CUPOLA_ANTIALIASING_TEXTURE, .samples = 9},
    {.method = CUPOLA_ANTIALIASING_NONE},
    {.method = CUPOLA_ANTIALIASING_CONE},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 7, .turned = true},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE, .samples = 6},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT},
};

/* The two that every method has. */
static const enum cupola_table filter_stages[FILTER_STAGES] = {CUPOLA_TABLE_NONE,
                                                               CUPOLA_TABLE_TILES};

/* For messages; overwritten by the next call. */
static inline const char *filter_text(const struct cupola_filter *filter)
{
    static char text[64];
    snprintf(text, sizeof text, "%s %d", cupola_antialiasing_name((int)filter->method),
             filter->samples);
    return text;
}

/* Far too bright: all of an atlas of floats but the views, and their outermost texels. */
static inline void spoil_beyond_views(const struct fixture *fixture, int rings)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    int width = report->atlas_width_px, height = report->atlas_height_px;
    float *atlas = fixture_atlas(fixture);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            bool inside = false;
            for (int v = 0; v < cupola_plan_view_count(fixture->plan); v++) {
                const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, v)->rect;
                inside |= x >= rect->x + rings && x < rect->x + rect->width - rings &&
                          y >= rect->y + rings && y < rect->y + rect->height - rings;
            }
            for (int c = 0; c < 4 && !inside; c++)
                atlas[4 * (y * width + x) + c] = 1000.0f;
        }
    glBindTexture(GL_TEXTURE_2D, cupola_gl_atlas(fixture->gl));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, atlas);
    glBindTexture(GL_TEXTURE_2D, 0);
    free(atlas);
}

#endif
