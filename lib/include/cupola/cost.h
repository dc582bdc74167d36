/*
 * Prices for the planner, measured instead of assumed: a host times frames of a few plans, and
 * struct cupola_cost comes out of it, for the machine, the driver and the scene at hand.
 *
 *     cupola_gl_measure_cost(dome, &wishes, &gl_params, NULL, draw_view, host, &wishes.cost, NULL);
 *     cupola_plan_create(dome, &wishes, &plan, NULL);
 *
 * Times depend on what else the machine does: measured prices, and so the plan, are not the same
 * from one start to the next. A host that wants the same plan always keeps the prices.
 */
#ifndef CUPOLA_COST_H
#define CUPOLA_COST_H

#include "gl.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A plan's amounts, all per output pixel but the last two, and what a frame of it takes. */
struct cupola_cost_trial {
    double texels_shaded;    /* 0 or above */
    double texels_allocated; /* of the views' rectangles, 0 or above */
    double views;            /* 0 or above */
    double directions_drawn; /* as in struct cupola_plan_report, 0 or above */
    double seconds;          /* 0 or above */
};

enum { CUPOLA_COST_TRIALS_MAX = 64 };

/*
 * What a plan would put into a trial; `seconds` is 0.
 *
 * unmasked the host lays no mask: whole rectangles are shaded
 * trial    out
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT for NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_cost_trial_of(const cupola_plan *plan, bool unmasked,
                                    struct cupola_cost_trial *trial);

/*
 * Prices from trials, by least squares with no price below 0 (C. Lawson, R. Hanson, Solving least
 * squares problems, 1974), of times that are off by a part of themselves. What is the same in all
 * trials, a warp for instance, is in no price.
 *
 * trials   whose amounts differ, strongly where it can be; one may be of nothing at all
 * count    of them, 3 to 64
 * cost     out: prices in the price of a shaded texel. A price that the trials cannot tell, by its
 *          standard error, is 0, the default, and the others are what goes with that; one that is
 *          told and comes out as nothing is 1e-9. Untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT for NULL, a number of trials or an amount outside of its range, or
 *          trials that cannot tell what a shaded texel costs: they shade the same, or take no
 *          longer where they shade more and nothing else has a price
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_cost_fit(const struct cupola_cost_trial *trials, int count,
                               struct cupola_cost *cost, struct cupola_error *error);

/* Draws one view as a host would: the mask, if it lays one (gl.h), and its scene. */
typedef void cupola_draw_view(cupola_gl *gl, int index, const struct cupola_gl_view *view,
                              void *user);

/*
 * Measures prices: plans a dome in nine ways (few views and many, fewer texels, without the mask),
 * draws each a few times in turn and fits prices to the shortest times. Takes some 54 frames, most
 * of them of fewer texels than the host's own, and nine atlases at once; finishes the GL's work,
 * and makes and destroys everything by itself.
 *
 * wishes   of the plan that is to be made: layout, guard, `unmasked` and so on are kept, prices not
 *          asked; NULL: all zero
 * params   NULL: all zero. Views of the library's own (storage: the atlas); tables, gains and
 *          overlays are left out
 * frame    near, far, clear colour; NULL: all zero
 * draw     called between cupola_gl_view_begin and cupola_gl_view_end of each view
 * user     given to it
 * cost     out: as of cupola_cost_fit, so what could not be told is 0, the default. Where the views
 *          have no mask at all, what an allocated texel costs never can. Untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT for NULL or the host's textures or layers as views
 *          or what cupola_plan_create, cupola_gl_create, cupola_gl_frame_begin,
 *          cupola_gl_view_begin and cupola_cost_fit return; then prices may be left as they are
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_measure_cost(const cupola_dome *dome,
                                      const struct cupola_plan_params *wishes,
                                      const struct cupola_gl_params *params,
                                      const struct cupola_frame *frame, cupola_draw_view *draw,
                                      void *user, struct cupola_cost *cost,
                                      struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
