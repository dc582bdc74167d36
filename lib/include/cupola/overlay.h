/*
 * Overlays: text, a cursor or a picture of the host's, laid over an output's image by direction and
 * angular size, as the viewer's eye sees them. They are drawn per output pixel after the warp, so
 * they are as sharp as the projector and belong to no view. text.h makes pictures of text.
 *
 * The other way round, from the pixel under a mouse to the direction that it shows and from a
 * direction to its pixel, is cupola_dome_ray and cupola_dome_pixel (dome.h).
 */
#ifndef CUPOLA_OVERLAY_H
#define CUPOLA_OVERLAY_H

#include <stdbool.h>

#include "gl.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What an overlay shows. */
enum cupola_overlay_kind {
    CUPOLA_OVERLAY_PICTURE = 0, /* a texture */
    CUPOLA_OVERLAY_CURSOR,      /* a ring with a dot in its middle, of `color` */
    CUPOLA_OVERLAY_DISC,        /* a round spot of `color` */
};

/*
 * One overlay: a flat rectangle that faces the eye, its middle in `direction`, so that it looks
 * there as it does on a sheet of paper. Direction and width are needed.
 */
struct cupola_overlay {
    enum cupola_overlay_kind kind; /* 0: a picture */
    double direction[3]; /* of its middle, host's camera frame, from the eye, any length above 0 */
    double width_rad;    /* angle between the middles of its left and right edge, above 0 and up to
                       * 5/6 pi */
    /* The same, of lower and upper edge; 0: square texels for a picture, which must not make it
     * higher than that either, as high as wide for the others. */
    double height_rad;
    /* Counter-clockwise as the viewer sees it, -2 pi to 2 pi. At 0 its lower edge is level: up is
     * towards +Y of the host's camera frame, and where the direction is straight up or down, as if
     * the viewer had raised or lowered the head from straight ahead. */
    double roll_rad;
    /* A GL_TEXTURE_2D, its first row the lower edge, floats or normalised numbers, filtered by a
     * sampler object of Cupola's; its own filter and wrap parameters do not count. Its colour is
     * premultiplied: in linear light, colour times alpha, and for a texture of an sRGB format
     * encoded after that. Colour above alpha is light that is added, as of a glow. Not asked of the
     * other kinds. */
    unsigned int texture;
    bool mipmaps; /* the texture has all its levels */
    /* Four floats: RGBA in linear light, 0 or more, alpha up to 1, not premultiplied; a picture is
     * multiplied by it. Read during the call only. NULL: opaque white */
    const float *color;
};

/*
 * Draws overlays over what is in the target, in their order: an output's image after
 * cupola_gl_warp. Edges are smooth; only pixels inside of the image circle and the screen change.
 *
 * output    index, as in cupola_gl_warp
 * overlays  `count` of them
 * count     0 or more
 * target    as in cupola_gl_warp. Where the gl's encoding is sRGB and the target's format is, too,
 *           colours are mixed in linear light. Into other formats encoded numbers are mixed: of a
 *           colour up to alpha, (1 - alpha) of what was there and alpha of the encoded colour, not
 *           premultiplied; a colour above alpha comes the nearer to its code over black the less of
 *           it the alpha covers
 * error     may be NULL
 * returns   CUPOLA_OK
 *           CUPOLA_ERROR_ARGUMENT if gl, or overlays with a count above 0, is NULL, gl was made
 *           without overlays, there is no such output, a field is outside of its range, a texture
 *           is no GL_TEXTURE_2D or not as said above (asked for where OpenGL ES is not 3.0), the
 *           output's gain has been deleted or is of another size by now, texture or gain is a
 *           colour of the target, or its corner is too far
 *           CUPOLA_ERROR_ORDER inside a view or a pass
 *           CUPOLA_ERROR_CONTEXT, CUPOLA_ERROR_LOST
 *           CUPOLA_ERROR_GL if the framebuffer does not exist or is not complete, its draw buffer 0
 *           is none or of integers, the target is RGBA32F in an OpenGL ES without
 *           GL_EXT_float_blend, or the encoding is linear and this OpenGL ES always encodes into
 *           the target's format
 * thread    the context's
 * since     0.1
 */
CUPOLA_API int cupola_gl_overlay(cupola_gl *gl, int output, const struct cupola_overlay *overlays,
                                 int count, const struct cupola_target *target,
                                 struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
