/*
 * The inside of a plan and the steps that make it:
 *
 *   plan_rays    the rays of all outputs on a grid of places, once per plan
 *   plan_layout  candidates: orientations and selectors for a number of views
 *   plan_fit     base rectangles of a candidate, from the rays
 *   plan_refusal which lens it is that no layout can serve
 *   plan_density texels per unit of the base plane
 *   plan_atlas   the views' places in the atlas
 *   plan_camera  matrices and frustum planes
 */
#ifndef PLAN_PRIVATE_H
#define PLAN_PRIVATE_H

#include <stddef.h>

#include "angle.h"
#include "cupola/plan.h"
#include "dome.h"

/* A view's axis and a ray that falls to it are at most this far apart. */
#define PLAN_REACH_RAD (80.0 * (pi / 180.0))

struct cupola_plan {
    cupola_dome dome;
    int view_count;
    bool rotation_in_projection;
    struct cupola_view views[CUPOLA_VIEWS_MAX];
    struct cupola_plan_report report;
};

/*
 * A corner of the grid. Corners beyond the rim are drawn onto it. Beyond the screen's cap there is
 * the edge itself, where the lit part ends, and the farthest place whose pixel it may still cut:
 * that pixel is sampled at its middle.
 */
struct plan_ray {
    struct varying ray; /* D - E in the host's camera frame, to be sampled; changes per pixel */
    double seen[3];     /* the same, drawn onto the edge */
    double place_px[2]; /* image coordinates of that */
    bool on_screen;     /* within the cap or drawn onto its edge */
    bool near_screen;   /* or no farther from it than a cell, by the slope here */
};

/* Square cells over the lit part of an output's image; a cell counts if any of it is lit. */
struct plan_grid {
    int columns, rows; /* of cells; corners are one more each way */
    double sense;      /* 1 if the eye sees the image's sense of rotation, -1 if it is mirrored */
    struct plan_ray *corners;
    unsigned char *lit;   /* of each cell */
    unsigned char *views; /* of each corner: bit v if it counts for view v of the fit under way */
};

struct plan_rays {
    int count;
    struct plan_grid grids[CUPOLA_OUTPUTS_MAX];
    double mean[3];     /* mean seen direction, unit length, host's camera frame */
    double solid_angle; /* of all cells, sr; overlapping outputs count twice */
    double opening_rad; /* the largest angle of a ray to the mean direction, twice */
    double pixels;      /* lit pixels, partial ones in part */
};

/*
 * With at most `cells_max` cells each way: cells of whole pixels where there are more pixels than
 * that, of parts of a pixel where there are very few.
 */
int plan_rays_gather(const cupola_dome *dome, int cells_max, struct plan_rays *rays,
                     struct cupola_error *error);
void plan_rays_release(struct plan_rays *rays);

/* Calls a function for every lit cell, with its corners counter-clockwise from the lower left. */
typedef void plan_cell_visitor(const struct plan_grid *grid,
                               const struct plan_ray *const corners[4], void *user);
void plan_rays_visit(const struct plan_rays *rays, plan_cell_visitor *visit, void *user);

/* The corners of cell (column, row), counter-clockwise from the lower left. */
static inline void plan_cell(const struct plan_grid *grid, int column, int row,
                             const struct plan_ray *corners[4])
{
    const struct plan_ray *lower = grid->corners + row * (grid->columns + 1) + column;
    const struct plan_ray *upper = lower + grid->columns + 1;
    corners[0] = lower;
    corners[1] = lower + 1;
    corners[2] = upper + 1;
    corners[3] = upper;
}

/* How views are sized: by density (texels per pixel along a line) or by hand. */
struct plan_sizing {
    double density;
    int view_size_px; /* 0: by density */
    int guard_px;
};

/* The fit of one view. `core` is left, right, bottom, top of what its rays meet. */
struct plan_view_fit {
    double core[4];
    double density[2]; /* texels per unit of the base plane, along u and v */
    double least_texels_per_pixel;
    double farthest_rad; /* the largest angle between its axis and a ray that falls to it */
    double area;         /* of the base plane that its cells cover */
    int cells;           /* whose middle falls to it */
};

struct plan_fit {
    struct plan_view_fit views[CUPOLA_VIEWS_MAX];
    double texels; /* of all cores */
    double farthest_rad;
    bool complete; /* every view has cells */
};

/*
 * Fits base rectangles and densities to the rays, for views whose rotation and selector are set.
 * Returns CUPOLA_OK; CUPOLA_ERROR_LAYOUT if a view has no cells or would have to reach farther than
 * PLAN_REACH_RAD, and then only farthest_rad and cells are filled in; CUPOLA_ERROR_MEMORY.
 */
int plan_fit_views(struct plan_rays *rays, const struct cupola_view *views, int count,
                   const struct plan_sizing *sizing, struct plan_fit *fit);

/* What one pixel asks of the texels of a view: (J J^T)^-1, see plan_density.c. */
struct plan_footprint {
    double uu, uv, vv;
};

struct plan_footprint plan_footprint_of(const struct cupola_view *view, const struct varying *ray,
                                        const double base[2]);

/* The least texels per unit of the plane along u and v that satisfy every footprint. */
void plan_density_search(const struct plan_footprint *footprints, size_t count, double density[2]);

/* Texels per pixel in the worst direction. */
double plan_density_reached(const struct plan_footprint *footprint, const double density[2]);

/*
 * Writes rotations and selectors of the cheapest candidate of a layout with `count` views; a view
 * that no pixel would fall to is left out. Returns the number of views; CUPOLA_ERROR_LAYOUT where
 * no candidate reaches every ray, and then *farthest_rad says how far the best one would have to
 * reach; CUPOLA_ERROR_MEMORY. `rays` may be a coarse grid.
 */
int plan_layout_asymmetric(struct plan_rays *rays, int count, const struct plan_sizing *sizing,
                           struct cupola_view *views, double *farthest_rad);
int plan_layout_rotated(struct plan_rays *rays, int count, const struct plan_sizing *sizing,
                        struct cupola_view *views, double *farthest_rad);

/*
 * CUPOLA_ERROR_LAYOUT with the lens because of which not even CUPOLA_VIEWS_MAX rotated views reach
 * every ray of the grid `rays`, made with `cells_max`, and what it may be.
 */
int plan_refuse_lens(const cupola_dome *dome, const struct plan_rays *rays, int cells_max,
                     const struct plan_sizing *sizing, struct cupola_error *error);

/* Places rectangles, whose sizes are set, in an atlas of the least area found. */
int plan_atlas_pack(struct cupola_view *views, int count, int max_px, int *width_px, int *height_px,
                    struct cupola_error *error);

#endif
