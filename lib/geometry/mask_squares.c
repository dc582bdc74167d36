/*
 * The lit part of the outputs' images in squares. A square of more than SMALL_PX is used where it
 * and all squares of its size round it are lit, so that a box round it never reaches beyond the lit
 * part's edge. A box of corners holds what lies between them only if they are near each other: a
 * square is cut, below a pixel if need be, until it is small beside the image circle and as the eye
 * sees it.
 */
#include <math.h>
#include <stdlib.h>

#include "mask.h"
#include "vector.h"

enum { SMALL_PX = 2, MOST_PX = 32, PLACES = 9 };

/* Half the diagonal of a pixel and some more: farther from an edge none is cut. */
static const double pixel_reach = 0.75;

/*
 * How far apart the corners of a square may lie, as a part of their distance from the eye. Where
 * rays turn by an angle and are up to 80 degrees off a view's axis, they bulge out of the box of
 * their ends by up to tan 80 / 4 = 1.4 of that angle, of the box.
 */
static const double most_part = 0.1;

/* Of the box, for that angle; the least; where it costs nothing, as squares lie round it. */
static const double margin_per_part = 2.5, least_margin = 0.0625;
static const float large_margin = 0.25f;

/* Parts of the image circle's radius: squares of lenses in a few pixels; where cutting ends. */
static const double most_of_circle = 0.0625, least_of_circle = 1.0 / 8192;

/* Of circles: where squares say how they lie to a cap by differences. */
static const double differences_px = 64;

enum lit { LIT_NOT, LIT_IN_PART, LIT };

/* One output being cut. */
struct cutting {
    const cupola_plan *plan;
    const struct projector *projector;
    struct mask *mask;
    int least_px; /* of a square */
};

static void point_of(const struct projector *projector, double x_px, double y_px,
                     struct varying *point)
{
    struct varying ray;
    double place[2];
    circle_place(projector, x_px, y_px, place);
    lens_ray(projector, place, &ray);
    screen_point(projector, &ray, point);
}

/* What else has to be lit on each side of a square. */
static double ring_px(double side)
{
    return side > SMALL_PX ? side : 0;
}

/* How far the image circle's centre is from a square. */
static double off_center(const struct projector *projector, double x, double y, double side)
{
    double dx = x - projector->center_px[0], dy = y - projector->center_px[1];
    return hypot(fmax(fmax(dx, -dx - side), 0), fmax(fmax(dy, -dy - side), 0));
}

/* How a square lies to the image circle: it, and with its ring. */
static enum lit lit_by_rim(const struct projector *projector, double x, double y, double side)
{
    double farthest[2], ring = ring_px(side);
    double at[2] = {x - projector->center_px[0], y - projector->center_px[1]};
    for (int i = 0; i < 2; i++)
        farthest[i] = fmax(fabs(at[i] - ring), fabs(at[i] + side + ring));
    if (off_center(projector, x, y, side) > projector->radius_px + pixel_reach)
        return LIT_NOT;
    return hypot(farthest[0], farthest[1]) < projector->radius_px - pixel_reach ? LIT : LIT_IN_PART;
}

/* The same to the screen's cap, for squares inside of the circle; by second differences. */
static enum lit lit_by_cap(const struct projector *projector, double x, double y, double side)
{
    double excess[PLACES], least = HUGE_VAL, most = -HUGE_VAL, bend = 0, step = 0;
    if (!projector->capped)
        return LIT;
    for (int i = 0; i < PLACES; i++) {
        struct varying point;
        point_of(projector, x + side * (1.5 * (i % 3) - 1), y + side * (1.5 * (i / 3) - 1), &point);
        excess[i] = -point.at[2] / projector->screen_radius_m - projector->cap_cosine;
        least = fmin(least, excess[i]);
        most = fmax(most, excess[i]);
    }
    for (int i = 0; i < 3; i++) {
        const double *row = excess + 3 * i, *column = excess + i;
        bend = fmax(bend, fabs(row[0] - 2 * row[1] + row[2]));
        bend = fmax(bend, fabs(column[0] - 2 * column[3] + column[6]));
        step = fmax(step, fmax(fabs(row[2] - row[0]), fabs(column[6] - column[0])));
    }
    double pixel = (step + 4 * bend) / (3 * side);
    if (most + bend + pixel < 0)
        return LIT_NOT;
    return least - bend - pixel > 0 ? LIT : LIT_IN_PART;
}

static enum lit lit_of(const struct projector *projector, double x, double y, double side)
{
    enum lit rim = lit_by_rim(projector, x, y, side);
    if (x >= projector->width_px || y >= projector->height_px || rim == LIT_NOT)
        return LIT_NOT;
    if (rim == LIT_IN_PART || projector->radius_px < differences_px)
        return LIT_IN_PART;
    enum lit cap = lit_by_cap(projector, x, y, side);
    double more = ring_px(side);
    bool framed = x >= more && y >= more && x + side + more <= projector->width_px &&
                  y + side + more <= projector->height_px;
    return cap == LIT && !framed ? LIT_IN_PART : cap;
}

