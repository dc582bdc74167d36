/* How far two pictures of RGBA floats are apart: in brightness, and by displacement. */
#ifndef PICTURE_ERROR_H
#define PICTURE_ERROR_H

#include "check.h"

/* Over red, green and blue; full scale is 1. */
static inline double psnr_db(const float *a, const float *b, int width, int height)
{
    double sum = 0.0;
    for (int i = 0; i < 4 * width * height; i++)
        if (i % 4 != 3)
            sum += pow((double)a[i] - (double)b[i], 2.0);
    return -10.0 * log10(sum / (3.0 * width * height));
}

/*
 * What makes a picture differ from a plain one p by little: a displacement d, which changes it by
 * -gradient(p) . d, and the smoothing of bilinear samplings, which changes it by second derivatives
 * times whatever; five unknowns.
 */
enum { CHANGES = 5 };

static inline void changes_at(const float *p, int width, double changes[CHANGES])
{
    const float *above = p + 4 * width, *below = p - 4 * width;
    changes[0] = 0.5 * ((double)p[-4] - (double)p[4]);
    changes[1] = 0.5 * ((double)*below - (double)*above);
    changes[2] = (double)p[-4] + (double)p[4] - 2.0 * (double)p[0];
    changes[3] = (double)*below + (double)*above - 2.0 * (double)p[0];
    changes[4] =
        0.25 * ((double)above[4] + (double)below[-4] - (double)above[-4] - (double)below[4]);
}

/*
 * Cholesky's way through the normal equations, from the last unknown to the first. 0 where they do
 * not determine the unknowns: what is left of a diagonal entry, a mean square, is below `least`.
 */
static inline int solve_changes(double m[CHANGES][CHANGES], double b[CHANGES], double least)
{
    for (int k = CHANGES - 1; k >= 0; k--) {
        if (!(m[k][k] > (k < 2 ? least : 1e-15)))
            return 0;
        for (int i = 0; i < k; i++) {
            double factor = m[i][k] / m[k][k];
            for (int j = 0; j < k; j++)
                m[i][j] -= factor * m[k][j];
            b[i] -= factor * b[k];
        }
    }
    b[0] /= m[0][0];
    b[1] = (b[1] - m[1][0] * b[0]) / m[1][1];
    return 1;
}

/*
 * By how much a block of `seen` is displaced against `plain`, px, by least squares over its pixels
 * and three channels. Negative where the block is too smooth along some direction to tell.
 */
static inline double block_displacement_px(const float *plain, const float *seen, int width, int x0,
                                           int y0, int size)
{
    double m[CHANGES][CHANGES] = {{0}}, b[CHANGES] = {0};
    double weight = 1.0 / (3.0 * (size - 2) * (size - 2));
    for (int y = y0 + 1; y < y0 + size - 1; y++)
        for (int x = x0 + 1; x < x0 + size - 1; x++)
            for (int c = 0; c < 3; c++) {
                int at = 4 * (y * width + x) + c;
                double changes[CHANGES], change = (double)seen[at] - (double)plain[at];
                changes_at(plain + at, width, changes);
                for (int i = 0; i < CHANGES; i++) {
                    for (int j = 0; j < CHANGES; j++)
                        m[i][j] += weight * changes[i] * changes[j];
                    b[i] += weight * changes[i] * change;
                }
            }
    /* Steepness of 0.001 per px, root mean square. */
    return solve_changes(m, b, 1e-6) ? hypot(b[0], b[1]) : -1.0;
}

/* The largest of all blocks; `blocks` counts those that could tell. */
static inline double displacement_px(const float *plain, const float *seen, int width, int height,
                                     int size, int *blocks)
{
    double most = -1.0;
    *blocks = 0;
    for (int y = 0; y + size <= height; y += size)
        for (int x = 0; x + size <= width; x += size) {
            double moved = block_displacement_px(plain, seen, width, x, y, size);
            *blocks += moved >= 0.0;
            most = moved > most ? moved : most;
        }
    return most;
}

#endif
