/*
 * Text as a picture, for overlays and for whatever else takes pictures. One built-in font of plain
 * letters; a host with fonts of its own makes its own pictures.
 */
#ifndef CUPOLA_TEXT_H
#define CUPOLA_TEXT_H

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The size of a text's picture: cupola_text_draw.
 *
 * text     lines are ended by '\n'; characters outside of printable ASCII become '?'
 * scale    texels per unit of the letters, 1 to 64; a line is 12 units high
 * width    out, texels
 * height   out, texels
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if a pointer is NULL, the text is empty, the scale is not as said
 *          above, or the picture would be larger than 16384 texels each way
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_text_size(const char *text, int scale, int *width, int *height,
                                struct cupola_error *error);

/*
 * Draws text into a picture, for glTexImage2D and a picture's overlay: white letters on a clear
 * ground, premultiplied.
 *
 * text     as for cupola_text_size
 * scale    likewise
 * rgba     out: 4 width height bytes, rows from the bottom up
 * width, height
 *          as cupola_text_size says
 * error    may be NULL
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_text_draw(const char *text, int scale, unsigned char *rgba, int width,
                                int height, struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
