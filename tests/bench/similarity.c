/* How far a picture is from another. */
#include "similarity.h"

#include <math.h>
#include <stdlib.h>

enum { WINDOW_RADIUS = 5, MOMENTS = 6 };

/* Gaussian means round a pixel: of the weights, both lumas, their squares and their product. */
enum moment { WEIGHT, WISHED, FOUND, WISHED_2, FOUND_2, PRODUCT };

double decibels(double mean_square)
{
    double db = 10 * log10(255.0 * 255.0 / mean_square);

    return db < DECIBEL_MOST ? db : DECIBEL_MOST;
}

static double luma(const unsigned char *rgb)
{
    return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}

static void fill_moments(const struct picture_pair *pair, float *planes[MOMENTS])
{
    size_t pixels = (size_t)pair->width * (size_t)pair->height;

    for (size_t i = 0; i < pixels; i++) {
        double counts = pair->counts[i] ? 1 : 0;
        double x = counts * luma(pair->wished + 3 * i), y = counts * luma(pair->found + 3 * i);
        const double values[MOMENTS] = {counts, x, y, x * x, y * y, x * y};
        for (int k = 0; k < MOMENTS; k++)
            planes[k][i] = (float)values[k];
    }
}

/* Along lines of `length` that are `step` apart inside and `stride` from each other. */
static void blur(const float *from, float *to, int lines, size_t stride, int length, size_t step)
{
    double weights[WINDOW_RADIUS + 1];

    for (int k = 0; k <= WINDOW_RADIUS; k++)
        weights[k] = exp(-k * k / (2 * 1.5 * 1.5));
    for (int line = 0; line < lines; line++)
        for (int i = 0; i < length; i++) {
            double sum = 0;
            for (int k = -WINDOW_RADIUS; k <= WINDOW_RADIUS; k++)
                if (i + k >= 0 && i + k < length)
                    sum += weights[abs(k)] *
                           (double)from[(size_t)line * stride + (size_t)(i + k) * step];
            to[(size_t)line * stride + (size_t)i * step] = (float)sum;
        }
}

static double similarity_at(float *const planes[MOMENTS], size_t i)
{
    const double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    double mean[MOMENTS];

    for (int k = 0; k < MOMENTS; k++)
        mean[k] = (double)planes[k][i] / (double)planes[WEIGHT][i];
    double x = mean[WISHED], y = mean[FOUND];
    double spread = mean[WISHED_2] - x * x + mean[FOUND_2] - y * y;
    return (2 * x * y + c1) * (2 * (mean[PRODUCT] - x * y) + c2) /
           ((x * x + y * y + c1) * (spread + c2));
}

static bool find_ssim(const struct picture_pair *pair, double *ssim)
{
    size_t pixels = (size_t)pair->width * (size_t)pair->height, count = 0;
    float *memory = malloc((MOMENTS + 1) * pixels * sizeof *memory), *planes[MOMENTS];
    double sum = 0;

    if (!memory)
        return false;
    for (int k = 0; k < MOMENTS; k++)
        planes[k] = memory + (size_t)k * pixels;
    fill_moments(pair, planes);
    for (int k = 0; k < MOMENTS; k++) {
        float *rows = memory + MOMENTS * pixels;
        blur(planes[k], rows, pair->height, (size_t)pair->width, pair->width, 1);
        blur(rows, planes[k], pair->width, 1, pair->height, (size_t)pair->width);
    }
    for (size_t i = 0; i < pixels; i++)
        if (pair->counts[i]) {
            sum += similarity_at(planes, i);
            count++;
        }
    free(memory);
    *ssim = sum / (double)count;
    return true;
}

static int descending(const void *a, const void *b)
{
    int x = *(const int *)a, y = *(const int *)b;

    return (x < y) - (x > y);
}

bool similarity_of(const struct picture_pair *pair, struct similarity *similarity)
{
    size_t pixels = (size_t)pair->width * (size_t)pair->height, count = 0, worst;
    int *squares = malloc(pixels * sizeof *squares);
    double sum = 0, worst_sum = 0;

    if (!squares)
        return false;
    for (size_t i = 0; i < pixels; i++) {
        int square = 0;
        for (size_t k = 3 * i; k < 3 * i + 3; k++)
            square += (pair->found[k] - pair->wished[k]) * (pair->found[k] - pair->wished[k]);
        if (pair->counts[i])
            squares[count++] = square;
    }
    qsort(squares, count, sizeof *squares, descending);
    worst = count / 100 > 0 ? count / 100 : 1;
    for (size_t i = 0; i < count; i++) {
        sum += squares[i];
        worst_sum += i < worst ? squares[i] : 0;
    }
    free(squares);
    if (count == 0)
        return false;
    similarity->psnr_db = decibels(sum / (3 * (double)count));
    similarity->worst_db = decibels(worst_sum / (3 * (double)worst));
    return find_ssim(pair, &similarity->ssim);
}
