/*
 * How a plan is carried out in OpenGL: formats of the views, masks, table stages, encoding.
 */
#ifndef CUPOLA_GL_PARAMS_H
#define CUPOLA_GL_PARAMS_H

#include <stdbool.h>

#include "antialiasing.h"
#include "log.h"
#include "version.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Of the views' colour. In OpenGL ES the formats of floats need extensions; docs/host-contract.md
 * names them.
 */
enum cupola_format {
    CUPOLA_FORMAT_RGBA8 = 0, /* 0 to 1 in 255 steps, taken as they are */
    CUPOLA_FORMAT_RGBA16F,   /* 11 significant bits, up to 65504 */
    CUPOLA_FORMAT_RGBA32F,   /* single precision */
    /* GL_SRGB8_ALPHA8: what stands in it is sRGB-encoded and filtered in linear light. A host that
     * draws encoded colours leaves GL_FRAMEBUFFER_SRGB off, one that draws linear light switches it
     * on; in OpenGL ES it is always on. */
    CUPOLA_FORMAT_SRGB8,
};

/* Of the views' depth. */
enum cupola_depth_format {
    CUPOLA_DEPTH_32F = 0,       /* single precision; where `reversed` is worth it */
    CUPOLA_DEPTH_24,            /* 0 to 1 in 2^24 - 1 steps */
    CUPOLA_DEPTH_32F_STENCIL_8, /* the first with 8 bits of stencil */
    CUPOLA_DEPTH_24_STENCIL_8,  /* the second with 8 bits of stencil */
    CUPOLA_DEPTH_NONE,          /* no depth: for hosts that need none */
};

/* Where the views are. */
enum cupola_storage {
    CUPOLA_STORAGE_ATLAS = 0, /* rectangles of one texture that Cupola makes */
    CUPOLA_STORAGE_TEXTURES,  /* the host's: a GL_TEXTURE_2D for each view, or one for several */
    CUPOLA_STORAGE_LAYERS,    /* the host's: layers of one GL_TEXTURE_2D_ARRAY */
};

/*
 * What the numbers that the warp writes mean. The warp itself computes in linear light: what it
 * samples from sRGB formats is decoded by the GL, everything else is taken as it is.
 */
enum cupola_encoding {
    CUPOLA_ENCODING_LINEAR = 0, /* as they are computed */
    /* sRGB (IEC 61966-2-1), for windows and files: red, green and blue are encoded after everything
     * else, in whatever format the target is. Alpha is not. */
    CUPOLA_ENCODING_SRGB,
};

/*
 * What is computed once instead of once per frame; the paper's section 3.3.1. A table has one ray
 * for each pixel: with a filter that may send out more (cone, adaptive, footprint) every stage but
 * tiles and auto is none, and cupola_gl_table answers so.
 */
enum cupola_table {
    CUPOLA_TABLE_POINTS = 0,  /* D, the points of the screen */
    CUPOLA_TABLE_NONE,        /* nothing: all in the shader */
    CUPOLA_TABLE_ANGLES,      /* the two angles of each ray */
    CUPOLA_TABLE_SINES,       /* their sines and cosines, the paper's choice */
    CUPOLA_TABLE_COORDINATES, /* finished coordinates in the atlas */
    /* Square tiles of 8 to 128 px, each with a polynomial of its points, to 0.002 texels and 1e-5
     * rad: what is not lit, or cut by a rim, goes apart, and only tiles at borders of views ask
     * each pixel which of them it falls to. The least work for a pixel, and no texture of the
     * output's size. Needs a GL with points of 8 px. */
    CUPOLA_TABLE_TILES,
    /* The one of these that is the fastest here: cupola_gl_create draws them a few times for every
     * output and keeps one; cupola_gl_table tells which. After 1/4 s per output nothing new is
     * begun: a table that is being made, or two draws, are still ended, which is what a slow
     * rasteriser takes longer (some 1 s for 4096 x 4096 pixels by one core). With the host's
     * textures as views, and where nothing can be measured, tiles or else what can be made. */
    CUPOLA_TABLE_AUTO,
};

