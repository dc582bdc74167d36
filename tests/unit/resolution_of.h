/* Plans and what is measured of them. */
#ifndef RESOLUTION_OF_H
#define RESOLUTION_OF_H

#include "cupola/resolution.h"
#include "oracle.h"

static inline cupola_plan *plan_of_rig(const struct cupola_rig *rig,
                                       const struct cupola_plan_params *params)
{
    cupola_dome *dome = dome_of(rig);
    cupola_plan *plan = NULL;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_plan_create(dome, params, &plan, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    cupola_dome_destroy(&dome);
    return plan;
}

static inline struct cupola_resolution measured(const cupola_plan *plan, int output)
{
    struct cupola_resolution resolution;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_resolution_measure(plan, output, &resolution, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    return resolution;
}

#endif
