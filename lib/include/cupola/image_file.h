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
 * path     of a regular file, or of one that is not there yet
 * rgba     4 width height floats
 * width, height
 *          px, 1 to 32768 each; (3 width + 1) height is at most 900 million
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if path is NULL or empty, rgba is NULL, or the size is not as said
 *          CUPOLA_ERROR_FILE if the file cannot be written
 *          CUPOLA_ERROR_MEMORY: it takes some 20 bytes a pixel, and 6 MiB
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_png_write(const char *path, const float *rgba, int width, int height,
                                struct cupola_error *error);

/*
 * Writes a colour PFM: three little-endian floats per pixel, bit for bit, rows from the bottom up;
 * alpha is left out.
 *
 * path     of a regular file, or of one that is not there yet
 * rgba     4 width height floats
 * width, height
 *          px, 1 to 32768 each
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if path is NULL or empty, rgba is NULL, or the size is not as said
 *          CUPOLA_ERROR_FILE if the file cannot be written
 *          CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_pfm_write(const char *path, const float *rgba, int width, int height,
                                struct cupola_error *error);

/*
 * Reads a PFM: colour ("PF") or grey ("Pf", the value goes to all three channels), of either byte
 * order; alpha becomes 1. Of the scale in the header only the sign counts (the byte order).
 *
 * path     of the file
 * rgba     out: allocated; to be given to cupola_image_free; untouched on failure
 * width, height
 *          out, px, 1 to 32768 each; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if path is NULL or empty, or rgba, width or height is NULL
 *          CUPOLA_ERROR_FILE if the file cannot be read
 *          CUPOLA_ERROR_SYNTAX if it is no PFM, or not of the length that its header says
 *          CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_pfm_read(const char *path, float **rgba, int *width, int *height,
                               struct cupola_error *error);

/*
 * Frees an image and sets the pointer to NULL.
 *
 * rgba     the pointer's address; NULL and a pointer that is NULL are allowed
 * thread   any
 * since    0.1
 */
CUPOLA_API void cupola_image_free(float **rgba);

#ifdef __cplusplus
}
#endif

#endif
