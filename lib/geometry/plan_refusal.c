/* Lenses that no layout can serve: which one it is, and how wide it might be. */
#include <math.h>
#include <stdlib.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/* The widest cell of each output, as seen by the eye. */
struct widest {
    const struct plan_rays *rays;
    double angle_rad[CUPOLA_OUTPUTS_MAX];
};

static void widen(const struct plan_grid *grid, const struct plan_ray *const corners[4], void *user)
{
    struct widest *widest = user;
    double *angle = &widest->angle_rad[grid - widest->rays->grids];
    for (int i = 0; i < 2; i++) {
        double across[3];
        cross3(corners[i]->seen, corners[i + 2]->seen, across);
        *angle = fmax(*angle, atan2(length3(across), dot3(corners[i]->seen, corners[i + 2]->seen)));
    }
}

/* The output whose lens spreads a part of its image farthest. */
static int steepest_output(const struct plan_rays *rays)
{
    struct widest widest = {.rays = rays};
    int steepest = 0;
    plan_rays_visit(rays, widen, &widest);
    for (int i = 1; i < rays->count; i++)
        if (widest.angle_rad[i] > widest.angle_rad[steepest])
            steepest = i;
    return steepest;
}

/* Whether any number of views would do if the output's lens were that narrow. */
static bool can_serve(const struct cupola_rig *rig, int output, double fov_rad, int cells_max,
                      const struct plan_sizing *sizing)
{
    struct cupola_rig narrowed = *rig;
    cupola_dome *dome = NULL;
    struct plan_rays rays = {.count = 0};
    struct cupola_view views[CUPOLA_VIEWS_MAX];
    double ignored;
    narrowed.outputs[output].lens.fov_rad = fov_rad;
    bool can = false;
    if (cupola_dome_create(&narrowed, &dome, NULL) == CUPOLA_OK &&
        plan_rays_gather(dome, cells_max, &rays, NULL) == CUPOLA_OK)
        for (int count = CUPOLA_VIEWS_MAX; count > 0 && !can; count--)
            can = plan_layout_rotated(&rays, count, sizing, views, &ignored) > 0;
    plan_rays_release(&rays);
    cupola_dome_destroy(&dome);
    return can;
}

/* The widest lens of whole degrees that can be served, by bisection; 0: none, or a measured lens,
 * which is as wide as it is. */
static int widest_degrees(const struct cupola_rig *rig, int output, int cells_max,
                          const struct plan_sizing *sizing)
{
    const struct cupola_lens *lens = &rig->outputs[output].lens;
    int can = 0, cannot = (int)ceil(lens->fov_rad * (180 / pi) - 1e-9);
    if (lens->model == CUPOLA_LENS_TABLE)
        return 0;
    while (cannot - can > 1) {
        int middle = (can + cannot) / 2;
        if (can_serve(rig, output, middle * (pi / 180), cells_max, sizing))
            can = middle;
        else
            cannot = middle;
    }
    return can;
}

int plan_refuse_lens(const cupola_dome *dome, const struct plan_rays *rays, int cells_max,
                     const struct plan_sizing *sizing, struct cupola_error *error)
{
    int output = steepest_output(rays);
    const struct cupola_lens *lens = &dome->rig.outputs[output].lens;
    const char *name = cupola_lens_model_name((int)lens->model);
    double fov_rad = dome->projectors[output].lens.half_fov * 2;
    int allowed = widest_degrees(&dome->rig, output, cells_max, sizing);
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
