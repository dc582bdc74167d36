/* What masks have left of views: what every pixel needs of it, and what was drawn there. */
#ifndef MASK_LEFT_H
#define MASK_LEFT_H

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "geometry/plan.h"
#include "host_depth.h"
#include "triangles.h"

/* Marks all texels of the atlas whose middles are within the guard band of what a pixel samples. */
static inline void need_pixel(const cupola_plan *plan, const struct cupola_ray *ray,
                              unsigned char *needed)
{
    int width = cupola_plan_report(plan)->atlas_width_px;
    int view = cupola_plan_select(plan, ray->direction), guard = plan->guard_px;
    const struct cupola_rect *rect = &cupola_plan_view(plan, view)->rect;
    double texel[2];
    assert_int_equal(cupola_plan_texel(plan, view, ray->direction, texel), 1);
    int left = (int)ceil(fmax(texel[0] - guard - 0.5, rect->x));
    int right = (int)floor(fmin(texel[0] + guard - 0.5, rect->x + rect->width - 1));
    int bottom = (int)ceil(fmax(texel[1] - guard - 0.5, rect->y));
    int top = (int)floor(fmin(texel[1] + guard - 0.5, rect->y + rect->height - 1));
    for (int y = bottom; y <= top; y++)
        for (int x = left; x <= right; x++)
            needed[y * width + x] = 1;
}

/* Of all outputs, for the plan's eye; freed by the caller. */
static inline unsigned char *texels_needed(const cupola_plan *plan)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    unsigned char *needed =
        calloc((size_t)report->atlas_width_px * (size_t)report->atlas_height_px, 1);
    assert_non_null(needed);
    for (int output = 0; output < rig->output_count; output++)
        for (int i = 0; i < rig->outputs[output].width_px * rig->outputs[output].height_px; i++) {
            struct cupola_ray ray;
            double x = i % rig->outputs[output].width_px + 0.5;
            double y = i / rig->outputs[output].width_px + 0.5; /* whole rows */
            if (cupola_dome_ray(dome, output, NULL, x, y, &ray) == 1)
                need_pixel(plan, &ray, needed);
        }
    return needed;
}

/* Colours that differ: of each view its own. */
static inline void view_color(int view, float color[4])
{
    static const float colors[CUPOLA_VIEWS_MAX][4] = {{1, 0, 0, 1}, {0, 1, 0, 1},   {0, 0, 1, 1},
                                                      {1, 1, 0, 1}, {0, 1, 1, 1},   {1, 0, 1, 1},
                                                      {1, 1, 1, 1}, {1, 0.5f, 0, 1}};
    memcpy(color, colors[view], sizeof colors[view]);
}

/* Texels of the atlas that are needed, those drawn, and those that were not drawn and should. */
struct texels_left {
    int needed, left, missing;
};

static inline int view_of_texel(const cupola_plan *plan, int x, int y)
{
    for (int v = 0; v < cupola_plan_view_count(plan); v++) {
        const struct cupola_rect *rect = &cupola_plan_view(plan, v)->rect;
        if (x >= rect->x && x < rect->x + rect->width && y >= rect->y && y < rect->y + rect->height)
            return v;
    }
    return -1;
}

/* Whether a texel has been drawn: in the colour of its view, or in red. */
static inline bool texel_drawn(const cupola_plan *plan, int index, const float *atlas, bool colored)
{
    int width = cupola_plan_report(plan)->atlas_width_px;
    int view = colored ? view_of_texel(plan, index % width, index / width) : 0;
    float color[4];
    if (view < 0)
        return false;
    view_color(view, color);
    for (int k = 0; k < 3; k++)
        if (fabsf(atlas[4 * index + k] - color[k]) > 0.01f)
            return false;
    return true;
}

static inline struct texels_left texels_count(const cupola_plan *plan, const float *atlas,
                                              bool colored)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    struct texels_left count = {0, 0, 0};
    unsigned char *needed = texels_needed(plan);
    for (int i = 0; i < report->atlas_width_px * report->atlas_height_px; i++) {
        bool drawn = texel_drawn(plan, i, atlas, colored);
        count.needed += needed[i];
        count.left += drawn;
        count.missing += needed[i] && !drawn;
    }
    free(needed);
    return count;
}

/* All of a view in one colour, tested by depth or stencil as a host does. */
static inline void draw_plain(const struct triangles *triangles, const cupola_plan *plan, int index,
                              const struct cupola_depth *depth, enum cupola_mask mask,
                              const float color[4])
{
    static const double nearness[3] = {0.3, 0, 0};
    struct cupola_camera camera;
    float points[6][3];
    assert_int_equal(cupola_plan_camera(plan, index, depth, &camera, NULL), CUPOLA_OK);
    plane_over_view(plan, index, nearness, points);
    host_depth(depth);
    if (mask == CUPOLA_MASK_STENCIL) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 0, 128);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
    triangles_draw(triangles, &camera, color, points, 6);
    glDisable(GL_STENCIL_TEST);
    host_depth_reset();
}

static inline void draw_red(const struct triangles *triangles, const cupola_plan *plan, int index,
                            const struct cupola_depth *depth, enum cupola_mask mask)
{
    float red[4];
    view_color(0, red);
    draw_plain(triangles, plan, index, depth, mask, red);
}

/* Every view of a frame, tested by depth, in the colour of the view that is `shift` further on. */
static inline void draw_views_from(const struct triangles *triangles, cupola_gl *gl,
                                   const cupola_plan *plan, const struct cupola_depth *depth,
                                   int shift)
{
    const struct cupola_frame frame = {.depth = *depth};
    int views = cupola_gl_frame_begin(gl, &frame, NULL);
    assert_int_equal(views, cupola_plan_view_count(plan));
    for (int i = 0; i < views; i++) {
        float color[4];
        view_color((i + shift) % CUPOLA_VIEWS_MAX, color);
        assert_int_equal(cupola_gl_view_begin(gl, i, NULL, NULL), CUPOLA_OK);
        draw_plain(triangles, plan, i, depth, CUPOLA_MASK_DEPTH, color);
        assert_int_equal(cupola_gl_view_end(gl, NULL), CUPOLA_OK);
    }
}

/* Every view of a frame, in red. */
static inline void draw_red_views(const struct triangles *triangles, cupola_gl *gl,
                                  const cupola_plan *plan, const struct cupola_depth *depth,
                                  enum cupola_mask mask)
{
    const struct cupola_frame frame = {.depth = *depth};
    int views = cupola_gl_frame_begin(gl, &frame, NULL);
    assert_int_equal(views, cupola_plan_view_count(plan));
    for (int i = 0; i < views; i++) {
        assert_int_equal(cupola_gl_view_begin(gl, i, NULL, NULL), CUPOLA_OK);
        draw_red(triangles, plan, i, depth, mask);
        assert_int_equal(cupola_gl_view_end(gl, NULL), CUPOLA_OK);
    }
}

#endif
