/* Candidates of both layouts, and the cheapest of each. */
#include <math.h>
#include <string.h>

#include "plan.h"
#include "vector.h"

static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* The best candidate so far. */
struct choice {
    struct plan_rays *rays;
    const struct plan_sizing *sizing;
    struct cupola_view views[CUPOLA_VIEWS_MAX];
    int count;           /* 0: none yet */
    double texels;       /* what it costs */
    double farthest_rad; /* of the candidate that has to reach least far, possible or not */
};

/* Takes out the views that no pixel falls to. Their rays never choose them, so nothing else moves.
 */
static int drop_empty(struct cupola_view *views, int count, const struct plan_fit *fit)
{
    int kept = 0;
    for (int v = 0; v < count; v++)
        if (fit->views[v].cells > 0)
            views[kept++] = views[v];
    return kept;
}

static int consider(struct choice *choice, const struct cupola_view *candidate, int count)
{
    struct plan_fit fit;
    struct cupola_view views[CUPOLA_VIEWS_MAX];
    memcpy(views, candidate, (size_t)count * sizeof *views);
    int status = plan_fit_views(choice->rays, views, count, choice->sizing, &fit);
    if (status == CUPOLA_ERROR_LAYOUT && !fit.complete) {
        count = drop_empty(views, count, &fit);
        status = plan_fit_views(choice->rays, views, count, choice->sizing, &fit);
    }
    choice->farthest_rad = fmin(choice->farthest_rad, fit.farthest_rad);
    if (status == CUPOLA_ERROR_MEMORY)
        return status;
    /* One in a thousand, so that rounding errors never decide between equals. */
    if (status == CUPOLA_OK && (choice->count == 0 || fit.texels < 0.999 * choice->texels)) {
        memcpy(choice->views, views, sizeof choice->views);
        choice->count = count;
        choice->texels = fit.texels;
    }
    return CUPOLA_OK;
}

static int conclude(const struct choice *choice, struct cupola_view *views, double *farthest_rad)
{
    *farthest_rad = choice->farthest_rad;
    if (choice->count == 0)
        return CUPOLA_ERROR_LAYOUT;
    memcpy(views, choice->views, sizeof choice->views);
    return choice->count;
}

/* An upright orientation that looks along the mean seen direction. */
static void look_along_mean(const double mean[3], double rotation[9])
{
    const double up[3] = {0, 1, 0};
    double right[3], back[3] = {-mean[0], -mean[1], -mean[2]};
    cross3(mean, up, right);
    /* Near the zenith "upright" means little: keep the host's right, as a planetarium does. */
    if (length3(right) < 0.2) {
        double along = back[0];
        for (int i = 0; i < 3; i++)
            right[i] = (i == 0) - along * back[i];
    }
    scale3(right, 1 / length3(right));
    double upright[3];
    cross3(back, right, upright);
    memcpy(rotation, right, sizeof right);
    memcpy(rotation + 3, upright, sizeof upright);
    memcpy(rotation + 6, back, sizeof back);
}

/* Where the rays meet the plane of an orientation: left, right, bottom, top. */
struct extent {
    const double *rotation;
    double bounds[4];
};

static void extend(const struct plan_grid *grid, const struct plan_ray *const corners[4],
                   void *user)
{
    (void)grid;
    struct extent *extent = user;
    for (int i = 0; i < 4; i++) {
        double q[3];
        if (!corners[i]->on_screen)
            continue;
        transform3(extent->rotation, corners[i]->seen, q);
        for (int axis = 0; axis < 2; axis++) {
            double *bounds = extent->bounds + 2 * axis;
            bounds[0] = fmin(bounds[0], q[axis] / -q[2]);
            bounds[1] = fmax(bounds[1], q[axis] / -q[2]);
        }
    }
}

/*
 * The plane cut into columns and rows at equal angles. A cut between the parts k and k + 1 of an
 * axis is where their selectors' products are equal: part k has k a - (sum of the cuts before it),
 * the upper envelope of lines of growing slope; the selector of a cell is the sum of both axes.
 */
