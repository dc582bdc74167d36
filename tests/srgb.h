/* The sRGB curve, IEC 61966-2-1, both ways; codes and light from 0 to 1. */
#ifndef TEST_SRGB_H
#define TEST_SRGB_H

#include <math.h>

static inline double light_encoded(double light)
{
    if (light <= 0.0)
        return 0.0;
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1.0 / 2.4) - 0.055;
}

static inline double light_decoded(double code)
{
    return code <= 0.04045 ? code / 12.92 : pow((code + 0.055) / 1.055, 2.4);
}

#endif
