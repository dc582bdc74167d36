/*
 * Plans that were made before in the same process: cupola_plan_create of the tests that are linked
 * with --wrap=cupola_plan_create. Making a plan takes longer than most of what is tested with it
 * here, and tests/unit has the tests of plans.
 */
#include <stdlib.h>
#include <string.h>

#include "cupola/cupola.h"
#include "geometry/plan.h"

int __real_cupola_plan_create(const cupola_dome *dome, const struct cupola_plan_params *params,
                              cupola_plan **plan, struct cupola_error *error);
int __wrap_cupola_plan_create(const cupola_dome *dome, const struct cupola_plan_params *params,
                              cupola_plan **plan, struct cupola_error *error);

enum { PLANS_MAX = 64 };

static struct {
    struct cupola_dome dome;
    struct cupola_plan_params params;
    cupola_plan *plan;
} made[PLANS_MAX];
static int made_count;

static cupola_plan *copy_of(const cupola_plan *from)
{
    cupola_plan *plan = malloc(sizeof *plan);
    if (plan && plan_copy(from, plan, NULL) == CUPOLA_OK)
        return plan;
    free(plan);
    return NULL;
}

int __wrap_cupola_plan_create(const cupola_dome *dome, const struct cupola_plan_params *params,
                              cupola_plan **plan, struct cupola_error *error)
{
    struct cupola_plan_params wished = {0};
    if (!dome || !plan)
        return __real_cupola_plan_create(dome, params, plan, error);
    if (params)
        wished = *params;
    for (int i = 0; i < made_count; i++)
        if (memcmp(&made[i].dome, dome, sizeof *dome) == 0 &&
            memcmp(&made[i].params, &wished, sizeof wished) == 0 && (*plan = copy_of(made[i].plan)))
            return CUPOLA_OK;
    int status = __real_cupola_plan_create(dome, params, plan, error);
    if (status == CUPOLA_OK && made_count < PLANS_MAX && (made[made_count].plan = copy_of(*plan))) {
        made[made_count].dome = *dome;
        made[made_count++].params = wished;
    }
    return status;
}
