/* How uncertain the viewer's directions are: the values' covariance through their derivatives. */
#include "view_certainty.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/dome.h>

#include "order.h"

enum { ACROSS = 20, PLACES_MAX = ACROSS * ACROSS, COLUMNS_MAX = MODEL_VALUES_MAX + 1 };

struct view {
    int output;
    cupola_dome *dome; /* as solved */
    int places;
    double place_px[PLACES_MAX][2];
    /* Of every place, the direction's change by every value. */
    double change[COLUMNS_MAX][PLACES_MAX][3];
};

/* A grid over image circle and frame buffer. */
static void find_places(struct view *view, const struct cupola_output *output)
{
    const struct cupola_circle *circle = &output->circle;
    double low_x = fmax(circle->center_x_px - circle->radius_px, 0);
    double low_y = fmax(circle->center_y_px - circle->radius_px, 0);
    double high_x = fmin(circle->center_x_px + circle->radius_px, output->width_px);
    double high_y = fmin(circle->center_y_px + circle->radius_px, output->height_px);

    for (int i = 0; i < PLACES_MAX; i++) {
        double x = low_x + (high_x - low_x) * (i % ACROSS + 0.5) / ACROSS;
        double y = low_y + (high_y - low_y) * (i / ACROSS + 0.5) / ACROSS;
        struct cupola_ray ray;
        if (cupola_dome_ray(view->dome, view->output, NULL, x, y, &ray) != 1)
            continue;
        view->place_px[view->places][0] = x;
        view->place_px[view->places++][1] = y;
    }
}

/* The dome as it would be at some values; the radius of the screen on top, where points tell it. */
static cupola_dome *dome_at(const struct model *model, const struct cupola_rig *rig, int output,
                            const double *x, double more_radius_m)
{
    struct model_base at;
    struct cupola_rig moved = *rig;
    cupola_dome *dome = NULL;

    model_apply(model, x, &at);
    moved.outputs[output] = at.output;
    if (model->marks->kind == MARKS_DIRECTIONS)
        moved.screen.radius_m = at.radius_m;
    moved.screen.radius_m += more_radius_m;
    return cupola_dome_create(&moved, &dome, NULL) < 0 ? NULL : dome;
}

static void derive(struct view *view, int column, const struct model *model,
                   const struct cupola_rig *rig)
{
    const double step = 1e-6;
    cupola_dome *side[2];

    for (int s = 0; s < 2; s++) {
        double x[COLUMNS_MAX] = {0}, way = s ? step : -step;
        x[column] = way;
        side[s] = dome_at(model, rig, view->output, x, column == model->count ? way : 0);
    }
    for (int i = 0; i < view->places; i++) {
        struct cupola_ray ray[2];
        bool known = true;
        for (int s = 0; s < 2; s++) {
            const cupola_dome *dome = side[s] ? side[s] : view->dome;
            known = known && cupola_dome_ray(dome, view->output, NULL, view->place_px[i][0],
                                             view->place_px[i][1], &ray[s]) >= 0;
        }
        double width = step * ((side[0] != NULL) + (side[1] != NULL));
        for (int k = 0; k < 3; k++)
            view->change[column][i][k] =
                known && width > 0 ? (ray[1].direction[k] - ray[0].direction[k]) / width : 0;
    }
    cupola_dome_destroy(&side[0]);
    cupola_dome_destroy(&side[1]);
}

/* The root of the summed variances of a direction's components. */
static double uncertainty(const struct view *view, const struct certainty *certainty,
                          double radius_sd_m, int place)
{
    int n = certainty->count;
    double sum = 0;

    for (int i = 0; i < n * n; i++) {
        const double *a = view->change[i / n][place], *b = view->change[i % n][place];
        sum += certainty->covariance[i] * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
    }
    const double *r = view->change[n][place];
    double by_radius = radius_sd_m * radius_sd_m * (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    return sqrt(fmax(sum, 0) * certainty->noise_px * certainty->noise_px + by_radius);
}

bool view_certainty_find(const struct model *model, const struct certainty *certainty,
                         struct solve_result *result, int output)
{
    struct view *view = calloc(1, sizeof *view);
    double sd_rad[PLACES_MAX];
    double radius_sd_m = model->marks->kind == MARKS_POINTS ? result->radius_sd_m : 0;

    if (!view || cupola_dome_create(&result->rig, &view->dome, NULL) < 0) {
        free(view);
        return false;
    }
    view->output = output;
    find_places(view, &result->rig.outputs[output]);
    for (int i = 0; i <= model->count; i++) {
        if (i < model->count || radius_sd_m > 0)
            derive(view, i, model, &result->rig);
    }
    for (int i = 0; i < view->places; i++)
        sd_rad[i] = uncertainty(view, certainty, radius_sd_m, i);
    if (view->places > 0) {
        order_sort(sd_rad, view->places);
        result->worst_direction_sd_rad = sd_rad[view->places - 1];
        result->direction_sd_rad = sd_rad[view->places / 2];
    }
    cupola_dome_destroy(&view->dome);
    free(view);
    return true;
}
