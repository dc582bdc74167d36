/*
 * Densities and rectangles that hold at every pixel.
 *
 * A grid of cells over every output's image, their corners traced exactly. Where a cell might still
 * raise a view's density or widen its rectangle it is divided, down to a 512th of the image; so
 * only cells along borders and round the worst places are. All corners of a cell count for every
 * view that any place in it may fall to.
 */
#include <math.h>
#include <stdlib.h>

#include "plan_exact.h"
#include "vector.h"

/*
 * How far the middle of a cell may lie above its corners, by what the corners say and by the
 * square of the angle that its size stands for.
 */
static const double bulge_of_range = 0.2, bulge_of_angle = 1.5, bulge_of_table = 8,
                    bulge_of_collapse = 30;

/* What is not worth dividing a cell for: of the metric, and of a texel. */
static const double metric_slack = 2e-4, texel_slack = PLAN_TEXEL_SLACK;

/*
 * Corners beyond the rim are drawn onto it, and where rim and frame meet the lit part may reach out
 * of what its corners span, by about half of that.
 */
static const double edge_range = 0.5;

/* A corner this far off an axis has no place on the base plane to speak of. */
static const double flat_cosine = 0.03;

/* No place of a cell is farther from a corner than half of the diagonal, in sizes; some more. */
static const double far_from_corner = 0.8;

/* `near` has the same place or, near the rim, half a pixel inside: slopes may be infinite there. */
static void measure_gaps(const struct fitting *fitting, const struct plan_sample *near,
                         struct plan_corner *corner)
{
    const struct plan_exact *result = fitting->exact;
    double products[CUPOLA_VIEWS_MAX];
    int own = 0;
    for (int v = 0; v < result->count; v++) {
        products[v] = dot3(result->views[v].selector, corner->ray.at);
        if (products[v] > products[own])
            own = v;
    }
    const double *mine = result->views[own].selector;
    double mine_x = dot3(mine, near->dx), mine_y = dot3(mine, near->dy);
    for (int v = 0; v < result->count; v++) {
        const double *other = result->views[v].selector;
        double across = dot3(other, near->dx) - mine_x, up = dot3(other, near->dy) - mine_y;
        corner->gap[v] = products[own] - products[v];
        corner->slope[v] = sqrt(across * across + up * up);
        corner->across[v] = across;
        corner->up[v] = up;
    }
}

void plan_corner_trace(struct fitting *fitting, double x_px, double y_px,
                       struct plan_corner *corner)
{
    const struct projector *projector = &fitting->dome->projectors[fitting->output];
    double x = x_px - projector->center_px[0], y = y_px - projector->center_px[1];
    double r = sqrt(x * x + y * y), most = projector->radius_px - 0.5;
    corner->inside_px =
        plan_trace(fitting->dome, fitting->eye_m, fitting->output, x_px, y_px, &corner->ray);
    struct plan_sample near = corner->ray;
    if (r > most)
        plan_trace(fitting->dome, fitting->eye_m, fitting->output,
                   projector->center_px[0] + x * most / r, projector->center_px[1] + y * most / r,
                   &near);
    measure_gaps(fitting, &near, corner);
}

/* What the corners say of one view: largest excess and its range, and the extent of the bases. */
struct reading {
    double most, bulge, range, bounds[4];
    bool flat; /* a corner does not meet the base plane */
    bool edge; /* a corner is not lit */
};

/*
 * By the square of an angle. Footprints change abruptly where pixels begin to have no width (see
 * widen_collapsed) and between the samples of a measured lens.
 */
static double curvature(const struct projector *projector)
{
    if (projector->lens.half_fov > 140 * (pi / 180))
        return bulge_of_collapse;
    return projector->lens.model == CUPOLA_LENS_TABLE ? bulge_of_table : bulge_of_angle;
}

static struct reading read_view(const struct fitting *fitting, const struct plan_square *cell,
                                int v)
{
    double least = HUGE_VAL;
    struct reading reading = {.bounds = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL}};
    const double *rotation = fitting->exact->views[v].rotation;
    for (int i = 0; i < 4; i++) {
        struct plan_metric footprint;
        double base[2];
        reading.edge = reading.edge || cell->corners[i]->inside_px < 0;
        if (!(-dot3(rotation + 6, cell->corners[i]->ray.at) > flat_cosine)) {
            reading.flat = true;
            continue;
        }
        plan_footprint(rotation, &cell->corners[i]->ray, &footprint, base);
        double excess = plan_excess(&fitting->metric[v], &footprint);
        reading.most = larger(reading.most, excess);
        least = smaller(least, excess);
        for (int axis = 0; axis < 2; axis++) {
            double *bounds = reading.bounds + 2 * axis;
            bounds[0] = smaller(bounds[0], base[axis]);
            bounds[1] = larger(bounds[1], base[axis]);
        }
    }
    const struct projector *projector = &fitting->dome->projectors[fitting->output];
    double angle = cell->size_px / projector->radius_px * larger(projector->lens.half_fov, 1);
    double curved = curvature(projector);
    reading.range = reading.most - least;
    if (curved > bulge_of_angle && cell->size_px <= fitting->leaf_px)
        reading.most += 0.5 * reading.range;
    reading.bulge = larger(bulge_of_range * reading.range, curved * angle * angle);
    return reading;
}

