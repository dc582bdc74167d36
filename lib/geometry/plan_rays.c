/* The rays of all outputs on a grid of places, and what they have in common. */
#include <math.h>
#include <stdlib.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/*
 * Towards the rim of a lens of nearly 360 degrees a pixel covers no angle at all across the radius,
 * since the whole rim shows one point, and no finite density would do. There a pixel counts as no
 * narrower than a quarter of the lens's mean radial step; up to 280 degrees this changes nothing.
 */
static void widen_collapsed(const struct projector *projector, const double place[2],
                            struct varying *ray)
{
    double r = hypot(place[0], place[1]);
    if (!(r > 0.5))
        return;
    double sine = sin(lens_angle(&projector->lens, fmin(r, 1)));
    double missing = (0.25 * projector->lens.half_fov - sine / r) / projector->radius_px;
    if (!(missing > 0))
        return;
    double tangent[3] = {-place[1] / r, place[0] / r, 0}, in_dome[3];
    transform3(projector->aim, tangent, in_dome);
    for (int i = 0; i < 3; i++) {
        ray->dx[i] += missing * projector->sign[0] * tangent[0] * in_dome[i];
        ray->dy[i] += missing * projector->sign[1] * tangent[1] * in_dome[i];
    }
}

static void trace_corner(const cupola_dome *dome, const struct projector *projector, double x_px,
                         double y_px, double step_px, struct plan_ray *corner)
{
    double place[2];
    struct varying lens, point;
    circle_place(projector, x_px, y_px, place);
    lens_ray(projector, place, &lens);
    widen_collapsed(projector, place, &lens);
    screen_point(projector, &lens, &point);
    eye_ray(dome, dome->rig.eye_m, &point, &corner->ray);
    for (int i = 0; i < 2; i++)
        corner->place_px[i] =
            projector->center_px[i] + projector->sign[i] * projector->radius_px * place[i];
    double excess_m = -point.at[2] - projector->cap_cosine * projector->screen_radius_m;
    double slope = fabs(point.dx[2]) + fabs(point.dy[2]);
    corner->on_screen = !projector->capped || excess_m >= 0;
    corner->near_screen = corner->on_screen || excess_m >= -slope * step_px;
}

/* Whether image circle and screen reach into a cell. */
static bool cell_is_lit(const struct projector *projector, const struct plan_ray *const corners[4],
                        double x_px, double y_px, double step_px)
{
    double nearest_x = fmin(fmax(projector->center_px[0], x_px), x_px + step_px);
    double nearest_y = fmin(fmax(projector->center_px[1], y_px), y_px + step_px);
    double distance =
        hypot(nearest_x - projector->center_px[0], nearest_y - projector->center_px[1]);
    if (!(distance < projector->radius_px))
        return false;
    return corners[0]->near_screen || corners[1]->near_screen || corners[2]->near_screen ||
           corners[3]->near_screen;
}

static int gather_grid(const cupola_dome *dome, const struct projector *projector, int cells_max,
                       struct plan_grid *grid)
{
    double larger = fmax(projector->width_px, projector->height_px);
    double step = ceil(larger / cells_max);
    grid->columns = (int)ceil(projector->width_px / step);
    grid->rows = (int)ceil(projector->height_px / step);
    size_t corner_count = (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
    grid->corners = malloc(corner_count * sizeof *grid->corners);
    grid->lit = malloc((size_t)grid->columns * (size_t)grid->rows);
    grid->views = malloc(corner_count);
    if (!grid->corners || !grid->lit || !grid->views)
        return CUPOLA_ERROR_MEMORY;

    for (int row = 0; row <= grid->rows; row++)
        for (int column = 0; column <= grid->columns; column++)
            trace_corner(dome, projector, fmin(column * step, projector->width_px),
                         fmin(row * step, projector->height_px), step,
                         &grid->corners[row * (grid->columns + 1) + column]);
    for (int row = 0; row < grid->rows; row++)
        for (int column = 0; column < grid->columns; column++) {
            const struct plan_ray *corners[4];
            plan_cell(grid, column, row, corners);
            grid->lit[row * grid->columns + column] =
                cell_is_lit(projector, corners, column * step, row * step, step);
        }
    return CUPOLA_OK;
}

/* Twice the area of a quadrilateral in the image, its unlit part taken off by its corners. */
static double lit_area(const struct plan_ray *const corners[4])
{
    double twice = 0;
    int on_screen = 0;
    for (int i = 0; i < 4; i++) {
        const double *a = corners[i]->place_px, *b = corners[(i + 1) % 4]->place_px;
        twice += a[0] * b[1] - a[1] * b[0];
        on_screen += corners[i]->on_screen;
    }
    return 0.5 * fabs(twice) * on_screen / 4;
}

void plan_rays_visit(const struct plan_rays *rays, plan_cell_visitor *visit, void *user)
{
    for (int g = 0; g < rays->count; g++) {
        const struct plan_grid *grid = &rays->grids[g];
        for (int row = 0; row < grid->rows; row++)
            for (int column = 0; column < grid->columns; column++) {
                const struct plan_ray *corners[4];
                plan_cell(grid, column, row, corners);
                if (grid->lit[row * grid->columns + column])
                    visit(corners, user);
            }
    }
}

static void add_cell(const struct plan_ray *const corners[4], void *user)
{
    struct plan_rays *rays = user;
    double area = lit_area(corners);
    rays->pixels += area;
    for (int i = 0; i < 4; i++) {
        double length = length3(corners[i]->ray.at);
        for (int k = 0; k < 3; k++)
            rays->mean[k] += area * corners[i]->ray.at[k] / length;
    }
}

static void widen_opening(const struct plan_ray *const corners[4], void *user)
{
    struct plan_rays *rays = user;
    for (int i = 0; i < 4; i++) {
        const double *v = corners[i]->ray.at;
        double across[3];
        if (!corners[i]->on_screen)
            continue;
        cross3(rays->mean, v, across);
        double angle = atan2(length3(across), dot3(rays->mean, v));
        rays->opening_rad = fmax(rays->opening_rad, 2 * angle);
    }
}

int plan_rays_gather(const cupola_dome *dome, int cells_max, struct plan_rays *rays,
                     struct cupola_error *error)
{
    *rays = (struct plan_rays){.count = dome->rig.output_count};
    for (int i = 0; i < rays->count; i++)
        if (gather_grid(dome, &dome->projectors[i], cells_max, &rays->grids[i]) != CUPOLA_OK) {
            plan_rays_release(rays);
            return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the rays of output %d", i);
        }
    plan_rays_visit(rays, add_cell, rays);
    if (!(rays->pixels > 0)) {
        plan_rays_release(rays);
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "no pixel of any output lights the screen; allowed: a cap, image circle "
                         "and aim that meet");
    }

    /* Symmetric rigs mean an exact axis; rounding errors must not tilt the views. */
    double length = length3(rays->mean);
    for (int i = 0; i < 3; i++)
        if (fabs(rays->mean[i]) < 1e-9 * fmax(length, rays->pixels))
            rays->mean[i] = 0;
    length = length3(rays->mean);
    if (length > 0) {
        scale3(rays->mean, 1 / length);
    } else {
        const double axis[3] = {0, 0, -1}; /* seen all round: any direction will do */
        cupola_dome_to_camera(dome, axis, rays->mean);
    }
    plan_rays_visit(rays, widen_opening, rays);
    return CUPOLA_OK;
}

void plan_rays_release(struct plan_rays *rays)
{
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++) {
        free(rays->grids[i].corners);
        free(rays->grids[i].lit);
        free(rays->grids[i].views);
    }
    *rays = (struct plan_rays){0};
}
