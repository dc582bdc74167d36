/*
 * The point table of a theatre without any views: for hosts that cast rays themselves, and for
 * whatever draws per output pixel while the theatre is still being set up. cupola_gl_points (gl.h)
 * gives the same table to a host that has views.
 *
 * Rules of the context, of threads and of state as in gl.h. GL errors that are pending are dropped
 * by cupola_points_create, and by cupola_points_set_dome where it makes a texture or fails.
 *
 * Where an OpenGL ES cannot draw into floats, the table is computed on the CPU in each call.
 */
#ifndef CUPOLA_POINTS_H
#define CUPOLA_POINTS_H

#include "gl.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cupola_points cupola_points;

/*
 * Draws the point table of one output of a dome. Nothing of the dome is kept.
 *
 * output   index, 0 to the number of the rig's outputs - 1
 * points   out: to be given to cupola_points_destroy; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if dome or points is NULL, there is no such output, or it is
 *          larger than this GL's textures may be
 *          CUPOLA_ERROR_CONTEXT, CUPOLA_ERROR_LOST, CUPOLA_ERROR_MEMORY
 *          CUPOLA_ERROR_GL if the GL refuses a texture, a framebuffer or a shader
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_points_create(const cupola_dome *dome, int output, cupola_points **points,
                                    struct cupola_error *error);

/*
 * Draws the table anew, of another dome: the same rig with a value changed, say, as often as the
 * host likes. A shader is compiled only where the lens is of another model or the screen's cap
 * comes or goes, for the first time; the texture is another one only where the output's size has
 * changed.
 *
 * output   index, as above
 * error    may be NULL
 * returns  as cupola_points_create; after a failure the table is what it was
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_points_set_dome(cupola_points *points, const cupola_dome *dome, int output,
                                      struct cupola_error *error);

/*
 * The table: a GL_TEXTURE_2D of the output's size, RGBA32F: x, y, z of D in metres (dome frame) and
 * the pixel's coverage, 0 to 1.
 *
 * returns  its name; 0 without points
 * thread   any
 * since    0.1
 */
CUPOLA_API unsigned int cupola_points_texture(const cupola_points *points);

/*
 * Gives back every GL object and sets the handle to NULL; NULL and a handle that is NULL are
 * allowed. The context in which it was made must be current; if none is, only memory is freed.
 *
 * thread   the context's
 * since    0.1
 */
CUPOLA_API void cupola_points_destroy(cupola_points **points);

#ifdef __cplusplus
}
#endif

#endif
