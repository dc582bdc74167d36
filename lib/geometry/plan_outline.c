/*
 * Base rectangles for an eye that moves. What a view shows is where the cone of the rays that fall
 * to it meets the lit part of the screen. The cone's sides are planes through the eye, straight
 * lines on the base plane; so the rectangle round it all is given by the lit part's edge, as far as
 * it lies in the cone, and by those edges of the cone that the outputs light. The lit part's edge
 * is a line on the screen and does not depend on the eye: it is traced once.
 */
#include <math.h>
#include <stdlib.h>

#include "plan.h"
#include "vector.h"

/* Pieces of each curve of an output's outline. */
enum { PIECES = 720, CURVES = 3, BISECTIONS = 20 };

/* Places this far beyond the cap's edge count still: pixels there may be lit in part. */
static const double beyond_px = 0.8;

/* The same for the corners of cones. */
static const double corner_beyond_px = 1;

static void place_on_rim(const struct projector *projector, double t, double place_px[2])
{
    double azimuth = 2 * pi * t / PIECES;
    place_px[0] = projector->center_px[0] + projector->radius_px * cos(azimuth);
    place_px[1] = projector->center_px[1] + projector->radius_px * sin(azimuth);
}

static void place_on_frame(const struct projector *projector, double t, double place_px[2])
{
    double side = fmod(4 * t / PIECES, 4), along = side - floor(side);
    double width = projector->width_px, height = projector->height_px;
    const double corners[5][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}};
    int from = (int)side;
    for (int i = 0; i < 2; i++)
        place_px[i] = corners[from][i] + along * (corners[from + 1][i] - corners[from][i]);
}

/* False where the lens does not see the edge. */
static bool place_on_cap(const struct projector *projector, double t, double place_px[2])
{
    double azimuth = 2 * pi * t / PIECES, radius = projector->screen_radius_m;
    double cosine = projector->cap_cosine, sine = sqrt(larger(1 - cosine * cosine, 0));
    double to[3] = {radius * sine * cos(azimuth), radius * sine * sin(azimuth), -radius * cosine};
    double place[2];
    struct varying lens, point;
    for (int i = 0; i < 3; i++)
        to[i] -= projector->position_m[i];
    if (!projector->capped || !lens_pixel(projector, to, place_px))
        return false;
    circle_place(projector, place_px[0], place_px[1], place);
    lens_ray(projector, place, &lens);
    screen_point(projector, &lens, &point);
    double slope = hypot(point.dx[2], point.dy[2]);
    place_px[0] += PLAN_HALF_DIAGONAL_PX * point.dx[2] / larger(slope, 1e-300);
    place_px[1] += PLAN_HALF_DIAGONAL_PX * point.dy[2] / larger(slope, 1e-300);
    return true;
}

/* One curve of one output. */
struct curve {
    const cupola_dome *dome;
    const struct projector *projector;
    int kind;
};

/* The point of a place of a curve; false where it does not bound the lit part. */
static bool trace(const struct curve *curve, double t, double point[3])
{
    const struct projector *projector = curve->projector;
    double place_px[2], place[2];
    struct varying lens, found;
    if (curve->kind == 0)
        place_on_rim(projector, t, place_px);
    else if (curve->kind == 1)
        place_on_frame(projector, t, place_px);
    else if (!place_on_cap(projector, t, place_px))
        return false;
    double r = circle_place(projector, place_px[0], place_px[1], place);
    lens_ray(projector, place, &lens);
    screen_point(projector, &lens, &found);
    transform3(curve->dome->tilt, found.at, point);
    double slack = curve->kind == 2 ? 1 : 1e-6;
    if ((r - 1) * projector->radius_px > slack || place_px[0] < -slack || place_px[1] < -slack ||
        place_px[0] > projector->width_px + slack || place_px[1] > projector->height_px + slack)
        return false;
    double excess = -found.at[2] / projector->screen_radius_m - projector->cap_cosine;
    double slope = hypot(found.dx[2], found.dy[2]) / projector->screen_radius_m;
    return curve->kind == 2 || !projector->capped || excess >= -beyond_px * slope;
}

