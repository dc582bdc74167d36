/*
 * All views in one pass: a host that can draw an object several times in one call (by instances)
 * walks through its scene once instead of once for each view.
 *
 *     struct cupola_gl_pass pass;
 *     cupola_gl_frame_begin(gl, &frame, NULL);
 *     cupola_gl_pass_begin(gl, world_to_camera, &pass, NULL);
 *     glBindBufferBase(GL_UNIFORM_BUFFER, 3, pass.buffer);
 *     for each object: glDrawElementsInstanced(..., pass.view_count);
 *     cupola_gl_pass_end(gl, NULL);
 *     cupola_gl_warp(gl, 0, NULL, &target, NULL);
 *
 * Each vertex goes to a view of its own choice. That needs several viewports (OpenGL 4.1 or
 * GL_ARB_viewport_array; OpenGL ES 3.2 with GL_OES_viewport_array or GL_NV_viewport_array) and a
 * shader that names one of them: the vertex shader where GL_ARB_shader_viewport_layer_array or
 * GL_AMD_vertex_shader_viewport_index is, else a geometry shader. cupola_pass_way tells whether and
 * how; hosts of a GL that cannot draw view by view (gl.h), and get the same picture.
 *
 * The text that cupola_pass_glsl gives goes behind the #version line and the host's own #extension
 * lines of the vertex shader, which no GLSL allows further down, and before everything else:
 *
 *     int cupola_view()      the view of this instance: gl_InstanceID % the number of views
 *     int cupola_instance()  the host's own instance: gl_InstanceID / the number of views
 *     void cupola_place(vec4 place, int view)
 *                            sets gl_Position: `place` as the view's camera sees it, in the frame
 *                            that the matrix given to pass_begin starts from
 *     void cupola_send(vec4 clip, int view)
 *                            the same with a place in the view's clip space, for what covers views
 *
 * Exactly one of the latter two is called, once per vertex, with one view for all vertices of a
 * primitive. Both are functions of the host's numbers alone: who culls per view gives each instance
 * the number of its view as an attribute, and draws the lists of all views in one call. Attributes
 * of the host's own instances advance every view_count instances (glVertexAttribDivisor).
 *
 * Uniforms are in a block `cupola_pass` whose binding is the host's choice:
 *
 *     glUniformBlockBinding(program, glGetUniformBlockIndex(program, "cupola_pass"), 3);
 */
#ifndef CUPOLA_ONE_PASS_H
#define CUPOLA_ONE_PASS_H

#include <stddef.h>

#include "gl.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which shader chooses the view. */
enum cupola_pass_way {
    CUPOLA_PASS_BEST = 0, /* the first of these that the GL can */
    CUPOLA_PASS_VERTEX,   /* the vertex shader: costs about nothing */
    CUPOLA_PASS_GEOMETRY, /* a geometry shader, which costs more per triangle on most GPUs */
};

/*
 * Whether the current context can draw all views in one pass, and how. For programs to be made
 * before there is a cupola_gl.
 *
 * error    may be NULL; says what is missing
 * returns  CUPOLA_PASS_VERTEX or CUPOLA_PASS_GEOMETRY
 *          CUPOLA_ERROR_GL if it cannot
 *          CUPOLA_ERROR_CONTEXT if no context is current, or one older than the floor
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_pass_way(struct cupola_error *error);

/* Of which shader the text is. */
enum cupola_pass_stage { CUPOLA_PASS_STAGE_VERTEX = 0, CUPOLA_PASS_STAGE_GEOMETRY };

/* Of a geometry shader: what the host's calls draw. */
enum cupola_pass_primitive {
    CUPOLA_PASS_TRIANGLES = 0, /* strips and fans, too */
    CUPOLA_PASS_LINES,         /* strips and loops, too */
    CUPOLA_PASS_POINTS,        /* their gl_PointSize is passed on; not in OpenGL ES */
};

enum { CUPOLA_PASS_VARYINGS_MAX = 32, CUPOLA_PASS_CLIP_DISTANCES_MAX = 8 };