/* Whether a cell may still teach something about a view that it is not sure to belong to. */
static bool may_raise(const struct fitting *fitting, const struct reading *reading, int v,
                      bool whole)
{
    const double *core = fitting->core[v];
    if (reading->flat)
        return true;
    if (reading->most + reading->bulge > fitting->excess[v] + metric_slack &&
        larger(whole ? 0 : reading->range, reading->bulge) > metric_slack)
        return true;
    for (int axis = 0; axis < 2 && !whole; axis++) {
        double slack = texel_slack / fitting->density[v][axis];
        if (reading->edge)
            slack -= edge_range * (reading->bounds[2 * axis + 1] - reading->bounds[2 * axis]);
        if (reading->bounds[2 * axis] < core[2 * axis] - slack ||
            reading->bounds[2 * axis + 1] > core[2 * axis + 1] + slack)
            return true;
    }
    return false;
}

/* How far off their axis the rays of a view are that surely fall to it. */
static void learn_reach(struct fitting *fitting, const struct plan_square *cell, int v)
{
    for (int i = 0; i < 4; i++) {
        const struct plan_corner *corner = cell->corners[i];
        if (corner->gap[v] > 0 || corner->inside_px < -2 * fitting->leaf_px)
            continue;
        double c = -dot3(fitting->exact->views[v].rotation + 6, corner->ray.at);
        fitting->least_cosine[v] = smaller(fitting->least_cosine[v], c);
    }
}

static void learn(struct fitting *fitting, const struct reading *reading, int v, bool whole)
{
    double *core = fitting->core[v];
    double bulge = whole ? smaller(reading->bulge, metric_slack) : 0;
    fitting->excess[v] = larger(fitting->excess[v], reading->most + bulge);
    for (int axis = 0; axis < 2; axis++) {
        const double *bounds = reading->bounds + 2 * axis;
        double beyond = reading->edge ? 0.5 * edge_range * (bounds[1] - bounds[0]) : 0;
        core[2 * axis] = smaller(core[2 * axis], bounds[0] - beyond);
        core[2 * axis + 1] = larger(core[2 * axis + 1], bounds[1] + beyond);
    }
}

/* Whether view v may have a larger product than view w at some place in a cell. */
static bool may_beat(const struct plan_square *cell, int v, int w)
{
    double steepest = 0, most = -HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        const struct plan_corner *corner = cell->corners[i];
        double across = corner->across[v] - corner->across[w];
        double up = corner->up[v] - corner->up[w];
        steepest = larger(steepest, across * across + up * up);
        most = larger(most, corner->gap[w] - corner->gap[v]);
    }
    return most >= 0 || most >= -far_from_corner * cell->size_px * sqrt(steepest);
}

/*
 * Of the views that a cell meets, without those that another one surely beats: of two that look
 * nearly the same way both are near to a third at its border.
 */
static unsigned drop_beaten(unsigned met, const struct plan_square *cell)
{
    for (int v = 0; v < CUPOLA_VIEWS_MAX; v++)
        for (int w = 0; w < CUPOLA_VIEWS_MAX && met >> v & 1; w++)
            if (w != v && met >> w & 1 && !may_beat(cell, v, w))
                met &= ~(1u << v);
    return met;
}

/* The views that some place in a cell may fall to. */
static unsigned views_met(const struct fitting *fitting, const struct plan_square *cell)
{
    unsigned met = 0;
    for (int v = 0; v < fitting->exact->count; v++) {
        double slope = 0, gap = HUGE_VAL;
        for (int i = 0; i < 4; i++) {
            slope = larger(slope, cell->corners[i]->slope[v]);
            gap = smaller(gap, cell->corners[i]->gap[v]);
        }
        if (gap <= far_from_corner * cell->size_px * slope)
            met |= 1u << v;
    }
    return met & (met - 1) ? drop_beaten(met, cell) : met;
}

static void divide_cell(struct fitting *fitting, const struct plan_square *cell)
{
    struct plan_corner made[5];
    const struct plan_corner *grid[9];
    static const int old_place[4] = {0, 2, 8, 6}, new_place[5] = {1, 3, 4, 5, 7};
    double half = 0.5 * cell->size_px;
    for (int i = 0; i < 4; i++)
        grid[old_place[i]] = cell->corners[i];
    for (int i = 0; i < 5; i++) {
        int place = new_place[i];
        plan_corner_trace(fitting, cell->x_px + place % 3 * half, cell->y_px + place / 3 * half,
                          &made[i]);
        grid[place] = &made[i];
    }
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 2; column++) {
            int at = 3 * row + column;
            struct plan_square part = {cell->x_px + column * half,
                                       cell->y_px + row * half,
                                       half,
                                       {grid[at], grid[at + 1], grid[at + 4], grid[at + 3]}};
            plan_square_visit(fitting, &part);
        }
}

void plan_square_visit(struct fitting *fitting, const struct plan_square *cell)
{
    unsigned met = views_met(fitting, cell);
    double most_inside = -HUGE_VAL, least_inside = HUGE_VAL;
    struct reading readings[CUPOLA_VIEWS_MAX];
    for (int i = 0; i < 4; i++) {
        most_inside = larger(most_inside, cell->corners[i]->inside_px);
        least_inside = smaller(least_inside, cell->corners[i]->inside_px);
    }
    bool whole = (met & (met - 1)) == 0 && least_inside >= 0, divide = false;
    bool leaf = cell->size_px <= fitting->leaf_px;
    if (most_inside < -PLAN_HALF_DIAGONAL_PX - 0.71 * cell->size_px)
        return;
    for (int v = 0; v < fitting->exact->count; v++)
        if (met & 1u << v) {
            readings[v] = read_view(fitting, cell, v);
            divide = divide || may_raise(fitting, &readings[v], v, whole);
        }
    if (divide && !leaf) {
        divide_cell(fitting, cell);
        return;
    }
    for (int v = 0; v < fitting->exact->count; v++)
        if (met & 1u << v) {
            learn(fitting, &readings[v], v, whole);
            learn_reach(fitting, cell, v);
        }
}
