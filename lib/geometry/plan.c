/* Plans: from wishes to views. */
#include "plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "error.h"
#include "names.h"
#include "vector.h"
#include "views.h"

/* Candidates are compared on a coarse grid of rays, the one chosen is fitted on a fine one. */
enum { COARSE_CELLS = 32, FINE_CELLS = 512 };

static const char *const layout_names[] = {"auto", "asymmetric", "rotated"};

enum { LAYOUT_COUNT = sizeof layout_names / sizeof layout_names[0] };

const char *cupola_layout_name(int layout)
{
    return name_of_number(layout_names, LAYOUT_COUNT, layout);
}

int cupola_layout_find(const char *name)
{
    return number_of_name(layout_names, LAYOUT_COUNT, name);
}

static int check_integer(const char *name, int value, int least, int most,
                         struct cupola_error *error)
{
    if (value >= least && value <= most)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is %d; allowed: %d to %d", name, value,
                     least, most);
}

static int complete_params(const struct cupola_plan_params *wished,
                           struct cupola_plan_params *params, struct cupola_error *error)
{
    *params = wished ? *wished : (struct cupola_plan_params){0};
    if (params->density != 0 && params->view_size_px != 0)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "density is %g and view size is %d texels; allowed: one of them",
                         params->density, params->view_size_px);
    if (params->density == 0)
        params->density = 1;
    if (params->guard_px == 0)
        params->guard_px = 2;
    if (params->max_texture_px == 0)
        params->max_texture_px = 16384;
    int status;
    if ((status = check_integer("layout", (int)params->layout, 0, LAYOUT_COUNT - 1, error)) < 0 ||
        (status = check_integer("number of views", params->views, 0, CUPOLA_VIEWS_MAX, error)) <
            0 ||
        (status = check_integer("guard band in texels", params->guard_px, 1, 256, error)) < 0 ||
        (status = check_integer("view size in texels", params->view_size_px, 0, 16384, error)) <
            0 ||
        (status = check_integer("largest side of the atlas in texels", params->max_texture_px, 64,
                                32768, error)) < 0)
        return status;
    if (!(params->density >= 1.0 / 16 && params->density <= 16))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "density is %g; allowed: 0.0625 to 16",
                         params->density);
    return CUPOLA_OK;
}

/* The paper's section 3: two passes up to 90 degrees, three up to 140, four beyond. */
static int usual_views(double opening_rad)
{
    const double slack = 1e-6;
    if (opening_rad <= 90 * (pi / 180) + slack)
        return 2;
    return opening_rad <= 140 * (pi / 180) + slack ? 3 : 4;
}

/* Everything that a plan is made with. */
struct planning {
    struct cupola_plan_params params;
    struct plan_sizing sizing;
    struct plan_rays coarse, fine;
    struct plan_fit fit;
};

/* Chooses views on the coarse grid and fits them on the fine one. Returns their number. */
static int try_layout(struct planning *planning, enum cupola_layout layout, int count,
                      struct cupola_view *views, double *farthest_rad)
{
    int found =
        layout == CUPOLA_LAYOUT_ASYMMETRIC
            ? plan_layout_asymmetric(&planning->coarse, count, &planning->sizing, views,
                                     farthest_rad)
            : plan_layout_rotated(&planning->coarse, count, &planning->sizing, views, farthest_rad);
    if (found < 0)
        return found;
    int status = plan_fit_views(&planning->fine, views, found, &planning->sizing, &planning->fit);
    *farthest_rad = fmax(*farthest_rad, planning->fit.farthest_rad);
    return status == CUPOLA_OK ? found : status;
}

static int refuse_asymmetric(double farthest_rad, struct cupola_error *error)
{
    return error_set(error, CUPOLA_ERROR_LAYOUT,
                     "layout asymmetric would have to reach rays %.4g degrees off its axis; "
                     "allowed: up to 80; layout rotated can",
                     farthest_rad * (180 / pi));
}

