/*
 * Text as a picture, for overlays and for whatever else takes pictures. One built-in font of plain
 * letters; a host with fonts of its own makes its own pictures.
 */
#ifndef CUPOLA_TEXT_H
#define CUPOLA_TEXT_H

#include <stddef.h>

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * What a text is drawn as: printable ASCII and '\n'. Latin letters (U+00C0 to U+017F) lose their
 * accents, and so do letters that are followed by combining ones (U+0300 to U+036F); each other
 * character becomes '?', and so does each byte that is no part of a character.
 *
 * text     UTF-8; NULL: as an empty one
 * letters  out, NULL or `size` bytes: the letters, ended by 0, as many as there is room for
 * size     bytes, 0 to write nothing
 * returns  how many characters of the whole text became '?' without being one
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_text_letters(const char *text, char *letters, size_t size);

/*
 * The size of a text's picture: cupola_text_draw.
 *
 * text     UTF-8; lines are ended by '\n'; drawn as cupola_text_letters says
 * scale    texels per unit of the letters, 1 to 64: capitals are 7 units high, lines 12 apart; a
 *          picture of N lines is 12 N - 1 units high
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
 * ground, premultiplied. The capitals of a line are in the middle of their picture: its last
 * baseline is 2 units above the lower edge, and the capitals of its first line end 2 units below
 * the upper one. Across, there is 1 clear unit before the first letter and after the last one of
 * the longest line; other lines begin below it, at the left.
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
