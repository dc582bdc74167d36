/*
 * The plan: which perspective views are rendered, how large, and which of them each ray falls to.
 *
 * A view is an orientation and a base rectangle, where its frustum cuts the plane at distance 1
 * (the paper's section 3.2.2). All views are rendered from the viewer's eye.
 *
 *   asymmetric  all views share one orientation and divide one plane between them: that of the
 *               host's camera where every ray lies within 80 degrees of it, else the mean seen
 *               direction. Lighting that depends on the view is the same in every view.
 *   rotated     every view has an orientation of its own; reaches 180 degrees and more
 *
 * Views are looked for by sample rays, which are kept within 80 degrees of the axis of the view
 * that they fall to. Rays between the samples may be up to 2 degrees farther off: a plan that has
 * rays more than 82 degrees off their view's axis is refused.
 *
 * Each ray falls to exactly one view, the one for which the product of ray and selector is largest;
 * a product of a longer ray is longer for all, so rays need no unit length. A view's base rectangle
 * is fitted to the rays that fall to it and widened by a guard band for the filter's taps.
 */
#ifndef CUPOLA_PLAN_H
#define CUPOLA_PLAN_H

#include <stdbool.h>

#include "dome.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cupola_plan cupola_plan;

enum {
    CUPOLA_VIEWS_MAX = 8,   /* views in a plan */
    CUPOLA_FAMILY_MAX = 32, /* bytes of the name of a plan's family */
};

/* How the views stand to each other, see above. */
enum cupola_layout {
    CUPOLA_LAYOUT_AUTO = 0,   /* the cheaper one of those that reach every ray */
    CUPOLA_LAYOUT_ASYMMETRIC, /* one orientation */
    CUPOLA_LAYOUT_ROTATED,    /* an orientation for each view */
};

/* What a plan is to save. */
enum cupola_goal {
    CUPOLA_GOAL_FILL = 0, /* shaded texels: scenes whose fragments are dear */
    CUPOLA_GOAL_VERTICES, /* objects drawn into more than one view: scenes of many triangles */
};

/*
 * What things cost, in the price of shading one texel for every output pixel: with `view` 0.005 a
 * view costs as much as 0.005 texels shaded per output pixel. All zero is what suits most hosts;
 * what costs nothing has a very small price. 0 or above, up to 1e6.
 */
struct cupola_cost {
    double view;            /* of each view: clear, mask, change of state; 0: 0.005 */
    double texel_allocated; /* of a texel of the views' rectangles, shaded or not, as a part of the
                             * price of shading it: memory, clear, mask; 0: 0.05 */
    double vertices;        /* of drawing all that is round the eye once, in all directions, where
                             * the host culls by cupola_camera_sees_sphere or _box and an object's
                             * radius is some 2 degrees; 0: nothing for CUPOLA_GOAL_FILL, 100 for
                             * CUPOLA_GOAL_VERTICES */
};

/* What is wished of a plan. All zero is what most hosts want. */
struct cupola_plan_params {
    enum cupola_layout layout; /* 0: auto */
    /* 1 to 8. 0: as many as cost least; with the asymmetric layout by the paper, 2 where the eye
     * sees up to 90 degrees, 3 up to 140, 4 beyond. */
    int views;
    /* Texels per output pixel along a line, 1/16 to 16: at 1 no output pixel ever gets less than
     * one texel in any direction ("no loss"), 2 is four times the texels. 0: 1. */
    double density;
    /* Length of every view's longer side in texels without guard band, 1 to 16384, instead of a
     * density. 0: sizes follow from the density. */
    int view_size_px;
    int guard_px; /* guard band on each side, texels, 1 to 256; 0: 2, enough for bilinear taps */
    /* Puts each view's rotation into its projection matrix instead of its view matrix, so that
     * lighting computed in eye space is the same in every view. */
    bool rotation_in_projection;
    int max_texture_px;      /* largest side of the atlas, 64 to 32768; 0: 16384 */
    enum cupola_goal goal;   /* 0: fill */
    struct cupola_cost cost; /* what is minimised */
    /* The host does not lay the mask of what no pixel samples: whole rectangles are shaded. */
    bool unmasked;
    /* Of a sphere round the rig's eye in which cupola_plan_set_eye may move it, m: sizes and
     * densities suffice for every eye in it. The sphere lies within the screen, 1/10 of its radius
     * from it at least; one in which eyes see rays farther off every view's axis than said above
     * is refused. 0: the eye rests. */
    double head_radius_m;
    /* A plan that was made before, or NULL. Where it was made for an equal rig and equal wishes its
     * views are taken over, without a search; otherwise it is ignored. It is not kept. For hosts
     * that make everything anew, with a window for instance. */
    const cupola_plan *earlier;
};

/* A rectangle of pixels or texels. */
struct cupola_rect {
    int x;      /* of its left edge */
    int y;      /* of its lower edge, from the bottom */
    int width;  /* above 0 */
    int height; /* above 0 */
};