/* Names the least number of views that would do, or else the lens for which none does. */
static int refuse_rotated(struct planning *planning, const cupola_dome *dome, int count,
                          double farthest_rad, struct cupola_error *error)
{
    for (int enough = count + 1; enough <= CUPOLA_VIEWS_MAX; enough++) {
        struct cupola_view views[CUPOLA_VIEWS_MAX];
        double ignored;
        if (try_layout(planning, CUPOLA_LAYOUT_ROTATED, enough, views, &ignored) > 0)
            return error_set(error, CUPOLA_ERROR_LAYOUT,
                             "layout rotated with %d view%s would have to reach rays %.4g degrees "
                             "off a view's axis, more than 80; allowed: at least %d views",
                             count, count == 1 ? "" : "s", farthest_rad * (180 / pi), enough);
    }
    return plan_refuse_lens(dome, &planning->coarse, COARSE_CELLS, &planning->sizing, error);
}

static int choose_views(struct planning *planning, cupola_plan *plan, struct cupola_error *error)
{
    const struct cupola_plan_params *params = &planning->params;
    int usual = usual_views(planning->fine.opening_rad);
    int count = params->views ? params->views : usual;
    double farthest = 0;
    int found = CUPOLA_ERROR_LAYOUT;
    if (params->layout != CUPOLA_LAYOUT_ROTATED) {
        found = try_layout(planning, CUPOLA_LAYOUT_ASYMMETRIC, count, plan->views, &farthest);
        plan->report.layout = CUPOLA_LAYOUT_ASYMMETRIC;
        if (found == CUPOLA_ERROR_LAYOUT && params->layout == CUPOLA_LAYOUT_ASYMMETRIC)
            return refuse_asymmetric(farthest, error);
    }
    if (found == CUPOLA_ERROR_LAYOUT) {
        plan->report.layout = CUPOLA_LAYOUT_ROTATED;
        int most = params->views ? count : CUPOLA_VIEWS_MAX;
        for (; count <= most && found == CUPOLA_ERROR_LAYOUT; count++)
            found = try_layout(planning, CUPOLA_LAYOUT_ROTATED, count, plan->views, &farthest);
        if (found == CUPOLA_ERROR_LAYOUT)
            return refuse_rotated(planning, &plan->dome, most, farthest, error);
    }
    if (found < 0)
        return error_set(error, (enum cupola_status)found, "no memory for a plan");
    plan->view_count = found;
    snprintf(plan->report.reason, sizeof plan->report.reason,
             "%d %s view%s: the eye sees %.4g degrees and the farthest ray is %.4g degrees off a "
             "view's axis (up to 80)",
             found, layout_names[plan->report.layout], found == 1 ? "" : "s",
             planning->fine.opening_rad * (180 / pi), planning->fit.farthest_rad * (180 / pi));
    return CUPOLA_OK;
}

/* Whole texels, and the guard band round them. */
static int size_views(const struct planning *planning, cupola_plan *plan,
                      struct cupola_error *error)
{
    int guard = planning->params.guard_px, limit = planning->params.max_texture_px;
    for (int v = 0; v < plan->view_count; v++) {
        const struct plan_view_fit *fit = &planning->fit.views[v];
        struct cupola_view *view = &plan->views[v];
        double extent[2] = {fit->core[1] - fit->core[0], fit->core[3] - fit->core[2]};
        /* A size asked for by hand must not grow by a rounding error. */
        double texels[2] = {fmax(ceil(extent[0] * fit->density[0] - 1e-9), 1),
                            fmax(ceil(extent[1] * fit->density[1] - 1e-9), 1)};
        if (!(texels[0] + 2 * guard <= limit && texels[1] + 2 * guard <= limit))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "view %d would be %.0f x %.0f texels; allowed: up to %d each way; "
                             "a lower density or more views make it smaller",
                             v, texels[0] + 2 * guard, texels[1] + 2 * guard, limit);
        double guard_u = guard * extent[0] / texels[0], guard_v = guard * extent[1] / texels[1];
        view->left = fit->core[0] - guard_u;
        view->right = fit->core[1] + guard_u;
        view->bottom = fit->core[2] - guard_v;
        view->top = fit->core[3] + guard_v;
        view->rect.width = (int)texels[0] + 2 * guard;
        view->rect.height = (int)texels[1] + 2 * guard;
    }
    return CUPOLA_OK;
}

