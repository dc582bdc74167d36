/* How much each mark counts. */
#include "weights.h"

#include <math.h>
#include <stddef.h>

#include <cupola/projection.h>

/* Two directions across one. */
static void directions_across(const double d[3], double across[2][3])
{
    int least = 0;

    for (int i = 1; i < 3; i++)
        least = fabs(d[i]) < fabs(d[least]) ? i : least;
    double length = sqrt(1 - d[least] * d[least]);
    for (int i = 0; i < 3; i++)
        across[0][i] = ((i == least) - d[least] * d[i]) / length;
    for (int i = 0; i < 3; i++)
        across[1][i] =
            d[(i + 1) % 3] * across[0][(i + 2) % 3] - d[(i + 2) % 3] * across[0][(i + 1) % 3];
}

/* Mean square of the pixels by which a place moves that moves by a radian; 0: it has none. */
static double square_px_per_rad(const struct model *model, int mark)
{
    const double step_rad = 1e-5;
    double point_m[3], d[3], across[2][3], sum = 0;

    model_point(model, model->base.radius_m, mark, point_m);
    double length = hypot(hypot(point_m[0], point_m[1]), point_m[2]);
    if (!(length > 0))
        return 0;
    for (int i = 0; i < 3; i++)
        d[i] = point_m[i] / length;
    directions_across(d, across);
    for (int way = 0; way < 2; way++) {
        double pixel_px[2][2];
        for (int s = 0; s < 2; s++) {
            double moved_m[3];
            for (int i = 0; i < 3; i++)
                moved_m[i] = point_m[i] + (s ? step_rad : -step_rad) * length * across[way][i];
            if (cupola_output_pixel(&model->base.output, moved_m, pixel_px[s], NULL) < 0)
                return 0;
        }
        double moved_px = hypot(pixel_px[1][0] - pixel_px[0][0], pixel_px[1][1] - pixel_px[0][1]);
        sum += 0.5 * pow(moved_px / (2 * step_rad), 2);
    }
    return sum;
}

void weights_find(const struct model *model, double *weights)
{
    double mean = pow(model_px_per_rad(model), 2);

    for (int i = 0; i < model->marks->count; i++) {
        double square = square_px_per_rad(model, i) / mean;
        weights[i] = square > 0 && isfinite(square) ? 1 / sqrt(0.5 * (1 + square)) : 1;
    }
}
