/* What is solved for as a list of numbers, and the pixels that they predict. */
#include "model.h"

#include <math.h>
#include <string.h>

#include <cupola/projection.h>

#include "rotation.h"

static void add(struct model *model, enum model_value value, double unit)
{
    model->values[model->count] = value;
    model->units[model->count++] = unit;
}

/* Any common factor of the coefficients cancels: the first that is not 0 stays. */
static void add_coefficients(struct model *model)
{
    const struct cupola_lens *lens = &model->base.output.lens;
    double half = 0.5 * lens->fov_rad;
    int first = 0, last = 3;

    if (lens->model != CUPOLA_LENS_POLYNOMIAL)
        return;
    while (first < 3 && lens->k[first] == 0)
        first++;
    while (last > first && lens->k[last] == 0)
        last--;
    for (int i = first + 1; i <= last; i++)
        add(model, (enum model_value)(VALUE_K1 + i),
            fabs(lens->k[first]) * pow(half, 2 * (first - i)));
}

void model_begin(struct model *model, const struct solve_request *request, int free)
{
    const struct cupola_output *output = &request->start->outputs[request->output];

    *model = (struct model){
        .marks = request->marks,
        .free = free,
        .base = {*output, request->start->screen.radius_m},
        .radius_px = output->circle.radius_px,
        .screen_m = request->start->screen.radius_m,
    };
    for (int i = 0; i < 2 && free & SOLVE_CIRCLE; i++)
        add(model, (enum model_value)(VALUE_CIRCLE_X + i), model->radius_px);
    if (free & SOLVE_CIRCLE_RADIUS)
        add(model, VALUE_CIRCLE_RADIUS, model->radius_px);
    if (free & SOLVE_LENS) {
        add(model, VALUE_FOV, output->lens.fov_rad);
        add_coefficients(model);
    }
    for (int i = 0; i < 3 && free & SOLVE_POSITION; i++)
        add(model, (enum model_value)(VALUE_X + i), model->screen_m);
    for (int i = 0; i < 3 && free & SOLVE_AIM; i++)
        add(model, (enum model_value)(VALUE_AIM_X + i), 1);
    if (free & SOLVE_RADIUS && model->marks->kind == MARKS_DIRECTIONS)
        add(model, VALUE_RADIUS, model->screen_m);
}

static void turn(struct cupola_aim *aim, const double w[3])
{
    double before[9], by[9], after[9];

    if (w[0] == 0 && w[1] == 0 && w[2] == 0)
        return;
    rotation_from_aim(aim, before);
    rotation_from_vector(w, by);
    rotation_multiply(before, by, after);
    rotation_to_aim(after, aim);
}

void model_apply(const struct model *model, const double *x, struct model_base *solved)
{
    struct cupola_output *output = &solved->output;
    double w[3] = {0, 0, 0};

    *solved = model->base;
    for (int i = 0; i < model->count; i++) {
        double step = x[i] * model->units[i];
        double factor = exp(fmin(fmax(x[i], -20), 20));
        switch (model->values[i]) {
        case VALUE_CIRCLE_X:
            output->circle.center_x_px += step;
            break;
        case VALUE_CIRCLE_Y:
            output->circle.center_y_px += step;
            break;
        case VALUE_CIRCLE_RADIUS:
            output->circle.radius_px *= factor;
            break;
        case VALUE_FOV:
            output->lens.fov_rad *= factor;
            break;
        case VALUE_X:
        case VALUE_Y:
        case VALUE_Z:
            output->position_m[model->values[i] - VALUE_X] += step;
            break;
        case VALUE_AIM_X:
        case VALUE_AIM_Y:
        case VALUE_AIM_Z:
            w[model->values[i] - VALUE_AIM_X] = x[i];
            break;
        case VALUE_RADIUS:
            solved->radius_m *= factor;
            break;
        default:
            output->lens.k[model->values[i] - VALUE_K1] += step;
        }
    }
    turn(&output->aim, w);
}

void model_point(const struct model *model, double radius_m, int mark, double point_m[3])
{
    double scale = model->marks->kind == MARKS_POINTS ? 1 : radius_m;

    for (int i = 0; i < 3; i++)
        point_m[i] = scale * model->marks->list[mark].place[i];
}

bool model_residuals(const struct model *model, const struct model_base *at, const int *chosen,
                     int count, bool weighted, double *residuals_px)
{
    enum { BLOCK = 128 };
    double points_m[3 * BLOCK], pixels_px[2 * BLOCK];

    for (int from = 0; from < count; from += BLOCK) {
        int size = count - from < BLOCK ? count - from : BLOCK;
        for (int i = 0; i < size; i++)
            model_point(model, at->radius_m, chosen ? chosen[from + i] : from + i,
                        points_m + 3 * i);
        if (cupola_output_pixels(&at->output, size, points_m, pixels_px, NULL) < 0)
            return false;
        for (int i = 0; i < 2 * size; i++) {
            int mark = chosen ? chosen[from + i / 2] : from + i / 2;
            double weight = weighted && model->weights ? model->weights[mark] : 1;
            residuals_px[2 * from + i] =
                weight * (model->marks->list[mark].pixel_px[i % 2] - pixels_px[i]);
        }
    }
    return true;
}

/* Of one value; where one side is impossible (an opening at its limit), of the other alone. */
static void derive(const struct model *model, const double *x, int value, const int *chosen,
                   int count, double *column, double *room)
{
    const double step = 1e-6;
    double moved[MODEL_VALUES_MAX], width = 0;
    double *side[2] = {room, column};

    memcpy(moved, x, (size_t)model->count * sizeof *moved);
    for (int s = 0; s < 2; s++) {
        struct model_base at;
        moved[value] = x[value] + (s ? step : -step);
        model_apply(model, moved, &at);
        if (model_residuals(model, &at, chosen, count, true, side[s])) {
            width += step;
            continue;
        }
        model_apply(model, x, &at);
        if (!model_residuals(model, &at, chosen, count, true, side[s]))
            width = -HUGE_VAL;
    }
    for (int i = 0; i < 2 * count; i++)
        column[i] = width > 0 ? (side[1][i] - side[0][i]) / width : 0;
}

void model_jacobian(const struct model *model, const double *x, const int *chosen, int count,
                    double *jacobian)
{
    size_t rows = 2 * (size_t)count;

    for (int i = 0; i < model->count; i++)
        derive(model, x, i, chosen, count, jacobian + rows * (size_t)i,
               jacobian + rows * (size_t)model->count);
}

const char *model_value_name(enum model_value value)
{
    static const char *const names[] = {"circle x",
                                        "circle y",
                                        "circle-radius",
                                        "lens fov",
                                        "lens k1",
                                        "lens k3",
                                        "lens k5",
                                        "lens k7",
                                        "position x",
                                        "position y",
                                        "position z",
                                        "aim up and down",
                                        "aim left and right",
                                        "aim roll",
                                        "radius"};

    return names[value];
}

double model_px_per_rad(const struct model *model)
{
    return model->radius_px / (0.5 * model->base.output.lens.fov_rad);
}