static void report_costs(const struct planning *planning, cupola_plan *plan)
{
    struct cupola_plan_report *report = &plan->report;
    double shaded = 0, sampled = 0;
    report->least_texels_per_pixel = HUGE_VAL;
    for (int v = 0; v < plan->view_count; v++) {
        const struct cupola_view *view = &plan->views[v];
        const struct plan_view_fit *fit = &planning->fit.views[v];
        double density[2] = {view->rect.width / (view->right - view->left),
                             view->rect.height / (view->top - view->bottom)};
        /* Rounding up to whole texels gave a little more than the fit asked for. */
        double gain = fmin(density[0] / fit->density[0], density[1] / fit->density[1]);
        report->least_texels_per_pixel =
            fmin(report->least_texels_per_pixel, gain * fit->least_texels_per_pixel);
        shaded += (double)view->rect.width * view->rect.height;
        sampled += fit->area * density[0] * density[1];
    }
    report->views = plan->view_count;
    report->pixels = planning->fine.pixels;
    report->seen_fov_rad = planning->fine.opening_rad;
    report->texels_allocated_per_pixel =
        (double)report->atlas_width_px * report->atlas_height_px / report->pixels;
    report->texels_shaded_per_pixel = shaded / report->pixels;
    report->texels_sampled_per_pixel = sampled / report->pixels;
}

int cupola_plan_create(const cupola_dome *dome, const struct cupola_plan_params *params,
                       cupola_plan **plan, struct cupola_error *error)
{
    if (!dome || !plan)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: a %s",
                         dome ? "plan" : "dome", dome ? "place for a plan" : "dome");
    struct planning planning = {.sizing = {0}};
    cupola_plan *made = NULL;
    int status = complete_params(params, &planning.params, error);
    if (status != CUPOLA_OK)
        return status;
    planning.sizing = (struct plan_sizing){planning.params.density, planning.params.view_size_px,
                                           planning.params.guard_px};
    if ((status = plan_rays_gather(dome, COARSE_CELLS, &planning.coarse, error)) != CUPOLA_OK ||
        (status = plan_rays_gather(dome, FINE_CELLS, &planning.fine, error)) != CUPOLA_OK)
        goto done;
    made = calloc(1, sizeof *made);
    if (!made) {
        status = error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a plan");
        goto done;
    }
    made->dome = *dome;
    made->rotation_in_projection = planning.params.rotation_in_projection;
    if ((status = choose_views(&planning, made, error)) != CUPOLA_OK ||
        (status = size_views(&planning, made, error)) != CUPOLA_OK ||
        (status = plan_atlas_pack(made->views, made->view_count, planning.params.max_texture_px,
                                  &made->report.atlas_width_px, &made->report.atlas_height_px,
                                  error)) != CUPOLA_OK)
        goto done;
    report_costs(&planning, made);
    *plan = made;
    made = NULL;
done:
    plan_rays_release(&planning.coarse);
    plan_rays_release(&planning.fine);
    free(made);
    return status;
}

void cupola_plan_destroy(cupola_plan **plan)
{
    if (!plan)
        return;
    free(*plan);
    *plan = NULL;
}

int cupola_plan_view_count(const cupola_plan *plan)
{
    return plan ? plan->view_count : 0;
}

const struct cupola_view *cupola_plan_view(const cupola_plan *plan, int index)
{
    return plan && index >= 0 && index < plan->view_count ? &plan->views[index] : NULL;
}

const cupola_dome *cupola_plan_dome(const cupola_plan *plan)
{
    return plan ? &plan->dome : NULL;
}

const struct cupola_plan_report *cupola_plan_report(const cupola_plan *plan)
{
    return plan ? &plan->report : NULL;
}

int cupola_plan_select(const cupola_plan *plan, const double direction[3])
{
    if (!plan || !direction)
        return CUPOLA_ERROR_ARGUMENT;
    return view_select(plan->views, plan->view_count, direction);
}

int cupola_plan_texel(const cupola_plan *plan, int index, const double direction[3],
                      double texel[2])
{
    double base[2];
    if (!plan || !direction || !texel || index < 0 || index >= plan->view_count)
        return CUPOLA_ERROR_ARGUMENT;
    if (!view_hit(&plan->views[index], direction, base))
        return 0;
    view_texel(&plan->views[index], base, texel);
    return 1;
}
