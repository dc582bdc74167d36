/*
 * The plans by which prices are measured. They lie as far apart as plans for one dome can: all
 * texels and next to none, as many views as there may be and as few, with masks and without.
 */
#include <math.h>
#include <stddef.h>

#include "cost_trials.h"

/* What a trial wishes otherwise. */
struct variation {
    int views;      /* 0: any number; FEWEST: as few as reach every ray */
    double density; /* times what is wished */
    bool vertices;  /* as for scenes of many triangles */
    bool maskless;
};

enum { FEWEST = -1 };

/* At 1/4 a 16th of the texels: there views and vertices are what takes time. With fewer texels the
 * guard bands would be a large part of the views. */
static const struct variation variations[COST_TRIALS] = {
    {0, 1, false, false},
    {0, 0.5, false, false},
    {0, 0.25, false, false},
    {CUPOLA_VIEWS_MAX, 1, false, false},
    {CUPOLA_VIEWS_MAX, 0.25, false, false},
    {FEWEST, 0.7, true, false},
    {FEWEST, 0.25, true, false},
    {0, 1, false, true},
    {CUPOLA_VIEWS_MAX, 0.7, false, true},
};

bool cost_trial_is_maskless(int index)
{
    return variations[index].maskless;
}

int cost_trial_plan(const cupola_dome *dome, const struct cupola_plan_params *wishes, int index,
                    cupola_plan **plan, struct cupola_error *error)
{
    const struct variation *variation = &variations[index];
    struct cupola_plan_params params = wishes ? *wishes : (struct cupola_plan_params){0};
    double density = params.density > 0 ? params.density : 1;
    params.cost = (struct cupola_cost){0};
    params.earlier = NULL;
    params.view_size_px = 0;
    params.goal = variation->vertices ? CUPOLA_GOAL_VERTICES : CUPOLA_GOAL_FILL;
    /* A density that is no number, or too large, is refused as any other. */
    params.density = density < 1.0 / 16 ? density : fmax(density * variation->density, 1.0 / 16);
    params.views = variation->views == FEWEST ? 1 : variation->views;
    int status = cupola_plan_create(dome, &params, plan, error);
    while (variation->views == FEWEST && status == CUPOLA_ERROR_LAYOUT &&
           params.views++ < CUPOLA_VIEWS_MAX)
        status = cupola_plan_create(dome, &params, plan, error);
    return status;
}
