/* Every lit pixel of a plan's outputs and where it falls, by brute force; shared by the tests. */
#ifndef PLAN_PIXELS_H
#define PLAN_PIXELS_H

#include "cupola/plan.h"
#include "oracle.h"

struct plan_pixel {
    int x, y;
    struct cupola_ray ray;
    int in_circle; /* the pixel's middle is: r <= 1 */
    int view;
    double texel[2];
    double jacobian[4]; /* texels per pixel: dx/di, dx/dj, dy/di, dy/dj */
};

typedef void (*plan_visitor)(const cupola_plan *plan, const struct plan_pixel *pixel, void *user);

static inline void texel_of(const cupola_plan *plan, int view, const double direction[3],
                            double texel[2])
{
    if (cupola_plan_texel(plan, view, direction, texel) != 1)
        fail_msg("a ray does not meet view %d", view);
}

/* Differences over 1e-5 rad, of a map whose second derivative is at most some 100 of its first. */
static inline void texel_change(const cupola_plan *plan, int view, const double direction[3],
                                const double change[3], double *dx, double *dy)
{
    double ahead[3], back[3], there[2], here[2], square = 0.0;
    for (int i = 0; i < 3; i++)
        square += change[i] * change[i];
    double step = 1e-5 / sqrt(square);
    for (int i = 0; i < 3; i++) {
        ahead[i] = direction[i] + step * change[i];
        back[i] = direction[i] - step * change[i];
    }
    texel_of(plan, view, ahead, there);
    texel_of(plan, view, back, here);
    *dx = (there[0] - here[0]) / (2.0 * step);
    *dy = (there[1] - here[1]) / (2.0 * step);
}

static inline void visit_output(const cupola_plan *plan, int index, plan_visitor visit, void *user)
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_output *output = &cupola_dome_rig(dome)->outputs[index];
    int step = output->width_px > 1000 ? 5 : 1; /* the whole rim, and inside one in 25 */
    for (int j = 0; j < output->height_px; j++) {
        for (int i = 0; i < output->width_px; i++) {
            struct plan_pixel pixel;
            double x = i + 0.5, y = j + 0.5, *to = pixel.jacobian;
            pixel.x = i;
            pixel.y = j;
            int lit = cupola_dome_ray(dome, index, NULL, x, y, &pixel.ray);
            check_at_least(lit, 0);
            if (!lit || (step > 1 && (i % step || j % step) && pixel.ray.coverage >= 1.0))
                continue;
            pixel.in_circle = hypot(x - output->circle.center_x_px,
                                    y - output->circle.center_y_px) <= output->circle.radius_px;
            pixel.view = cupola_plan_select(plan, pixel.ray.direction);
            check_at_least(pixel.view, 0);
            check_at_most(pixel.view, cupola_plan_view_count(plan) - 1);
            texel_of(plan, pixel.view, pixel.ray.direction, pixel.texel);
            texel_change(plan, pixel.view, pixel.ray.direction, pixel.ray.direction_dx, &to[0],
                         &to[2]);
            texel_change(plan, pixel.view, pixel.ray.direction, pixel.ray.direction_dy, &to[1],
                         &to[3]);
            visit(plan, &pixel, user);
        }
    }
}

static inline void visit_pixels(const cupola_plan *plan, plan_visitor visit, void *user)
{
    int outputs = cupola_dome_rig(cupola_plan_dome(plan))->output_count;
    for (int i = 0; i < outputs; i++)
        visit_output(plan, i, visit, user);
}

/* The least and the product of the singular values of a 2 x 2 matrix. */
static inline double smaller_singular_value(const double m[4])
{
    double sum = m[0] * m[0] + m[1] * m[1] + m[2] * m[2] + m[3] * m[3];
    double product = fabs(m[0] * m[3] - m[1] * m[2]);
    double larger = (sum + sqrt(fmax(0.0, sum * sum - 4.0 * product * product))) / 2.0;
    return product / sqrt(larger);
}

static inline double area_factor(const double m[4])
{
    return fabs(m[0] * m[3] - m[1] * m[2]);
}

/* The plan, which must be possible. */
static inline cupola_plan *plan_of(const struct cupola_rig *rig,
                                   const struct cupola_plan_params *params)
{
    cupola_dome *dome = dome_of(rig);
    cupola_plan *plan = NULL;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_plan_create(dome, params, &plan, &error) != CUPOLA_OK)
        fail_msg("plan: %s", error.message);
    cupola_dome_destroy(&dome);
    return plan;
}

/* The error that it ends in; CUPOLA_OK where a plan was made (and destroyed). */
static inline int plan_status(const struct cupola_rig *rig, const struct cupola_plan_params *params,
                              struct cupola_error *error)
{
    cupola_dome *dome = dome_of(rig);
    cupola_plan *plan = NULL;
    int status = cupola_plan_create(dome, params, &plan, error);
    if (status < 0)
        assert_null(plan);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    return status;
}

/*
 * A random theatre whose rays any layout with enough views reaches, and wishes that are legal:
 * asymmetric layouts only for lenses up to 130 degrees whose eye and projector are near the centre.
 */
static inline void random_plan_case(uint64_t *seed, struct cupola_rig *rig,
                                    struct cupola_plan_params *params)
{
    *rig = random_rig(seed, 0.3);
    memset(params, 0, sizeof *params);
    rig->outputs[0].aim.yaw_rad *= 0.1;
    rig->outputs[0].aim.pitch_rad *= 0.2;
    rig->tilt_rad *= 0.1;
    params->layout = (enum cupola_layout)random_int(seed, 0, 2);
    params->guard_px = random_int(seed, 0, 1) ? random_int(seed, 1, 9) : 0;
    params->density = random_int(seed, 0, 1) ? random_between(seed, 0.7, 1.6) : 0.0;
    if (params->layout == CUPOLA_LAYOUT_ASYMMETRIC) {
        double most = rig->outputs[0].lens.model == CUPOLA_LENS_POLYNOMIAL ? 130.0 : 120.0;
        rig->outputs[0].lens = random_lens(seed, rig->outputs[0].lens.model,
                                           radians(random_between(seed, 90.0, most)));
        for (int i = 0; i < 3; i++) {
            rig->eye_m[i] *= 0.3;
            rig->outputs[0].position_m[i] *= 0.3;
        }
        params->views = random_int(seed, 0, 8);
    } else if (params->layout == CUPOLA_LAYOUT_ROTATED) {
        params->views = random_int(seed, 0, 1) ? random_int(seed, 6, 8) : 0;
    }
}

#endif
