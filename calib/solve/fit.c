/* Least squares over the pixels of some of the marks, by cminpack. */
#include "fit.h"

#include <cminpack.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct fit {
    const struct model *model;
    const int *chosen;
    double bound_px;
};

/* How much a residual counts, and how much less the further it goes. */
static double bounded(double bound_px, const double r[2], double *bend)
{
    double square = (r[0] * r[0] + r[1] * r[1]) / (bound_px * bound_px);
    double factor = 1 / sqrt(1 + square);

    *bend = factor * factor * factor / (bound_px * bound_px);
    return factor;
}

static void residuals(const struct fit *fit, int count, const double *x, double *out)
{
    const double impossible_px = 1e6;
    struct model_base at;
    bool possible;

    model_apply(fit->model, x, &at);
    possible = model_residuals(fit->model, &at, fit->chosen, count, true, out);
    for (int i = 0; i < count; i++) {
        double *r = out + 2 * i, bend;
        if (!possible)
            r[0] = r[1] = impossible_px;
        double factor = fit->bound_px > 0 ? bounded(fit->bound_px, r, &bend) : 1;
        r[0] *= factor;
        r[1] *= factor;
    }
}

/* d(f r) = f dr - (r . dr) r f^3 / bound^2 */
static void bound_jacobian(const struct fit *fit, int count, const double *x, double *jacobian)
{
    struct model_base at;
    size_t rows = 2 * (size_t)count;
    double *residual = jacobian + rows * (size_t)fit->model->count; /* its room for one more */

    model_apply(fit->model, x, &at);
    if (!model_residuals(fit->model, &at, fit->chosen, count, true, residual))
        return;
    for (int i = 0; i < count; i++) {
        double bend, *r = residual + 2 * i, factor = bounded(fit->bound_px, r, &bend);
        for (int k = 0; k < fit->model->count; k++) {
            double *d = jacobian + rows * (size_t)k + 2 * i;
            double along = bend * (r[0] * d[0] + r[1] * d[1]);
            d[0] = factor * d[0] - along * r[0];
            d[1] = factor * d[1] - along * r[1];
        }
    }
}

static int evaluate(void *data, int rows, int values, const double *x, double *out,
                    double *jacobian, int stride, int flag)
{
    const struct fit *fit = data;

    (void)values;
    (void)stride; /* equals the rows */
    if (flag == 1)
        residuals(fit, rows / 2, x, out);
    if (flag == 2) {
        model_jacobian(fit->model, x, fit->chosen, rows / 2, jacobian);
        if (fit->bound_px > 0)
            bound_jacobian(fit, rows / 2, x, jacobian);
    }
    return 0;
}

bool fit_marks(struct model *model, const int *chosen, int count, double bound_px, int steps)
{
    enum { N = MODEL_VALUES_MAX };
    struct fit fit = {model, chosen, bound_px};
    size_t rows = 2 * (size_t)count;
    double x[N] = {0}, diag[N], qtf[N], wa1[N], wa2[N], wa3[N];
    int pivot[N], evaluations, derivatives;
    int n = model->count;
    struct model_base solved;

    if (n == 0)
        return true;
    if (2 * count < n)
        return false;
    double *room = malloc(rows * (size_t)(n + 3) * sizeof *room);
    if (!room)
        return false;
    for (int i = 0; i < n; i++)
        diag[i] = 1;
    double *wa4 = room + rows, *jacobian = room + 2 * rows;
    int info =
        lmder(evaluate, &fit, (int)rows, n, x, room, jacobian, (int)rows, 1e-13, 1e-12, 0, steps,
              diag, 2, 1.0, 0, &evaluations, &derivatives, pivot, qtf, wa1, wa2, wa3, wa4);
    free(room);
    model_apply(model, x, &solved);
    if (info < 0 || info == 0 || cupola_lens_validate(&solved.output.lens, NULL) < 0)
        return false;
    model->base = solved;
    return true;
}
