/*
 * The plan in OpenGL: views to draw into, tables, and the warp.
 *
 * What this does NOT do: it never creates, makes current, swaps or destroys a context, opens no
 * window, draws no scene, and keeps no pointer of the host's.
 *
 * A frame:
 *
 *     int views = cupola_gl_frame_begin(gl, &frame, NULL);
 *     for (int i = 0; i < views; i++) {
 *         struct cupola_gl_view view;
 *         cupola_gl_view_begin(gl, i, &view, NULL);
 *         draw_scene(view.camera.projection, view.camera.view);
 *         cupola_gl_view_end(gl, NULL);
 *     }
 *     cupola_gl_warp(gl, 0, NULL, &target, NULL);
 *
 * Pictures that exist already (source.h) need no views: a cupola_gl made for them alone goes
 * straight to the warp.
 *
 * Every call here runs on the thread where the host's context is current, and leaves the GL state
 * as it found it (docs/host-contract.md has the list), except that between view_begin and view_end
 * the view's framebuffer, viewport and scissor rectangle are set for the host. OpenGL 3.3 core or
 * OpenGL ES 3.0 is the floor. Object names are of type GLuint, spelled `unsigned int` so that no GL
 * header is needed. Where no context is current, whatever needs one answers CUPOLA_ERROR_CONTEXT;
 * which calls do is said with each. Where the context has been lost (a robust one after a reset),
 * they answer CUPOLA_ERROR_LOST, now and ever after: destroy the cupola_gl and make another.
 *
 * GL errors that are pending when cupola_gl_create, cupola_gl_points or cupola_gl_density (as they
 * make a texture) or cupola_gl_capture is called are dropped: those calls have to ask for errors of
 * their own.
 */
#ifndef CUPOLA_GL_H
#define CUPOLA_GL_H

#include <stdbool.h>

#include "gl_params.h"
#include "plan.h"
#include "source.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cupola_gl cupola_gl;

/*
 * Makes textures, framebuffers, tables and programs for a plan. Nothing of the plan is kept.
 *
 * params   NULL: all zero
 * gl       out: to be given to cupola_gl_destroy; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if plan or gl is NULL, a parameter is not as said above,
 *          sources has a bit that is no kind, samples is not 0 to what this GL has of that format,
 *          the table of coordinates or one pass is wished for the host's textures, one pass without
 *          views, jitters with another table or guard band than gl_params.h says, or the atlas or
 *          an output is larger than this GL's textures may be
 *          CUPOLA_ERROR_CONTEXT if no context is current, or one older than the floor
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_MEMORY
 *          CUPOLA_ERROR_GL if the GL refuses a texture, a framebuffer or a shader, has no views of
 *          that format, cannot draw them in one pass, which is wished, or cannot draw into floats
 *          and the table of angles, sines or coordinates is wished for a plan whose eye may move
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_create(const cupola_plan *plan, const struct cupola_gl_params *params,
                                cupola_gl **gl, struct cupola_error *error);

/*
 * Gives back every GL object and sets the handle to NULL; NULL and a handle that is NULL are
 * allowed. A view that is open is ended first. The context in which it was made must be current
 * (one that shares its textures will not do: framebuffers and vertex arrays are not shared); if
 * none is, only memory is freed.
 *
 * thread   the context's
 * since    0.1
 */
CUPOLA_API void cupola_gl_destroy(cupola_gl **gl);

/* What all views of a frame have in common. */
struct cupola_frame {
    struct cupola_depth depth; /* near, far and how depth runs; all zero: 0.1 to 1000 */
    float clear_color[4];      /* RGBA that each view is cleared to, in linear light (SRGB8 encodes
                                * it), finite; all zero: transparent black */
};

/*
 * Begins a frame. Draws nothing and needs no context.
 *
 * frame    NULL: all zero
 * error    may be NULL
 * returns  the number of views to draw, 1 or more
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL, made without views or for the host's textures,
 *          the distances are not as said in plan.h, or the colour is not finite
 *          CUPOLA_ERROR_ORDER inside a view or a pass
 *          CUPOLA_ERROR_LOST if that was seen by an earlier call
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_frame_begin(cupola_gl *gl, const struct cupola_frame *frame,
                                     struct cupola_error *error);

/* One view to draw into. */
struct cupola_gl_view {
    unsigned int framebuffer;    /* already bound for drawing and reading */
    struct cupola_rect rect;     /* its viewport and scissor rectangle, already set */
    struct cupola_camera camera; /* its matrices and frustum planes */
};

