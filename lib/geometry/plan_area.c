/* What the pixels of a cell cover: of the image, and of the base planes of its views. */
#include <math.h>

#include "plan_exact.h"
#include "vector.h"

/* The lit part of a cell, 0 to 1, from how far inside its corners are. */
static double lit_part_of(const cupola_dome *dome, const double eye_m[3], int output, double x_px,
                          double y_px, double size_px, int levels)
{
    double inside[4], sum = 0;
    int lit = 0;
    for (int i = 0; i < 4; i++) {
        struct plan_sample ignored;
        inside[i] = plan_trace(dome, eye_m, output, x_px + (i & 1) * size_px,
                               y_px + (i >> 1) * size_px, &ignored);
        lit += inside[i] >= 0;
    }
    if (lit == 4)
        return 1;
    double half = 0.5 * size_px;
    if (levels > 0) {
        for (int i = 0; i < 4; i++)
            sum += lit_part_of(dome, eye_m, output, x_px + (i & 1) * half, y_px + (i >> 1) * half,
                               half, levels - 1);
        return 0.25 * sum;
    }
    double middle = 0.25 * (inside[0] + inside[1] + inside[2] + inside[3]);
    return edge_coverage(middle / size_px, inside[1] - inside[0] + inside[3] - inside[2],
                         inside[2] - inside[0] + inside[3] - inside[1]);
}

/* The area of the base plane between the corners of a cell, 0 where it does not meet it. */
static double base_area(const double rotation[9], const struct plan_square *cell)
{
    double base[4][2], twice = 0;
    for (int i = 0; i < 4; i++) {
        double q[3];
        transform3(rotation, cell->corners[i]->ray.at, q);
        if (!(-q[2] > 0.1))
            return 0;
        base[i][0] = q[0] / -q[2];
        base[i][1] = q[1] / -q[2];
    }
    for (int i = 0; i < 4; i++) {
        const double *a = base[i], *b = base[(i + 1) % 4];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return 0.5 * fabs(twice);
}

/* The part of a cell's square that is left when its corners are drawn onto the rim. */
static double inside_rim(const struct projector *projector, const struct plan_square *cell)
{
    double place[4][2], twice = 0;
    for (int i = 0; i < 4; i++)
        circle_place(projector, cell->x_px + (i == 1 || i == 2) * cell->size_px,
                     cell->y_px + (i >= 2) * cell->size_px, place[i]);
    for (int i = 0; i < 4; i++) {
        const double *a = place[i], *b = place[(i + 1) % 4];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    double size = cell->size_px / projector->radius_px;
    return 0.5 * fabs(twice) / (size * size);
}

/* Adds what a cell's pixels cover; corners share it, each for the view that it falls to. */
void plan_square_add(struct fitting *fitting, const struct plan_square *cell)
{
    enum { LEVELS = 2 };
    const struct projector *projector = &fitting->dome->projectors[fitting->output];
    double most = -HUGE_VAL, least = HUGE_VAL, lit = 1, kept = 1;
    for (int i = 0; i < 4; i++) {
        most = larger(most, cell->corners[i]->inside_px);
        least = smaller(least, cell->corners[i]->inside_px);
    }
    if (most < -0.71 * cell->size_px)
        return;
    if (least < 0) {
        lit = lit_part_of(fitting->dome, fitting->eye_m, fitting->output, cell->x_px, cell->y_px,
                          cell->size_px, LEVELS);
        kept = inside_rim(projector, cell);
    }
    fitting->exact->pixels += lit * cell->size_px * cell->size_px;
    for (int i = 0; i < 4 && lit > 0 && kept > 0.01; i++)
        for (int v = 0; v < fitting->exact->count; v++)
            if (cell->corners[i]->gap[v] <= 0) {
                struct plan_exact_view *view = &fitting->exact->views[v];
                view->area += 0.25 * base_area(view->rotation, cell) * smaller(lit / kept, 1);
                break;
            }
}
