/* Plans: from wishes to views, and views that follow the eye. */
#include "plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "error.h"
#include "names.h"
#include "vector.h"
#include "views.h"

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

static int check_price(const char *name, double value, struct cupola_error *error)
{
    if (value >= 0 && value <= 1e6)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is %g; allowed: 0 to 1e6", name, value);
}

static int complete_prices(struct cupola_plan_params *params, struct cupola_error *error)
{
    struct cupola_cost *cost = &params->cost;
    int status;
    if ((status = check_integer("goal", (int)params->goal, 0, CUPOLA_GOAL_VERTICES, error)) < 0 ||
        (status = check_price("price of a view", cost->view, error)) < 0 ||
        (status = check_price("price of an allocated texel", cost->texel_allocated, error)) < 0 ||
        (status = check_price("price of all vertices", cost->vertices, error)) < 0)
        return status;
    if (cost->view == 0)
        cost->view = PLAN_VIEW_USUAL;
    if (cost->texel_allocated == 0)
        cost->texel_allocated = PLAN_ALLOCATED_USUAL;
    if (cost->vertices == 0 && params->goal == CUPOLA_GOAL_VERTICES)
        cost->vertices = 100;
    return CUPOLA_OK;
}

/* The sphere that the eye moves in keeps away from the screen. */
static int check_head(const cupola_dome *dome, double head_radius_m, struct cupola_error *error)
{
    double most = 0.9 * dome->rig.screen.radius_m - length3(dome->rig.eye_m);
    if (head_radius_m == 0 || (head_radius_m > 0 && head_radius_m <= most))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "head radius is %g m; allowed: 0 to %g m, which is 9/10 of the screen's "
                     "radius less the eye's distance from its centre",
                     head_radius_m, fmax(most, 0));
}

static int complete_params(const cupola_dome *dome, const struct cupola_plan_params *wished,
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
    status = complete_prices(params, error);
    return status == CUPOLA_OK ? check_head(dome, params->head_radius_m, error) : status;
}

/* Whole texels, and the guard band round them. */
static int size_view(const struct cupola_plan_params *params, const struct plan_exact_view *fit,
                     int index, struct cupola_view *view, struct cupola_error *error)
{
    static const double texel_slack = 2 * PLAN_TEXEL_SLACK;
    int guard = params->guard_px, limit = params->max_texture_px;
    double texels[2], density[2], longer = 0;
    for (int axis = 0; axis < 2; axis++)
        longer = fmax(longer, fit->extent[axis] * fit->density[axis] + texel_slack);
    double factor = params->view_size_px ? params->view_size_px / longer : 1;
    for (int axis = 0; axis < 2; axis++) {
        density[axis] = factor * fit->density[axis];
        /* A size asked for by hand must not grow by a rounding error. */
        double exact = factor * (fit->extent[axis] * fit->density[axis] + texel_slack);
        texels[axis] = fmax(ceil(exact - 1e-9), 1) + 2 * guard;
    }
    if (!(texels[0] <= limit && texels[1] <= limit))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "view %d would be %.0f x %.0f texels; allowed: up to %d each way; "
                         "a lower density or more views make it smaller",
                         index, texels[0], texels[1], limit);
    memcpy(view->rotation, fit->rotation, sizeof view->rotation);
    memcpy(view->selector, fit->selector, sizeof view->selector);
    view->rect.width = (int)texels[0];
    view->rect.height = (int)texels[1];
    /* Rounding up widens the rectangle and not the density: under a mask that is free. */
    view->left = 0;
    view->right = texels[0] / density[0];
    view->bottom = 0;
    view->top = texels[1] / density[1];
    return CUPOLA_OK;
}

/* Moves a base rectangle, whose size is set, so that what the rays meet is in its middle. */
static void center_view(const double core[4], struct cupola_view *view)
{
    double half_width = 0.5 * (view->right - view->left);
    double half_height = 0.5 * (view->top - view->bottom);
    double u = 0.5 * (core[0] + core[1]), v = 0.5 * (core[2] + core[3]);
    view->left = u - half_width;
    view->right = u + half_width;
    view->bottom = v - half_height;
    view->top = v + half_height;
}