/* One view of a plan. */
struct cupola_view {
    /* Rows: the view's right, up and backward axes in the host's camera frame, row-major; so a
     * camera-frame vector v is rotation v in the view's frame. */
    double rotation[9];
    double selector[3];      /* host's camera frame; see above */
    double left;             /* of the base rectangle at distance 1, guard band included, as: */
    double right;            /* above left */
    double bottom;           /* lower edge */
    double top;              /* above bottom */
    struct cupola_rect rect; /* its place in the atlas, texels, guard band included */
};

/* What a plan costs and why it is as it is. "Per pixel" is per pixel of the image circles. */
struct cupola_plan_report {
    enum cupola_layout layout;         /* never AUTO */
    int views;                         /* their number, 1 to CUPOLA_VIEWS_MAX */
    int atlas_width_px;                /* of the texture that holds every view */
    int atlas_height_px;               /* the same */
    double pixels;                     /* lit pixels of all outputs, partial ones in part */
    double texels_allocated_per_pixel; /* of the whole atlas */
    double texels_shaded_per_pixel;    /* of the views' rectangles, guard bands included: what is
                                        * shaded where nothing is masked */
    double texels_sampled_per_pixel;   /* of the part of the views that the pixels cover. What two
                                        * outputs cover counts twice, a view as a whole at most */
    double texels_masked_per_pixel;    /* of that with a guard band round it, which is what masks
                                        * (gl.h) leave to be shaded, to 2 % where images have 1000
                                        * px, in small ones they leave more (in 128 px up to a
                                        * tenth); an estimate for hosts without masks, too */
    double cost;                       /* what was minimised: texels shaded (masked ones, or whole
                                        * rectangles with `unmasked`) and the prices of struct
                                        * cupola_cost, per pixel */
    double directions_drawn;           /* of all directions round the eye, by all views together,
                                        * with objects of 2 degrees; 1: all of them once */
    double least_texels_per_pixel; /* over all pixels and directions, along a line; 1 is no loss */
    double seen_fov_rad;           /* full opening of the rays round their mean direction */
    /* How the views lie: of rotated ones the numbers in each ring round the mean seen direction,
     * from the innermost ("1+6"), or "free 8" where eight lie in no rings, spread so that no ray
     * is far from an axis; of asymmetric ones columns and rows ("3x1"). A bare number: views that
     * no pixel fell to have been left out. */
    char family[CUPOLA_FAMILY_MAX];
    /* One sentence: what was asked for, what is least, its cost and what that is made of. */
    char reason[256];
};

/*
 * Plans the views for a dome and the eye of its rig. Nothing of the dome is kept. The same wishes
 * give the same plan.
 *
 * Takes time, on one core some 40 ms for 140 degrees and 50 to 150 ms for wider lenses or several
 * outputs; for a head that moves 150 to 250 ms with one output and 800 ms with six; seconds where
 * it is refused. Not for a frame: hosts that make everything anew give the `earlier` plan.
 *
 * params   NULL: all zero
 * plan     out: to be given to cupola_plan_destroy; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT for a parameter outside of its range, a rig none of whose pixels
 *          lights the screen, or an atlas that would be too large
 *          CUPOLA_ERROR_LAYOUT where the layout cannot reach every ray, with the one that can, or
 *          not for every eye of the sphere, with the radius that it can
 *          CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_plan_create(const cupola_dome *dome, const struct cupola_plan_params *params,
                                  cupola_plan **plan, struct cupola_error *error);

/*
 * Destroys a plan and sets the handle to NULL; NULL and a handle that is NULL are allowed.
 *
 * thread   any, but no other may use the plan any more
 * since    0.1
 */
CUPOLA_API void cupola_plan_destroy(cupola_plan **plan);

/*
 * Moves the eye of a plan within the sphere that it was planned for. The views' base rectangles and
 * cameras follow and the eye of cupola_plan_dome is the new one; rotations, selectors, densities
 * and places in the atlas stay as they are. Allocates nothing and takes about 0.2 ms per output. A
 * cupola_gl has a copy of the plan that it was made from, whose eye cupola_gl_set_eye moves.
 *
 * eye_m    dome frame, at most head_radius_m from the eye of the rig that was planned for
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT for NULL or an eye outside of the sphere; the plan is as it was
 * thread   any, but no other may use the plan meanwhile
 * since    0.1
 */
CUPOLA_API int cupola_plan_set_eye(cupola_plan *plan, const double eye_m[3],
                                   struct cupola_error *error);

/*
 * The number of views of a plan.
 *
 * returns  1 to CUPOLA_VIEWS_MAX
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_plan_view_count(const cupola_plan *plan);

/*
 * One view of a plan.
 *
 * index    0 to view count - 1
 * returns  lives as long as the plan; NULL for an index outside
 * thread   any
 * since    0.1
 */
CUPOLA_API const struct cupola_view *cupola_plan_view(const cupola_plan *plan, int index);

/*
 * The dome that a plan was made for: a copy of the one it was made from.
 *
 * returns  lives as long as the plan
 * thread   any
 * since    0.1
 */