/* The end of a lit piece, between a place that is lit and one that is not. */
static void find_end(const struct curve *curve, double lit, double dark, double point[3])
{
    double tried[3];
    trace(curve, lit, point);
    for (int i = 0; i < BISECTIONS; i++) {
        double middle = 0.5 * (lit + dark);
        if (trace(curve, middle, tried)) {
            lit = middle;
            memcpy(point, tried, sizeof tried);
        } else {
            dark = middle;
        }
    }
}

static void trace_curve(const struct curve *curve, struct plan_outline *outline)
{
    bool was_lit = false;
    for (int i = 0; i <= PIECES; i++) {
        struct plan_outline_point here = {.joined = i < PIECES}, end = {.joined = true};
        bool lit = trace(curve, i, here.point);
        if (lit && !was_lit && i > 0) {
            find_end(curve, i, i - 1, end.point);
            outline->points[outline->count++] = end;
        }
        if (!lit && was_lit) {
            find_end(curve, i - 1, i, end.point);
            end.joined = false;
            outline->points[outline->count++] = end;
        }
        if (lit)
            outline->points[outline->count++] = here;
        was_lit = lit;
    }
}

int plan_outline_trace(const cupola_dome *dome, struct plan_outline *outline)
{
    /* Ends come in addition: never more than one per place. */
    size_t most = (size_t)dome->rig.output_count * CURVES * 2 * (PIECES + 1);
    outline->count = 0;
    outline->points = malloc(most * sizeof *outline->points);
    if (!outline->points)
        return CUPOLA_ERROR_MEMORY;
    for (int output = 0; output < dome->rig.output_count; output++)
        for (int kind = 0; kind < CURVES; kind++) {
            struct curve curve = {dome, &dome->projectors[output], kind};
            trace_curve(&curve, outline);
        }
    return CUPOLA_OK;
}

/* What is known of a view. */
struct reach {
    double core[4];
    double least_cosine;
};

static void widen(const struct cupola_view *view, const double ray[3], struct reach *reach)
{
    double q[3], *core = reach->core;
    transform3(view->rotation, ray, q);
    double cosine = -q[2] / length3(q);
    reach->least_cosine = smaller(reach->least_cosine, cosine);
    if (!(cosine > 0.05))
        return;
    for (int axis = 0; axis < 2; axis++) {
        core[2 * axis] = smaller(core[2 * axis], q[axis] / -q[2]);
        core[2 * axis + 1] = larger(core[2 * axis + 1], q[axis] / -q[2]);
    }
}

/* By how much a view's selector is ahead of the others; above 0: the ray falls to it. */
static void lead(const cupola_plan *plan, int view, const double ray[3], double ahead[])
{
    double own = dot3(plan->views[view].selector, ray);
    for (int w = 0; w < plan->view_count; w++)
        ahead[w] = own - dot3(plan->views[w].selector, ray);
}

/* The part of a piece of edge that falls to the view. Between its ends `ahead` runs straight. */
static void widen_by_piece(const cupola_plan *plan, int view, const double from[3],
                           const double to[3], struct reach *reach)
{
    double first[CUPOLA_VIEWS_MAX], last[CUPOLA_VIEWS_MAX], begin = 0, end = 1, ray[3];
    lead(plan, view, from, first);
    lead(plan, view, to, last);
    for (int w = 0; w < plan->view_count; w++) {
        if (first[w] < 0 && last[w] < 0)
            return;
        if (first[w] < 0)
            begin = larger(begin, first[w] / (first[w] - last[w]));
        else if (last[w] < 0)
            end = smaller(end, first[w] / (first[w] - last[w]));
    }
    if (begin > end)
        return;
    for (int i = 0; i < 3; i++)
        ray[i] = from[i] + begin * (to[i] - from[i]);
    widen(&plan->views[view], ray, reach);
    for (int i = 0; i < 3; i++)
        ray[i] = from[i] + end * (to[i] - from[i]);
    widen(&plan->views[view], ray, reach);
}