static void refit(cupola_plan *plan, const double eye_m[3])
{
    double core[4];
    for (int v = 0; v < plan->view_count; v++)
        if (plan_outline_core(plan, eye_m, v, core, NULL))
            center_view(core, &plan->views[v]);
}

static int size_views(const struct planning *planning, cupola_plan *plan,
                      struct cupola_error *error)
{
    plan->view_count = planning->exact.count;
    for (int v = 0; v < plan->view_count; v++) {
        const struct plan_exact_view *fit = &planning->exact.views[v];
        int status = size_view(&planning->params, fit, v, &plan->views[v], error);
        if (status != CUPOLA_OK)
            return status;
        center_view(fit->core, &plan->views[v]);
    }
    return CUPOLA_OK;
}

/* What one view adds to the sums of a report, in texels. */
static void add_view(const struct planning *planning, const struct cupola_view *view,
                     const struct plan_exact_view *fit, struct cupola_plan_report *report)
{
    double density[2] = {view->rect.width / (view->right - view->left),
                         view->rect.height / (view->top - view->bottom)};
    double rect = (double)view->rect.width * view->rect.height;
    double width = (fit->core[1] - fit->core[0]) * density[0];
    double height = (fit->core[3] - fit->core[2]) * density[1];
    double guard = 2 * planning->params.guard_px;
    /* What two outputs see is in the area twice. */
    double sampled = fmin(fit->area * density[0] * density[1], rect);
    report->texels_shaded_per_pixel += rect;
    report->texels_sampled_per_pixel += sampled;
    /* A shape without dents, widened by a square, gains its rectangle's sides. */
    report->texels_masked_per_pixel += fmin(sampled + guard * (width + height + guard), rect);
    report->least_texels_per_pixel =
        fmin(report->least_texels_per_pixel, fit->least * density[0] / fit->density[0]);
}

static void report_costs(const struct planning *planning, cupola_plan *plan)
{
    struct cupola_plan_report *report = &plan->report;
    const struct cupola_plan_params *params = &planning->params;
    const struct plan_choice *choice = &planning->choices[planning->chosen];
    double pixels = planning->exact.pixels, farthest = 0;
    report->least_texels_per_pixel = HUGE_VAL;
    for (int v = 0; v < plan->view_count; v++) {
        add_view(planning, &plan->views[v], &planning->exact.views[v], report);
        farthest = fmax(farthest, planning->exact.views[v].farthest_rad);
    }
    report->layout = choice->layout;
    report->directions_drawn = choice->drawn;
    report->views = plan->view_count;
    report->pixels = pixels;
    report->seen_fov_rad = 2 * planning->fine.half_rad;
    report->texels_allocated_per_pixel =
        (double)report->atlas_width_px * report->atlas_height_px / pixels;
    report->texels_shaded_per_pixel /= pixels;
    report->texels_sampled_per_pixel /= pixels;
    report->texels_masked_per_pixel /= pixels;
    double filled =
        params->unmasked ? report->texels_shaded_per_pixel : report->texels_masked_per_pixel;
    report->cost = filled + params->cost.texel_allocated * report->texels_shaded_per_pixel +
                   params->cost.view * plan->view_count + params->cost.vertices * choice->drawn;
    if (plan->view_count == choice->count)
        memcpy(report->family, choice->family, sizeof report->family);
    else
        snprintf(report->family, sizeof report->family, "%d", plan->view_count);
    plan_explain(params, farthest, report);
}

