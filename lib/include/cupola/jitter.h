/*
 * Samples beside the middles of texels and pixels: for stills and films, of which each picture is
 * the mean of many frames.
 *
 *     for (int i = 0; i < count; i++) {
 *         double texels[2], pixels[2];
 *         cupola_jitter_place(i, texels, pixels);
 *         cupola_gl_set_jitter(gl, texels, pixels, NULL);
 *         draw a frame; add its pixels up, in linear light
 *     }
 */
#ifndef CUPOLA_JITTER_H
#define CUPOLA_JITTER_H

#include "gl.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Moves what is sampled beside the middles of texels and pixels, for a picture that is the mean of
 * many frames: with places that lie evenly over (-1/2, 1/2)^4 it comes to what a box over each
 * pixel, widened by one over a texel (antialiasing none) or by what else a ray means, makes of the
 * scene. From the next view, pass and warp on; so a frame's
 * jitter is set before its first view. 0 everywhere, which is how it begins, is the picture of a
 * cupola_gl made without jitters, but for the last bits.
 *
 * Every view's base rectangle is moved: its cameras' matrices and planes, the lookups of the warp
 * and the texels that are sampled follow, and those stay within the guard band and outside of the
 * masks. Rays leave the moved place of their pixel; where an image circle or the screen's edge cuts
 * a pixel, they are drawn together into the part that is lit, and its coverage is that of the whole
 * pixel. Overlays, gains and the textures of cupola_gl_points and cupola_gl_density stay as they
 * are. The plan that gl was made from does not move, nor do cameras of cupola_plan_camera.
 *
 * Makes no GL call and allocates nothing.
 *
 * texels   to the right and up, -1/2 to 1/2, by which the middles of all texels move over the
 *          scene; 0 alone for the host's textures as views. NULL: 0
 * pixels   in image coordinates, -1/2 to 1/2, by which rays move; views and pictures. NULL: 0
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL or was made without jitters, or a number is not as
 *          said above; all is as it was
 *          CUPOLA_ERROR_ORDER inside a view or a pass
 *          CUPOLA_ERROR_LOST if that was seen by an earlier call
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_set_jitter(cupola_gl *gl, const double texels[2], const double pixels[2],
                                    struct cupola_error *error);

/*
 * Numbers for cupola_gl_set_jitter that lie evenly, however many frames there are: Halton's
 * sequence, bases 2 and 3 for pixels and 5 and 7 for texels, each point followed by its mirror
 * image, so that the mean of every even number of them is 0.
 *
 * index    of the frame, from 0
 * texels, pixels
 *          out: above -1/2 and below 1/2
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT for an index below 0 or NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_jitter_place(int index, double texels[2], double pixels[2]);

#ifdef __cplusplus
}
#endif

#endif
