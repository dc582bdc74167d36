/*
 * Theatres that show smooth light, in each way that the warp has: what stands in their targets, and
 * what must stand there by the warp in plain C.
 */
#ifndef LIGHT_FIXTURE_H
#define LIGHT_FIXTURE_H

#include "fixture.h"
#include "srgb.h"

/* The ways. Not every context has views of floats; all have the others. */
enum light_kind {
    LIGHT_ATLAS, /* views that are Cupola's */
    LIGHT_TEXTURES,
    LIGHT_LAYERS,
    LIGHT_DOMEMASTER,
    LIGHT_EQUIRECTANGULAR,
    LIGHT_CUBE,
    LIGHT_KINDS,
};

enum { LIGHT_WIDTH = 96, LIGHT_HEIGHT = 80 };

struct light_theatre {
    struct fixture fixture;
    struct cupola_source source; /* all zero: the views */
    GLuint texture;              /* of views or picture, where it is not Cupola's */
    float *texels;               /* what is shown, as the warp in C wants it */
    int height;                  /* of that, where it is a picture */
};

/* In every theatre: the border, in linear light. */
extern const float light_border[4];

bool light_exists(enum light_kind kind);
const char *light_name(enum light_kind kind);

/*
 * An off-axis theatre whose screen ends inside of the image. Of the parameters border, format,
 * storage and sources are set here.
 */
void light_make(enum light_kind kind, const struct cupola_gl_params *params,
                struct light_theatre *theatre);
void light_release(struct light_theatre *theatre);

/* By the warp in C, linear light; freed by the caller. */
float *light_expected(const struct light_theatre *theatre);

/* Colour formats for targets that this context has: of 8 bits, or of floats. */
GLenum light_float_format(void); /* 0 where there is none */

/*
 * The numbers that stand in a target of such a format after a warp, RGBA, freed by the caller; what
 * the warp answered. NULL where it refused.
 */
float *light_shown(const struct light_theatre *theatre, GLenum format, struct cupola_error *error);

/* Encodes red, green and blue in place. */
void light_encode(float *rgba, int pixels);

/* The largest difference of two images of this size, over red, green, blue and alpha. */
double light_difference(const float *a, const float *b);

#endif
