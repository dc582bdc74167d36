/* The rays of all outputs on a grid of places, and what they have in common. */
#include <math.h>
#include <stdlib.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/* The point of the screen at a place; returns how far inside of the cap it is, in cosines. */
static double trace_point(const struct projector *projector, const double place_px[2],
                          double place[2], struct varying *point)
{
    struct varying lens;
    circle_place(projector, place_px[0], place_px[1], place);
    lens_ray(projector, place, &lens);
    plan_widen_collapsed(projector, place, &lens);
    screen_point(projector, &lens, point);
    return -point->at[2] / projector->screen_radius_m - projector->cap_cosine;
}

/*
 * Draws a place onto the cap's edge along the edge's normal (Newton's method). False, and the place
 * as it was, where that does not come to an end within a few cells, as at a rim of infinite slope.
 */
static bool draw_onto_edge(const struct projector *projector, double step_px, double place_px[2])
{
    double at_px[2] = {place_px[0], place_px[1]};
    for (int i = 0; i < 12; i++) {
        double place[2];
        struct varying point;
        double excess = trace_point(projector, at_px, place, &point);
        double dx = -point.dx[2] / projector->screen_radius_m;
        double dy = -point.dy[2] / projector->screen_radius_m;
        double slope = hypot(dx, dy);
        double error_px = excess / slope;
        if (fabs(error_px) < 1e-6) {
            memcpy(place_px, at_px, sizeof at_px);
            return true;
        }
        at_px[0] -= error_px * dx / slope;
        at_px[1] -= error_px * dy / slope;
        if (!(hypot(at_px[0] - place_px[0], at_px[1] - place_px[1]) < 5 * step_px))
            return false;
    }
    return false;
}

