/* Prices for the planner, by drawing a few plans in turn. */
#include <epoxy/gl.h>
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "cupola/cost.h"
#include "error.h"

enum { TRIALS = 5, ROUNDS = 5 };

/* What a trial wishes otherwise. */
struct variation {
    int views;      /* 0: any number */
    double density; /* times what is wished */
    int guard;      /* texels more for every pixel of the largest output's side / 1000 */
};

/* Shading, rectangles, views and objects that are drawn twice, each changed with few others. */
static const struct variation variations[TRIALS] = {
    {0, 1, 0}, {0, 0.5, 0}, {5, 1, 0}, {0, 1, 30}, {8, 0.5, 0}};

struct trial {
    cupola_plan *plan;
    cupola_gl *gl;
    struct cupola_cost_trial amounts;
};

static int largest_side_px(const cupola_dome *dome)
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    int side = 1;
    for (int i = 0; i < rig->output_count; i++) {
        side = rig->outputs[i].width_px > side ? rig->outputs[i].width_px : side;
        side = rig->outputs[i].height_px > side ? rig->outputs[i].height_px : side;
    }
    return side;
}

static int plan_trial(const cupola_dome *dome, const struct cupola_plan_params *wishes, int index,
                      struct trial *trial, struct cupola_error *error)
{
    struct cupola_plan_params params = wishes ? *wishes : (struct cupola_plan_params){0};
    const struct variation *variation = &variations[index];
    int more = variation->guard * largest_side_px(dome) / 1000;
    double density = params.density > 0 ? params.density : 1;
    params.cost = (struct cupola_cost){0};
    params.earlier = NULL;
    params.view_size_px = 0;
    params.views = variation->views;
    params.density = fmax(density * variation->density, 1.0 / 16);
    params.guard_px = (params.guard_px > 0 ? params.guard_px : 2) + more;
    if (params.guard_px > 256)
        params.guard_px = 256;
    int status = cupola_plan_create(dome, &params, &trial->plan, error);
    /* Few views do not reach every ray of a wide dome. */
    if (status == CUPOLA_ERROR_LAYOUT && params.views > 0) {
        params.views = CUPOLA_VIEWS_MAX;
        status = cupola_plan_create(dome, &params, &trial->plan, error);
    }
    if (status == CUPOLA_OK)
        cupola_cost_trial_of(trial->plan, params.unmasked, &trial->amounts);
    return status;
}

static int make_trials(const cupola_dome *dome, const struct cupola_plan_params *wishes,
                       const struct cupola_gl_params *params, struct trial trials[TRIALS],
                       struct cupola_error *error)
{
    struct cupola_gl_params lean = params ? *params : (struct cupola_gl_params){0};
    lean.table = CUPOLA_TABLE_NONE;
    lean.sources = 1u << CUPOLA_SOURCE_VIEWS;
    lean.overlays = false;
    for (int i = 0; i < TRIALS; i++) {
        int status = plan_trial(dome, wishes, i, &trials[i], error);
        if (status == CUPOLA_OK)
            status = cupola_gl_create(trials[i].plan, &lean, &trials[i].gl, error);
        if (status != CUPOLA_OK)
            return status;
    }
    return CUPOLA_OK;
}

static double now_s(void)
{
    struct timespec now = {0, 0};
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int draw_frame(cupola_gl *gl, const struct cupola_frame *frame, cupola_draw_view *draw,
                      void *user, struct cupola_error *error)
{
    int views = cupola_gl_frame_begin(gl, frame, error);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        int status = cupola_gl_view_begin(gl, i, &view, error);
        if (status != CUPOLA_OK)
            return status;
        draw(gl, i, &view, user);
        status = cupola_gl_view_end(gl, error);
        if (status != CUPOLA_OK)
            return status;
    }
    return views > 0 ? CUPOLA_OK : views;
}

/* The first round warms up: drivers compile as things are first drawn. */
static int time_trials(struct trial trials[TRIALS], const struct cupola_frame *frame,
                       cupola_draw_view *draw, void *user, struct cupola_error *error)
{
    for (int round = 0; round <= ROUNDS; round++)
        for (int i = 0; i < TRIALS; i++) {
            glFinish();
            double begin = now_s();
            int status = draw_frame(trials[i].gl, frame, draw, user, error);
            if (status != CUPOLA_OK)
                return status;
            glFinish();
            double took = fmax(now_s() - begin, 0);
            if (round == 1 || (round > 1 && took < trials[i].amounts.seconds))
                trials[i].amounts.seconds = took;
        }
    return CUPOLA_OK;
}

int cupola_gl_measure_cost(const cupola_dome *dome, const struct cupola_plan_params *wishes,
                           const struct cupola_gl_params *params, const struct cupola_frame *frame,
                           cupola_draw_view *draw, void *user, struct cupola_cost *cost,
                           struct cupola_error *error)
{
    struct trial trials[TRIALS] = {{.plan = NULL}};
    struct cupola_cost_trial amounts[TRIALS];
    if (!dome || !draw || !cost)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: %s",
                         !dome ? "dome" : (!draw ? "draw" : "cost"),
                         !dome ? "a dome" : (!draw ? "a function" : "a place for prices"));
    int status = make_trials(dome, wishes, params, trials, error);
    if (status == CUPOLA_OK)
        status = time_trials(trials, frame, draw, user, error);
    for (int i = 0; i < TRIALS; i++) {
        amounts[i] = trials[i].amounts;
        cupola_gl_destroy(&trials[i].gl);
        cupola_plan_destroy(&trials[i].plan);
    }
    return status == CUPOLA_OK ? cupola_cost_fit(amounts, TRIALS, cost, error) : status;
}
