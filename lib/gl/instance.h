/*
 * The inside of a cupola_gl:
 *
 *   instance  what there is, made and given back
 *   views     the atlas and the framebuffers that the host draws into
 *   mask      of texels that no pixel samples
 *   passes    tables and warps, one of each per output
 *   eye       what follows a viewer who moves
 *   jitter    samples beside the middles of texels and pixels
 */
#ifndef INSTANCE_H
#define INSTANCE_H

#include <epoxy/gl.h>

#include "cupola/gl.h"
#include "geometry/mask.h"
#include "geometry/plan.h"
#include "geometry/source.h"
#include "geometry/tiles.h"
#include "guest.h"
#include "host_areas.h"
#include "host_state.h"

/* What shows one kind of source on one output. */
struct warp_program {
    GLuint program;               /* 0 where the kind was not asked for */
    GLint target_corner, encoded; /* locations of uniforms; -1: not there */
    GLint ray_jitter;
    GLint eye, bases, tile_views;              /* of views: what follows the eye */
    GLint rotation, center, half_fov, mipmaps; /* of pictures */
    GLint image_rect, image_layer;             /* of views that are the host's textures */
};

/* What shows overlays on one output. */
struct overlay_program {
    GLuint program;                                        /* 0 where they were not asked for */
    GLint target_corner, encoded, kind, axes, half, color; /* locations of uniforms */
    GLint eye;
};

/* The tiles of one output; nothing of them without the stage of tiles. */
struct tile_pass {
    struct tiles tiles;
    GLuint buffers[TILE_KINDS], arrays[TILE_KINDS];
};

/* What draws an output's table once more for another eye; nothing of it where none is needed. */
struct table_pass {
    GLuint program, framebuffer;
    GLint eye, bases; /* locations of uniforms; -1: not there */
};

/* The density map of one output; nothing of it until it is asked for. */
struct density_pass {
    GLuint texture;
    struct table_pass redraw; /* where the eye may move and the GL draws into floats */
    unsigned int moves;       /* of the eye that are taken in; see cupola_gl */
};

/* What an output's programs are for: kinds of sources, then kinds of tiles of views. */
enum { WARP_PROGRAMS = SOURCE_KINDS + TILE_KINDS };

/* Tables and programs of one output. */
struct warp_pass {
    enum cupola_table stage; /* of its views; never auto */
    GLuint table;            /* 0 for the stages none and tiles */
    GLuint points;           /* 0 until asked for; the same as `table` for the stage points */
    GLuint gain;             /* the host's; 0: none */
    bool gained;             /* there are programs with gain */
    /* Without gain, and with it: those are made when a gain is set for the first time. */
    struct warp_program programs[2][WARP_PROGRAMS];
    struct overlay_program overlays[2];
    struct tile_pass tiles;
    struct table_pass redraw; /* of the table */
    struct density_pass density;
    unsigned int moves; /* of the eye that are taken in; see cupola_gl */
};

/* What no pixel samples of the views. */
struct mask_pass {
    enum cupola_mask kind; /* what begins views lays; for a host's textures: NONE or not */
    struct mask mask;
    GLuint buffer, array, program;
    GLint area, nearest; /* locations of uniforms */
    unsigned int moves;  /* of the eye that are taken in; see cupola_gl */
};

/* Where views are that the host brings: as cupola_gl_views_import was told. */
struct view_images {
    bool given;
    GLuint textures[CUPOLA_VIEWS_MAX];
    GLfloat rects[4 * CUPOLA_VIEWS_MAX]; /* x, y, width, height, texels; all zero: all of it */
    GLfloat layers[CUPOLA_VIEWS_MAX];
};

/* As cupola_gl_set_jitter was told. */
struct jitter {
    double texels[2], pixels[2];
    bool laid;                         /* the plan's base rectangles are moved from here: */
    double bases[CUPOLA_VIEWS_MAX][4]; /* left, right, bottom, top */
};