/* How far a point of the screen lies within the cap, px of the lens's image, by the slope there. */
static double inside_cap_px(const struct projector *projector, const double pixel_px[2])
{
    double place[2];
    struct varying lens, point;
    circle_place(projector, pixel_px[0], pixel_px[1], place);
    lens_ray(projector, place, &lens);
    screen_point(projector, &lens, &point);
    double slope = hypot(point.dx[2], point.dy[2]);
    double inside_m = -point.at[2] - projector->cap_cosine * projector->screen_radius_m;
    return inside_m / larger(slope, 1e-300);
}

/* With what the cap's edge was moved outwards: else a corner between the two would count for none.
 */
static bool is_lit(const cupola_plan *plan, const double eye_m[3], const double ray[3])
{
    const cupola_dome *dome = &plan->dome;
    double point_m[3], to[3], pixel_px[2];
    eye_point(dome, eye_m, ray, point_m);
    for (int g = 0; g < dome->rig.output_count; g++) {
        const struct projector *projector = &dome->projectors[g];
        for (int i = 0; i < 3; i++)
            to[i] = point_m[i] - projector->position_m[i];
        if (lens_pixel(projector, to, pixel_px) && pixel_px[0] >= 0 && pixel_px[1] >= 0 &&
            pixel_px[0] <= projector->width_px && pixel_px[1] <= projector->height_px &&
            (!projector->capped || inside_cap_px(projector, pixel_px) >= -corner_beyond_px))
            return true;
    }
    return false;
}

/* The edges of the view's cone: where it meets two others. */
static void widen_by_cone(const cupola_plan *plan, const double eye_m[3], int view,
                          struct reach *reach)
{
    const double *own = plan->views[view].selector;
    for (int v = 0; v < plan->view_count; v++)
        for (int w = 0; w < v; w++) {
            double a[3], b[3], ray[3], ahead[CUPOLA_VIEWS_MAX];
            if (v == view || w == view)
                continue;
            for (int i = 0; i < 3; i++) {
                a[i] = own[i] - plan->views[v].selector[i];
                b[i] = own[i] - plan->views[w].selector[i];
            }
            cross3(a, b, ray);
            if (dot3(plan->views[view].rotation + 6, ray) > 0)
                scale3(ray, -1);
            lead(plan, view, ray, ahead);
            double slack = -1e-9 * length3(ray) * length3(own);
            bool falls = true;
            for (int x = 0; x < plan->view_count; x++)
                falls = falls && ahead[x] >= slack;
            if (falls && is_lit(plan, eye_m, ray))
                widen(&plan->views[view], ray, reach);
        }
}

bool plan_outline_core(const cupola_plan *plan, const double eye_m[3], int view, double core[4],
                       double *least_cosine)
{
    struct reach reach = {{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL}, 1};
    double eye[3];
    const struct plan_outline *outline = &plan->outline;
    transform3(plan->dome.tilt, eye_m, eye);
    for (int i = 0; i + 1 < outline->count; i++) {
        double from[3], to[3];
        if (!outline->points[i].joined)
            continue;
        for (int k = 0; k < 3; k++) {
            from[k] = outline->points[i].point[k] - eye[k];
            to[k] = outline->points[i + 1].point[k] - eye[k];
        }
        widen_by_piece(plan, view, from, to, &reach);
    }
    widen_by_cone(plan, eye_m, view, &reach);
    memcpy(core, reach.core, sizeof reach.core);
    if (least_cosine)
        *least_cosine = smaller(*least_cosine, reach.least_cosine);
    return core[0] <= core[1];
}
