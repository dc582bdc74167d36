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
