/*
 * The simulated theatre: an output's image thrown by the simulated projectors onto the simulated
 * screen, seen by a camera. With the camera at the eye of a right rig it shows what a plain
 * perspective rendering of the scene shows, and that is the end-to-end test of everything else.
 *
 * Rules of the context, of threads and of state as in gl.h. GL errors that are pending stay so,
 * except that cupola_theatre_draw drops one where it finds an image that is no 2-D texture, and
 * cupola_theatre_create drops them where it fails.
 */
#ifndef CUPOLA_THEATRE_H
#define CUPOLA_THEATRE_H

#include "gl.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cupola_theatre cupola_theatre;

/*
 * Builds the theatre of a dome. Nothing of the dome is kept.
 *
 * theatre  out: to be given to cupola_theatre_destroy; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if dome or theatre is NULL
 *          CUPOLA_ERROR_CONTEXT if no context is current, or one older than OpenGL 3.3 or
 *          OpenGL ES 3.0
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_MEMORY
 *          CUPOLA_ERROR_GL if the GL refuses a shader
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_theatre_create(const cupola_dome *dome, cupola_theatre **theatre,
                                     struct cupola_error *error);

/*
 * Gives back every GL object and sets the handle to NULL; NULL and a handle that is NULL are
 * allowed. The context in which it was made must be current; if none is, only memory is freed.
 *
 * thread   the context's
 * since    0.1
 */
CUPOLA_API void cupola_theatre_destroy(cupola_theatre **theatre);

/* Who looks at the theatre. */
struct cupola_spectator {
    double position_m[3]; /* dome frame, finite; in the sphere or out of it; zero: its centre */
    /* Rows: its right, up and backward axes in the dome frame, of unit length, square to each other
     * (products within 1e-6) and right-handed; all zero: looks the way the host's camera does. */
    double rotation[9];
    double fov_rad;       /* vertical opening, above 0 and below pi; 0: 60 degrees */
    bool furniture;       /* draws projectors, viewer and the outside of the screen, too */
    float ambient_rgb[3]; /* light on an unlit screen, linear, finite; all zero: black */
    /* Of the picture that is drawn; 0: linear. The images are light: those of sRGB formats are
     * decoded as they are sampled, and projectors are added up before anything is encoded. */
    enum cupola_encoding encoding;
};

/*
 * A spectator at the rig's eye who looks the way the host's camera does; and one who stands
 * outside, behind and above the viewer, with the whole theatre in sight. Nothing is done if either
 * pointer is NULL.
 *
 * spectator  out: all of it
 * thread     any
 * since      0.1
 */
CUPOLA_API void cupola_spectator_at_eye(const cupola_dome *dome,
                                        struct cupola_spectator *spectator);
CUPOLA_API void cupola_spectator_outside(const cupola_dome *dome,
                                         struct cupola_spectator *spectator);

/*
 * Draws what the spectator sees.
 *
 * spectator
 *          who looks, and at what
 * images   names of GL_TEXTURE_2D, one per output of the rig, of the outputs' sizes, floats or
 *          normalised numbers; sampled bilinearly
 * width, height
 *          of the rectangle drawn, px, 1 to 32768 each
 * target   its framebuffer, of which draw buffer 0 is drawn into, and lower left corner; NULL: all
 *          zero. None of the images may be attached to it
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if theatre, images or spectator is NULL, the spectator is not as
 *          said above, a side or the target's corner is not, or an image is no 2-D texture, in
 *          another format (asked for where OpenGL ES is not 3.0) or a colour of the target
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_MEMORY
 *          CUPOLA_ERROR_GL if the framebuffer does not exist or is not complete, its draw buffer 0
 *          is none or of integers, the encoding is linear and this OpenGL ES always encodes into
 *          the target's format, or the GL refuses a texture to add up the light of several
 *          projectors
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_theatre_draw(cupola_theatre *theatre, const unsigned int *images,
                                   const struct cupola_spectator *spectator, int width, int height,
                                   const struct cupola_target *target, struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
