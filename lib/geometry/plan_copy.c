/* A plan of one's own: all that a copy has to share with nobody. */
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "plan.h"

int plan_copy(const cupola_plan *from, cupola_plan *to, struct cupola_error *error)
{
    size_t size = (size_t)from->outline.count * sizeof *from->outline.points;
    struct plan_outline_point *points = NULL;
    if (size > 0) {
        points = malloc(size);
        if (!points)
            return error_set(error, CUPOLA_ERROR_MEMORY,
                             "no memory for the outline of a plan (%zu bytes)", size);
        memcpy(points, from->outline.points, size);
    }
    *to = *from;
    to->outline.points = points;
    return CUPOLA_OK;
}

void plan_release(cupola_plan *plan)
{
    free(plan->outline.points);
    plan->outline = (struct plan_outline){0, NULL};
}

/* Bytes between members may differ between equal rigs: then the search is made once more. */
static bool same_rig(const cupola_plan *plan, const struct cupola_rig *rig)
{
    struct cupola_rig planned = plan->dome.rig;
    memcpy(planned.eye_m, plan->planned_eye_m, sizeof planned.eye_m);
    return memcmp(&planned, rig, sizeof planned) == 0;
}

bool plan_serves(const cupola_plan *plan, const cupola_dome *dome,
                 const struct cupola_plan_params *params)
{
    const struct cupola_plan_params *own = &plan->params;
    return own->layout == params->layout && own->views == params->views &&
           own->density == params->density && own->view_size_px == params->view_size_px &&
           own->guard_px == params->guard_px &&
           own->rotation_in_projection == params->rotation_in_projection &&
           own->max_texture_px == params->max_texture_px && own->goal == params->goal &&
           own->cost.view == params->cost.view &&
           own->cost.texel_allocated == params->cost.texel_allocated &&
           own->cost.vertices == params->cost.vertices && own->unmasked == params->unmasked &&
           own->head_radius_m == params->head_radius_m && same_rig(plan, &dome->rig);
}
