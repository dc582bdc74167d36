/* How well the marks determine what was solved for. */
#include "certainty.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "option_values.h"
#include "rotation.h"
#include "solve/view_certainty.h"
#include "symmetric.h"

/* Beyond this sd a value is worth nothing, in its scaled unit; from a tenth of it on it is weak. */
static double limit(enum model_value value)
{
    switch (value) {
    case VALUE_CIRCLE_X:
    case VALUE_CIRCLE_Y:
        return 0.1;
    case VALUE_K1:
    case VALUE_K3:
    case VALUE_K5:
    case VALUE_K7:
        return 1;
    case VALUE_AIM_X:
    case VALUE_AIM_Y:
    case VALUE_AIM_Z:
        return 3 * rad_per_deg;
    default:
        return 0.2;
    }
}

static const double warning_share = 0.1;

/* Units at the solution: where a value is a logarithm, the value as solved. */
static double unit_now(const struct model *model, int value)
{
    switch (model->values[value]) {
    case VALUE_CIRCLE_RADIUS:
        return model->base.output.circle.radius_px;
    case VALUE_FOV:
        return model->base.output.lens.fov_rad;
    case VALUE_RADIUS:
        return model->base.radius_m;
    default:
        return model->units[value];
    }
}

static void invert(struct certainty *certainty, const double *jacobian, int rows)
{
    int n = certainty->count;
    double normal[MODEL_VALUES_MAX * MODEL_VALUES_MAX] = {0};

    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            for (int r = 0; r < rows; r++)
                normal[n * i + j] += jacobian[rows * i + r] * jacobian[rows * j + r];
        }
    }
    symmetric_eigen(n, normal, certainty->eigenvalues, certainty->eigenvectors);
    for (int k = 0; k < n; k++) {
        double value = fmax(certainty->eigenvalues[k], 1e-15 * certainty->eigenvalues[n - 1]);
        for (int i = 0; i < n * n; i++)
            certainty->covariance[i] += certainty->eigenvectors[n * k + i / n] *
                                        certainty->eigenvectors[n * k + i % n] /
                                        fmax(value, 1e-300);
    }
}

bool certainty_find(const struct model *model, const bool *rejected, struct certainty *certainty)
{
    size_t all = (size_t)model->marks->count;
    int *kept = calloc(all, sizeof *kept), count = 0;
    double *jacobian = malloc(2 * all * (size_t)(model->count + 1) * sizeof *jacobian);
    double zero[MODEL_VALUES_MAX] = {0}, sum = 0;
    bool found;

    *certainty = (struct certainty){.count = model->count};
    for (int i = 0; i < model->marks->count && kept; i++) {
        if (!rejected[i])
            kept[count++] = i;
    }
    found = kept && jacobian && model_residuals(model, &model->base, kept, count, true, jacobian);
    for (int i = 0; i < 2 * count && found; i++)
        sum += jacobian[i] * jacobian[i];
    if (found) {
        certainty->freedoms = 2 * count - model->count;
        certainty->noise_px = sqrt(sum / fmax(certainty->freedoms, 1));
        for (int i = 0; i < model->count; i++)
            certainty->units[i] = unit_now(model, i);
        model_jacobian(model, zero, kept, count, jacobian);
        invert(certainty, jacobian, 2 * count);
    }
    free(kept);
    free(jacobian);
    return found;
}

/* Even marks without any error tell nothing where usual ones would tell nothing. */
static double usual_noise_px(const struct model *model, const struct certainty *certainty)
{
    return fmax(certainty->noise_px, 0.05 * rad_per_deg * model_px_per_rad(model));
}

static double share_of_limit(const struct model *model, const struct certainty *certainty,
                             int value, double noise_px)
{
    double sd = noise_px * sqrt(certainty->covariance[(certainty->count + 1) * value]);
    return sd / limit(model->values[value]);
}

/* The values that change together where the marks notice it least: "a, b and c". */
static void name_combination(const struct model *model, const struct certainty *certainty,
                             char *text, size_t size)
{
    int n = certainty->count, named = 0, total = 0;
    double most = 0, parts[MODEL_VALUES_MAX];
    size_t used = 0;

    for (int i = 0; i < n; i++) {
        parts[i] = fabs(certainty->eigenvectors[i]) / limit(model->values[i]);
        most = fmax(most, parts[i]);
    }
    for (int i = 0; i < n; i++)
        total += parts[i] >= 0.2 * most;
    text[0] = 0;
    for (int i = 0; i < n && used < size; i++) {
        if (parts[i] < 0.2 * most)
            continue;
        named++;
        used += (size_t)snprintf(text + used, size - used, "%s%s",
                                 named == 1       ? ""
                                 : named == total ? " and "
                                                  : ", ",
                                 model_value_name(model->values[i]));
    }
}

