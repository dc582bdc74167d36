/*
 * Base rectangles and sizes of views, from the rays.
 *
 * A cell of the grid falls to every view that one of its corners falls to, and then all its corners
 * count for that view: so no pixel of the cell can lie outside of the rectangle that it is sampled
 * from, and none can get less than the density.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plan.h"
#include "vector.h"
#include "views.h"

/* The density test inside a cell differs from that at its corners by less than this factor. */
static const double density_margin = 1.0002;

/* Middle of a cell, as a direction. */
static void cell_middle(const struct plan_ray *const corners[4], double middle[3])
{
    for (int k = 0; k < 3; k++)
        middle[k] = corners[0]->ray.at[k] + corners[1]->ray.at[k] + corners[2]->ray.at[k] +
                    corners[3]->ray.at[k];
}

static double angle_to(const struct cupola_view *view, const double ray[3])
{
    double q[3];
    transform3(view->rotation, ray, q);
    return atan2(hypot(q[0], q[1]), -q[2]);
}

/* The area of the base plane that a cell covers, its unlit part taken off by its corners. */
static double base_area(const struct cupola_view *view, const struct plan_ray *const corners[4])
{
    double base[4][2], twice = 0;
    int on_screen = 0;
    for (int i = 0; i < 4; i++) {
        if (!view_hit(view, corners[i]->seen, base[i]))
            return 0;
        on_screen += corners[i]->on_screen;
    }
    for (int i = 0; i < 4; i++) {
        const double *a = base[i], *b = base[(i + 1) % 4];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * twice * on_screen / 4;
}

/* Tells which views the cells of a grid fall to. */
static void assign_cells(struct plan_grid *grid, const struct cupola_view *views, int count,
                         struct plan_fit *fit)
{
    size_t corner_count = (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
    memset(grid->views, 0, corner_count);
    for (int row = 0; row < grid->rows; row++)
        for (int column = 0; column < grid->columns; column++) {
            if (!grid->lit[row * grid->columns + column])
                continue;
            const struct plan_ray *corners[4];
            double middle[3];
            plan_cell(grid, column, row, corners);
            cell_middle(corners, middle);
            int own = view_select(views, count, middle);
            unsigned met = 1u << own;
            fit->views[own].cells++;
            fit->views[own].area += grid->sense * base_area(&views[own], corners);
            for (int i = 0; i < 4; i++) {
                int v = view_select(views, count, corners[i]->ray.at);
                met |= 1u << v;
                if (corners[i]->on_screen)
                    fit->views[v].farthest_rad =
                        fmax(fit->views[v].farthest_rad, angle_to(&views[v], corners[i]->seen));
            }
            for (int i = 0; i < 4; i++)
                grid->views[corners[i] - grid->corners] |= (unsigned char)met;
        }
}

/* Widens a view's rectangle to the corners that count for it and collects their footprints. */
static size_t fit_rectangle(const struct plan_rays *rays, const struct cupola_view *view, int v,
                            struct plan_footprint *footprints, double core[4])
{
    size_t count = 0;
    core[0] = core[2] = HUGE_VAL;
    core[1] = core[3] = -HUGE_VAL;
    for (int g = 0; g < rays->count; g++) {
        const struct plan_grid *grid = &rays->grids[g];
        size_t corner_count = (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
        for (size_t i = 0; i < corner_count; i++) {
            double base[2];
            const struct varying *ray = &grid->corners[i].ray;
            if (!(grid->views[i] & 1u << v) || !view_hit(view, ray->at, base))
                continue;
            core[0] = fmin(core[0], base[0]);
            core[1] = fmax(core[1], base[0]);
            core[2] = fmin(core[2], base[1]);
            core[3] = fmax(core[3], base[1]);
            footprints[count++] = plan_footprint_of(view, ray, base);
        }
    }
    return count;
}

static void fit_view(const struct plan_rays *rays, const struct cupola_view *view, int v,
                     const struct plan_sizing *sizing, struct plan_footprint *footprints,
                     struct plan_view_fit *fit)
{
    size_t count = fit_rectangle(rays, view, v, footprints, fit->core);
    if (sizing->view_size_px) {
        double longer = fmax(fit->core[1] - fit->core[0], fit->core[3] - fit->core[2]);
        fit->density[0] = fit->density[1] = sizing->view_size_px / longer;
    } else {
        plan_density_search(footprints, count, fit->density);
        for (int i = 0; i < 2; i++)
            fit->density[i] *= sizing->density * density_margin;
    }
    fit->least_texels_per_pixel = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        fit->least_texels_per_pixel =
            fmin(fit->least_texels_per_pixel, plan_density_reached(&footprints[i], fit->density));
}

int plan_fit_views(struct plan_rays *rays, const struct cupola_view *views, int count,
                   const struct plan_sizing *sizing, struct plan_fit *fit)
{
    size_t corner_count = 0;
    *fit = (struct plan_fit){.complete = true};
    for (int g = 0; g < rays->count; g++) {
        struct plan_grid *grid = &rays->grids[g];
        assign_cells(grid, views, count, fit);
        corner_count += (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
    }
    for (int v = 0; v < count; v++) {
        fit->complete = fit->complete && fit->views[v].cells > 0;
        fit->farthest_rad = fmax(fit->farthest_rad, fit->views[v].farthest_rad);
    }
    if (!fit->complete || fit->farthest_rad > PLAN_REACH_RAD + 1e-9)
        return CUPOLA_ERROR_LAYOUT;

    struct plan_footprint *footprints = malloc(corner_count * sizeof *footprints);
    if (!footprints)
        return CUPOLA_ERROR_MEMORY;
    for (int v = 0; v < count; v++) {
        struct plan_view_fit *view = &fit->views[v];
        fit_view(rays, &views[v], v, sizing, footprints, view);
        fit->texels += (view->core[1] - view->core[0]) * view->density[0] *
                       (view->core[3] - view->core[2]) * view->density[1];
    }
    free(footprints);
    return CUPOLA_OK;
}
