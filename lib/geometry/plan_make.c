/* From wishes to the views chosen: the samples, the searches, and the exact fit of the cheapest. */
#include <math.h>

#include "plan.h"

/* The families are compared on few samples, the best of them on more. */
enum { COARSE_CELLS = 16, FINE_CELLS = 30 };

int planning_begin(const cupola_dome *dome, const struct cupola_plan_params *params,
                   struct planning *planning, struct cupola_error *error)
{
    *planning = (struct planning){.dome = dome, .params = *params};
    double head_radius_m = params->head_radius_m;
    int status = plan_samples_gather(dome, head_radius_m, COARSE_CELLS, &planning->coarse, error);
    if (status == CUPOLA_OK)
        status = plan_samples_gather(dome, head_radius_m, FINE_CELLS, &planning->fine, error);
    return status;
}

void planning_end(struct planning *planning)
{
    plan_samples_release(&planning->coarse);
    plan_samples_release(&planning->fine);
}

/* The paper's section 3: two passes up to 90 degrees, three up to 140, four beyond. */
static int usual_views(double opening_rad)
{
    const double slack = 1e-6;
    if (opening_rad <= 90 * (pi / 180) + slack)
        return 2;
    return opening_rad <= 140 * (pi / 180) + slack ? 3 : 4;
}

static struct plan_question ask(const struct planning *planning, enum cupola_layout layout,
                                int views, double reach_cosine)
{
    const struct cupola_plan_params *params = &planning->params;
    double pixels = planning->fine.pixels;
    struct plan_question question = {
        .coarse = &planning->coarse,
        .fine = &planning->fine,
        .prices = {.density = params->density,
                   .guard_px = params->guard_px,
                   .view = params->cost.view * pixels,
                   .vertices = params->cost.vertices * pixels,
                   .allocated = params->cost.texel_allocated,
                   .unmasked = params->unmasked,
                   .reach_cosine = reach_cosine},
        .least_views = views ? views : 1,
        .most_views = views ? views : CUPOLA_VIEWS_MAX,
    };
    if (layout == CUPOLA_LAYOUT_ASYMMETRIC && views == 0)
        question.least_views = question.most_views = usual_views(2 * planning->fine.half_rad);
    return question;
}

/*
 * Fits the cheapest choice for which there is an exact fit. `sampled`: without the views that no
 * pixel samples; an image of a few pixels may need them to reach all of what a pixel covers.
 */
static int fit_cheapest(struct planning *planning, const struct plan_prices *prices, bool sampled)
{
    int status = CUPOLA_ERROR_LAYOUT;
    for (int i = 0; i < PLAN_CHOICES && status == CUPOLA_ERROR_LAYOUT; i++) {
        const struct plan_choice *choice = &planning->choices[i];
        if (choice->count == 0 || !(choice->cost < PLAN_IMPOSSIBLE))
            break;
        planning->chosen = i;
        status = plan_exact_fit(planning->dome, choice, prices, planning->params.head_radius_m,
                                sampled, &planning->exact);
    }
    return status;
}

static int solve_within(struct planning *planning, enum cupola_layout layout, int views,
                        double reach_cosine)
{
    struct plan_question question = ask(planning, layout, views, reach_cosine);
    int status = CUPOLA_OK;
    for (int i = 0; i < PLAN_CHOICES; i++)
        planning->choices[i].count = 0;
    if (layout != CUPOLA_LAYOUT_ROTATED)
        status = plan_strips(&question, planning->choices);
    if (layout != CUPOLA_LAYOUT_ASYMMETRIC && status == CUPOLA_OK)
        status = plan_search(&question, planning->choices);
    if (status != CUPOLA_OK)
        return status;
    status = fit_cheapest(planning, &question.prices, true);
    return status == CUPOLA_ERROR_LAYOUT ? fit_cheapest(planning, &question.prices, false) : status;
}

int planning_solve(struct planning *planning, enum cupola_layout layout, int views)
{
    /* Between samples rays may be farther off than any of them: once more, with more to spare. */
    static const double cautious_cosine = 0.276; /* 74 degrees */
    int status = solve_within(planning, layout, views, PLAN_REACH_COSINE);
    if (status == CUPOLA_ERROR_LAYOUT && layout != CUPOLA_LAYOUT_ASYMMETRIC)
        status = solve_within(planning, layout, views, cautious_cosine);
    return status;
}