/*
 * Where the mask of what no pixel samples is laid when views begin, so that the host's own tests
 * drop those fragments before they are shaded. All that filters within the guard band may touch is
 * left free, wherever the eye is.
 */
enum cupola_mask {
    CUPOLA_MASK_AUTO = 0, /* depth; none where the views have none or the plan is `unmasked` */
    CUPOLA_MASK_NONE,     /* nothing: whole rectangles are shaded */
    /* Masked texels hold the depth of what is nearest (0, reversed 1): with GL_LESS or GL_LEQUAL
     * (reversed: GL_GREATER, GL_GEQUAL) nothing is drawn there. */
    CUPOLA_MASK_DEPTH,
    /* Masked texels have stencil 128, all others 0: the host draws with glStencilFunc(GL_EQUAL, 0,
     * 128) and leaves that bit alone. For hosts that write depth without testing it, or read it
     * afterwards. Needs a depth format with stencil, which the usual one, 32F, is not. */
    CUPOLA_MASK_STENCIL,
};

/*
 * How a plan is carried out. All zero passes numbers through as they are; a host that draws colours
 * for a screen sets format to SRGB8 and encoding to SRGB, and they are mixed as light.
 */
struct cupola_gl_params {
    enum cupola_format format;      /* of the views; 0: RGBA8. Not asked of a host's textures */
    enum cupola_depth_format depth; /* of the views; 0: 32F. Likewise */
    int samples;                    /* per texel of a view, at least: the GL may give more (the log
                                     * tells). view_end resolves them. 0, 1: one */
    enum cupola_storage storage;    /* 0: the atlas. Others not with the coordinates' table */
    enum cupola_table table;        /* 0: points */
    /* 0: auto. With a host's textures, which cupola_gl_mask masks, all but none are the same. */
    enum cupola_mask mask;
    enum cupola_encoding encoding; /* of what the warp writes; 0: linear */
    /* RGBA of pixels that are not lit, in linear light, finite (below 0 for targets that hold such
     * numbers); all zero: transparent black */
    float border[4];
    /* What the warp will show: the sum of 1u << kind for each kind of enum cupola_source_kind, so
     * that its program is ready before the first frame. Without the views nothing is made for them:
     * no atlas, no tables. 0: the views alone. */
    unsigned int sources;
    bool overlays; /* cupola_gl_overlay will be called (overlay.h): its program is made, too */
    bool one_pass; /* cupola_gl_pass_begin will be called (one_pass.h): its buffer is made, too */
    /* cupola_gl_set_jitter will be called (jitter.h). Of views needs the table stage none, tiles or
     * auto, and a guard band of 2 texels; views' places are no constants of the shaders then. */
    bool jitters;
    /* For hosts that set all of their state before they draw again: frames neither ask for the GL's
     * state nor put it back, which is then what the call needed, and trust the host about what only
     * the GL could tell of textures and targets, that they exist included.
     * docs/host-contract.md has both lists. */
    bool leaves_state;
    /*
     * How many rays a pixel sends out, and which texels each of them means (antialiasing.h); all
     * zero: one, of four texels. Views are asked by the rays of this filter, and so are pictures;
     * of one with mipmaps each ray takes the level that its part of the pixel calls for.
     */
    struct cupola_filter filter;
    /* Noise for targets of so few bits, so that a slope of light shows no steps: 8, or 0 for none.
     * It is the same in all channels of a pixel, by `seed` of the filter, at most one step either
     * way, and leaves the mean of what the warp computes and black and white as they are. */
    int dither_bits;
    struct cupola_log log; /* who is told what happens (log.h); all zero: nobody */
};

/*
 * The name of a table stage as on command lines.
 *
 * table    of enum cupola_table
 * returns  a static string; NULL for a number that is no stage
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_table_name(int table);

/*
 * The way back from the name of a table stage.
 *
 * name     as cupola_table_name gives it
 * returns  of enum cupola_table; CUPOLA_ERROR_ARGUMENT if there is none, or for NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_table_find(const char *name);

#ifdef __cplusplus
}
#endif

#endif
