/*
 * Image files: PNG (8 bit, written) and PFM (32-bit float, read and written). Files appear whole or
 * not at all. Part of the build option `io`.
 *
 * Images in memory are RGBA floats with rows from the bottom up, as GL has them. The first row of a
 * PNG file is the top of the image.
 */
#ifndef CUPOLA_IMAGE_FILE_H
#define CUPOLA_IMAGE_FILE_H

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Writes a PNG of 8 bits in three channels: 0 to 1 becomes 0 to 255, rounded to nearest; values
 * outside are clamped, NaN is written as 0, alpha is left out.
 *
 * rgba     4 width height floats
 * width    px, 1 to 32768 each, and at most 300 million pixels
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_FILE; CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_png_write(const char *path, const float *rgba, int width, int height,
                                struct cupola_error *error);

/*
 * Writes a colour PFM: three little-endian floats per pixel, bit for bit, rows from the bottom up;
 * alpha is left out.
 */
CUPOLA_API int cupola_pfm_write(const char *path, const float *rgba, int width, int height,
                                struct cupola_error *error);

/*
 * Reads a PFM: colour ("PF") or grey ("Pf", the value goes to all three channels), of either byte
 * order; alpha becomes 1. Of the scale in the header only the sign counts (the byte order).
 *
 * rgba     out: allocated; to be given to cupola_image_free; untouched on failure
 * width    out, px; at most 32768 each
 * returns  CUPOLA_OK; CUPOLA_ERROR_FILE; CUPOLA_ERROR_SYNTAX; CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_pfm_read(const char *path, float **rgba, int *width, int *height,
                               struct cupola_error *error);

/* Frees an image and sets the pointer to NULL; NULL is allowed. */
CUPOLA_API void cupola_image_free(float **rgba);

#ifdef __cplusplus
}
#endif

#endif
