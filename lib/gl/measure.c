/* Prices for the planner, by drawing a few plans in turn. */
#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "error.h"
#include "geometry/cost_trials.h"
#include "instance.h"

/* The last trial is a frame of which nothing is drawn: what a frame takes whatever it shows. */
enum { BARE = COST_TRIALS, TRIALS, ROUNDS = 5 };

struct trial {
    cupola_plan *plan;
    cupola_gl *gl;
    struct cupola_cost_trial amounts;
};

static int check_storage(const struct cupola_gl_params *params, struct cupola_error *error)
{
    if (!params || params->storage == CUPOLA_STORAGE_ATLAS)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "storage is %d; allowed: %d, the atlas, since prices are measured by drawing "
                     "into views of the library's own",
                     (int)params->storage, CUPOLA_STORAGE_ATLAS);
}

static int make_trial(const cupola_dome *dome, const struct cupola_plan_params *wishes,
                      const struct cupola_gl_params *params, int index, struct trial *trial,
                      struct cupola_error *error)
{
    struct cupola_gl_params lean = params ? *params : (struct cupola_gl_params){0};
    lean.table = CUPOLA_TABLE_NONE;
    lean.sources = 1u << CUPOLA_SOURCE_VIEWS;
    lean.overlays = false;
    if (cost_trial_is_maskless(index))
        lean.mask = CUPOLA_MASK_NONE;
    int status = cost_trial_plan(dome, wishes, index, &trial->plan, error);
    if (status == CUPOLA_OK)
        status = cupola_gl_create(trial->plan, &lean, &trial->gl, error);
    if (status == CUPOLA_OK)
        cupola_cost_trial_of(trial->plan, trial->gl->mask.kind == CUPOLA_MASK_NONE,
                             &trial->amounts);
    return status;
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

/* One view, and that empty. */
static int draw_bare(cupola_gl *gl, const struct cupola_frame *frame, struct cupola_error *error)
{
    struct cupola_gl_view view;
    int status = cupola_gl_frame_begin(gl, frame, error);
    if (status > 0)
        status = cupola_gl_view_begin(gl, 0, &view, error);
    return status == CUPOLA_OK ? cupola_gl_view_end(gl, error) : status;
}

/* The first round warms up: drivers compile as things are first drawn. */
static int time_trials(struct trial trials[TRIALS], const struct cupola_frame *frame,
                       cupola_draw_view *draw, void *user, struct cupola_error *error)
{
    for (int round = 0; round <= ROUNDS; round++)
        for (int i = 0; i < TRIALS; i++) {
            glFinish();
            double begin_s = clock_now_s();
            int status = i == BARE ? draw_bare(trials[BARE - 1].gl, frame, error)
                                   : draw_frame(trials[i].gl, frame, draw, user, error);
            if (status != CUPOLA_OK)
                return status;
            glFinish();
            double took_s = clock_now_s() - begin_s;
            if (round == 1 || (round > 1 && took_s < trials[i].amounts.seconds))
                trials[i].amounts.seconds = took_s;
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
    int status = check_storage(params, error);
    for (int i = 0; i < COST_TRIALS && status == CUPOLA_OK; i++)
        status = make_trial(dome, wishes, params, i, &trials[i], error);
    if (status == CUPOLA_OK)
        status = time_trials(trials, frame, draw, user, error);
    for (int i = 0; i < TRIALS; i++) {
        amounts[i] = trials[i].amounts;
        cupola_gl_destroy(&trials[i].gl);
        cupola_plan_destroy(&trials[i].plan);
    }
    return status == CUPOLA_OK ? cupola_cost_fit(amounts, TRIALS, cost, error) : status;
}
