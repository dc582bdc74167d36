/* The noise of photographs. */
#include "capture/code_noise.h"

#include <math.h>

void code_noise_add(struct code_noise *noise, double light, double variance)
{
    noise->count += 1;
    noise->light += light;
    noise->light_square += light * light;
    noise->variance += variance;
    noise->light_variance += light * variance;
}

void code_noise_fit(struct code_noise *noise)
{
    double count = fmax(noise->count, 1);
    double light = noise->light / count, variance = noise->variance / count;
    double spread = noise->light_square / count - light * light;
    double slope = 0;

    if (spread > 1e-4 * light * light)
        slope = (noise->light_variance / count - light * variance) / spread;
    /* Neither part of the noise can be below nothing. */
    slope = fmin(fmax(slope, 0), light > 0 ? fmax(variance, 0) / light : 0);
    noise->slope = slope;
    noise->constant = fmax(variance - slope * light, 0);
}

double code_noise_at(const struct code_noise *noise, double light)
{
    return sqrt(fmax(noise->constant + noise->slope * fmax(light, 0), 0));
}
