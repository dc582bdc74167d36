/*
 * The inside of a cupola_gl:
 *
 *   instance  what there is, made and given back
 *   views     the atlas and the framebuffers that the host draws into
 *   passes    tables and warps, one of each per output
 */
#ifndef INSTANCE_H
#define INSTANCE_H

#include <epoxy/gl.h>

#include "cupola/gl.h"
#include "geometry/plan.h"
#include "geometry/source.h"
#include "host_state.h"

/* What shows pictures of one kind. */
struct source_program {
    GLuint program; /* 0 where the kind was not asked for */
    GLint target_corner, rotation, center, half_fov, mipmaps; /* locations of the uniforms */
};

/* Tables and programs of one output. */
struct warp_pass {
    GLuint program;
    GLint target_corner; /* location of the uniform */
    GLuint table;        /* 0 for the stage none */
    GLuint points;       /* 0 until asked for; the same as `table` for the stage points */
    struct source_program sources[SOURCE_KINDS]; /* that of the views stays empty */
};

struct cupola_gl {
    struct cupola_plan plan;
    struct cupola_gl_params params;
    struct host_features features;
    GLuint vertex_array; /* without any attribute: the full-screen triangle needs none */
    GLuint atlas, depth, framebuffer; /* 0 without views */
    GLuint sampler;                   /* of pictures; 0 where none are shown */
    struct warp_pass passes[CUPOLA_OUTPUTS_MAX];
    struct cupola_frame frame;
    bool frame_begun;
    bool view_open;
    struct host_target host_target; /* while a view is open */
};

/* An error unless a context of OpenGL 3.3, OpenGL ES 3.0 or newer is current. */
int context_check(struct cupola_error *error);

/* In creation the error is never NULL. */
int views_create(cupola_gl *gl, struct cupola_error *error);
void views_destroy(cupola_gl *gl);

/* All with the host's state saved already. */
int warp_pass_create(cupola_gl *gl, int output, struct cupola_error *error);
void warp_pass_destroy(struct warp_pass *pass);
int source_programs_create(cupola_gl *gl, int output, struct cupola_error *error);

/* Whether a kind of source was asked for at creation. */
static inline bool shows_source(const cupola_gl *gl, enum cupola_source_kind kind)
{
    return gl->params.sources >> (unsigned int)kind & 1u;
}

/*
 * Draws a picture into the framebuffer that is bound, with its area set. The source has been
 * checked.
 */
void source_draw(const cupola_gl *gl, int output, const struct cupola_source *source,
                 const struct cupola_target *place);

/* Also whether its kind was asked for and its texture is one. */
int source_check_gl(const cupola_gl *gl, const struct cupola_source *source,
                    struct cupola_error *error);

/*
 * Binds a texture to the active unit; false, and no error left in the GL, if there is none of that
 * name or it is of another kind. The target is GL_TEXTURE_2D or GL_TEXTURE_CUBE_MAP.
 */
bool texture_bind(GLenum target, GLuint name);

/*
 * A stage's table of one output by the C functions, for GLs that cannot draw into floats. 0 on
 * failure.
 */
GLuint table_upload(const cupola_gl *gl, int output, enum cupola_table stage,
                    struct cupola_error *error);

/*
 * Binds a host's framebuffer for drawing and reading; CUPOLA_ERROR_GL, and no error left in the GL,
 * if there is none of that name or it is not complete.
 */
int target_bind(GLuint framebuffer, struct cupola_error *error);

/*
 * For the framebuffer that target_bind has bound: CUPOLA_ERROR_ARGUMENT if one of its colours is a
 * texture that would be sampled while it is drawn into. Textures of name 0 are none.
 */
int target_check_sampled(GLuint framebuffer, const GLuint *textures, int count,
                         struct cupola_error *error);

/* Forgets errors that were there before, so that the next glGetError tells of our own calls. */
void gl_errors_drop(void);

/* A framebuffer with one colour texture. 0 on failure. */
GLuint framebuffer_create(GLuint texture);

/* A 2-D texture without mipmaps, clamped to its edge. 0 on failure. */
GLuint texture_create(GLenum internal_format, int width_px, int height_px, GLenum filter,
                      struct cupola_error *error);

void draw_fullscreen(GLuint vertex_array);

#endif
