/*
 * How many texels a unit of a base plane needs.
 *
 * With J the change of the base-plane point per pixel and S = diag(su, sv) the texels per unit of
 * the plane, a pixel gets at least one texel in every direction if the smaller singular value of
 * S J is at least 1, that is if S^2 - (J J^T)^-1 is positive semidefinite. For a given su^2 = p
 * that is a bound on sv^2 = q, and the least p q is found by a search over p.
 */
#include <math.h>

#include "plan.h"
#include "vector.h"

struct plan_footprint plan_footprint_of(const struct cupola_view *view, const struct varying *ray,
                                        const double base[2])
{
    double q[3], dx[3], dy[3];
    transform3(view->rotation, ray->at, q);
    transform3(view->rotation, ray->dx, dx);
    transform3(view->rotation, ray->dy, dy);
    double depth = -q[2];
    double a[2] = {(dx[0] + base[0] * dx[2]) / depth, (dy[0] + base[0] * dy[2]) / depth};
    double b[2] = {(dx[1] + base[1] * dx[2]) / depth, (dy[1] + base[1] * dy[2]) / depth};
    double determinant = a[0] * b[1] - a[1] * b[0];
    double scale = 1 / fmax(determinant * determinant, 1e-300);
    return (struct plan_footprint){
        .uu = scale * (b[0] * b[0] + b[1] * b[1]),
        .uv = -scale * (a[0] * b[0] + a[1] * b[1]),
        .vv = scale * (a[0] * a[0] + a[1] * a[1]),
    };
}

double plan_density_reached(const struct plan_footprint *f, const double density[2])
{
    double uu = f->uu / (density[0] * density[0]);
    double uv = f->uv / (density[0] * density[1]);
    double vv = f->vv / (density[1] * density[1]);
    double largest = 0.5 * (uu + vv) + sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
    return 1 / sqrt(largest);
}

/* The least q that every `stride`-th footprint allows with this p. */
static double least_q(const struct plan_footprint *footprints, size_t count, size_t stride,
                      double p)
{
    double q = 0;
    for (size_t i = 0; i < count; i += stride) {
        const struct plan_footprint *f = &footprints[i];
        q = fmax(q, f->vv + f->uv * f->uv / fmax(p - f->uu, 1e-300));
    }
    return q;
}

void plan_density_search(const struct plan_footprint *footprints, size_t count, double density[2])
{
    static const double golden = 0.6180339887498949;
    enum { STEPS = 24, SEARCHED = 4096 };
    /* The place of the least p q may be found on some of the footprints; q then holds for all. */
    size_t stride = count / SEARCHED + 1;
    double least_p = 0;
    for (size_t i = 0; i < count; i++)
        least_p = fmax(least_p, footprints[i].uu);

    /* Every footprint's p q is quasi-convex in p, and so is their largest: golden section over
     * p = least_p e^t. */
    double low = 1e-6, high = 3;
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
    density[0] = sqrt(p);
    density[1] = sqrt(least_q(footprints, count, 1, p));
}
