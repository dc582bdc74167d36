/*
 * Sources: what the warp shows. The views are one; the others are pictures that exist already.
 *
 *   domemaster       a round picture: the middle is the dome's axis, and the angle from it grows
 *                    evenly up to the rim of the largest circle in a square. On a planetarium,
 *                    whose axis is the zenith, the front is at the bottom. What Cupola itself shows
 *                    through an angular lens at the dome's centre is such a picture. Its last 1.5
 *                    texels, which may be mixed with what lies beyond, are not taken
 *   equirectangular  longitude and latitude, twice as wide as high: the middle is straight ahead
 *                    (-Z of the host's camera), left and right edge meet behind, the upper edge is
 *                    straight up
 *   cube             a cube map of GL: the texel that texture(cube, d) finds is seen along d, in
 *                    the host's camera frame, as where a host draws the six faces itself
 *
 * Such a picture can be meant in two ways:
 *
 *   screen    it is painted on the screen: each point of the screen has the colour that belongs to
 *             it as seen from the dome's centre, whoever looks at it from where. So a planetarium
 *             expects its domemasters
 *   infinity  it is the world far away: the viewer's eye sees each colour in the direction that it
 *             has in the picture
 *
 * With the eye at the dome's centre both are the same.
 */
#ifndef CUPOLA_SOURCE_H
#define CUPOLA_SOURCE_H

#include <stdbool.h>

#include "rig.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the warp shows. */
enum cupola_source_kind {
    CUPOLA_SOURCE_VIEWS = 0,       /* the views that the host has drawn */
    CUPOLA_SOURCE_DOMEMASTER,      /* a fisheye picture of a dome, angular lens, full circle */
    CUPOLA_SOURCE_EQUIRECTANGULAR, /* all directions, longitude across and latitude up */
    CUPOLA_SOURCE_CUBE,            /* six faces */
};

/* Where a picture is thought to be. */
enum cupola_source_place {
    CUPOLA_PLACE_DEFAULT = 0, /* a domemaster on the screen, the others at infinity */
    CUPOLA_PLACE_SCREEN,      /* on the screen itself: the same for every eye */
    CUPOLA_PLACE_INFINITY,    /* far away: by the direction from the eye */
};

/* All zero: the views, of which nothing below is asked. */
struct cupola_source {
    enum cupola_source_kind kind;   /* what it is */
    enum cupola_source_place place; /* where it is; not asked of the views */
    /* The picture: a GL_TEXTURE_2D, its first row the lower edge, or a GL_TEXTURE_CUBE_MAP, in a
     * format of colours that are floats or normalised numbers. It is filtered by a sampler object
     * of Cupola's; its own filter and wrap parameters do not count. */
    unsigned int texture;
    bool mipmaps;   /* the texture has all its levels (without them it would be black, and is
                     * refused where the GL can be asked): for pictures finer than the output */
    double fov_rad; /* of a domemaster: its full opening, above 0 and up to 2 pi; 0: pi */
    /* Turns the picture: a domemaster from the dome's axis in the dome frame (roll is round the
     * axis), the others from straight ahead in the host's camera frame (yaw is to the left). */
    struct cupola_aim orientation;
};

/*
 * The name of a kind as on command lines.
 *
 * kind     of enum cupola_source_kind
 * returns  a static string; NULL for a number that is no kind
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_source_name(int kind);

/*
 * The way back from the name of a kind.
 *
 * name     as cupola_source_name gives it
 * returns  0 or above: of enum cupola_source_kind; CUPOLA_ERROR_ARGUMENT if nothing is called that,
 *          or for NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_source_find(const char *name);

#ifdef __cplusplus
}
#endif

#endif
