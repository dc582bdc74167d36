/*
 * The host's GL state: everything that Cupola's calls change, saved and put back. The list here is
 * the one in docs/host-contract.md.
 */
#ifndef HOST_STATE_H
#define HOST_STATE_H

#include <epoxy/gl.h>
#include <stdbool.h>

enum {
    HOST_CAPABILITIES_MAX = 32,
    HOST_TEXTURE_UNITS_MAX = 16, /* as many as every GL has */
    HOST_PIXEL_STORES = 10,
    HOST_DRAW_BUFFERS_MAX = 16, /* as many as the GL has names for */
};

/* Debug groups and labels. */
enum host_debug {
    HOST_DEBUG_NONE = 0,
    HOST_DEBUG_CORE, /* functions of the core's names */
    HOST_DEBUG_KHR,  /* OpenGL ES before 3.2 */
};

/* By which function a context tells that it has been lost. */
enum host_reset {
    HOST_RESET_NEVER = 0, /* it is not robust */
    HOST_RESET_CORE,
    HOST_RESET_KHR,
    HOST_RESET_ARB,
    HOST_RESET_EXT,
};

/* What a context has, by its version or by an extension. */
struct host_features {
    bool es;                 /* OpenGL ES, not desktop OpenGL */
    bool compatibility;      /* a compatibility profile, which has old kinds of points */
    bool viewport_array;     /* several viewports and scissor rectangles */
    bool viewport_array_nv;  /* by the functions of that name */
    bool clip_control;       /* origin and depth range of clip space */
    bool mask_per_buffer;    /* colour mask and blending on or off for each draw buffer */
    bool blend_per_buffer;   /* blend functions for each draw buffer */
    bool transform_feedback; /* that can be paused */
    bool polygon_mode;       /* lines or points for polygons */
    bool float_targets;      /* drawing into RGBA32F, and into RGBA16F */
    bool half_float_targets; /* drawing into RGBA16F */
    bool float_filter;       /* bilinear filtering of RGBA32F */
    bool float_blend;        /* blending in targets of 32 bit floats */
    bool srgb_always;        /* what is drawn into sRGB formats is encoded, wished or not */
    bool texture_sizes;      /* can be asked for */
    int draw_buffers;
    enum host_debug debug;
    int debug_groups;   /* that fit into the stack */
    bool debug_context; /* made for debugging */
    enum host_reset reset;
    bool capabilities[HOST_CAPABILITIES_MAX];
    /* What is used, not what there is: texture units from 0 on, and array textures on unit 0. */
    int texture_units;
    bool texture_arrays;
};

/* Where drawing goes: what view_begin changes for the host until view_end. */
struct host_target {
    GLint draw_framebuffer;
    GLint read_framebuffer;
    GLfloat viewport[4];
    GLint scissor[4];
    GLboolean scissor_test;
};

/* How drawing is done: what never differs for the host from one of its own commands to the next. */
struct host_state {
    const struct host_features *features;
    bool kept; /* saved, to be restored */
    struct host_target target;
    GLboolean capabilities[HOST_CAPABILITIES_MAX];
    GLboolean blend;
    GLint blend_equation[2], blend_factors[4];
    GLint color_masks[HOST_DRAW_BUFFERS_MAX][4];
    GLboolean depth_mask;
    GLint polygon_mode[2];
    GLint clip_origin, clip_depth;
    bool paused_feedback;
    GLint program;
    GLint vertex_array;
    GLint renderbuffer;
    GLint active_texture;
    GLint textures[HOST_TEXTURE_UNITS_MAX];
    GLint texture_array;
    GLint samplers[HOST_TEXTURE_UNITS_MAX];
    GLint unpack_buffer;
    GLint pack_buffer;
    GLint pixel_stores[HOST_PIXEL_STORES];
    GLint clamp_read_color;
};

/* Slow: once per context. Two texture units are used. */
void host_features_find(struct host_features *features);

void host_target_save(struct host_target *target);
/* What the host has deleted in the meantime is no longer bound, as if we had not been there. */
void host_target_forget_deleted(struct host_target *target);
void host_target_restore(const struct host_target *target, const struct host_features *features);

/*
 * Saves all of it and sets what a full-screen pass, a clear or a transfer of pixels needs: no test,
 * no blending, all channels of draw buffer 0 written and none of the others, textures read without
 * sampler objects, packed pixels. The features must live until host_state_restore.
 */
void host_state_save(struct host_state *state, const struct host_features *features);
void host_state_restore(const struct host_state *state);

/* Sets the same without asking; host_state_restore then only ends the encoding of sRGB. */
void host_state_set(struct host_state *state, const struct host_features *features);

/* Between saving and restoring: adds what is drawn to what is there; alpha stays. */
void host_set_adding(const struct host_features *features, bool adding);

/* Between saving and restoring: has the GL encode what is drawn into sRGB formats. */
void host_set_encoding(const struct host_features *features, bool encoding);

/*
 * Between saving and restoring: lays what is drawn, premultiplied, over what is there; alpha
 * likewise. `linear`: in linear light, if the target has an sRGB format.
 */
void host_set_over(const struct host_features *features, bool linear);

/* glEnable or glDisable. */
void host_set_capability(GLenum name, GLboolean on);

/* Sets viewport 0 alone. */
void host_set_viewport(const struct host_features *features, GLint x, GLint y, GLsizei width,
                       GLsizei height);

/* Sets viewport and scissor rectangle 0 and no other of the context. */
void host_set_area(const struct host_features *features, GLint x, GLint y, GLsizei width,
                   GLsizei height);

#endif
