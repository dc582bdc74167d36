/*
 * Why a plan is as it is, in one sentence: what was asked for, what was minimised, what it costs.
 */
#include <stdio.h>
#include <string.h>

#include "plan.h"
#include "vector.h"

/* What was asked for, and whether anything was left to be chosen by its cost. */
static const char *choice_text(const struct cupola_plan_params *params, bool single)
{
    if (params->layout == CUPOLA_LAYOUT_AUTO && params->views == 0)
        return single ? " costs least," : " cost least,";
    if (params->layout == CUPOLA_LAYOUT_AUTO)
        return single ? ", its number as asked, costs least,"
                      : ", their number as asked, cost least,";
    if (params->layout == CUPOLA_LAYOUT_ROTATED && params->views == 0)
        return single ? ", rotated as asked, costs least," : ", rotated as asked, cost least,";
    if (params->views == 0)
        return ", layout as asked, number usual, cost";
    return single ? ", as asked, costs" : ", as asked, cost";
}

/* Masks keep what no pixel samples from being shaded; without them all is. */
static void write_texels(const struct cupola_plan_params *params,
                         const struct cupola_plan_report *report, char text[64])
{
    if (params->unmasked)
        snprintf(text, 64, "%.3g shaded, all there are", report->texels_shaded_per_pixel);
    else
        snprintf(text, 64, "%.3g shaded under a mask, of %.3g in all",
                 report->texels_masked_per_pixel, report->texels_shaded_per_pixel);
}

void plan_explain(const struct cupola_plan_params *params, double farthest_rad,
                  struct cupola_plan_report *report)
{
    char drawn[40] = "", texels[64], seen[12];
    bool single = report->views == 1;
    if (params->cost.vertices > 1e-8) /* 1e-9 stands for nothing */
        snprintf(drawn, sizeof drawn, "%.3g of all objects drawn, ", report->directions_drawn);
    write_texels(params, report, texels);
    snprintf(seen, sizeof seen, "%.4g", report->seen_fov_rad * (180 / pi));
    snprintf(report->reason, sizeof report->reason,
             "%d %s view%s (%s)%s %.3g texels a pixel: %s%s; the eye sees %s degree%s, rays are up "
             "to %.3g (of %d) off a view's axis",
             report->views, cupola_layout_name((int)report->layout), single ? "" : "s",
             report->family, choice_text(params, single), report->cost, drawn, texels, seen,
             strcmp(seen, "1") == 0 ? "" : "s", farthest_rad * (180 / pi), PLAN_REACH_MOST_DEG);
}
