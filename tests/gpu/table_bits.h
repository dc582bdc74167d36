/* Tables of floats read to the last bit, also where a GL cannot draw into floats or read them. */
#ifndef TABLE_BITS_H
#define TABLE_BITS_H

#include <epoxy/gl.h>

/* RGBA floats of an RGBA32F texture; freed by the caller. */
float *table_bits(GLuint texture, int width_px, int height_px);

#endif
