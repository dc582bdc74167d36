/* The rays of one pixel, for hosts that ask. */
#include "error.h"
#include "filter.h"
#include "plan.h"
#include "vector.h"

static int check_pixel(const cupola_plan *plan, int output, int x, int y,
                       struct cupola_error *error)
{
    int count = plan->dome.rig.output_count;
    if (output < 0 || output >= count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "output is %d; allowed: 0 to %d", output,
                         count - 1);
    const struct cupola_output *size = &plan->dome.rig.outputs[output];
    if (x < 0 || x >= size->width_px)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "column x is %d px; allowed: 0 to %d", x,
                         size->width_px - 1);
    if (y < 0 || y >= size->height_px)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "row y is %d px; allowed: 0 to %d", y,
                         size->height_px - 1);
    return CUPOLA_OK;
}

int cupola_filter_rays(const struct cupola_filter *filter, const cupola_plan *plan, int output,
                       int x, int y, struct cupola_pixel_ray rays[CUPOLA_RAYS_MAX],
                       struct cupola_error *error)
{
    struct cupola_filter complete;
    struct filter_pixel pixel;
    struct pattern pattern;
    struct filter_place places[CUPOLA_RAYS_MAX];
    int status = filter_check(filter, &complete, error);
    if (status != CUPOLA_OK)
        return status;
    if (!plan || !rays)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: %s",
                         plan ? "rays" : "plan", plan ? "a place for them" : "a plan");
    status = check_pixel(plan, output, x, y, error);
    if (status != CUPOLA_OK)
        return status;
    filter_pixel_prepare(plan, output, x, y, &pixel);
    if (!(pixel.coverage > 0))
        return 0;
    int places_needed = filter_pattern_count(&complete, &pixel);
    if (places_needed > 0)
        filter_pattern(&complete, places_needed, &pattern);
    int count = filter_places(&complete, &pattern, &pixel, places);
    for (int k = 0; k < count; k++) {
        rays[k] = (struct cupola_pixel_ray){places[k].x_px, places[k].y_px, places[k].weight, {0}};
        filter_direction(&pixel, &places[k], rays[k].direction);
        scale3(rays[k].direction, 1 / length3(rays[k].direction));
    }
    return count;
}