/*
 * Begins one view: clears its colour, depth and stencil (the host must not clear it), binds its
 * framebuffer and sets viewport and scissor rectangle to it. view_end puts back what the host had.
 *
 * index    0 to the number of views - 1, in any order, each as often as wished; what a view shows
 *          that a frame does not begin is not defined
 * view     out; may be NULL; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL or there is no such view
 *          CUPOLA_ERROR_ORDER before frame_begin, or inside a view or a pass
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_view_begin(cupola_gl *gl, int index, struct cupola_gl_view *view,
                                    struct cupola_error *error);

/*
 * Ends the view that is open: several samples are resolved, and framebuffers, viewport and scissor
 * are again what they were when it began.
 *
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL
 *          CUPOLA_ERROR_ORDER outside of a view
 *          CUPOLA_ERROR_CONTEXT, and the view stays open
 *          CUPOLA_ERROR_LOST, and it does not
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_view_end(cupola_gl *gl, struct cupola_error *error);

/*
 * Moves the viewer's eye within the sphere that the plan was made for (head_radius_m of plan.h).
 * From the next view, import, warp and overlay on they are the new eye's; so a frame's eye is set
 * before its first view. The plan that gl was made from does not move: a host that draws into
 * textures of its own moves that one, too, for its cameras (cupola_plan_set_eye).
 *
 * Makes no GL call and allocates nothing; an eye that is where it was costs nothing. What an output
 * has of the eye follows in its next warp: uniforms, tiles, or the table of angles, sines or
 * coordinates, which is drawn once more. (Where the GL cannot draw into floats, cupola_gl_create
 * refuses those three for a plan whose eye may move.)
 *
 * eye_m    dome frame, at most head_radius_m from the eye of the rig that was planned for
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT for NULL or an eye outside of the sphere; the eye is as it was
 *          CUPOLA_ERROR_ORDER inside a view or a pass
 *          CUPOLA_ERROR_LOST if that was seen by an earlier call
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_set_eye(cupola_gl *gl, const double eye_m[3], struct cupola_error *error);

/*
 * Lays the mask of one view into the framebuffer that is bound for drawing: for hosts that draw
 * into textures of their own, once they have cleared them. Colour stays as it is.
 *
 * index    0 to the number of views - 1
 * mask     DEPTH or STENCIL
 * rect     where the view's base rectangle lies in the framebuffer, px; corner -2^24 to 2^24, size
 *          the plan's or any other, down to the plan's by the guard band; NULL: at (0, 0), of the
 *          plan's size
 * reversed the nearest depth is 1
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL, made without views, for views of its own or
 *          without masks, there is no such view, or mask or rectangle are not as said above
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_GL if the framebuffer is not complete
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_mask(cupola_gl *gl, int index, enum cupola_mask mask,
                              const struct cupola_rect *rect, bool reversed,
                              struct cupola_error *error);

/* A host's texture, or a part of it, as a view. */
struct cupola_view_image {
    /* GL_TEXTURE_2D, or GL_TEXTURE_2D_ARRAY for CUPOLA_STORAGE_LAYERS, in a format of colours that
     * are floats or normalised numbers */
    unsigned int texture;
    int layer; /* of an array; else 0 */
    /* Where the view's base rectangle lies in it, guard band included, texels; all zero: all of it.
     * The size need not be the plan's. */
    struct cupola_rect rect;
};

/*
 * Says where the host's own views are. They are drawn with the matrices of cupola_plan_camera, and
 * sampled bilinearly by a sampler object of Cupola's; the textures' own filter and wrap parameters
 * do not count, their base level and swizzles do. Holds until the next call; nothing is copied, and
 * the textures must live as long as warps show them. May be called in every frame.
 *
 * images   one for each view of the plan
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl or images is NULL, gl was not made for textures of the
 *          host's, one of them is none of that kind or in another format, a layer or a rectangle
 *          is outside of it, or layers are of different arrays. Which format, layers and texels a
 *          texture has cannot be asked in OpenGL ES 3.0 (3.1 can): there layers and rectangles are
 *          checked against the largest that the GL allows
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_views_import(cupola_gl *gl, const struct cupola_view_image *images,
                                      struct cupola_error *error);

/*
 * Sets what each pixel of an output is multiplied by, in linear light, before it is encoded:
 * photometry, masks, blending of projectors. It holds for all that is drawn into the output: views,
 * pictures, overlays and the border; alpha stays as it is.
 *
 * output   index, 0 to the number of the rig's outputs - 1
 * texture  a GL_TEXTURE_2D of the output's size, floats or normalised numbers, of which red, green
 *          and blue are used, fetched texel by texel; it must live and keep its size as long as it
 *          is set. One of a single channel is red, and lets green and blue be 0: a grey gain has
 *          three channels, or swizzles red into all. 0: none, which is how it begins
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL, there is no such output, or the texture is none or
 *          of another size or format (not asked for in OpenGL ES 3.0: see docs/host-contract.md)
 *          CUPOLA_ERROR_ORDER inside a view or a pass
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_MEMORY
 *          CUPOLA_ERROR_GL if the GL refuses a shader: the first call for an output makes programs
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_set_gain(cupola_gl *gl, int output, unsigned int texture,
                                  struct cupola_error *error);

/*
 * Where the warp draws: draw buffer 0 of a framebuffer, and no other of it, in a format of colours
 * that are floats or normalised numbers. All zero is the default framebuffer at (0, 0).
 */
