/*
 * What views cost, from the rays at pixels and nothing of the planner: roll, densities, rectangles
 * and cost as struct cupola_cost and docs/geometry.md define them, found by trying.
 */
#ifndef PLAN_BRUTE_H
#define PLAN_BRUTE_H

#include <stdlib.h>

#include "plan_pixels.h"

/* Of a pixel, or of several. */
struct brute_ray {
    double at[3], dx[3], dy[3]; /* unit length, its change per pixel */
    double pixels, solid_angle; /* that it stands for */
    int step;                   /* pixels each way */
};

struct brute_rays {
    int count;
    struct brute_ray *list;
    double pixels, mean[3];
};

/* Views in the middle of being tried. */
struct brute_views {
    int count;
    double axis[CUPOLA_VIEWS_MAX][3], up[CUPOLA_VIEWS_MAX][3];
    double selector[CUPOLA_VIEWS_MAX][3];
    double texels[CUPOLA_VIEWS_MAX]; /* per unit of the base plane */
    double cost;                     /* per pixel */
};

struct brute_wish {
    struct cupola_cost cost; /* complete */
    int unmasked;
    double guard;
    int rolls; /* tried per quarter turn */
};

static const double brute_reach = 0.17364817766693033; /* the cosine of 80 degrees */

static inline double dot_of(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross_of(const double a[3], const double b[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static inline void unit(double v[3])
{
    double length = sqrt(dot_of(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/*
 * Where the whole rim of a lens shows nearly one point a pixel counts as no narrower than a quarter
 * of the lens's mean radial step; for lenses at the centre, which is where such are tried.
 */
static inline void widen_rim(const struct cupola_output *output, double x, double y,
                             struct brute_ray *ray)
{
    double across = x - output->circle.center_x_px, along = y - output->circle.center_y_px;
    double r = hypot(across, along), tangent[3], radial[3];
    double least = 0.125 * output->lens.fov_rad / output->circle.radius_px;
    if (output->lens.fov_rad < radians(280.0) || r < 0.5 * output->circle.radius_px)
        return;
    across /= r;
    along /= r;
    for (int i = 0; i < 3; i++) {
        tangent[i] = across * ray->dy[i] - along * ray->dx[i];
        radial[i] = across * ray->dx[i] + along * ray->dy[i];
    }
    double length = sqrt(dot_of(tangent, tangent));
    for (int i = 0; i < 3; i++) {
        tangent[i] *= fmax(1.0, least / length);
        ray->dx[i] = across * radial[i] - along * tangent[i];
        ray->dy[i] = along * radial[i] + across * tangent[i];
    }
}

/* One pixel in `step` each way, and all of those that the rim cuts in one of `step` alone. */
static inline void gather_output(const cupola_dome *dome, int index, int step,
                                 struct brute_rays *rays)
{
    const struct cupola_output *output = &cupola_dome_rig(dome)->outputs[index];
    int cut = 0;
    for (int j = 0; j < output->height_px; j++)
        for (int i = 0; i < output->width_px; i++) {
            struct cupola_ray seen;
            int chosen = i % step == step / 2 && j % step == step / 2;
            if (cupola_dome_ray(dome, index, NULL, i + 0.5, j + 0.5, &seen) != 1)
                continue;
            if (!chosen && (seen.coverage >= 1.0 || cut++ % step))
                continue;
            struct brute_ray *ray = &rays->list[rays->count++];
            double pixels = chosen ? (double)(step * step) * seen.coverage : 0.0;
            *ray = (struct brute_ray){.pixels = pixels,
                                      .solid_angle = pixels * seen.solid_angle_sr,
                                      .step = chosen ? step : 1};
            memcpy(ray->at, seen.direction, sizeof ray->at);
            memcpy(ray->dx, seen.direction_dx, sizeof ray->dx);
            memcpy(ray->dy, seen.direction_dy, sizeof ray->dy);
            widen_rim(output, i + 0.5, j + 0.5, ray);
            rays->pixels += pixels;
            for (int k = 0; k < 3; k++)
                rays->mean[k] += ray->solid_angle * ray->at[k];
        }
}

static inline struct brute_rays gather(const cupola_dome *dome, int step)
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    struct brute_rays rays = {.count = 0};
    size_t room = 0;
    for (int i = 0; i < rig->output_count; i++)
        room += (size_t)rig->outputs[i].width_px * (size_t)rig->outputs[i].height_px;
    rays.list = calloc(room, sizeof *rays.list);
    assert_non_null(rays.list);
    for (int i = 0; i < rig->output_count; i++)
        gather_output(dome, i, step, &rays);
    unit(rays.mean);
    return rays;
}

/* (J J^T)^-1 of a ray in a view's frame. */
struct footprint {
    double uu, uv, vv, u, v;
    double pixel[4]; /* J of all that the ray stands for: a rectangle holds whole pixels */
};

struct brute_fit {
    int count;
    struct footprint *list;
    double area; /* of the base plane */
};

/* False where the ray is out of reach. */
static inline int add_footprint(const double right[3], const double up[3], const double axis[3],
                                const struct brute_ray *ray, struct brute_fit *fit)
{
    double c = dot_of(axis, ray->at), j[4], u = dot_of(right, ray->at), v = dot_of(up, ray->at);
    if (!(c >= brute_reach))
        return 0;
    for (int way = 0; way < 2; way++) {
        const double *change = way ? ray->dy : ray->dx;
        double away = dot_of(axis, change);
        j[way] = (dot_of(right, change) * c - u * away) / (c * c);
        j[2 + way] = (dot_of(up, change) * c - v * away) / (c * c);
    }
    double a = j[0] * j[0] + j[1] * j[1], d = j[2] * j[2] + j[3] * j[3];
    double b = j[0] * j[2] + j[1] * j[3], det = j[0] * j[3] - j[1] * j[2];
    fit->list[fit->count++] =
        (struct footprint){d / (det * det), -b / (det * det), a / (det * det), u / c, v / c, {0}};
    for (int i = 0; i < 4; i++)
        fit->list[fit->count - 1].pixel[i] = j[i] * ray->step;
    fit->area += ray->pixels * fabs(det);
    return 1;
}

/* The least q = s_v^2 that all of them allow with p = s_u^2. */
static inline double least_v(const struct footprint *list, int count, double p)
{
    double q = 0.0;
    for (int i = 0; i < count; i++) {
        double beside = p - list[i].uu;
        double asked =
            list[i].vv + list[i].uv * list[i].uv / (beside > 1e-9 * p ? beside : 1e-9 * p);
        q = asked > q ? asked : q;
    }
    return q;
}

/* Densities of least product for a roll: tries 12 of s_u. */
static inline void try_densities(const struct brute_fit *fit, double s[2])
{
    double least_p = 0.0, low = 0.0, high = 2.0;
    for (int i = 0; i < fit->count; i++)
        least_p = fmax(least_p, fit->list[i].uu);
    for (int step = 0; step < 12; step++) {
        double third = (high - low) / 3.0;
        double first = least_p * exp(low + third), second = least_p * exp(high - third);
        if (first * least_v(fit->list, fit->count, first) <=
            second * least_v(fit->list, fit->count, second))
            high -= third;
        else
            low += third;
    }
    double p = least_p * exp(0.5 * (low + high));
    s[0] = sqrt(p);
    s[1] = sqrt(least_v(fit->list, fit->count, p));
}

static inline void turn_by(double angle, struct brute_fit *fit)
{
    double c = cos(angle), s = sin(angle);
    for (int i = 0; i < fit->count; i++) {
        struct footprint *f = &fit->list[i], was = *f;
        f->uu = c * c * was.uu + 2.0 * c * s * was.uv + s * s * was.vv;
        f->vv = s * s * was.uu - 2.0 * c * s * was.uv + c * c * was.vv;
        f->uv = c * s * (was.vv - was.uu) + (c * c - s * s) * was.uv;
        f->u = c * was.u + s * was.v;
        f->v = c * was.v - s * was.u;
        for (int way = 0; way < 2; way++) {
            f->pixel[way] = c * was.pixel[way] + s * was.pixel[2 + way];
            f->pixel[2 + way] = c * was.pixel[2 + way] - s * was.pixel[way];
        }
    }
}

/* Of a view with its own densities, texels. */
static inline double texels_of(const struct brute_wish *wish, double width, double height,
                               double sampled, double rect)
{
    double guard = 2.0 * wish->guard;
    double masked = fmin(sampled + guard * (width + height + guard), rect);
    return (wish->unmasked ? rect : masked) + wish->cost.texel_allocated * rect;
}

static inline void bounds_of(const struct brute_fit *fit, double bounds[4])
{
    bounds[0] = bounds[2] = HUGE_VAL;
    bounds[1] = bounds[3] = -HUGE_VAL;
    for (int i = 0; i < fit->count; i++) {
        const struct footprint *f = &fit->list[i];
        double half_u = 0.5 * (fabs(f->pixel[0]) + fabs(f->pixel[1]));
        double half_v = 0.5 * (fabs(f->pixel[2]) + fabs(f->pixel[3]));
        bounds[0] = fmin(bounds[0], f->u - half_u);
        bounds[1] = fmax(bounds[1], f->u + half_u);
        bounds[2] = fmin(bounds[2], f->v - half_v);
        bounds[3] = fmax(bounds[3], f->v + half_v);
    }
}

/* Tries rolls; the cost in texels, and texels per unit of the base plane. */
static inline double fit_view(const struct brute_wish *wish, struct brute_fit *fit, double *texels)
{
    double least = HUGE_VAL;
    for (int roll = 0; roll < wish->rolls; roll++) {
        double s[2], bounds[4];
        if (roll > 0)
            turn_by(radians(90.0) / wish->rolls, fit);
        try_densities(fit, s);
        bounds_of(fit, bounds);
        double width = s[0] * (bounds[1] - bounds[0]), height = s[1] * (bounds[3] - bounds[2]);
        /* Whole texels, a quarter of one to spare on each side. */
        double rect =
            (ceil(width + 0.5) + 2.0 * wish->guard) * (ceil(height + 0.5) + 2.0 * wish->guard);
        double cost = texels_of(wish, width, height, fit->area * s[0] * s[1], rect);
        if (cost < least) {
            least = cost;
            *texels = s[0] * s[1];
        }
    }
    return least;
}

/* How many views an object of 2 degrees in a ray's direction is drawn into. */
static inline int drawn_into(double selectors[][3], int count, const double at[3], int own)
{
    int drawn = 1;
    for (int v = 0; v < count; v++) {
        double apart[3];
        for (int i = 0; i < 3; i++)
            apart[i] = selectors[own][i] - selectors[v][i];
        drawn += v != own && dot_of(apart, at) < sin(radians(2.0)) * sqrt(dot_of(apart, apart));
    }
    return drawn;
}

static inline int own_view(double selectors[][3], int count, const double at[3])
{
    int own = 0;
    for (int v = 1; v < count; v++)
        if (dot_of(selectors[v], at) > dot_of(selectors[own], at))
            own = v;
    return own;
}

/* Fits every view to the rays whose product with its selector is largest. */
static inline void evaluate(const struct brute_rays *rays, const struct brute_wish *wish,
                            unsigned char *owner, struct footprint *room, struct brute_views *views)
{
    double drawn = 0.0, sum = wish->cost.view * views->count * rays->pixels;
    views->cost = HUGE_VAL;
    for (int i = 0; i < rays->count; i++) {
        const double *at = rays->list[i].at;
        owner[i] = (unsigned char)own_view(views->selector, views->count, at);
        if (wish->cost.vertices > 0.0)
            drawn +=
                rays->list[i].solid_angle * drawn_into(views->selector, views->count, at, owner[i]);
    }
    for (int v = 0; v < views->count; v++) {
        struct brute_fit fit = {.list = room};
        double right[3];
        cross_of(views->axis[v], views->up[v], right);
        for (int i = 0; i < rays->count; i++)
            if (owner[i] == v &&
                !add_footprint(right, views->up[v], views->axis[v], &rays->list[i], &fit))
                return;
        if (fit.count == 0)
            return;
        sum += fit_view(wish, &fit, &views->texels[v]);
    }
    sum += wish->cost.vertices * rays->pixels * drawn / (4.0 * 3.14159265358979);
    views->cost = sum / rays->pixels;
}

#endif