CUPOLA_API const cupola_dome *cupola_plan_dome(const cupola_plan *plan);

/*
 * What a plan costs and why it is as it is.
 *
 * returns  lives as long as the plan
 * thread   any
 * since    0.1
 */
CUPOLA_API const struct cupola_plan_report *cupola_plan_report(const cupola_plan *plan);

/*
 * The view that a ray falls to.
 *
 * direction  host's camera frame, from the eye, any length
 * returns    an index, 0 to view count - 1
 * thread     any
 * since      0.1
 */
CUPOLA_API int cupola_plan_select(const cupola_plan *plan, const double direction[3]);

/*
 * Where a ray meets a view, in continuous texels of the atlas, origin bottom left.
 *
 * index      of the view
 * direction  host's camera frame, any length
 * texel      out: {x, y}; untouched unless 1 is returned
 * returns    1; 0 if the ray does not meet the view's plane (it points backwards);
 *            CUPOLA_ERROR_ARGUMENT for a view that is not there
 * thread     any
 * since      0.1
 */
CUPOLA_API int cupola_plan_texel(const cupola_plan *plan, int index, const double direction[3],
                                 double texel[2]);

/* What a host needs to draw one view. */
struct cupola_camera {
    /* Column-major. clip = projection view x, x in the host's camera frame in scene units; a host
     * appends its own camera matrix: projection view host. */
    float view[16];
    float projection[16]; /* column-major; depth as struct cupola_depth says */
    /* Left, right, bottom, top, near, far: a x + b y + c z + d >= 0 inside; (a, b, c) has unit
     * length; host's camera frame, scene units. Without a far end the last is (0, 0, 0, 1). */
    float planes[6][4];
    /* The same through the eye, towards the other views: on the far side of one of them no pixel
     * samples this view, but for a guard band, which they leave room for. Views overlap, so that a
     * host that culls by these too draws far fewer objects twice. */
    float borders[7][4];
    int border_count; /* views less 1 */
};

/*
 * Near and far, and how depth runs between them in clip space. All zero: 0.1 to 1000, from -1 to 1
 * as OpenGL has it. Cupola makes the matrices and clears the views to what belongs to the far end;
 * glClipControl, glDepthFunc and glDepthRange are the host's.
 */
struct cupola_depth {
    double near_distance; /* along each view's axis, scene units, 1e-20 to 1e20; 0: 0.1 */
    double far_distance;  /* the same, beyond near and up to 1e20; 0: 1000 */
    bool infinite;        /* there is no far end: far_distance is not asked */
    bool reversed;        /* depth falls from near to far: views are cleared to 0, and nearer is
                           * GL_GREATER */
    bool zero_to_one;     /* for glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE); with `reversed` and
                           * floats even precision over all distances */
};

/*
 * Matrices and frustum planes of one view.
 *
 * index    of the view
 * depth    NULL: all zero. Rays at the corner of a wide view are up to six times as long as their
 *          depth
 * camera   out; untouched on failure
 * error    may be NULL
 * returns  CUPOLA_OK
 *          CUPOLA_ERROR_ARGUMENT if plan or camera is NULL, there is no such view, or a distance is
 *          not as said above
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_plan_camera(const cupola_plan *plan, int index,
                                  const struct cupola_depth *depth, struct cupola_camera *camera,
                                  struct cupola_error *error);

/*
 * Whether a view may see something of a sphere: culling on the CPU, once per view and object. It
 * never leaves out what pixels sample of the view, guard band included; a sphere that passes by an
 * edge or a corner of the frustum may count as seen.
 *
 * camera   of a view; its planes and borders are asked, so a plane of (0, 0, 0, 1) leaves nothing
 *          out
 * center   {x, y, z}, host's camera frame, scene units
 * radius   scene units; below 0: 0. What holds something that is not a number, or no end, is seen
 * returns  1: it may be seen; 0: not a point of it is; CUPOLA_ERROR_ARGUMENT for NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_camera_sees_sphere(const struct cupola_camera *camera, const float center[3],
                                         float radius);

/*
 * The same of a box along the axes of the host's camera frame. A host's own boxes may lie askew:
 * it gives the box round them, or a sphere.
 *
 * camera   as above
 * least    {x, y, z} of the corner with the least coordinates, host's camera frame, scene units
 * most     the corner across; coordinates that are less than those of `least` change places
 * returns  as above
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_camera_sees_box(const struct cupola_camera *camera, const float least[3],
                                      const float most[3]);

/*
 * The name of a layout as on command lines.
 *
 * layout   of enum cupola_layout
 * returns  a static string; NULL for a number that is no layout
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_layout_name(int layout);

/*
 * The way back from the name of a layout.
 *
 * name     as cupola_layout_name gives it
 * returns  of enum cupola_layout, or CUPOLA_ERROR_ARGUMENT
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_layout_find(const char *name);

#ifdef __cplusplus
}
#endif

#endif