/* What is needed to move the eye later. */
static int prepare_moves(const struct planning *planning, cupola_plan *plan,
                         struct cupola_error *error)
{
    plan->head_radius_m = planning->params.head_radius_m;
    memcpy(plan->planned_eye_m, plan->dome.rig.eye_m, sizeof plan->planned_eye_m);
    if (plan->head_radius_m == 0)
        return CUPOLA_OK;
    if (plan_outline_trace(&plan->dome, &plan->outline) != CUPOLA_OK)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the outline of a plan");
    refit(plan, plan->dome.rig.eye_m);
    return CUPOLA_OK;
}

static int finish(struct planning *planning, cupola_plan *plan, struct cupola_error *error)
{
    const struct cupola_plan_params *params = &planning->params;
    int status = planning_solve(planning, params->layout, params->views);
    if (status == CUPOLA_ERROR_LAYOUT)
        return plan_refuse(planning, error);
    if (status != CUPOLA_OK)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a plan");
    if ((status = size_views(planning, plan, error)) != CUPOLA_OK ||
        (status = plan_atlas_pack(plan->views, plan->view_count, params->max_texture_px,
                                  &plan->report.atlas_width_px, &plan->report.atlas_height_px,
                                  error)) != CUPOLA_OK)
        return status;
    report_costs(planning, plan);
    return prepare_moves(planning, plan, error);
}

/* The views of a plan whose eye may have moved since. */
static int take_over(const cupola_plan *earlier, const cupola_dome *dome, cupola_plan *made,
                     struct cupola_error *error)
{
    int status = plan_copy(earlier, made, error);
    if (status != CUPOLA_OK)
        return status;
    bool moved = memcmp(made->dome.rig.eye_m, dome->rig.eye_m, sizeof dome->rig.eye_m) != 0;
    made->dome = *dome;
    if (moved)
        refit(made, dome->rig.eye_m);
    return CUPOLA_OK;
}

int cupola_plan_create(const cupola_dome *dome, const struct cupola_plan_params *params,
                       cupola_plan **plan, struct cupola_error *error)
{
    if (!dome || !plan)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: a %s",
                         dome ? "plan" : "dome", dome ? "place for a plan" : "dome");
    struct cupola_plan_params complete;
    struct planning planning;
    int status = complete_params(dome, params, &complete, error);
    if (status != CUPOLA_OK)
        return status;
    cupola_plan *made = calloc(1, sizeof *made);
    if (!made)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a plan");
    if (complete.earlier && plan_serves(complete.earlier, dome, &complete)) {
        status = take_over(complete.earlier, dome, made, error);
        goto done;
    }
    made->dome = *dome;
    made->params = complete;
    made->params.earlier = NULL;
    made->rotation_in_projection = complete.rotation_in_projection;
    made->guard_px = complete.guard_px;
    made->unmasked = complete.unmasked;
    status = planning_begin(dome, &complete, &planning, error);
    if (status == CUPOLA_OK)
        status = finish(&planning, made, error);
    planning_end(&planning);
done:
    if (status != CUPOLA_OK)
        cupola_plan_destroy(&made);
    else
        *plan = made;
    return status;
}

int cupola_plan_set_eye(cupola_plan *plan, const double eye_m[3], struct cupola_error *error)
{
    if (!plan || !eye_m)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: %s",
                         plan ? "eye" : "plan", plan ? "a place in the dome" : "a plan");
    double apart[3];
    for (int i = 0; i < 3; i++)
        apart[i] = eye_m[i] - plan->planned_eye_m[i];
    double distance = length3(apart);
    if (!(distance <= plan->head_radius_m * (1 + 1e-9)))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "eye is %g m from where the plan has it; allowed: up to its head radius, "
                         "%g m",
                         distance, plan->head_radius_m);
    if (plan->head_radius_m > 0)
        refit(plan, eye_m);
    memcpy(plan->dome.rig.eye_m, eye_m, sizeof plan->dome.rig.eye_m);
    return CUPOLA_OK;
}

void cupola_plan_destroy(cupola_plan **plan)
{
    if (!plan)
        return;
    if (*plan)
        plan_release(*plan);
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
