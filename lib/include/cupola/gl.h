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
 *     cupola_gl_warp(gl, 0, &target, NULL);
 *
 * Every call here runs on the thread where the host's context is current, and leaves the GL state
 * as it found it (docs/host-contract.md has the list), except that between view_begin and view_end
 * the view's framebuffer, viewport and scissor rectangle are set for the host. OpenGL 3.3 core is
 * the floor. Object names are of type GLuint, spelled `unsigned int` so that no GL header is
 * needed. Where no context is current, whatever needs one answers CUPOLA_ERROR_CONTEXT.
 */
#ifndef CUPOLA_GL_H
#define CUPOLA_GL_H

#include "plan.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cupola_gl cupola_gl;

/* Of the views' colour; depth is always 32 bit float. */
enum cupola_format {
    CUPOLA_FORMAT_RGBA8 = 0,
    CUPOLA_FORMAT_RGBA16F,
    CUPOLA_FORMAT_RGBA32F,
};

/* What is computed once instead of once per frame; the paper's section 3.3.1. */
enum cupola_table {
    CUPOLA_TABLE_POINTS = 0,  /* D, the points of the screen */
    CUPOLA_TABLE_NONE,        /* nothing: all in the shader */
    CUPOLA_TABLE_ANGLES,      /* the two angles of each ray */
    CUPOLA_TABLE_SINES,       /* their sines and cosines, the paper's choice */
    CUPOLA_TABLE_COORDINATES, /* finished coordinates in the atlas */
};

struct cupola_gl_params {
    enum cupola_format format;
    enum cupola_table table;
    float border[4]; /* RGBA of pixels that are not lit; all zero: transparent black */
};

/*
 * Makes textures, framebuffers, tables and programs for a plan. Nothing of the plan is kept.
 *
 * params   NULL: all zero
 * gl       out: to be given to cupola_gl_destroy; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK; CUPOLA_ERROR_CONTEXT if no context is current or it is older than 3.3;
 *          CUPOLA_ERROR_ARGUMENT if the atlas is larger than this GL's textures may be;
 *          CUPOLA_ERROR_MEMORY; CUPOLA_ERROR_GL
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_create(const cupola_plan *plan, const struct cupola_gl_params *params,
                                cupola_gl **gl, struct cupola_error *error);

/*
 * Gives back every GL object and sets the handle to NULL; NULL and a handle that is NULL are
 * allowed. The context in which it was made must be current (one that shares its textures will not
 * do: framebuffers and vertex arrays are not shared); if none is, only memory is freed.
 */
CUPOLA_API void cupola_gl_destroy(cupola_gl **gl);

struct cupola_frame {
    double near_distance; /* along each view's axis, scene units; 0: 0.1 */
    double far_distance;  /* 0: 1000 */
    float clear_color[4]; /* RGBA that each view is cleared to; all zero: transparent black */
};

/*
 * Begins a frame.
 *
 * frame    NULL: all zero
 * returns  the number of views to draw; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_ORDER inside a view
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_frame_begin(cupola_gl *gl, const struct cupola_frame *frame,
                                     struct cupola_error *error);

struct cupola_gl_view {
    unsigned int framebuffer; /* already bound for drawing and reading */
    struct cupola_rect rect;  /* its viewport and scissor rectangle, already set */
    struct cupola_camera camera;
};

/*
 * Begins one view: clears its colour and depth (the host must not clear it), binds its framebuffer
 * and sets viewport and scissor rectangle to it. view_end puts back what the host had.
 *
 * index    0 to the number of views - 1, in any order, each as often as wished
 * view     out; may be NULL
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_ORDER before frame_begin or inside a view
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_view_begin(cupola_gl *gl, int index, struct cupola_gl_view *view,
                                    struct cupola_error *error);
CUPOLA_API int cupola_gl_view_end(cupola_gl *gl, struct cupola_error *error);

/* Where the warp draws. All zero is the default framebuffer at (0, 0). */
struct cupola_target {
    unsigned int framebuffer; /* 0: the default framebuffer */
    int x;                    /* lower left corner of the output's image in it, px */
    int y;
};

/*
 * Draws an output's image into a target, from the views as they are now. The rectangle is of the
 * output's size; every pixel in it is written (colour, all four channels), none outside of it.
 *
 * output   index
 * target   NULL: all zero
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_ORDER inside a view; CUPOLA_ERROR_GL
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_warp(cupola_gl *gl, int output, const struct cupola_target *target,
                              struct cupola_error *error);

/*
 * The views' texture: its name and size, guard bands and gaps included. The rectangles are the
 * plan's. Lives as long as gl.
 *
 * returns  the name of a GL_TEXTURE_2D
 * thread   any
 * since    0.1
 */
CUPOLA_API unsigned int cupola_gl_atlas(const cupola_gl *gl);

/*
 * The point table of an output, for hosts that cast rays themselves: a GL_TEXTURE_2D of the
 * output's size, RGBA32F: x, y, z of D in metres (dome frame) and the pixel's coverage, 0 to 1.
 * Made at the first call, whatever the table stage. Lives as long as gl.
 *
 * texture  out
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_ORDER inside a view; CUPOLA_ERROR_MEMORY;
 *          CUPOLA_ERROR_GL
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_points(cupola_gl *gl, int output, unsigned int *texture,
                                struct cupola_error *error);

/*
 * Reads a rectangle of a framebuffer: the capture of a target.
 *
 * target   framebuffer and lower left corner; NULL: all zero
 * rgba     out: 4 width height floats, rows from the bottom up, as GL converts them
 * returns  CUPOLA_OK; CUPOLA_ERROR_CONTEXT; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_GL
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_capture(const struct cupola_target *target, int width, int height,
                                 float *rgba, struct cupola_error *error);

/*
 * The name of a table stage as on command lines, and the way back (CUPOLA_ERROR_ARGUMENT if there
 * is none); the name is NULL for a number that is no stage.
 *
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_table_name(int table);
CUPOLA_API int cupola_table_find(const char *name);

#ifdef __cplusplus
}
#endif

#endif
