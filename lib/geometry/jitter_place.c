/*
 * Places of samples: Halton's sequence in the bases 2, 3, 5, 7, each point followed by its mirror
 * image. So the mean of every even number of them is the middle, and by the centred L2 discrepancy
 * the first 4, 16, 64 and 256 are more even, in all four dimensions, than those of the sequence
 * alone, or of one by powers of the root of x^5 = x + 1 (R4).
 */
#include "cupola/jitter.h"

/* The digits of a number in a base, mirrored at the point. */
static double mirrored(int number, int base)
{
    double place = 1, sum = 0;
    for (; number > 0; number /= base) {
        place /= base;
        sum += place * (number % base);
    }
    return sum;
}

int cupola_jitter_place(int index, double texels[2], double pixels[2])
{
    if (index < 0 || !texels || !pixels)
        return CUPOLA_ERROR_ARGUMENT;
    int number = index / 2 + 1;
    double sign = index % 2 ? -1 : 1;
    pixels[0] = sign * (mirrored(number, 2) - 0.5);
    pixels[1] = sign * (mirrored(number, 3) - 0.5);
    texels[0] = sign * (mirrored(number, 5) - 0.5);
    texels[1] = sign * (mirrored(number, 7) - 0.5);
    return CUPOLA_OK;
}
