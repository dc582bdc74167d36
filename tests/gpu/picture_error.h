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
 * By how much a block of `seen` is displaced against `plain`, px: the d that best explains
 * seen - plain = -gradient(plain) . d over the block's pixels and three channels. Negative where
 * the block is too smooth along some direction to tell.
 */
static inline double block_displacement_px(const float *plain, const float *seen, int width, int x0,
                                           int y0, int size)
{
    double xx = 0.0, xy = 0.0, yy = 0.0, xt = 0.0, yt = 0.0;
    for (int y = y0 + 1; y < y0 + size - 1; y++)
        for (int x = x0 + 1; x < x0 + size - 1; x++)
            for (int c = 0; c < 3; c++) {
                const float *p = plain + 4 * (y * width + x) + c;
                double dx = 0.5 * ((double)p[4] - (double)p[-4]);
                double dy = 0.5 * ((double)p[4 * width] - (double)p[-4 * width]);
                double change = (double)p[0] - (double)seen[4 * (y * width + x) + c];
                xx += dx * dx;
                xy += dx * dy;
                yy += dy * dy;
                xt += dx * change;
                yt += dy * change;
            }
    double determinant = xx * yy - xy * xy;
    double flattest = 0.5 * (xx + yy - sqrt((xx - yy) * (xx - yy) + 4.0 * xy * xy));
    if (flattest < 1e-5 * size * size) /* less than 0.002 per px and channel */
        return -1.0;
    return hypot(yy * xt - xy * yt, xx * yt - xy * xt) / determinant;
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
