/*
 * The exact fit, view by view: the metric that the grid's own corners ask for, nearly all of the
 * truth; by how much the rest of the pixels exceeds it; and the same for every place of the eye.
 */
#include <math.h>
#include <stdlib.h>

#include "plan_exact.h"
#include "vector.h"

/* What a leaf's places may have over its corners. */
static const double metric_margin = 1.0004;

/* Images of a few pixels are not divided as finely as others. */
static const double least_leaf_px = 1.0 / 64;

/* Eyes between those looked at may ask for more, by this part of what other eyes add to the middle.
 */
static const double beyond_eyes = 0.02;

/* Beyond it the search's samples were wrong about the reach. */
static const double least_cosine_allowed = 0.13917310096006544; /* of PLAN_REACH_MOST_DEG */

/* The lit part of an output's image as square cells. */
struct image_grid {
    double left, bottom, size_px;
    int columns, rows;
    struct plan_corner *corners;
};

static bool make_grid(struct fitting *fitting, int cells, struct image_grid *grid)
{
    struct plan_part part = plan_lit_part(&fitting->dome->projectors[fitting->output]);
    double width = part.sides[1] - part.sides[0], height = part.sides[3] - part.sides[2];
    grid->left = part.sides[0];
    grid->bottom = part.sides[2];
    fitting->leaf_px = larger(larger(width, height) / 512, least_leaf_px);
    grid->size_px = fitting->leaf_px;
    while (grid->size_px * cells < larger(width, height))
        grid->size_px *= 2;
    grid->columns = (int)ceil(width / grid->size_px);
    grid->rows = (int)ceil(height / grid->size_px);
    size_t count = (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
    grid->corners = malloc(count * sizeof *grid->corners);
    if (!grid->corners)
        return false;
    for (int row = 0; row <= grid->rows; row++)
        for (int column = 0; column <= grid->columns; column++)
            plan_corner_trace(fitting, grid->left + column * grid->size_px,
                              grid->bottom + row * grid->size_px,
                              &grid->corners[row * (grid->columns + 1) + column]);
    return true;
}

static struct plan_square square_of(const struct image_grid *grid, int column, int row)
{
    const struct plan_corner *lower = grid->corners + row * (grid->columns + 1) + column;
    const struct plan_corner *upper = lower + grid->columns + 1;
    return (struct plan_square){grid->left + column * grid->size_px,
                                grid->bottom + row * grid->size_px,
                                grid->size_px,
                                {lower, lower + 1, upper + 1, upper}};
}

/* Whether a view is known to have rays that are too far off its axis. */
static bool reaches_too_far(const struct fitting *fitting)
{
    for (int v = 0; v < fitting->exact->count; v++)
        if (fitting->least_cosine[v] < least_cosine_allowed)
            return true;
    return false;
}

/* Ends early where the views are of no use and that is all that is asked. */
static void visit_grid(struct fitting *fitting, const struct image_grid *grid, bool to_the_end)
{
    for (int row = 0; row < grid->rows; row++)
        for (int column = 0; column < grid->columns; column++) {
            if (!to_the_end && reaches_too_far(fitting))
                return;
            struct plan_square cell = square_of(grid, column, row);
            plan_square_visit(fitting, &cell);
        }
}

/* Footprints of a view and where they meet its base plane. */
struct footprints {
    struct plan_metric *metrics;
    double (*base)[2];
    int count;
};

/* Whether the middle of one of the four pixels round a place is lit and falls to the view. */
static bool serves_pixel(const struct fitting *fitting, double x_px, double y_px, int v)
{
    for (int i = 0; i < 4; i++) {
        double x = floor(x_px - (i & 1)) + 0.5, y = floor(y_px - (i >> 1)) + 0.5;
        struct cupola_ray ray;
        if (cupola_dome_ray(fitting->dome, fitting->output, NULL, x, y, &ray) <= 0)
            continue;
        double own = dot3(fitting->exact->views[v].selector, ray.direction);
        bool best = true;
        for (int w = 0; w < fitting->exact->count; w++) {
            double product = dot3(fitting->exact->views[w].selector, ray.direction);
            best = best && (w < v ? product < own : product <= own);
        }
        if (best)
            return true;
    }
    return false;
}

/* Collects what the grids' corners ask of a view. Returns whether any pixel falls to it. */
static bool collect(struct fitting *fitting, const struct image_grid *grids, int v,
                    struct footprints *found)
{
    bool serves = false;
    found->count = 0;
    for (int g = 0; g < fitting->dome->rig.output_count; g++) {
        const struct image_grid *grid = &grids[g];
        fitting->output = g;
        for (int row = 0; row <= grid->rows; row++)
            for (int column = 0; column <= grid->columns; column++) {
                const struct plan_corner *corner =
                    &grid->corners[row * (grid->columns + 1) + column];
                if (corner->inside_px < -PLAN_HALF_DIAGONAL_PX || corner->gap[v] > 0)
                    continue;
                plan_footprint(fitting->exact->views[v].rotation, &corner->ray,
                               &found->metrics[found->count], found->base[found->count]);
                found->count++;
                serves = serves || serves_pixel(fitting, grid->left + column * grid->size_px,
                                                grid->bottom + row * grid->size_px, v);
            }
    }
    return serves;
}

/* Left, right, bottom, top of where rays meet the base plane, rolled. */
static void rolled_bounds(const struct footprints *found, double angle, double bounds[4])
{
    double c = cos(angle), s = sin(angle);
    bounds[0] = bounds[2] = HUGE_VAL;
    bounds[1] = bounds[3] = -HUGE_VAL;
    for (int k = 0; k < found->count; k++) {
        double u = c * found->base[k][0] + s * found->base[k][1];
        double w = c * found->base[k][1] - s * found->base[k][0];
        bounds[0] = smaller(bounds[0], u);
        bounds[1] = larger(bounds[1], u);
        bounds[2] = smaller(bounds[2], w);
        bounds[3] = larger(bounds[3], w);
    }
}

/* The metric's own roll, or the one of least cost where others may be better. */
static double cheapest_roll(const struct fitting *fitting, const struct footprints *found,
                            const struct plan_metric *x, double area)
{
    enum { ROLLS = 4 * PLAN_ROLLS };
    double own = plan_roll_of(x), best = own, least = HUGE_VAL;
    if (!plan_rolls_freely(fitting->prices, x))
        return own;
    for (int i = 0; i < ROLLS; i++) {
        double angle = own + 0.5 * pi * i / ROLLS;
        struct plan_metric d = plan_enclose_rolled(x, angle);
        struct plan_view_fit fit = {.area = area,
                                    .density = {fitting->prices->density * sqrt(d.uu),
                                                fitting->prices->density * sqrt(d.vv)}};
        rolled_bounds(found, angle, fit.core);
        plan_price_view(fitting->prices, PLAN_WHOLE_PX, &fit);
        if (fit.cost < 0.999 * least) {
            least = fit.cost;
            best = angle;
        }
    }
    return best;
}

/* Footprints as the view sees them once it is rolled. */
static void roll_footprints(double angle, struct footprints *found)
{
    double c = cos(angle), s = sin(angle);
    for (int i = 0; i < found->count; i++) {
        struct plan_metric *g = &found->metrics[i], was = *g;
        g->uu = c * c * was.uu + 2 * c * s * was.uv + s * s * was.vv;
        g->vv = s * s * was.uu - 2 * c * s * was.uv + c * c * was.vv;
        g->uv = c * s * (was.vv - was.uu) + (c * c - s * s) * was.uv;
    }
}

/* Roll, metric and the beginning of the rectangle. */
static void begin_view(struct fitting *fitting, int v, struct footprints *found)
{
    struct plan_exact_view *view = &fitting->exact->views[v];
    struct plan_metric *x = &fitting->metric[v];
    if (!fitting->upright) {
        struct plan_metric free_x = plan_enclose(found->metrics, found->count);
        double roll = cheapest_roll(fitting, found, &free_x, view->likely_area);
        plan_roll_by(roll, view->rotation);
        roll_footprints(roll, found);
        *x = plan_enclose_rolled(&free_x, roll);
    }
    if (fitting->upright || plan_rolls_freely(fitting->prices, x))
        *x = plan_enclose_upright(found->metrics, found->count);
    fitting->density[v][0] = fitting->prices->density * sqrt(x->uu);
    fitting->density[v][1] = fitting->prices->density * sqrt(x->vv);
    fitting->excess[v] = 1;
    fitting->least_cosine[v] = 1;
}

static void begin_cores(struct fitting *fitting)
{
    for (int v = 0; v < fitting->exact->count; v++) {
        fitting->core[v][0] = fitting->core[v][2] = HUGE_VAL;
        fitting->core[v][1] = fitting->core[v][3] = -HUGE_VAL;
    }
}

static void add_areas(struct fitting *fitting, const struct image_grid *grids)
{
    for (int g = 0; g < fitting->dome->rig.output_count; g++) {
        fitting->output = g;
        for (int row = 0; row < grids[g].rows; row++)
            for (int column = 0; column < grids[g].columns; column++) {
                struct plan_square cell = square_of(&grids[g], column, row);
                plan_square_add(fitting, &cell);
            }
    }
}

/* Traces the grids of all outputs. Returns the number of corners, 0 where memory is short. */
static size_t make_grids(struct fitting *fitting, int cells, struct image_grid *grids)
{
    size_t corners = 0;
    int outputs = fitting->dome->rig.output_count;
    for (fitting->output = 0; fitting->output < outputs; fitting->output++) {
        struct image_grid *grid = &grids[fitting->output];
        if (!make_grid(fitting, (int)(cells / sqrt(outputs)), grid))
            return 0;
        corners += (size_t)(grid->columns + 1) * (size_t)(grid->rows + 1);
    }
    return corners;
}

static void release_grids(struct image_grid *grids)
{
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        free(grids[i].corners);
}

static void visit_grids(struct fitting *fitting, const struct image_grid *grids, bool to_the_end)
{
    int outputs = fitting->dome->rig.output_count;
    for (fitting->output = 0; fitting->output < outputs; fitting->output++)
        visit_grid(fitting, &grids[fitting->output], to_the_end);
}

/* Takes out a view; what fell to it falls to the others. */
static void drop_view(struct plan_exact *exact, int v)
{
    exact->count--;
    for (; v < exact->count; v++)
        exact->views[v] = exact->views[v + 1];
}

/* The rig's own eye. Returns the index of a view that no pixel falls to, or the number of views. */
static int fit_middle(struct fitting *fitting, const struct image_grid *grids,
                      struct footprints *found)
{
    begin_cores(fitting);
    for (int v = 0; v < fitting->exact->count; v++) {
        bool serves = collect(fitting, grids, v, found);
        if (found->count == 0 || (fitting->sampled && !serves && fitting->exact->count > 1))
            return v;
        begin_view(fitting, v, found);
    }
    visit_grids(fitting, grids, false);
    return fitting->exact->count;
}

static int begin_fit(struct fitting *fitting)
{
    enum { CELLS = 96 };
    struct image_grid grids[CUPOLA_OUTPUTS_MAX] = {{.corners = NULL}};
    struct footprints found = {NULL, NULL, 0};
    int status = CUPOLA_ERROR_MEMORY, empty = -1;
    size_t corners = make_grids(fitting, CELLS, grids);
    if (corners > 0) {
        found.metrics = malloc(corners * sizeof *found.metrics);
        found.base = malloc(corners * sizeof *found.base);
    }
    if (found.metrics && found.base) {
        empty = fit_middle(fitting, grids, &found);
        status = CUPOLA_OK;
    }
    if (status == CUPOLA_OK && empty < fitting->exact->count) {
        drop_view(fitting->exact, empty);
        status = fitting->exact->count > 0 ? 1 : CUPOLA_ERROR_LAYOUT;
    }
    if (status == CUPOLA_OK && reaches_too_far(fitting))
        status = CUPOLA_ERROR_LAYOUT;
    if (status == CUPOLA_OK)
        add_areas(fitting, grids);
    release_grids(grids);
    free(found.metrics);
    free(found.base);
    return status;
}

/* The exact fit at the eye that asks most of a view; other views learn of it, too. */
static int fit_worst_eye(struct fitting *fitting, const double eye_m[3])
{
    /* Rectangles are known: no cell need be divided for them. */
    static const double everywhere[4] = {-HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL};
    enum { CELLS = 48 };
    struct image_grid grids[CUPOLA_OUTPUTS_MAX] = {{.corners = NULL}};
    memcpy(fitting->eye_m, eye_m, sizeof fitting->eye_m);
    for (int v = 0; v < fitting->exact->count; v++)
        memcpy(fitting->core[v], everywhere, sizeof everywhere);
    bool done = make_grids(fitting, CELLS, grids) > 0;
    if (done)
        visit_grids(fitting, grids, true);
    release_grids(grids);
    return done ? CUPOLA_OK : CUPOLA_ERROR_MEMORY;
}

/* Raises excesses to what every eye of a sphere asks. */
static int fit_other_eyes(struct fitting *fitting, double head_radius_m, struct plan_sphere *sphere)
{
    int status = plan_sphere_look(fitting, head_radius_m, sphere);
    for (int v = 0; v < fitting->exact->count && status == CUPOLA_OK; v++)
        if (sphere->least_cosine[v] < least_cosine_allowed)
            status = CUPOLA_ERROR_LAYOUT;
    for (int v = 0; v < fitting->exact->count && status == CUPOLA_OK; v++)
        status = fit_worst_eye(fitting, sphere->eye_m[v]);
    for (int v = 0; v < fitting->exact->count; v++)
        fitting->excess[v] = larger(fitting->excess[v], sphere->excess[v]);
    return status;
}

/* `middle` is the fit for the rig's eye, `all` has the excesses of all eyes. */
static void conclude(const struct fitting *middle, const struct fitting *all,
                     const struct plan_sphere *sphere, struct plan_exact *exact)
{
    for (int v = 0; v < exact->count; v++) {
        struct plan_exact_view *view = &exact->views[v];
        double added = larger(all->excess[v] - middle->excess[v], 0);
        double excess = (all->excess[v] + beyond_eyes * added) * metric_margin;
        double cosine = smaller(middle->least_cosine[v], sphere->least_cosine[v]);
        memcpy(view->core, middle->core[v], sizeof view->core);
        for (int axis = 0; axis < 2; axis++) {
            double extent = view->core[2 * axis + 1] - view->core[2 * axis];
            view->density[axis] = middle->density[v][axis] * sqrt(excess);
            view->extent[axis] =
                larger(extent, sphere->extent[v][axis] +
                                   beyond_eyes * larger(sphere->extent[v][axis] - extent, 0));
        }
        view->farthest_rad = acos(cosine);
        view->least = middle->prices->density * sqrt(excess / all->excess[v]);
    }
}

int plan_exact_fit(const cupola_dome *dome, const struct plan_choice *choice,
                   const struct plan_prices *prices, double head_radius_m, bool sampled,
                   struct plan_exact *exact)
{
    struct plan_sphere sphere = {.excess = {0}};
    struct fitting fitting = {.dome = dome,
                              .exact = exact,
                              .prices = prices,
                              .upright = choice->layout == CUPOLA_LAYOUT_ASYMMETRIC,
                              .sampled = sampled};
    int status = 1;
    *exact = (struct plan_exact){.count = choice->count};
    for (int v = 0; v < choice->count; v++) {
        memcpy(exact->views[v].rotation, choice->views[v].rotation,
               sizeof exact->views[v].rotation);
        memcpy(exact->views[v].selector, choice->views[v].selector,
               sizeof exact->views[v].selector);
        exact->views[v].likely_area = choice->views[v].area;
    }
    memcpy(fitting.eye_m, dome->rig.eye_m, sizeof fitting.eye_m);
    while (status == 1)
        status = begin_fit(&fitting);
    struct fitting middle = fitting;
    for (int v = 0; v < exact->count; v++)
        sphere.least_cosine[v] = 1;
    if (status == CUPOLA_OK && head_radius_m > 0)
        status = fit_other_eyes(&fitting, head_radius_m, &sphere);
    if (status == CUPOLA_OK)
        status = plan_kinks_look(&fitting, &sphere, head_radius_m > 0);
    if (status == CUPOLA_OK)
        conclude(&middle, &fitting, &sphere, exact);
    return status;
}
