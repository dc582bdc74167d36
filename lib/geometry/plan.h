/*
 * The inside of a plan and the steps that make it:
 *
 *   plan_trace     the ray of one place
 *   plan_rays      the rays of all outputs on a grid of places
 *   plan_rings     samples in rings
 *   plan_samples   samples in rings or on the grid
 *   plan_ellipse   the least texel metric that satisfies every footprint of a view
 *   plan_cost      what a candidate costs, on the samples
 *   plan_families  where the search for rotated views begins: rings
 *   plan_spread    the same where rings will not do
 *   plan_meetings  the corners of what falls to a view
 *   plan_search    the search, for rotated views
 *   plan_make      which layouts and numbers of views are searched
 *   plan_strips    one plane divided into views: the asymmetric layout
 *   plan_exact     densities and rectangles that hold at every pixel
 *   plan_sphere    the same for every eye of a sphere
 *   plan_outline   rectangles for an eye that moves
 *   plan_copy      copies of plans
 *   plan_refusal   what is said where nothing will do
 *   plan_atlas     the views' places in the atlas
 *   plan_camera    matrices, frustum planes and borders
 */
#ifndef PLAN_PRIVATE_H
#define PLAN_PRIVATE_H

#include <math.h>
#include <stddef.h>

#include "angle.h"
#include "cupola/plan.h"
#include "dome.h"

/*
 * A view's axis and a ray that falls to it are at most 80 degrees apart where views are looked for,
 * by samples: the cosine of that. Between the samples rays may be farther off, up to this.
 */
#define PLAN_REACH_COSINE   0.17364817766693033
#define PLAN_REACH_MOST_DEG 82

/* What 0 means in struct cupola_cost. */
#define PLAN_VIEW_USUAL      0.005
#define PLAN_ALLOCATED_USUAL 0.05

/* fmin and fmax without their care for NaN: compilers make one instruction of these. */
static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/* A point of the lit part's edge, for an eye that moves. */
struct plan_outline_point {
    double point[3]; /* D in the host's camera frame, m */
    bool joined;     /* to the next point by a piece of edge */
};

struct plan_outline {
    int count;
    struct plan_outline_point *points;
};

struct cupola_plan {
    cupola_dome dome;
    int view_count;
    bool rotation_in_projection;
    bool unmasked; /* planned for whole rectangles */
    int guard_px;
    double head_radius_m;
    double planned_eye_m[3];          /* the middle of the sphere that it was planned for */
    struct cupola_plan_params params; /* complete; without an earlier plan */
    struct plan_outline outline;
    struct cupola_view views[CUPOLA_VIEWS_MAX];
    struct cupola_plan_report report;
};

/*
 * A corner of the grid. Corners beyond the rim are drawn onto it, those beyond the screen's cap
 * onto its edge.
 */
struct plan_ray {
    struct varying seen; /* D - E in the host's camera frame; changes per pixel */
    double place_px[2];  /* image coordinates of that */
    bool on_screen;      /* within the cap or drawn onto its edge */
    bool near_screen;    /* or no farther from it than a cell, by the slope here */
};

/* Square cells over the lit part of an output's image; a cell counts if any of it is lit. */
struct plan_grid {
    int columns, rows; /* of cells; corners are one more each way */
    double sense;      /* 1 if the eye sees the image's sense of rotation, -1 if it is mirrored */
    struct plan_ray *corners;
    unsigned char *lit; /* of each cell */
};

struct plan_rays {
    int count;
    struct plan_grid grids[CUPOLA_OUTPUTS_MAX];
    double mean[3];     /* mean seen direction, unit length, host's camera frame */
    double solid_angle; /* of all cells, sr; overlapping outputs count twice */
    double opening_rad; /* the largest angle of a ray to the mean direction, twice */
    double pixels;      /* lit pixels, partial ones in part */
};

/* Left, right, bottom, top of a part of an image, px. */
struct plan_part {
    double sides[4];
};

/* Whole pixels round what may be lit: where frame buffer, image circle and cap meet. */
struct plan_part plan_lit_part(const struct projector *projector);