static bool any_pixel_lit(const struct projector *projector, int x, int y, int side)
{
    for (int i = 0; i < side * side; i++) {
        double x_px = x + i % side + 0.5, y_px = y + i / side + 0.5;
        struct varying point;
        point_of(projector, x_px, y_px, &point);
        if (pixel_coverage(projector, x_px, y_px, &point) > 0)
            return true;
    }
    return false;
}

static bool grow(struct mask *mask)
{
    int most = 2 * mask->square_most + 1024;
    void *more = realloc(mask->squares, (size_t)most * sizeof *mask->squares);
    if (!more)
        return false;
    mask->squares = more;
    mask->square_most = most;
    return true;
}

static double distance(const double a[3], const double b[3])
{
    double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return length3(d);
}

/*
 * How far apart the corners of a square and its middle are, as a part of the least distance from
 * any eye to them; the corners come out in the host's camera frame.
 */
static double see_square(const struct cutting *cutting, double x, double y, double side,
                         struct mask_square *square)
{
    const struct projector *projector = cutting->projector;
    const cupola_dome *dome = &cutting->plan->dome;
    double at[5][3], nearest = HUGE_VAL, apart = 0;
    for (int i = 0; i < 5; i++) {
        struct varying point;
        double across = i < 4 ? i & 1 : 0.5, up = i < 4 ? i >> 1 : 0.5, seen[3];
        point_of(projector, fmin(x + across * side, projector->width_px),
                 fmin(y + up * side, projector->height_px), &point);
        memcpy(at[i], point.at, sizeof at[i]);
        nearest = fmin(nearest, distance(at[i], dome->rig.eye_m) - cutting->plan->head_radius_m);
        for (int k = 0; k < i; k++)
            apart = fmax(apart, distance(at[i], at[k]));
        if (i == 4)
            break;
        transform3(dome->tilt, point.at, seen);
        square->x[i] = (float)seen[0];
        square->y[i] = (float)seen[1];
        square->z[i] = (float)seen[2];
    }
    return nearest > 0 ? apart / nearest : HUGE_VAL;
}

/*
 * A square, or its quarters where it is too large. What is beyond the circle is on its rim, from
 * corner to corner.
 */
static bool add_square(const struct cutting *cutting, double x, double y, double side)
{
    struct mask *mask = cutting->mask;
    double radius = cutting->projector->radius_px;
    bool beyond = off_center(cutting->projector, x, y, side) >= radius;
    struct mask_square square;
    if (mask->whole)
        return true;
    double part = see_square(cutting, x, y, side, &square);
    if (part > most_part || (!beyond && side > most_of_circle * radius)) {
        double half = 0.5 * side;
        mask->whole |= !(side > least_of_circle * radius);
        for (int i = 0; i < 4; i++)
            if (!add_square(cutting, x + half * (i & 1), y + half * (i >> 1), half))
                return false;
        return true;
    }
    if (mask->square_count == mask->square_most && !grow(mask))
        return false;
    square.margin =
        side > SMALL_PX ? large_margin : (float)fmax(least_margin, margin_per_part * part);
    mask->squares[mask->square_count++] = square;
    return true;
}

static bool cut_square(const struct cutting *cutting, int x, int y, int side)
{
    enum lit lit = lit_of(cutting->projector, x, y, side);
    if (lit == LIT_NOT)
        return true;
    if (side <= cutting->least_px)
        return (lit == LIT_IN_PART && !any_pixel_lit(cutting->projector, x, y, side)) ||
               add_square(cutting, x, y, side);
    if (lit == LIT)
        return add_square(cutting, x, y, side);
    int half = side / 2;
    for (int quarter = 0; quarter < 4; quarter++)
        if (!cut_square(cutting, x + half * (quarter & 1), y + half * (quarter >> 1), half))
            return false;
    return true;
}

bool mask_squares_cut(const cupola_plan *plan, struct mask *mask)
{
    for (int output = 0; output < plan->dome.rig.output_count; output++) {
        const struct projector *projector = &plan->dome.projectors[output];
        /* An eye that moves pays for squares in every frame. */
        struct cutting cutting = {plan, projector, mask, plan->head_radius_m > 0 ? SMALL_PX : 1};
        int most = SMALL_PX; /* squares that are not small beside the circle bulge */
        while (most < MOST_PX && 32 * most <= projector->radius_px)
            most *= 2;
        for (int y = 0; y < projector->height_px; y += most)
            for (int x = 0; x < projector->width_px; x += most)
                if (!cut_square(&cutting, x, y, most))
                    return false;
    }
    return true;
}
