/* Whether views and projector match, by which size they would, and what that leaves. */
#include "advice.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan.h"

static const double close_to_one = 0.05;

/* What the views have, and what they would have by the size that is advised. */
struct finding {
    double fewest; /* texels per pixel along a line */
    double now_px; /* the longest side of the views, without guard bands */
    double enough_px;
    double rim; /* of `fewest`, really, near the rim of a very wide lens */
};

/* Of a view's longer side, without its guard bands. */
static double longer_side(const cupola_plan *plan, int view)
{
    const struct cupola_rect *rect = &plan->views[view].rect;
    return (rect->width > rect->height ? rect->width : rect->height) - 2.0 * plan->guard_px;
}

static bool counts(const struct advice_asked *asked, int view)
{
    return asked->fewest[view] < HUGE_VAL && asked->fewest[view] > 0;
}

static struct finding find(const cupola_plan *plan, const struct advice_asked *asked)
{
    struct finding found = {HUGE_VAL, 0, 0, HUGE_VAL};
    for (int v = 0; v < plan->view_count; v++) {
        if (!counts(asked, v))
            continue;
        double side = longer_side(plan, v);
        found.fewest = fmin(found.fewest, asked->fewest[v]);
        found.now_px = fmax(found.now_px, side);
        found.enough_px = fmax(found.enough_px, ceil(side / asked->fewest[v] - 1e-6));
        found.rim = fmin(found.rim, asked->really[v]);
    }
    return found;
}

/* The least that pixels have once the views' longer sides are as advised. */
static double rim_followed(const cupola_plan *plan, const struct advice_asked *asked,
                           double enough_px)
{
    double rim = HUGE_VAL;
    for (int v = 0; v < plan->view_count; v++)
        if (counts(asked, v))
            rim = fmin(rim, asked->really[v] * enough_px / longer_side(plan, v));
    return rim;
}

static double texels(const cupola_plan *plan)
{
    double sum = 0;
    for (int v = 0; v < plan->view_count; v++)
        sum += (double)plan->views[v].rect.width * plan->views[v].rect.height;
    return sum;
}

/* Of a plan that no size was wished of; 0 where there is no such plan. */
static int texels_without_size(const cupola_plan *plan, double *count, struct cupola_error *error)
{
    struct cupola_plan_params params = plan->params;
    cupola_dome dome = plan->dome;
    cupola_plan *other = NULL;
    struct cupola_error refusal = {0};
    params.view_size_px = 0;
    params.density = 0;
    memcpy(dome.rig.eye_m, plan->planned_eye_m, sizeof dome.rig.eye_m);
    *count = 0;
    int status = cupola_plan_create(&dome, &params, &other, &refusal);
    if (status == CUPOLA_OK)
        *count = texels(other);
    cupola_plan_destroy(&other);
    if (status != CUPOLA_ERROR_MEMORY)
        return CUPOLA_OK;
    if (error)
        *error = refusal;
    return status;
}

static void add_rim(char *advice, double rim)
{
    size_t length = strlen(advice);
    if (rim < 1 - close_to_one)
        snprintf(advice + length, CUPOLA_ADVICE_MAX - length,
                 ", but near the rim of so wide a lens detail is lost: %.2g texels per pixel "
                 "along a line",
                 rim);
}

/* A given size is one for all views, however few pixels fall to some of them. */
static int add_waste(const cupola_plan *plan, char *advice, struct cupola_error *error)
{
    static const double much = 1.2;
    size_t length = strlen(advice);
    double needed, taken = texels(plan);
    int status = texels_without_size(plan, &needed, error);
    if (status == CUPOLA_OK && needed > 0 && taken > much * needed)
        snprintf(advice + length, CUPOLA_ADVICE_MAX - length,
                 "; a plan that chooses each view's size takes %.0f texels instead of %.0f", needed,
                 taken);
    return status;
}

int advice_give(const cupola_plan *plan, const struct advice_asked *asked,
                char advice[CUPOLA_ADVICE_MAX], struct cupola_error *error)
{
    struct finding found = find(plan, asked);
    const char *moving = plan->head_radius_m > 0 ? " for an eye that stayed here" : "";
    bool finer = found.fewest > 1 + close_to_one && found.enough_px < found.now_px;
    bool coarser = found.fewest < 1 - close_to_one && found.enough_px > found.now_px;
    double times = finer ? found.fewest : 1 / found.fewest;
    char factor[24];
    if (!asked->lit) {
        snprintf(advice, CUPOLA_ADVICE_MAX, "no pixel is lit");
        return CUPOLA_OK;
    }
    snprintf(factor, sizeof factor, times < 100 ? "%.3g" : "%.0f", times);
    if (!finer && !coarser)
        snprintf(advice, CUPOLA_ADVICE_MAX, "views and projector match");
    else
        snprintf(advice, CUPOLA_ADVICE_MAX,
                 "views are %sx %s than the projector can show: %.0f px would do%s", factor,
                 finer ? "finer" : "coarser", found.enough_px, finer ? moving : "");
    add_rim(advice, finer || coarser ? rim_followed(plan, asked, found.enough_px) : found.rim);
    if (coarser || !asked->all || plan->params.view_size_px == 0)
        return CUPOLA_OK;
    return add_waste(plan, advice, error);
}