/* A pixel that the cap's edge cuts has its middle at most half of its diagonal beyond it. */
#define PLAN_HALF_DIAGONAL_PX 0.71

/* On each side of an exact core there may be this more, in texels. */
#define PLAN_TEXEL_SLACK 0.25

/* With some `cells` each way, all outputs together. */
int plan_rays_gather(const cupola_dome *dome, const double eye_m[3], int cells,
                     struct plan_rays *rays, struct cupola_error *error);
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

/* Half of the opening from which on it may change anything: sin(h) < h / 4 from 2.47 on. */
#define PLAN_COLLAPSES_RAD 2.4
/* Towards the rim of a lens of nearly 360 degrees a pixel covers no angle: see plan_trace.c. */
void plan_widen_collapsed(const struct projector *projector, const double place[2],
                          struct varying *ray);

/* A ray of the lit part of the image, unit length, and its change per pixel (at right angles). */
struct plan_sample {
    double at[3], dx[3], dy[3];
    /* Pixels per change of direction: x_of . dx = 1, x_of . dy = 0 and so on. */
    double x_of[3], y_of[3];
    double weight;      /* pixels that it stands for; 0 for eyes other than the middle one */
    double solid_angle; /* of those, sr */
    double reach_rad;   /* half of the width of the part that it stands for */
};

/* Samples along the edge of what is lit of an output, in order, the last beside the first. */
struct plan_edge {
    int first, count;
};

struct plan_samples {
    int count, capacity;
    struct plan_edge edges[CUPOLA_OUTPUTS_MAX]; /* for the rig's eye */
    int edge_count;                             /* 0: not known */
    struct plan_sample *list;
    double pixels;   /* the sum of all weights */
    double mean[3];  /* unit length */
    double half_rad; /* the largest angle of a ray to the mean */
    /* Samples at a view's corners lie inside of it: what its width is short of, about. */
    double short_px;
};

/* Makes a sample of a ray of any length. */
void plan_sample_of(const struct varying *ray, struct plan_sample *sample);

/* What it stands for: pixels, and the pixels' solid angle as a multiple of the sample's own. */
void plan_sample_weigh(struct plan_sample *sample, double weight, double spread);
/* Up to this many times as many rings are tried where little of an image circle is lit. */
enum { PLAN_RINGS_MORE = 2 };

/* Adds samples in rings to a list that has room for them; false, and none, if they do not suit. */
bool plan_rings_add(const cupola_dome *dome, const double eye_m[3], int rings,
                    struct plan_samples *samples);

/*
 * The ray of one place in an output's image. Returns how far inside of image circle, frame buffer
 * and screen it lies, px, by the slope there.
 */
double plan_trace(const cupola_dome *dome, const double eye_m[3], int output, double x_px,
                  double y_px, struct plan_sample *sample);

/* Samples for the rig's eye and, where the radius is not 0, for places on a sphere round it. */
int plan_samples_gather(const cupola_dome *dome, double head_radius_m, int cells,
                        struct plan_samples *samples, struct cupola_error *error);
void plan_samples_release(struct plan_samples *samples);

/*
 * Where the eye may be, for a sphere round the rig's: its middle, the 6 ends of its axes, the 8
 * directions between them.
 */
enum { PLAN_EYES = 15 };
void plan_eye_place(const double middle_m[3], double radius_m, int index, double eye_m[3]);

/* A symmetric 2x2 matrix. */
struct plan_metric {
    double uu, uv, vv;
};

/* What one pixel asks of the texels of a view: (J J^T)^-1, and where it meets the base plane. */
void plan_footprint(const double rotation[9], const struct plan_sample *sample,
                    struct plan_metric *footprint, double base[2]);

