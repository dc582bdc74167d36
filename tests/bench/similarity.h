/* How far a picture is from another: PSNR, SSIM, and where it is worst. */
#ifndef SIMILARITY_H
#define SIMILARITY_H

#include <stdbool.h>

/* Two pictures of 8 bits, RGB, and which of their pixels count (not 0). */
struct picture_pair {
    int width;
    int height;
    const unsigned char *wished;
    const unsigned char *found;
    const unsigned char *counts;
};

enum { DECIBEL_MOST = 100 }; /* of pictures that are the same */

struct similarity {
    double psnr_db; /* over red, green and blue of all pixels that count */
    /* The same over the hundredth of these pixels that are worst, at least one. */
    double worst_db;
    /*
     * Structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004) of the luma (Rec. 601), mean
     * over the pixels that count: windows of 11 x 11, Gaussian with sigma 1.5, K1 0.01, K2 0.03.
     * Where a window holds pixels that do not count, the weights of the others are made to sum to
     * 1.
     */
    double ssim;
};

/* False where no pixel counts or memory is short. */
bool similarity_of(const struct picture_pair *pair, struct similarity *similarity);

/* Of a mean square of errors, in steps of 8 bits. */
double decibels(double mean_square);

#endif
