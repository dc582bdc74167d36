/*
 * Overlays: from a ray of the viewer's to a place in a flat picture that faces the eye, and how
 * much of a pixel it covers there. shaders/overlay.glsl says the same under the same names.
 */
#ifndef OVERLAY_PRIVATE_H
#define OVERLAY_PRIVATE_H

#include "cupola/overlay.h"
#include "dome.h"

enum { OVERLAY_KINDS = CUPOLA_OVERLAY_DISC + 1 };

/* Parts of half the cursor's width: its ring from here to 1, its dot up to there. */
#define OVERLAY_RING_INNER 0.75
#define OVERLAY_DOT_RADIUS 0.2

/* Along each side of a pixel, of which the coverage of round overlays is the mean. */
#define OVERLAY_PARTS 3

/*
 * An overlay's frame: axes v = (x, y, z) of a ray v has z forward, and on the plane z = 1 the
 * overlay reaches from -half to half in x and y.
 */
struct overlay_frame {
    double axes[9]; /* rows: right, up, forward, in the host's camera frame */
    double half[2]; /* of its width and height */
};

/* A rectangle of pixels; empty where a side is 0. */
struct overlay_area {
    int x, y, width, height;
};

/* CUPOLA_ERROR_ARGUMENT for a field outside of its range; textures are not asked for. */
int overlay_check(const struct cupola_overlay *overlay, struct cupola_error *error);

/*
 * CUPOLA_ERROR_ARGUMENT if a picture that leaves its height to its texture (width by height,
 * texels) would be higher than allowed.
 */
int overlay_check_height(const struct cupola_overlay *overlay, int width, int height,
                         struct cupola_error *error);

/*
 * For an overlay that has been checked. `aspect` is width by height of its texture, for a picture
 * that leaves its height to it; 0 where that is not known, and then it is as high as can be.
 */
void overlay_frame_prepare(const struct cupola_overlay *overlay, double aspect,
                           struct overlay_frame *frame);

/* Its colour with the default filled in, premultiplied. */
void overlay_color(const struct cupola_overlay *overlay, float premultiplied[4]);

/*
 * A ray in the overlay's frame with x and y in parts of its halves, so that it ends where the
 * larger of |x| and |y| is z. Linear in the ray (host's camera frame, any length): edges keep their
 * place and their gradient wherever the plane is, even at its horizon.
 */
void overlay_direction(const struct overlay_frame *frame, const struct varying *ray,
                       struct varying *direction);

/* Its place in the picture, 0 to 1 from the lower left; z must be above 0. */
void overlay_place(const struct varying *direction, double place[2]);

/* The part of the pixel that the overlay covers; of a picture, its rectangle. */
double overlay_coverage(enum cupola_overlay_kind kind, const struct varying *direction);

/* A rectangle outside of which no pixel of an output, seen from the rig's eye, is covered. */
struct overlay_area overlay_area_find(const cupola_dome *dome, int output,
                                      const struct overlay_frame *frame);

#endif