/* The X of least determinant with X - G positive semidefinite for every G; changes their order. */
struct plan_metric plan_enclose(struct plan_metric *footprints, int count);
/* The same for views that may not roll: X is diagonal. */
struct plan_metric plan_enclose_upright(const struct plan_metric *footprints, int count);
/* The least diagonal one round X in axes that are turned by an angle from right to up. */
struct plan_metric plan_enclose_rolled(const struct plan_metric *x, double angle);
/* The largest eigenvalue of X^-1 G: above 1 where G sticks out of X. */
double plan_excess(const struct plan_metric *x, const struct plan_metric *g);
/* The angle from right to up of the longer axis of a metric. */
double plan_roll_of(const struct plan_metric *x);
/* Turns right and up of a rotation by an angle from right to up. */
void plan_roll_by(double angle, double rotation[9]);

#include "plan_search.h"

/* What the exact fit of a view says. */
struct plan_exact_view {
    double rotation[9], selector[3];
    double core[4];      /* left, right, bottom, top of what its rays meet, for the rig's eye */
    double extent[2];    /* of the largest core, for every eye */
    double density[2];   /* texels per unit of the base plane, along u and v */
    double area;         /* of the base plane that its pixels cover */
    double likely_area;  /* the same, by the search */
    double farthest_rad; /* the largest angle between its axis and a ray that falls to it */
    double least;        /* texels per pixel along a line, over all pixels, directions and eyes */
};

struct plan_exact {
    int count;
    struct plan_exact_view views[CUPOLA_VIEWS_MAX];
    double pixels; /* lit, partial ones in part */
};

/*
 * Fits a choice at every pixel, for the rig's eye and a sphere round it. A view that nothing lit
 * falls to, or with `sampled` no pixel's middle, is left out, and the others take its part.
 * CUPOLA_OK, CUPOLA_ERROR_LAYOUT where a ray is out of reach after all, CUPOLA_ERROR_MEMORY.
 */
int plan_exact_fit(const cupola_dome *dome, const struct plan_choice *choice,
                   const struct plan_prices *prices, double head_radius_m, bool sampled,
                   struct plan_exact *exact);

/* The edge of the lit part of all outputs. CUPOLA_OK or CUPOLA_ERROR_MEMORY. */
int plan_outline_trace(const cupola_dome *dome, struct plan_outline *outline);
/*
 * Left, right, bottom, top of what a view's rays meet for an eye; false: nothing. `least_cosine`,
 * between them and its axis, becomes no larger; NULL: not asked for.
 */
bool plan_outline_core(const cupola_plan *plan, const double eye_m[3], int view, double core[4],
                       double *least_cosine);

/*
 * A copy that shares nothing, into a place that holds no plan, and what it has taken given back.
 * CUPOLA_OK or CUPOLA_ERROR_MEMORY, and then there is no copy.
 */
/* Whether a plan was made for such a rig and such wishes, which are complete. */
bool plan_serves(const cupola_plan *plan, const cupola_dome *dome,
                 const struct cupola_plan_params *params);
int plan_copy(const cupola_plan *from, cupola_plan *to, struct cupola_error *error);
void plan_release(cupola_plan *plan);

/* Everything that a plan is made with. */
struct planning {
    const cupola_dome *dome;
    struct cupola_plan_params params;
    struct plan_samples coarse, fine;
    struct plan_choice choices[PLAN_CHOICES];
    struct plan_exact exact;
    int chosen;
};

/* Gathers the samples. */
int planning_begin(const cupola_dome *dome, const struct cupola_plan_params *params,
                   struct planning *planning, struct cupola_error *error);
void planning_end(struct planning *planning);
/* Searches and fits exactly. CUPOLA_OK, CUPOLA_ERROR_LAYOUT or CUPOLA_ERROR_MEMORY. */
int planning_solve(struct planning *planning, enum cupola_layout layout, int views);

/* CUPOLA_ERROR_LAYOUT with what is allowed. */
int plan_refuse(const struct planning *planning, struct cupola_error *error);

/* The sentence of a report that is complete but for it. */
void plan_explain(const struct cupola_plan_params *params, double farthest_rad,
                  struct cupola_plan_report *report);

/* Places rectangles, whose sizes are set, in an atlas of the least area found. */
int plan_atlas_pack(struct cupola_view *views, int count, int max_px, int *width_px, int *height_px,
                    struct cupola_error *error);

#endif