static void cut_plane(const struct plan_rays *rays, const double rotation[9], int columns, int rows,
                      struct cupola_view *views)
{
    const int parts[2] = {columns, rows};
    struct extent extent = {rotation, {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL}};
    double offset[2][CUPOLA_VIEWS_MAX];
    plan_rays_visit(rays, extend, &extent);
    for (int axis = 0; axis < 2; axis++) {
        double least = atan(extent.bounds[2 * axis]), largest = atan(extent.bounds[2 * axis + 1]);
        double sum = 0;
        for (int k = 0; k < parts[axis]; k++) {
            if (k > 0)
                sum += tan(least + (largest - least) * k / parts[axis]);
            offset[axis][k] = sum;
        }
    }
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++) {
            struct cupola_view *view = &views[row * columns + column];
            double selector[3] = {column, row, offset[0][column] + offset[1][row]};
            memcpy(view->rotation, rotation, sizeof view->rotation);
            transform3_back(rotation, selector, view->selector);
        }
}

int plan_layout_asymmetric(struct plan_rays *rays, int count, const struct plan_sizing *sizing,
                           struct cupola_view *views, double *farthest_rad)
{
    struct choice choice = {.rays = rays, .sizing = sizing, .farthest_rad = 2 * pi};
    double mean[9];
    look_along_mean(rays->mean, mean);
    const double *orientations[2] = {identity, mean};
    for (int o = 0; o < 2 && choice.count == 0; o++) {
        struct cupola_view whole = {.selector = {0}};
        memcpy(whole.rotation, orientations[o], sizeof whole.rotation);
        int status = consider(&choice, &whole, 1);
        if (status != CUPOLA_OK)
            return status;
        if (choice.count == 0)
            continue;
        choice.count = 0; /* the plane reaches every ray; now divide it */
        for (int rows = 1; rows <= count; rows++) {
            struct cupola_view candidate[CUPOLA_VIEWS_MAX] = {0};
            if (count % rows != 0)
                continue;
            cut_plane(rays, orientations[o], count / rows, rows, candidate);
            status = consider(&choice, candidate, count);
            if (status != CUPOLA_OK)
                return status;
        }
    }
    return conclude(&choice, views, farthest_rad);
}

/* A view tilted away from an axis, towards `azimuth_rad`; its up points away from the axis. */
static void tilt_view(const double axis[9], double azimuth_rad, double tilt_rad,
                      struct cupola_view *view)
{
    double turn[9], raise[9];
    rotation_z(-azimuth_rad, turn);
    rotation_x(-tilt_rad, raise);
    multiply3(turn, axis, view->rotation);
    multiply3(raise, view->rotation, view->rotation);
    for (int i = 0; i < 3; i++)
        view->selector[i] = -view->rotation[6 + i];
}

/* `front` views along the axis (0 or 1), the others in a ring round it. */
static int consider_ring(struct choice *choice, const double axis[9], int count, int front,
                         double tilt_rad, double phase_rad)
{
    struct cupola_view candidate[CUPOLA_VIEWS_MAX] = {0};
    int ring = count - front;
    for (int v = 0; v < count; v++) {
        if (v < front)
            tilt_view(axis, 0, 0, &candidate[v]);
        else
            tilt_view(axis, phase_rad + 2 * pi * (v - front) / ring, tilt_rad, &candidate[v]);
    }
    return consider(choice, candidate, count);
}

int plan_layout_rotated(struct plan_rays *rays, int count, const struct plan_sizing *sizing,
                        struct cupola_view *views, double *farthest_rad)
{
    enum { TILTS = 28 };
    const double tilt_step = 0.5 * pi / 20;
    struct choice choice = {.rays = rays, .sizing = sizing, .farthest_rad = 2 * pi};
    double axis[9];
    look_along_mean(rays->mean, axis);
    if (count == 1) {
        int status = consider_ring(&choice, axis, 1, 1, 0, 0);
        return status == CUPOLA_OK ? conclude(&choice, views, farthest_rad) : status;
    }
    for (int front = 0; front <= (count >= 3); front++) {
        int ring = count - front;
        for (int t = 1; t <= TILTS; t++)
            for (int phase = 0; phase < 2; phase++) {
                double phase_rad = phase * pi / ring;
                int status = consider_ring(&choice, axis, count, front, t * tilt_step, phase_rad);
                if (status != CUPOLA_OK)
                    return status;
            }
    }
    return conclude(&choice, views, farthest_rad);
}