/* Which text is wished. */
struct cupola_pass_shader {
    enum cupola_pass_way way;     /* 0: the best one. The same for both stages */
    enum cupola_pass_stage stage; /* 0: the vertex shader's */
    /*
     * The outputs of the host's vertex shader, for the geometry shader that has to pass them on:
     * each as it is declared, without `out` and semicolon: "vec3 normal", "flat int material". That
     * is: one of flat, smooth and noperspective, and one of centroid and sample, as far as this
     * context has them; a precision; a scalar, vector or matrix type; a name. No arrays, no blocks:
     * hosts that have some write their own geometry shader. Not asked for where the vertex shader
     * chooses the view.
     */
    const char *const *varyings;
    int varying_count;                    /* 0 to CUPOLA_PASS_VARYINGS_MAX */
    enum cupola_pass_primitive primitive; /* what the host draws; 0: triangles */
    /*
     * How many gl_ClipDistance the host's vertex shader writes, for the geometry shader that has to
     * pass them on; 0 to CUPOLA_PASS_CLIP_DISTANCES_MAX, in OpenGL ES those of
     * GL_EXT_clip_cull_distance. What is not named here is lost there, as gl_CullDistance always
     * is. Not asked for where the vertex shader chooses the view.
     */
    int clip_distances;
};

/*
 * Writes GLSL. Of the vertex shader: #extension lines, the uniform block and the functions above,
 * to stand behind the host's #version line (3.30 or newer, 3.20 es) and its own #extension lines,
 * and before everything else; what follows it counts as line 2 and so on in messages. Of the
 * geometry shader: all but its #version line. The fragment shader stays as it is. Where a geometry
 * shader is needed, the vertex shader's outputs get other names by #define, so that no line of the
 * host's differs between both ways.
 *
 * shader   NULL: all zero
 * text     out: ends with a line's end and 0; untouched on failure
 * size     bytes; 16384 are always enough for names and types of up to 60 characters together
 * error    may be NULL
 * returns  its length without the 0
 *          CUPOLA_ERROR_ARGUMENT if text is NULL, a field is not as said above, a varying is no
 *          declaration, the geometry shader is asked for where the vertex shader needs none, or
 *          size is too small; the message says how many bytes are needed
 *          CUPOLA_ERROR_GL if this context cannot, or not in this way
 *          CUPOLA_ERROR_CONTEXT
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_pass_glsl(const struct cupola_pass_shader *shader, char *text, size_t size,
                                struct cupola_error *error);

/* What a host draws all views with. */
struct cupola_gl_pass {
    unsigned int framebuffer; /* already bound for drawing and reading */
    unsigned int buffer;      /* of the uniform block; not bound. The same as long as gl lives */
    int view_count;           /* of the plan; instances per object of the host's */
    /* For culling: matrices and planes of each, as view_begin gives them (without the host's
     * matrix). Its rectangle is that of the viewport of the same index. */
    struct cupola_gl_view views[CUPOLA_VIEWS_MAX];
};

/*
 * Begins a pass over all views of a frame, in place of view_begin for each: clears them all, binds
 * their framebuffer, sets viewport and scissor rectangle of index i to those of view i, and writes
 * the uniform block. pass_end puts back what the host had. gl must have been made with `one_pass`.
 *
 * Scissor rectangles keep what a view draws inside of it, wide lines and points included.
 *
 * world    column-major: from the frame that places are given in to the host's camera frame, as the
 *          host's camera matrix is; with it one product per vertex suffices, computed in double
 *          precision once. NULL: places are in the host's camera frame
 * pass     out; may be NULL; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL or was made without one_pass, or world has a number
 *          that is not finite
 *          CUPOLA_ERROR_ORDER before frame_begin, inside a view or inside a pass
 *          CUPOLA_ERROR_CONTEXT
 *          CUPOLA_ERROR_LOST
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_pass_begin(cupola_gl *gl, const float world[16],
                                    struct cupola_gl_pass *pass, struct cupola_error *error);

/*
 * Ends the pass that is open: several samples are resolved, and framebuffers, viewports and scissor
 * rectangles are again what they were when it began.
 *
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if gl is NULL
 *          CUPOLA_ERROR_ORDER outside of a pass
 *          CUPOLA_ERROR_CONTEXT, and the pass stays open
 *          CUPOLA_ERROR_LOST, and it does not
 * thread   the context's
 * since    0.1
 */
CUPOLA_API int cupola_gl_pass_end(cupola_gl *gl, struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