struct cupola_target {
    unsigned int framebuffer; /* 0: the default framebuffer */
    int x;                    /* lower left corner of the output's image in it, px, -2^24 to 2^24 */
    int y;                    /* the same, from the bottom */
};

/*
 * Draws an output's image into a target, from the views as they are now or from a picture. The
 * rectangle is of the output's size; every pixel in it is written (colour, all four channels), none
 * outside of it.
 *
 * output   index, 0 to the number of the rig's outputs - 1
 * source   what is shown, of a kind that gl was made for; NULL: the views
 * target   NULL: all zero. Textures that the warp samples (the views, the output's table and
 *          gain, the picture) must not be attached to it, so the views' framebuffer is no target
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL, there is no such output, the source is of a kind
 *          that gl was not made for, a field of it is outside of its range or its texture is none
 *          of that kind or not as source.h says (asked for where OpenGL ES is not 3.0), a texture
 *          that is sampled is a colour of the target, one that was imported or set as a gain has
 *          been deleted since, the gain has another size by now, or the target's corner is too far
 *          CUPOLA_ERROR_ORDER inside a view or a pass, or before the host's views were imported
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_GL if the framebuffer does not exist or is not complete, its draw buffer 0
 *          is none or of integers, or the encoding is linear and this OpenGL ES always encodes into
 *          the target's format
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_warp(cupola_gl *gl, int output, const struct cupola_source *source,
                              const struct cupola_target *target, struct cupola_error *error);

/*
 * The views' texture, guard bands and gaps included. Its size (atlas_width_px, atlas_height_px of
 * the report) and the views' rectangles in it are the plan's. Lives as long as gl.
 *
 * returns  the name of a GL_TEXTURE_2D; 0 if gl is NULL or made without views of its own
 * thread   any
 * since    0.1
 */
CUPOLA_API unsigned int cupola_gl_atlas(const cupola_gl *gl);

/*
 * The point table of an output, for hosts that cast rays themselves: a GL_TEXTURE_2D of the
 * output's size, RGBA32F: x, y, z of D in metres (dome frame) and the pixel's coverage, 0 to 1.
 * Made at the first call, whatever the table stage. Lives as long as gl.
 *
 * output   index, 0 to the number of the rig's outputs - 1
 * texture  out; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl or texture is NULL, there is no such output, or it is larger
 *          than this GL's textures may be
 *          CUPOLA_ERROR_ORDER inside a view or a pass
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_MEMORY
 *          CUPOLA_ERROR_GL if the GL refuses a texture, a framebuffer or a shader
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_points(cupola_gl *gl, int output, unsigned int *texture,
                                struct cupola_error *error);

/*
 * The density map of an output (resolution.h), made by the GPU: a GL_TEXTURE_2D of the output's
 * size, R32F: the solid angle in sr that each pixel covers, seen by the eye as it is now; 0 where a
 * pixel is not lit. It is that of cupola_density_map to 1e-5 of itself, within 3 px of the rim to
 * 1e-4, for image circles up to 1000 px wide; larger ones of steep lenses lose in proportion.
 * Made at the first call; after the eye has moved the next call makes it anew, in the same texture
 * (on the CPU where the GL cannot draw into floats: not for every frame). Lives as long as gl.
 *
 * output   index, 0 to the number of the rig's outputs - 1
 * texture  out; untouched on failure
 * error    may be NULL
 * returns  as cupola_gl_points
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_density(cupola_gl *gl, int output, unsigned int *texture,
                                 struct cupola_error *error);

/*
 * Reads a rectangle of a framebuffer: the capture of a target.
 *
 * target   framebuffer, of which the read buffer is read, and lower left corner; NULL: all zero
 * width, height
 *          px, 1 to 32768 each; pixels outside of the framebuffer are undefined
 * rgba     out: 4 width height floats, rows from the bottom up, as GL converts them (OpenGL ES: of
 *          8 bits each, unless the framebuffer holds floats); untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if rgba is NULL, or a side or the corner is not as said above
 *          CUPOLA_ERROR_CONTEXT if no context is current, or one older than the floor
 *          CUPOLA_ERROR_LOST
 *          CUPOLA_ERROR_GL if the framebuffer does not exist, is not complete, has several samples
 *          per pixel, no colour to read or one of integers
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_capture(const struct cupola_target *target, int width, int height,
                                 float *rgba, struct cupola_error *error);

/*
 * The table stage that an output is warped by: what was asked for, or what auto chose; or none
 * where a table was asked for and the filter may send out several rays from a pixel.
 *
 * output   index, 0 to the number of the rig's outputs - 1
 * returns  of enum cupola_table; CUPOLA_ERROR_ARGUMENT if gl is NULL, made without views, or there
 *          is no such output
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_table(const cupola_gl *gl, int output);

#ifdef __cplusplus
}
#endif

#endif
