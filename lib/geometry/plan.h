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
 *   plan_search    the search, for rotated views
 *   plan_make      which layouts and numbers of views are searched
 *   plan_strips    one plane divided into views: the asymmetric layout
 *   plan_exact     densities and rectangles that hold at every pixel
 *   plan_outline   rectangles for an eye that moves
 *   plan_copy      copies of plans
 *   plan_refusal   what is said where nothing will do
 *   plan_atlas     the views' places in the atlas
 *   plan_camera    matrices, frustum planes and borders
 */
#ifndef PLAN_PRIVATE_H
#define PLAN_PRIVATE_H

#include <stddef.h>

#include "angle.h"
#include "cupola/plan.h"
#include "dome.h"

/* A view's axis and a ray that falls to it are at most 80 degrees apart: the cosine of that. */
#define PLAN_REACH_COSINE 0.17364817766693033

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
    double planned_eye_m[3]; /* the middle of the sphere that it was planned for */
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

struct plan_samples {
    int count, capacity;
    struct plan_sample *list;
    double pixels;   /* the sum of all weights */
    double mean[3];  /* unit length */
    double half_rad; /* the largest angle of a ray to the mean */
};

/* Makes a sample of a ray of any length. */
void plan_sample_of(const struct varying *ray, struct plan_sample *sample);

/* What it stands for: pixels, and the pixels' solid angle as a multiple of the sample's own. */
void plan_sample_weigh(struct plan_sample *sample, double weight, double spread);
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
/* The largest eigenvalue of X^-1 G: above 1 where G sticks out of X. */
double plan_excess(const struct plan_metric *x, const struct plan_metric *g);
/* Turns right and up of a rotation onto the axes of a metric, which becomes diagonal. */
void plan_roll_onto(struct plan_metric *x, double rotation[9], double turn[2]);

/* What is known of a view before it is fitted. */
struct plan_candidate {
    double axis[3];     /* unit length */
    double selector[3]; /* the ray falls to the view of the largest product */
};

/* What is minimised. */
struct plan_prices {
    double density;   /* texels per pixel along a line */
    double guard_px;  /* texels */
    double view;      /* of a view, in shaded texels */
    double vertices;  /* of all vertices round the eye once, in shaded texels */
    double allocated; /* of a texel that is allocated, shaded or not */
    bool unmasked;    /* the whole rectangle is shaded */
    /* Of the largest angle between a view's axis and a sample that falls to it, cosine. */
    double reach_cosine;
};

/* What a view comes to on the samples. */
struct plan_view_fit {
    double rotation[9];
    double density[2];   /* texels per unit along u and v */
    double core[4];      /* left, right, bottom, top */
    double shaded;       /* texels, guard band included */
    double rect;         /* texels allocated */
    double drawn;        /* solid angle of the objects drawn into it, sr */
    double out_of_reach; /* 0, or by how much a ray lies beyond 80 degrees, in cosines */
    int samples;         /* that fall to it */
};

/* The view that a sample falls to, the next best, and the first one's part of the sample. */
struct plan_member {
    int view, next;
    double product, next_product; /* with their selectors */
    double part;                  /* 1/2 on the border between them, to 1 */
    double shared;                /* of it, what objects reach across the border into the next */
};

/* A candidate and all that was found out about it. */
struct plan_state {
    int count;
    const double *orientation; /* of all views, which may not roll; NULL: each its own */
    struct plan_candidate views[CUPOLA_VIEWS_MAX];
    struct plan_view_fit fits[CUPOLA_VIEWS_MAX];
    double shaded, rect;         /* texels */
    double drawn_cost;           /* of objects, in shaded texels */
    double cost;                 /* PLAN_IMPOSSIBLE and more where it will not do */
    struct plan_member *members; /* of each sample */
};

#define PLAN_IMPOSSIBLE 1e15

/* Room for footprints while a view is fitted; one per search. */
struct plan_scratch {
    struct plan_metric *footprints;
    double (*base)[2];
};