/* "1.2 degrees", "0.3 m": how uncertain a value is. */
static void describe(const struct model *model, const struct certainty *certainty, int value,
                     double noise_px, char *text, size_t size)
{
    double sd = noise_px * sqrt(certainty->covariance[(certainty->count + 1) * value]) *
                certainty->units[value];

    switch (model->values[value]) {
    case VALUE_CIRCLE_X:
    case VALUE_CIRCLE_Y:
    case VALUE_CIRCLE_RADIUS:
        snprintf(text, size, "%.3g px", sd);
        break;
    case VALUE_X:
    case VALUE_Y:
    case VALUE_Z:
    case VALUE_RADIUS:
        snprintf(text, size, "%.3g m", sd);
        break;
    case VALUE_FOV:
    case VALUE_AIM_X:
    case VALUE_AIM_Y:
    case VALUE_AIM_Z:
        snprintf(text, size, "%.3g degrees", sd / rad_per_deg);
        break;
    default:
        snprintf(text, size, "%.3g", sd);
    }
}

bool certainty_suffices(const struct model *model, const struct certainty *certainty,
                        const char *hint, char *message)
{
    char names[300], amount[60];
    int worst = 0;
    double noise_px = usual_noise_px(model, certainty);

    for (int i = 1; i < certainty->count; i++) {
        if (share_of_limit(model, certainty, i, noise_px) >
            share_of_limit(model, certainty, worst, noise_px))
            worst = i;
    }
    if (certainty->count == 0 || share_of_limit(model, certainty, worst, noise_px) <= 1)
        return true;
    name_combination(model, certainty, names, sizeof names);
    describe(model, certainty, worst, noise_px, amount, sizeof amount);
    snprintf(message, MESSAGE_SIZE,
             "the marks do not determine %s: %s would be uncertain by %s; allowed: %s", names,
             model_value_name(model->values[worst]), amount, hint);
    return false;
}

const char *certainty_weak(const struct model *model, const struct certainty *certainty, int *at)
{
    while (*at < certainty->count) {
        int value = (*at)++;
        if (share_of_limit(model, certainty, value, certainty->noise_px) > warning_share)
            return model_value_name(model->values[value]);
    }
    return NULL;
}

/*
 * From the covariance of a small rotation to those of yaw, pitch and roll, and of the one turn that
 * yaw and roll come to where the lens looks along +-Y.
 */
static void report_aim(const struct model *model, const struct certainty *certainty, int first,
                       double sd_rad[4])
{
    enum { YAW, PITCH, ROLL, TURN, WAYS };
    const double step = 1e-6, whole_rad = 360 * rad_per_deg;
    double change[WAYS][3], sign = model->base.output.aim.pitch_rad < 0 ? 1 : -1;
    struct model_base side[2];

    for (int k = 0; k < 3; k++) {
        double x[MODEL_VALUES_MAX] = {0};
        for (int s = 0; s < 2; s++) {
            x[first + k] = s ? step : -step;
            model_apply(model, x, &side[s]);
        }
        const struct cupola_aim *low = &side[0].output.aim, *high = &side[1].output.aim;
        double yaw = high->yaw_rad - low->yaw_rad, roll = high->roll_rad - low->roll_rad;
        change[YAW][k] = remainder(yaw, whole_rad) / (2 * step);
        change[PITCH][k] = (high->pitch_rad - low->pitch_rad) / (2 * step);
        change[ROLL][k] = remainder(roll, whole_rad) / (2 * step);
        change[TURN][k] = remainder(yaw + sign * roll, whole_rad) / (2 * step);
    }
    for (int i = 0; i < WAYS; i++) {
        double sum = 0;
        for (int k = 0; k < 9; k++)
            sum += change[i][k / 3] * change[i][k % 3] *
                   certainty->covariance[certainty->count * (first + k / 3) + first + k % 3];
        sd_rad[i] = certainty->noise_px * sqrt(fmax(sum, 0));
    }
}

bool certainty_report(const struct model *model, const struct certainty *certainty,
                      struct solve_result *result, int output)
{
    double aim_sd_rad[4] = {0};

    for (int i = 0; i < certainty->count; i++) {
        double sd = certainty->noise_px * certainty->units[i] *
                    sqrt(certainty->covariance[(certainty->count + 1) * i]);
        enum model_value value = model->values[i];
        if (value <= VALUE_CIRCLE_RADIUS)
            result->circle_sd_px[value - VALUE_CIRCLE_X] = sd;
        else if (value == VALUE_FOV)
            result->fov_sd_rad = sd;
        else if (value <= VALUE_K7)
            result->k_sd[value - VALUE_K1] = sd;
        else if (value <= VALUE_Z)
            result->position_sd_m[value - VALUE_X] = sd;
        else if (value == VALUE_AIM_X)
            report_aim(model, certainty, i, aim_sd_rad);
        else if (value == VALUE_RADIUS)
            result->radius_sd_m = sd;
    }
    memcpy(result->aim_sd_rad, aim_sd_rad, sizeof result->aim_sd_rad);
    result->turn_sd_rad = aim_sd_rad[3];
    result->noise_px = certainty->noise_px;
    return view_certainty_find(model, certainty, result, output);
}
