/* A viewer who moves: the filter that follows reports and looks ahead of them. */
#include "cupola/viewer.h"

#include <math.h>
#include <string.h>

#include "error.h"
#include "vector.h"

static const double memory_usual_s = 0.02;
static const double horizon_usual_s = 0.1;
static const double reach_usual = 0.9;
static const double farthest_m = 1e6;
/* Nobody's head is there: such a report would only spoil the velocity. In units of radius_m. */
static const double farthest_report = 100;

static int check_params(const struct cupola_viewer_params *params, struct cupola_error *error)
{
    if (!(params->memory_s >= 1e-4 && params->memory_s <= 10))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "memory is %g s; allowed: 0.0001 to 10, or 0 for the default",
                         params->memory_s);
    if (!(params->horizon_s <= 1))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "horizon is %g s; allowed: up to 1, 0 for the default, or below 0 for no "
                         "prediction",
                         params->horizon_s);
    if (!(params->radius_m > 0 && params->radius_m <= farthest_m))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "radius is %g m; allowed: above 0 and up to %g", params->radius_m,
                         farthest_m);
    if (!(params->reach > 0 && params->reach < 1))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "reach is %g; allowed: above 0 and below 1, or 0 for the default",
                         params->reach);
    for (int i = 0; i < 3; i++)
        if (!(fabs(params->center_m[i]) <= farthest_m))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "centre is (%g, %g, %g) m; allowed: -%g to %g each",
                             params->center_m[0], params->center_m[1], params->center_m[2],
                             farthest_m, farthest_m);
    return CUPOLA_OK;
}

int cupola_viewer_start(struct cupola_viewer *viewer, const struct cupola_viewer_params *params,
                        struct cupola_error *error)
{
    if (!viewer || !params)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", viewer ? "params" : "viewer");
    struct cupola_viewer fresh = {.params = *params, .started = true};
    if (fresh.params.memory_s == 0)
        fresh.params.memory_s = memory_usual_s;
    if (fresh.params.horizon_s == 0)
        fresh.params.horizon_s = horizon_usual_s;
    if (fresh.params.reach == 0)
        fresh.params.reach = reach_usual;
    int status = check_params(&fresh.params, error);
    if (status == CUPOLA_OK)
        *viewer = fresh;
    return status;
}

static bool is_acceptable(const struct cupola_viewer *viewer, double time_s,
                          const double position_m[3])
{
    double offset[3];

    if (!isfinite(time_s) || (viewer->reports > 0 && time_s <= viewer->time_s))
        return false;
    for (int i = 0; i < 3; i++) {
        if (!isfinite(position_m[i]))
            return false;
        offset[i] = position_m[i] / viewer->params.radius_m -
                    viewer->params.center_m[i] / viewer->params.radius_m;
    }
    return length3(offset) <= farthest_report;
}

/* After a long gap a velocity says nothing, neither the old one nor the mean of the gap. */
static bool begins_anew(const struct cupola_viewer *viewer, double interval_s)
{
    return viewer->reports == 0 || !(interval_s <= fmax(1, 10 * viewer->params.memory_s));
}

int cupola_viewer_report(struct cupola_viewer *viewer, double time_s, const double position_m[3])
{
    if (!viewer || !viewer->started || !position_m)
        return CUPOLA_ERROR_ARGUMENT;
    if (!is_acceptable(viewer, time_s, position_m)) {
        viewer->refused++;
        return 0;
    }
    double interval_s = time_s - viewer->time_s;
    if (begins_anew(viewer, interval_s)) {
        memcpy(viewer->position_m, position_m, sizeof viewer->position_m);
        memset(viewer->velocity_m_s, 0, sizeof viewer->velocity_m_s);
    } else {
        /* 1 - theta and 1 - theta^2, also where they are tiny */
        double forgotten = -expm1(-interval_s / viewer->params.memory_s);
        double g = -expm1(-2 * interval_s / viewer->params.memory_s);
        double h_by_s = forgotten * forgotten / interval_s;
        for (int i = 0; i < 3; i++) {
            double predicted = viewer->position_m[i] + viewer->velocity_m_s[i] * interval_s;
            double difference = position_m[i] - predicted;
            viewer->position_m[i] = predicted + g * difference;
            viewer->velocity_m_s[i] += h_by_s * difference;
        }
    }
    viewer->time_s = time_s;
    viewer->reports++;
    return 1;
}

/* Strictly inside of reach, whatever rounding does. */
static void keep_inside(const struct cupola_viewer_params *params, double eye_m[3])
{
    const double *center_m = params->center_m;
    double most = params->reach * params->radius_m * (1 - 1e-12) - 1e-15 * length3(center_m);
    double offset[3];

    for (int i = 0; i < 3; i++)
        offset[i] = eye_m[i] - center_m[i];
    double distance = length3(offset);
    if (distance <= most)
        return;
    for (int i = 0; i < 3; i++)
        eye_m[i] = center_m[i] + offset[i] * (fmax(most, 0) / distance);
}

int cupola_viewer_eye(const struct cupola_viewer *viewer, double time_s, double eye_m[3])
{
    if (!viewer || !viewer->started || !eye_m || !isfinite(time_s))
        return CUPOLA_ERROR_ARGUMENT;
    if (viewer->reports == 0)
        return 0;
    double ahead_s = fmax(0, fmin(time_s - viewer->time_s, viewer->params.horizon_s));
    for (int i = 0; i < 3; i++)
        eye_m[i] = viewer->position_m[i] + viewer->velocity_m_s[i] * ahead_s;
    keep_inside(&viewer->params, eye_m);
    return 1;
}
