/*
 * The warp in plain C over float images: slow, obvious, and the oracle of everything that runs on
 * a GPU. It has no GL in it.
 */
#ifndef CUPOLA_REFERENCE_H
#define CUPOLA_REFERENCE_H

#include "antialiasing.h"
#include "overlay.h"
#include "plan.h"
#include "source.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Warps an atlas of views into an output's image, as cupola_gl_warp does.
 *
 * output  index
 * atlas   RGBA floats, rows from the bottom up, of the size in the plan's report
 * border  RGBA of pixels that are not lit; NULL: all zero
 * image   out: RGBA floats, rows from the bottom up, of the output's size
 * returns CUPOLA_OK, CUPOLA_ERROR_ARGUMENT or CUPOLA_ERROR_MEMORY
 * thread  any
 * since   0.1
 */
CUPOLA_API int cupola_reference_warp(const cupola_plan *plan, int output, const float *atlas,
                                     const float border[4], float *image);

/*
 * The same with a filter, as a GL that was made with it does: cupola_reference_warp is this with
 * one that is all zero.
 *
 * output  index
 * filter  NULL: all zero
 * atlas, border, image
 *         as above
 * returns CUPOLA_OK; CUPOLA_ERROR_ARGUMENT, for an impossible filter too; CUPOLA_ERROR_MEMORY
 * thread  any
 * since   0.1
 */
CUPOLA_API int cupola_reference_filter(const cupola_plan *plan, int output,
                                       const struct cupola_filter *filter, const float *atlas,
                                       const float border[4], float *image);

/*
 * Draws the views themselves from a function of the ray, so that a whole dome image can be made
 * without a GPU.
 *
 * color   called once per texel of every view with the unit direction from the eye (host's camera
 *         frame); writes RGBA
 * user    handed to `color`
 * atlas   out: as in cupola_reference_warp; texels outside of every view become zero
 * returns CUPOLA_OK; CUPOLA_ERROR_ARGUMENT if plan, color or atlas is NULL
 * thread  any; `color` is called on the same thread
 * since   0.1
 */
CUPOLA_API int cupola_reference_views(const cupola_plan *plan,
                                      void (*color)(const double direction[3], float rgba[4],
                                                    void *user),
                                      void *user, float *atlas);

/*
 * Shows a picture through an output, as cupola_gl_warp does without mipmaps: bilinear.
 *
 * output   index
 * source   kind, place, opening and orientation; not the views. The texture is not asked for
 * picture  RGBA floats, rows from the bottom up; of a cube six faces in GL's order (+X, -X, +Y, -Y,
 *          +Z, -Z), each in the row order in which it would be handed to glTexImage2D
 * width    of the picture, or of a face of a cube, px, 1 to 32768
 * height   likewise; of a cube the same
 * border   RGBA of pixels that are not lit; NULL: all zero
 * image    out: RGBA floats, rows from the bottom up, of the output's size
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_reference_source(const cupola_dome *dome, int output,
                                       const struct cupola_source *source, const float *picture,
                                       int width, int height, const float border[4], float *image);

/*
 * Draws an overlay over an output's image, as cupola_gl_overlay does without mipmaps and in linear
 * light.
 *
 * output   index
 * overlay  its texture is not asked for
 * picture  of a picture: RGBA floats, premultiplied, rows from the bottom up; else not asked for
 * width    of the picture, px, 1 to 32768
 * height   likewise
 * image    RGBA floats, rows from the bottom up, of the output's size; changed
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_reference_overlay(const cupola_dome *dome, int output,
                                        const struct cupola_overlay *overlay, const float *picture,
                                        int width, int height, float *image);

#ifdef __cplusplus
}
#endif

#endif
