/*
 * The least texel metric of a view: the Loewner-John ellipse of its footprints.
 *
 * A pixel with footprint G = (J J^T)^-1 gets at least one texel in every direction if X - G is
 * positive semidefinite, X = R^T diag(su, sv)^2 R the metric of the view's texels with roll R.
 * That is: the ellipse of X holds that of G. The X of least determinant is the smallest ellipse
 * round the origin that holds all others; at most three points of them lie on it. Round by round
 * the farthest point outside joins the three, and the smallest ellipse through two or three of the
 * four that holds them all is next.
 */
#include "plan.h"
#include "vector.h"

double plan_excess(const struct plan_metric *x, const struct plan_metric *g)
{
    double det = x->uu * x->vv - x->uv * x->uv;
    /* Half of the trace of X^-1 G, and its determinant. */
    double half = 0.5 * (x->vv * g->uu + x->uu * g->vv - 2 * x->uv * g->uv) / det;
    double product = (g->uu * g->vv - g->uv * g->uv) / det;
    return half + sqrt(larger(half * half - product, 0));
}

/* The point of G's ellipse that lies farthest outside of that of X. */
static void farthest_point(const struct plan_metric *x, const struct plan_metric *g, double lambda,
                           double point[2])
{
    /* (G - lambda X) d = 0; the larger row is the better conditioned. */
    double a = g->uu - lambda * x->uu, b = g->uv - lambda * x->uv, c = g->vv - lambda * x->vv;
    double d[2] = {b, -a};
    if (fabs(c) + fabs(b) > fabs(a) + fabs(b)) {
        d[0] = c;
        d[1] = -b;
    }
    if (!(d[0] * d[0] + d[1] * d[1] > 0))
        d[0] = 1;
    double gx = g->uu * d[0] + g->uv * d[1], gy = g->uv * d[0] + g->vv * d[1];
    double scale = 1 / sqrt(gx * d[0] + gy * d[1]);
    point[0] = gx * scale;
    point[1] = gy * scale;
}

static struct plan_metric through_two(const double p[2], const double q[2])
{
    return (struct plan_metric){p[0] * p[0] + q[0] * q[0], p[0] * p[1] + q[0] * q[1],
                                p[1] * p[1] + q[1] * q[1]};
}