struct cupola_gl {
    struct cupola_plan plan; /* a copy of the host's */
    unsigned int moves;      /* of its eye; what was made for an eye follows when it is needed */
    struct cupola_gl_params params;
    struct host_features features;
    struct guest guest;  /* of the context with these features */
    char *filter_places; /* of rays, in the words of shaders/filter.glsl */
    GLuint vertex_array; /* without any attribute: the full-screen triangle needs none */
    GLuint atlas, depth; /* 0 without views; a depth only where one is wished */
    GLuint framebuffer;  /* what the host draws the views into */
    /* With several samples their colours, drawn into, and the framebuffer of the atlas; else 0. */
    GLuint samples, resolved;
    GLint sample_count;   /* what the GL made of the samples that were wished for */
    GLuint sampler;       /* of pictures; 0 where none are shown */
    GLuint image_sampler; /* of views that are the host's textures */
    GLuint gain_sampler;
    struct mask_pass mask;
    struct view_images images;
    struct jitter jitter;
    struct warp_pass passes[CUPOLA_OUTPUTS_MAX];
    struct cupola_frame frame;
    bool frame_begun;
    unsigned int views_begun; /* in this frame: 1 << index of each */
    unsigned int moves_begun; /* of the eye, when all of the atlas was cleared and masked */
    bool view_open;
    int open_view;                  /* its index */
    bool pass_open;                 /* over all views */
    GLuint pass_buffer;             /* the uniform block of one_pass.h; 0 where it was not wished */
    struct host_areas host_areas;   /* while a pass is open, unless the state is left */
    struct host_target host_target; /* while a view or a pass is open; likewise */
    bool view_grouped;              /* the same, in a debug group */
    bool views_drawn;               /* one of them at least, ever */
    bool blank_told;                /* that none was */
};

/* guest_ended for a public call on a gl, which may be NULL. */
int call_ended(cupola_gl *gl, const char *call, int status, struct cupola_error *error);

/* Whether a colour of the host's consists of finite numbers. */
int color_check(const char *name, const float color[4], struct cupola_error *error);

/* Tells the log what was made, and what of the GL is used. */
void instance_tell_created(const cupola_gl *gl);

/* Whether the formats of the views are such; samples are for views_create to judge. */
int views_check_params(const struct cupola_gl_params *params, struct cupola_error *error);

/* In creation the error is never NULL. */
int views_create(cupola_gl *gl, struct cupola_error *error);
void views_destroy(cupola_gl *gl);
bool views_have_stencil(const cupola_gl *gl);
bool views_format_has_stencil(enum cupola_depth_format format);

/* The host's state saved already: makes one view ready to be drawn; -1: all of them. */
void views_clear(cupola_gl *gl, int index);

/*
 * The end of one view, or of all of a pass: samples of `count` views from `first` on are resolved,
 * and all that view_begin changed for the host is put back.
 */
void views_finish(cupola_gl *gl, int first, int count);

/* What is open: "view", "pass" or NULL. */
static inline const char *open_kind(const cupola_gl *gl)
{
    return gl->view_open ? "view" : gl->pass_open ? "pass" : NULL;
}

const char *views_format_name(const cupola_gl *gl);
const char *views_depth_name(const cupola_gl *gl);

/* Whether the mask and the formats of the views, which have been checked, agree. */
int mask_check_params(const struct cupola_gl_params *params, struct cupola_error *error);

/* After views_create; all of the pass is there to be destroyed after a failure, too. */
int mask_pass_create(cupola_gl *gl, struct cupola_error *error);
void mask_pass_destroy(struct mask_pass *pass);
/* Its memory. */
void mask_pass_forget(struct mask_pass *pass);

/*
 * Lays the mask of one view, or of all of them (below 0), for the eye as it is now. Viewport and
 * scissor rectangle are set, and show the area of the atlas. Depth or stencil. Allocates nothing.
 */
void mask_lay(cupola_gl *gl, int view, enum cupola_mask kind, const struct cupola_rect *area,
              bool reversed);

/* Takes the jitter out of the plan's base rectangles, and lays it in again. */
void jitter_lift(cupola_gl *gl);
void jitter_lay(cupola_gl *gl);

/* Whether jitters are possible; so far as is known, all else has been checked. */
int jitter_check_params(const struct cupola_gl_params *params, int guard_px,
                        struct cupola_error *error);

/* How far from the middle of its pixel a ray may be, px. */
double jitter_reach_px(const cupola_gl *gl);

/* Whether gl and an output of it may be worked on now. */
int output_check(cupola_gl *gl, int output, struct cupola_error *error);

/* All with the host's state saved already. */
int warp_pass_create(cupola_gl *gl, int output, struct cupola_error *error);
void warp_pass_destroy(struct warp_pass *pass);

/* Of a pass whose stage is set, what shows views; after a failure a part of it may be there. */
int warp_views_create(cupola_gl *gl, int output, struct cupola_error *error);

/* Shows the views on an output, in a framebuffer that is bound, without any check. */
void warp_draw_views(cupola_gl *gl, int output, const struct cupola_target *place);

/* Of a pass whose stage is auto: creates what shows views by the stage that is the fastest. */
int table_choose(cupola_gl *gl, int output, struct cupola_error *error);

/*
 * Before views are shown on an output: its programs and its table or tiles follow the eye, if that
 * has moved since. Allocates nothing. The framebuffer is bound for drawing afterwards.
 */
void eye_follow(cupola_gl *gl, int output, GLuint framebuffer);

/* The programs of one output for all kinds that were asked for, with gain or without. */
int warp_programs_create(const cupola_gl *gl, int output, bool gained,
                         struct warp_program made[WARP_PROGRAMS], struct cupola_error *error);