bool plan_state_create(int samples, struct plan_state *state);
void plan_state_release(struct plan_state *state);
void plan_state_copy(const struct plan_state *from, int samples, struct plan_state *to);
bool plan_scratch_create(int samples, struct plan_scratch *scratch);
void plan_scratch_release(struct plan_scratch *scratch);

/* Finds out about a candidate whose count, orientation and views are set. */
void plan_evaluate(const struct plan_samples *samples, const struct plan_prices *prices,
                   struct plan_scratch *scratch, struct plan_state *state);
/* The same where only view `changed` differs from what is known of it. */
void plan_reevaluate(const struct plan_samples *samples, const struct plan_prices *prices,
                     struct plan_scratch *scratch, int changed, struct plan_state *state);
/* Some orientation that looks along an axis. */
void plan_look_along(const double axis[3], double rotation[9]);

/* Views in rings round the mean seen direction, see plan_families.c. */
struct plan_family {
    int rings;
    int views[3]; /* from the mean direction outwards */
    int count;
    double phase; /* 0 or 1: the outermost ring begins at the right or half a view further */
};

enum { PLAN_FAMILIES_MAX = 96 };

int plan_families(int least_views, int most_views, double half_rad,
                  struct plan_family families[PLAN_FAMILIES_MAX]);
/* Places a family's views on the samples; selectors are their axes. False: no memory. */
bool plan_family_place(const struct plan_family *family, const struct plan_samples *samples,
                       struct plan_state *state);

/* Moves axes so that no sample is far from one; selectors are the axes. */
void plan_spread_out(const struct plan_samples *samples, struct plan_state *state);
/* Places views so, from the mean direction on. */
void plan_spread_place(const struct plan_samples *samples, int views, struct plan_state *state);

/* Views that a search found. */
struct plan_choice {
    enum cupola_layout layout;
    int count; /* 0: none */
    struct {
        double rotation[9], selector[3];
    } views[CUPOLA_VIEWS_MAX];
    char family[CUPOLA_FAMILY_MAX];
    double drawn_cost; /* of objects, its part of: */
    double cost;       /* in shaded texels; PLAN_IMPOSSIBLE and more: some rays are out of reach */
};

enum { PLAN_CHOICES = 4 };

/* What a search looks at. */
struct plan_question {
    const struct plan_samples *coarse, *fine;
    struct plan_prices prices;
    int least_views, most_views;
};

/* Inserts in order of cost; of equals the first one stays first. */
void plan_choice_insert(struct plan_choice choices[PLAN_CHOICES], const struct plan_choice *next);
/* Insert what they find. CUPOLA_OK or CUPOLA_ERROR_MEMORY. */
int plan_search(const struct plan_question *question, struct plan_choice choices[PLAN_CHOICES]);
int plan_strips(const struct plan_question *question, struct plan_choice choices[PLAN_CHOICES]);

/* What the exact fit of a view says. */
struct plan_exact_view {
    double rotation[9], selector[3];
    double core[4];      /* left, right, bottom, top of what its rays meet, for the rig's eye */
    double extent[2];    /* of the largest core, for every eye */
    double density[2];   /* texels per unit of the base plane, along u and v */
    double area;         /* of the base plane that its pixels cover */
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
                   const struct cupola_plan_params *params, bool sampled, struct plan_exact *exact);

/* The edge of the lit part of all outputs. CUPOLA_OK or CUPOLA_ERROR_MEMORY. */
int plan_outline_trace(const cupola_dome *dome, struct plan_outline *outline);
/* Left, right, bottom, top of what a view's rays meet for an eye; false: nothing. */
bool plan_outline_core(const cupola_plan *plan, const double eye_m[3], int view, double core[4]);

/*
 * A copy that shares nothing, into a place that holds no plan, and what it has taken given back.
 * CUPOLA_OK or CUPOLA_ERROR_MEMORY, and then there is no copy.
 */
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

/* Places rectangles, whose sizes are set, in an atlas of the least area found. */
int plan_atlas_pack(struct cupola_view *views, int count, int max_px, int *width_px, int *height_px,
                    struct cupola_error *error);

#endif
