/* Lenses that no layout can serve: which one it is, and how wide it might be. */
#include <math.h>
#include <stdlib.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/* The largest angle that a pixel spans, rad. */
static double steepest_pixel(const struct projector *projector)
{
    enum { STEPS = 64 };
    double steepest = 0;
    for (int i = 0; i <= STEPS; i++) {
        double r = (double)i / STEPS, angle = lens_angle(&projector->lens, r);
        steepest = fmax(steepest, lens_angle_slope(&projector->lens, r, angle));
    }
    return steepest / projector->radius_px;
}

/* The output whose lens spreads a pixel farthest. */
static int steepest_output(const cupola_dome *dome)
{
    int steepest = 0;
    for (int i = 1; i < dome->rig.output_count; i++)
        if (steepest_pixel(&dome->projectors[i]) > steepest_pixel(&dome->projectors[steepest]))
            steepest = i;
    return steepest;
}

/* Whether any number of views would do if the output's lens were that narrow. */
static bool can_serve(const struct planning *planning, int output, double fov_rad)
{
    struct cupola_rig narrowed = planning->dome->rig;
    cupola_dome *dome = NULL;
    struct planning again = {.chosen = 0};
    narrowed.outputs[output].lens.fov_rad = fov_rad;
    bool can = cupola_dome_create(&narrowed, &dome, NULL) == CUPOLA_OK &&
               planning_begin(dome, &planning->params, &again, NULL) == CUPOLA_OK &&
               planning_solve(&again, CUPOLA_LAYOUT_ROTATED, 0) == CUPOLA_OK;
    planning_end(&again);
    cupola_dome_destroy(&dome);
    return can;
}

/* The widest lens of whole degrees that can be served, by bisection; 0: none, or a measured lens,
 * which is as wide as it is. */
static int widest_degrees(const struct planning *planning, int output)
{
    const struct cupola_lens *lens = &planning->dome->rig.outputs[output].lens;
    int can = 0, cannot = (int)ceil(lens->fov_rad * (180 / pi) - 1e-9);
    if (lens->model == CUPOLA_LENS_TABLE)
        return 0;
    while (cannot - can > 1) {
        int middle = (can + cannot) / 2;
        if (can_serve(planning, output, middle * (pi / 180)))
            can = middle;
        else
            cannot = middle;
    }
    return can;
}

/* The lens because of which not even CUPOLA_VIEWS_MAX rotated views reach every ray. */
static int refuse_lens(const struct planning *planning, struct cupola_error *error)
{
    const cupola_dome *dome = planning->dome;
    int output = steepest_output(dome);
    const char *name = cupola_lens_model_name((int)dome->rig.outputs[output].lens.model);
    double fov_rad = dome->projectors[output].lens.half_fov * 2;
    int allowed = widest_degrees(planning, output);
    if (allowed == 0)
        return error_set(
            error, CUPOLA_ERROR_LAYOUT,
            "lens %s of output %d, with a field of view of %g rad (%g degrees), is too "
            "steep for %d views; allowed: rays within 80 degrees of a view's axis",
            name, output, RAD_AND_DEG(fov_rad), CUPOLA_VIEWS_MAX);
    return error_set(error, CUPOLA_ERROR_LAYOUT,
                     "lens %s of output %d, with a field of view of %g rad (%g degrees), is too "
                     "steep about its axis for %d views; allowed here: up to %.4g rad (%d degrees)",
                     name, output, RAD_AND_DEG(fov_rad), CUPOLA_VIEWS_MAX, allowed * (pi / 180),
                     allowed);
}

/* The same for a sphere of another radius. */
static bool can_serve_head(const struct planning *planning, double head_radius_m)
{
    struct planning again = {.chosen = 0};
    struct cupola_plan_params params = planning->params;
    params.head_radius_m = head_radius_m;
    bool can = planning_begin(planning->dome, &params, &again, NULL) == CUPOLA_OK &&
               planning_solve(&again, params.layout, params.views) == CUPOLA_OK;
    planning_end(&again);
    return can;
}

/* The widest sphere, in eighths of what was wished for; 0: not even an eye at rest. */
static double widest_head_m(const struct planning *planning)
{
    enum { PARTS = 8 };
    double unit_m = planning->params.head_radius_m / PARTS;
    int can = 0, cannot = PARTS;
    if (unit_m == 0 || !can_serve_head(planning, 0))
        return 0;
    while (cannot - can > 1) {
        int middle = (can + cannot) / 2;
        if (can_serve_head(planning, middle * unit_m))
            can = middle;
        else
            cannot = middle;
    }
    return can * unit_m;
}

/* The largest angle of a ray to the better one of the two axes that one plane may have. */
static double farthest_of_plane(const struct plan_samples *samples)
{
    double to_host = 1, to_mean = 1;
    for (int i = 0; i < samples->count; i++) {
        to_host = smaller(to_host, -samples->list[i].at[2]);
        to_mean = smaller(to_mean, dot3(samples->list[i].at, samples->mean));
    }
    return acos(larger(larger(to_host, to_mean), -1));
}

int plan_refuse(const struct planning *planning, struct cupola_error *error)
{
    const struct cupola_plan_params *params = &planning->params;
    double head_m = widest_head_m(planning);
    if (head_m > 0)
        return error_set(error, CUPOLA_ERROR_LAYOUT,
                         "head radius is %g m, where eyes see rays more than 80 degrees off every "
                         "view's axis; allowed here: up to %.3g m%s",
                         params->head_radius_m, 0.999 * head_m,
                         params->views && params->views < CUPOLA_VIEWS_MAX ? ", or more views"
                                                                           : "");
    if (params->layout == CUPOLA_LAYOUT_ASYMMETRIC)
        return error_set(error, CUPOLA_ERROR_LAYOUT,
                         "layout asymmetric would have to reach rays %.4g degrees off its axis; "
                         "allowed: up to 80; layout rotated can",
                         farthest_of_plane(&planning->fine) * (180 / pi));
    struct planning again = *planning;
    for (int enough = params->views + 1; params->views && enough <= CUPOLA_VIEWS_MAX; enough++)
        if (planning_solve(&again, CUPOLA_LAYOUT_ROTATED, enough) == CUPOLA_OK)
            return error_set(error, CUPOLA_ERROR_LAYOUT,
                             "layout rotated with %d view%s cannot reach every ray within 80 "
                             "degrees of a view's axis where the eye sees %.4g degrees; allowed: "
                             "at least %d views",
                             params->views, params->views == 1 ? "" : "s",
                             2 * planning->fine.half_rad * (180 / pi), enough);
    return refuse_lens(planning, error);
}