void warp_programs_destroy(struct warp_program programs[WARP_PROGRAMS]);

/* Tiles and their buffers; all of the pass is there to be destroyed after a failure, too. */
int tile_pass_create(const cupola_gl *gl, int output, struct tile_pass *pass,
                     struct cupola_error *error);
void tile_pass_destroy(struct tile_pass *pass);
/* Frees memory alone, where the GL's objects are gone. */
void tile_pass_forget(struct tile_pass *pass);

/* After eye or views of the plan have changed. Allocates nothing. */
void tile_pass_refit(cupola_gl *gl, int output);

/* The program of a kind of tiles, with `lines` of warp_lines. 0 on failure. */
enum { TILE_LINES_MAX = 256 };
GLuint tile_program_create(const cupola_gl *gl, int output, int kind, const char *lines,
                           struct cupola_error *error);

/* All tiles of a kind, with the program in use. */
void tile_draw(const struct tile_pass *pass, int kind);

/* Whether a kind of source was asked for at creation. */
static inline bool shows_source(const cupola_gl *gl, enum cupola_source_kind kind)
{
    return gl->params.sources >> (unsigned int)kind & 1u;
}

/* Lines that images.glsl, light.glsl and filter.glsl rely on, but for RIM. */
enum { WARP_LINES_MAX = 896 };
void warp_lines(const cupola_gl *gl, bool gained, char lines[WARP_LINES_MAX]);

/* What shows the views pixel by pixel, with any vertex shader. 0 on failure. */
GLuint warp_program_compile(const cupola_gl *gl, const char *vertex_name, const char *vertex_text,
                            const char *defines, struct cupola_error *error);

/* Which units the program in use finds views and table on. */
void warp_set_units(const cupola_gl *gl, GLuint program);

/* That of one output, with gain or without; nothing where gl was made without overlays. */
int overlay_program_create(const cupola_gl *gl, int output, bool gained,
                           struct overlay_program *made, struct cupola_error *error);
void overlay_program_destroy(struct overlay_program *program);

/*
 * Those of light.glsl. Asked: whether to encode is left to a uniform, for contexts
 * where the GL may do it by itself.
 */
void light_lines(enum cupola_encoding encoding, bool asked, bool gained, bool dithered,
                 char lines[WARP_LINES_MAX]);

/*
 * Compiles what shows pictures of a kind, with `lines` before its files, and sets all but what
 * differs from frame to frame. 0 on failure.
 */
GLuint source_program_create(const cupola_gl *gl, int output, int kind, const char *lines,
                             struct cupola_error *error);

/* Sets texture and uniforms of a picture that has been checked; the program is in use. */
void source_bind(const cupola_gl *gl, const struct warp_program *program,
                 const struct cupola_source *source);

/*
 * Sets the sampler of pictures and overlays. Round about: the left edge meets the right one;
 * nearest: one texel, no mean.
 */
void picture_sampler_bind(const cupola_gl *gl, bool mipmaps, bool round_about, bool nearest);

/* Also whether its kind was asked for and its texture is one. */
int source_check_gl(const cupola_gl *gl, const struct cupola_source *source,
                    struct cupola_error *error);

/*
 * The texture units of the warp: the picture or the views' first texture, the table, further
 * textures of views, the gain.
 */
enum { UNIT_IMAGE = 0, UNIT_TABLE = 1 };
GLint view_image_unit(int view);
GLint gain_unit(const cupola_gl *gl);

/* The views that the host brings; set: what the program in use wants of them, if they are so. */
int view_images_create(cupola_gl *gl, struct cupola_error *error);
int view_images_check(const cupola_gl *gl, struct cupola_error *error);
void view_images_bind(const cupola_gl *gl);
void view_images_set(const cupola_gl *gl, const struct warp_program *program);

/* The gain of an output that has one. */
int gain_check(const cupola_gl *gl, int output, struct cupola_error *error);
void gain_bind(const cupola_gl *gl, int output);

/*
 * A stage's table of one output, in whatever way the GL allows. 0 on failure. `redraw` gets what
 * table_redraw needs, if the stage depends on an eye that may move; NULL: it is the eye's for ever.
 */
GLuint table_create(const cupola_gl *gl, int output, enum cupola_table stage,
                    struct table_pass *redraw, struct cupola_error *error);
void table_pass_destroy(struct table_pass *redraw);

void density_pass_destroy(struct density_pass *pass);

/* The table of one output for the eye as it is now, if it depends on that. */
void table_redraw(const cupola_gl *gl, int output);

/*
 * A stage's table of one output by the C functions, for GLs that cannot draw into floats. 0 on
 * failure.
 */
GLuint table_upload(const cupola_gl *gl, int output, enum cupola_table stage,
                    struct cupola_error *error);

#endif