/* p^T Y p = 1 for three points, X = Y^-1. False if that is no ellipse. */
static bool through_three(const double *p, const double *q, const double *r, struct plan_metric *x)
{
    const double *points[3] = {p, q, r};
    double rows[3][3], y[3];
    for (int i = 0; i < 3; i++) {
        rows[i][0] = points[i][0] * points[i][0];
        rows[i][1] = 2 * points[i][0] * points[i][1];
        rows[i][2] = points[i][1] * points[i][1];
    }
    double bc[3], ca[3], ab[3];
    double columns[3][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            columns[k][i] = rows[i][k];
    cross3(columns[1], columns[2], bc);
    cross3(columns[2], columns[0], ca);
    cross3(columns[0], columns[1], ab);
    double det = dot3(columns[0], bc);
    y[0] = (bc[0] + bc[1] + bc[2]) / det;
    y[1] = (ca[0] + ca[1] + ca[2]) / det;
    y[2] = (ab[0] + ab[1] + ab[2]) / det;
    double y_det = y[0] * y[2] - y[1] * y[1];
    if (!(y[0] > 0 && y_det > 0 && isfinite(y_det)))
        return false;
    *x = (struct plan_metric){y[2] / y_det, -y[1] / y_det, y[0] / y_det};
    return true;
}

struct support {
    double points[4][2];
    int count;
    struct plan_metric x;
};

static bool holds(const struct plan_metric *x, const struct support *s)
{
    double det = x->uu * x->vv - x->uv * x->uv;
    for (int i = 0; i < s->count; i++) {
        const double *p = s->points[i];
        double form = x->vv * p[0] * p[0] - 2 * x->uv * p[0] * p[1] + x->uu * p[1] * p[1];
        if (!(form <= det * (1 + 1e-9)))
            return false;
    }
    return true;
}

/* The smallest ellipse of up to four points; the newest is the last and lies on it. */
static void reduce_support(struct support *s)
{
    int last = s->count - 1, best[2] = {-1, -1};
    double least = HUGE_VAL;
    struct plan_metric found = s->x;
    for (int i = 0; i < last; i++)
        for (int k = i; k < last; k++) {
            struct plan_metric x = through_two(s->points[last], s->points[i]);
            if (k > i && !through_three(s->points[last], s->points[i], s->points[k], &x))
                continue;
            double det = x.uu * x.vv - x.uv * x.uv;
            if (det > 0 && det < least && holds(&x, s)) {
                least = det;
                found = x;
                best[0] = i;
                best[1] = k;
            }
        }
    if (best[0] < 0)
        return; /* rounding errors only: X stays and the caller's bound closes the rest */
    struct support next = {.x = found};
    memcpy(next.points[next.count++], s->points[best[0]], sizeof *s->points);
    if (best[1] > best[0])
        memcpy(next.points[next.count++], s->points[best[1]], sizeof *s->points);
    memcpy(next.points[next.count++], s->points[last], sizeof *s->points);
    *s = next;
}

/* The footprint that sticks out most, of every stride-th one. */
static int most_excess(const struct plan_metric *x, const struct plan_metric *footprints, int count,
                       int stride, double *excess)
{
    int worst = 0;
    double most = 0, per_det = 1 / (x->uu * x->vv - x->uv * x->uv);
    double a = 0.5 * x->vv * per_det, b = -x->uv * per_det, c = 0.5 * x->uu * per_det;
    for (int i = 0; i < count; i += stride) {
        const struct plan_metric *g = &footprints[i];
        double half = a * g->uu + b * g->uv + c * g->vv;
        if (2 * half <= most)
            continue; /* the trace bounds the eigenvalue */
        double product = (g->uu * g->vv - g->uv * g->uv) * per_det;
        double lambda = half + sqrt(larger(half * half - product, 0));
        if (lambda > most) {
            most = lambda;
            worst = i;
        }
    }
    *excess = most;
    return worst;
}

/* Moves the footprints that come near to the boundary of X to the front; returns their number. */
static int sort_near(const struct plan_metric *x, struct plan_metric *footprints, int count)
{
    static const double near = 0.85;
    int found = 0;
    for (int i = 0; i < count; i++)
        if (plan_excess(x, &footprints[i]) > near) {
            struct plan_metric moved = footprints[found];
            footprints[found++] = footprints[i];
            footprints[i] = moved;
        }
    return found;
}

/* The ellipse of one footprint, by two of its points. */
static void begin_support(const struct plan_metric *g, struct support *s)
{
    double root = sqrt(g->uu);
    *s = (struct support){.count = 2, .x = *g};
    s->points[0][0] = root;
    s->points[0][1] = g->uv / root;
    s->points[1][0] = 0;
    s->points[1][1] = sqrt(larger(g->vv - g->uv * g->uv / g->uu, 0));
}

/* Rounds until nothing sticks out of the ellipse by more than `slack`. */
static void grow_support(const struct plan_metric *footprints, int count, int stride,
                         struct support *s)
{
    enum { ROUNDS = 16 };
    static const double slack = 1 + 3e-4;
    double excess;
    for (int round = 0; round < ROUNDS && s->count <= 3; round++) {
        int worst = most_excess(&s->x, footprints, count, stride, &excess);
        if (excess <= slack)
            return;
        farthest_point(&s->x, &footprints[worst], excess, s->points[s->count++]);
        reduce_support(s);
    }
}

struct plan_metric plan_enclose(struct plan_metric *footprints, int count)
{
    int largest = 0;
    double excess;
    struct support s;
    for (int i = 1; i < count; i++)
        if (footprints[i].uu + footprints[i].vv > footprints[largest].uu + footprints[largest].vv)
            largest = i;
    begin_support(&footprints[largest], &s);
    /* First on some of the footprints, then on those that are near to the boundary. */
    grow_support(footprints, count, count > 40 ? 4 : 1, &s);
    grow_support(footprints, sort_near(&s.x, footprints, count), 1, &s);
    most_excess(&s.x, footprints, count, 1, &excess);
    return (struct plan_metric){s.x.uu * excess, s.x.uv * excess, s.x.vv * excess};
}

/* The least q that every `stride`-th footprint allows with this p. */
static double least_q(const struct plan_metric *footprints, int count, int stride, double p)
{
    double q = 0;
    for (int i = 0; i < count; i += stride) {
        const struct plan_metric *g = &footprints[i];
        q = larger(q, g->vv + g->uv * g->uv / larger(p - g->uu, 1e-300));
    }
    return q;
}

/*
 * For a given X.uu = p each footprint bounds X.vv = q from below. Every footprint's p q is
 * quasi-convex in p, and so is the largest of them: golden section over p = least_p e^t.
 */
struct plan_metric plan_enclose_upright(const struct plan_metric *footprints, int count)
{
    static const double golden = 0.6180339887498949;
    enum { STEPS = 24, SEARCHED = 1024 };
    /* The place of the least p q may be found on some of the footprints; q then holds for all. */
    int stride = count / SEARCHED + 1;
    double least_p = 0, low = 1e-6, high = 3;
    for (int i = 0; i < count; i++)
        least_p = larger(least_p, footprints[i].uu);
    for (int step = 0; step < STEPS; step++) {
        double lower = high - golden * (high - low), upper = low + golden * (high - low);
        double p_lower = least_p * exp(lower), p_upper = least_p * exp(upper);
        if (p_lower * least_q(footprints, count, stride, p_lower) <=
            p_upper * least_q(footprints, count, stride, p_upper))
            high = upper;
        else
            low = lower;
    }
    double p = least_p * exp(0.5 * (low + high));
    return (struct plan_metric){p, 0, least_q(footprints, count, 1, p)};
}

double plan_roll_of(const struct plan_metric *x)
{
    return 0.5 * atan2(2 * x->uv, x->uu - x->vv);
}

void plan_roll_by(double angle, double rotation[9])
{
    double c = cos(angle), s = sin(angle);
    for (int i = 0; i < 3; i++) {
        double right = rotation[i], up = rotation[3 + i];
        rotation[i] = c * right + s * up;
        rotation[3 + i] = c * up - s * right;
    }
}

struct plan_metric plan_enclose_rolled(const struct plan_metric *x, double angle)
{
    double c = cos(angle), s = sin(angle);
    double uu = c * c * x->uu + 2 * c * s * x->uv + s * s * x->vv;
    double vv = s * s * x->uu - 2 * c * s * x->uv + c * c * x->vv;
    double uv = fabs(c * s * (x->vv - x->uu) + (c * c - s * s) * x->uv), ratio = sqrt(uu / vv);
    return (struct plan_metric){uu + uv * ratio, 0, vv + uv / ratio};
}