static void trace_corner(const cupola_dome *dome, const double eye_m[3],
                         const struct projector *projector, double x_px, double y_px,
                         double step_px, struct plan_ray *corner)
{
    double place[2], edge_px[2] = {x_px, y_px};
    struct varying point;
    double excess = trace_point(projector, edge_px, place, &point);
    double slope = (fabs(point.dx[2]) + fabs(point.dy[2])) / projector->screen_radius_m;
    corner->on_screen = !projector->capped || excess >= 0;
    corner->near_screen = corner->on_screen || excess >= -slope * step_px;
    /* A lit cell's other corners are farther than one cell from the edge, but not much. */
    if (!corner->on_screen && excess >= -4 * slope * step_px &&
        draw_onto_edge(projector, step_px, edge_px)) {
        corner->on_screen = true;
        trace_point(projector, edge_px, place, &point);
    }
    eye_ray(dome, eye_m, &point, &corner->seen);
    for (int i = 0; i < 2; i++)
        corner->place_px[i] =
            projector->center_px[i] + projector->sign[i] * projector->radius_px * place[i];
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

/*
 * The image of the cap, by its edge. False where the lens does not see all of the edge or not the
 * pole: then the cap does not bound the image, or from the wrong side.
 */
static bool cap_part(const struct projector *projector, struct plan_part *part)
{
    enum { PLACES = 256 };
    double radius = projector->screen_radius_m, found[2];
    double cosine = projector->cap_cosine, sine = sqrt(fmax(1 - cosine * cosine, 0));
    *part = (struct plan_part){{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i <= PLACES; i++) {
        /* The last one is the pole. */
        double azimuth = 2 * pi * i / PLACES, across = i < PLACES ? sine * radius : 0;
        double to[3] = {across * cos(azimuth), across * sin(azimuth),
                        i < PLACES ? -cosine * radius : -radius};
        for (int k = 0; k < 3; k++)
            to[k] -= projector->position_m[k];
        if (!lens_pixel(projector, to, found))
            return false;
        for (int axis = 0; axis < 2; axis++) {
            part->sides[2 * axis] = fmin(part->sides[2 * axis], found[axis]);
            part->sides[2 * axis + 1] = fmax(part->sides[2 * axis + 1], found[axis]);
        }
    }
    /* Between two of the places the edge may bulge a little. */
    double margin =
        2 + 0.02 * fmax(part->sides[1] - part->sides[0], part->sides[3] - part->sides[2]);
    for (int axis = 0; axis < 2; axis++) {
        part->sides[2 * axis] -= margin;
        part->sides[2 * axis + 1] += margin;
    }
    return true;
}

struct plan_part plan_lit_part(const struct projector *projector)
{
    struct plan_part cap, part = {{0, projector->width_px, 0, projector->height_px}};
    bool capped = projector->capped && cap_part(projector, &cap);
    for (int axis = 0; axis < 2; axis++) {
        double *sides = part.sides + 2 * axis;
        sides[0] = fmax(sides[0], projector->center_px[axis] - projector->radius_px);
        sides[1] = fmin(sides[1], projector->center_px[axis] + projector->radius_px);
        if (capped) {
            sides[0] = fmax(sides[0], cap.sides[2 * axis]);
            sides[1] = fmin(sides[1], cap.sides[2 * axis + 1]);
        }
        sides[0] = floor(sides[0]);
        sides[1] = fmax(ceil(sides[1]), sides[0] + 1);
    }
    return part;
}

static int gather_grid(const cupola_dome *dome, const double eye_m[3],
                       const struct projector *projector, double cells, struct plan_grid *grid)
{
    struct plan_part part = plan_lit_part(projector);
    double left = part.sides[0], bottom = part.sides[2];
    double step = fmax(part.sides[1] - left, part.sides[3] - bottom) / cells;
    grid->sense = projector->sign[0] * projector->sign[1];
    grid->columns = (int)ceil((part.sides[1] - left) / step - 1e-9);
    grid->rows = (int)ceil((part.sides[3] - bottom) / step - 1e-9);
    size_t corner_count = (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
    grid->corners = malloc(corner_count * sizeof *grid->corners);
    grid->lit = malloc((size_t)grid->columns * (size_t)grid->rows);
    if (!grid->corners || !grid->lit)
        return CUPOLA_ERROR_MEMORY;

    for (int row = 0; row <= grid->rows; row++)
        for (int column = 0; column <= grid->columns; column++)
            trace_corner(dome, eye_m, projector, fmin(left + column * step, part.sides[1]),
                         fmin(bottom + row * step, part.sides[3]), step,
                         &grid->corners[row * (grid->columns + 1) + column]);
    for (int row = 0; row < grid->rows; row++)
        for (int column = 0; column < grid->columns; column++) {
            const struct plan_ray *corners[4];
            plan_cell(grid, column, row, corners);
            grid->lit[row * grid->columns + column] =
                cell_is_lit(projector, corners, left + column * step, bottom + row * step, step);
        }
    return CUPOLA_OK;
}

/*
 * The area of a cell in the image; of one that could not be cut at the cap's edge, a part. Cells
 * whose corners all lie on an edge may be folded and count below 0; so all together they tile the
 * lit part.
 */
static double lit_area(const struct plan_ray *const corners[4])
{
    double twice = 0;
    int on_screen = 0;
    for (int i = 0; i < 4; i++) {
        const double *a = corners[i]->place_px, *b = corners[(i + 1) % 4]->place_px;
        twice += a[0] * b[1] - a[1] * b[0];
        on_screen += corners[i]->on_screen;
    }
    return 0.5 * twice * on_screen / 4;
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
                    visit(grid, corners, user);
            }
    }
}

/*
 * Adds up the area and the mean direction. The integral of the direction over a part of the sphere
 * is half of the integral of r x dr round it, finite even where a pixel's solid angle is not.
 */
static void add_cell(const struct plan_grid *grid, const struct plan_ray *const corners[4],
                     void *user)
{
    struct plan_rays *rays = user;
    double unit[4][3], around[3] = {0}, middle[3] = {0};
    rays->pixels += lit_area(corners);
    for (int i = 0; i < 4; i++) {
        double length = length3(corners[i]->seen.at);
        for (int k = 0; k < 3; k++) {
            unit[i][k] = corners[i]->seen.at[k] / length;
            middle[k] += unit[i][k];
        }
    }
    for (int i = 0; i < 4; i++) {
        double part[3];
        cross3(unit[i], unit[(i + 1) % 4], part);
        for (int k = 0; k < 3; k++)
            around[k] += 0.5 * part[k];
    }
    /* Round an axis that points away from the eye, the product of two neighbours points back. */
    for (int k = 0; k < 3; k++)
        rays->mean[k] -= grid->sense * around[k];
    rays->solid_angle -= grid->sense * dot3(around, middle) / length3(middle);
}

/* Where the first output's axis is seen. */
static void axis_direction(const cupola_dome *dome, double direction[3])
{
    const double middle[2] = {0, 0};
    struct varying lens, point, ray;
    lens_ray(&dome->projectors[0], middle, &lens);
    screen_point(&dome->projectors[0], &lens, &point);
    eye_ray(dome, dome->rig.eye_m, &point, &ray);
    memcpy(direction, ray.at, sizeof ray.at);
}

static void widen_opening(const struct plan_grid *grid, const struct plan_ray *const corners[4],
                          void *user)
{
    (void)grid;
    struct plan_rays *rays = user;
    for (int i = 0; i < 4; i++) {
        const double *v = corners[i]->seen.at;
        double across[3];
        if (!corners[i]->on_screen)
            continue;
        cross3(rays->mean, v, across);
        double angle = atan2(length3(across), dot3(rays->mean, v));
        rays->opening_rad = fmax(rays->opening_rad, 2 * angle);
    }
}

int plan_rays_gather(const cupola_dome *dome, const double eye_m[3], int cells,
                     struct plan_rays *rays, struct cupola_error *error)
{
    double cells_each = cells / sqrt(dome->rig.output_count);
    *rays = (struct plan_rays){.count = dome->rig.output_count};
    for (int i = 0; i < rays->count; i++)
        if (gather_grid(dome, eye_m, &dome->projectors[i], cells_each, &rays->grids[i]) !=
            CUPOLA_OK) {
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

    /* Symmetric rigs mean an exact axis; rounding errors must not tilt the views. Where all
     * directions are seen alike, the mean is nothing but rounding errors. */
    double length = length3(rays->mean);
    if (length > 1e-3 * rays->solid_angle) {
        for (int i = 0; i < 3; i++)
            if (fabs(rays->mean[i]) < 1e-9 * length)
                rays->mean[i] = 0;
    } else {
        axis_direction(dome, rays->mean);
    }
    scale3(rays->mean, 1 / length3(rays->mean));
    plan_rays_visit(rays, widen_opening, rays);
    return CUPOLA_OK;
}

void plan_rays_release(struct plan_rays *rays)
{
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++) {
        free(rays->grids[i].corners);
        free(rays->grids[i].lit);
    }
    *rays = (struct plan_rays){0};
}
