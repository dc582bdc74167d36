/*
 * Resolution: how fine an image is for the viewer, pixel by pixel (the density map, the paper's
 * figure 8), and how well the views of a plan fit it.
 *
 * Everything is that of a pixel's middle, by the analytic change of its ray. Pixels whose middle is
 * less than half a pixel from the image circle's rim, or beyond it, are asked half a pixel inside
 * of it: at the rim itself some lenses cover infinitely much, or nothing. It is geometry in double
 * precision, without any GL; cupola_gl_density (gl.h) makes the map on a GPU.
 */
#ifndef CUPOLA_RESOLUTION_H
#define CUPOLA_RESOLUTION_H

#include "plan.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The density map: per pixel of an output, the solid angle that it covers, seen by the viewer. With
 * eye and lens in the middle of the screen that is a closed form: h^2 sin(a) / a for an angular
 * lens, h half of its field of view and a the angle off its axis, divided by the square of the
 * image circle's radius in px.
 *
 * output   index, 0 to the rig's output_count - 1
 * eye_m    dome frame, inside the sphere; NULL: the rig's eye
 * solid_angles_sr
 *          out: width height floats of the output's size, rows from the bottom up: of whole pixels,
 *          those that a rim cuts, too; 0 where a pixel is not lit. Untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT for NULL, an output that is not there or an eye outside
 *          of the sphere
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_density_map(const cupola_dome *dome, int output, const double eye_m[3],
                                  float *solid_angles_sr, struct cupola_error *error);

/* Of what the lit pixels have; all 0 where there are none. */
struct cupola_spread {
    double min;    /* the least */
    double median; /* as many have less as have more */
    double max;    /* the greatest */
};

/* One view, as the pixels that fall to it see it. */
struct cupola_view_resolution {
    double pixels;                         /* lit ones that fall to it, partial ones in part */
    struct cupola_spread texels_per_pixel; /* by area */
    /* By length, along the line through a pixel on which texels are fewest, and most: the singular
     * values of the change of place in the view, texels, per pixel. Below 1 detail is missing. */
    struct cupola_spread least_texels_per_pixel;
    struct cupola_spread most_texels_per_pixel; /* along the other line, at right angles to it */
    double texels;                              /* of the view's rectangle, guard band included */
    /* Of these, how many no pixel of any output touches, with a filter that keeps to the guard
     * band: what masks (gl_params.h) keep from being shaded, to some 3 %. */
    double texels_never_sampled;
};

/* Where something is. */
struct cupola_resolution_place {
    int output;          /* index */
    double pixel_px[2];  /* middle of the pixel: continuous image coordinates */
    double direction[3]; /* from the eye, unit length, host's camera frame */
};

enum { CUPOLA_ADVICE_MAX = 320 /* bytes of the advice of a resolution */ };

/* How well views and projector fit together, for the plan's eye as it is. */
struct cupola_resolution {
    int views;                                            /* of the plan */
    struct cupola_view_resolution view[CUPOLA_VIEWS_MAX]; /* the first `views` of them */
    double pixels;                                        /* lit ones, partial ones in part */
    /* Along a line, for square pixels of the same solid angle. The median is over what the viewer
     * sees: one half of the solid angle is finer, the other coarser. */
    struct cupola_spread pixels_per_degree;
    struct cupola_resolution_place coarsest; /* where pixels_per_degree.min is */
    struct cupola_resolution_place finest;   /* where pixels_per_degree.max is */
    double texels;                           /* of all views */
    double texels_never_sampled;             /* of all views */
    /* In one sentence: whether the views are finer than the projector can show or coarser, and by
     * which length of their longest side, without guard bands, they would match
     * (cupola_plan_params.view_size_px): "views are 1.8x finer than the projector can show: 720 px
     * would do". Within 5 % they match.
     *
     * Lenses of more than 275 degrees are counted as the planner does, which spares views texels
     * that only pixels near the rim would need (at 360 degrees no size would do). Where such
     * pixels have less than 0.95 texels along a line, or would by that length, the sentence goes
     * on with what they have: "..., but near the rim of so wide a lens detail is lost: 0.24 texels
     * per pixel along a line".
     *
     * A given view_size_px is one for all views, however few pixels fall to some of them. Where a
     * plan without it would take less than 5/6 of the texels, the sentence ends with both numbers,
     * unless views are coarser, or not all outputs were asked. */
    char advice[CUPOLA_ADVICE_MAX];
};

/*
 * Measures a plan. Up to 2048 x 2048 px, all outputs together, every pixel is asked, and beyond
 * every second one of a row and every second row, and so on. Takes some 1 s for so many on one
 * core, and 25 bytes a pixel meanwhile; with view_size_px another plan is made to compare with.
 *
 * output      index, 0 to the rig's output_count - 1, or -1: all of them together
 * resolution  out; untouched on failure
 * error       may be NULL
 * returns     CUPOLA_OK; CUPOLA_ERROR_ARGUMENT for NULL or an output that is not there;
 *             CUPOLA_ERROR_MEMORY
 * thread      any
 * since       0.1
 */
CUPOLA_API int cupola_resolution_measure(const cupola_plan *plan, int output,
                                         struct cupola_resolution *resolution,
                                         struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
