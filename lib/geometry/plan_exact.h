/*
 * Between the parts of the exact fit: plan_exact.c looks at cells, plan_exact_fit.c at views,
 * plan_sphere.c at eyes.
 */
#ifndef PLAN_EXACT_H
#define PLAN_EXACT_H

#include "plan.h"

/* A traced place of an image. */
struct plan_corner {
    struct plan_sample ray;
    /* By how much the selector's product is below the largest, and the change of that per pixel. */
    double gap[CUPOLA_VIEWS_MAX], slope[CUPOLA_VIEWS_MAX];
    double across[CUPOLA_VIEWS_MAX], up[CUPOLA_VIEWS_MAX]; /* the slope's parts */
    double inside_px;                                      /* of what is lit */
};

/* What is known so far. */
struct fitting {
    const cupola_dome *dome;
    struct plan_exact *exact;
    const struct plan_prices *prices;
    bool upright; /* views do not roll */
    bool sampled; /* views that no pixel samples are left out */
    double eye_m[3];
    int output;
    double leaf_px;
    struct plan_metric metric[CUPOLA_VIEWS_MAX]; /* in the frame of the view's rotation */
    double density[CUPOLA_VIEWS_MAX][2];         /* the same, as texels per unit */
    double excess[CUPOLA_VIEWS_MAX];             /* the largest yet */
    double core[CUPOLA_VIEWS_MAX][4];            /* the widest yet */
    double least_cosine[CUPOLA_VIEWS_MAX];       /* between axis and rays */
};

/* A cell of an image, its corners counter-clockwise from the lower left. */
struct plan_square {
    double x_px, y_px, size_px;
    const struct plan_corner *corners[4];
};

void plan_corner_trace(struct fitting *fitting, double x_px, double y_px,
                       struct plan_corner *corner);
/* Learns what a cell has to say, dividing it as far as that matters. */
void plan_square_visit(struct fitting *fitting, const struct plan_square *cell);
/* Adds what a cell covers to the exact fit's pixels and areas; plan_area.c. */
void plan_square_add(struct fitting *fitting, const struct plan_square *cell);

/* Points of the screen, in the host's camera frame, and their change per pixel. */
struct plan_probes {
    int count;
    struct varying *list;
};

bool plan_probes_create(const cupola_dome *dome, bool fine, struct plan_probes *probes);
void plan_probes_release(struct plan_probes *probes);
/* Raises what the probes ask over the metrics, of one view or, below 0, of all. */
void plan_probes_look(const struct plan_probes *probes, const struct fitting *fitting,
                      const double eye_m[3], int only, double excess[CUPOLA_VIEWS_MAX]);

/* The most that any eye of a sphere asks of each view. */
struct plan_sphere {
    double extent[CUPOLA_VIEWS_MAX][2];
    double least_cosine[CUPOLA_VIEWS_MAX];
    double excess[CUPOLA_VIEWS_MAX];   /* by the probes */
    double eye_m[CUPOLA_VIEWS_MAX][3]; /* where that is asked */
};

/* CUPOLA_OK or CUPOLA_ERROR_MEMORY; `fitting` knows the middle. plan_sphere.c. */
int plan_sphere_look(const struct fitting *fitting, double radius_m, struct plan_sphere *result);
/*
 * A measured lens may ask most where its slope has kinks, between the corners of all cells: for the
 * rig's eye and, where it moves, the worst ones. CUPOLA_OK or CUPOLA_ERROR_MEMORY.
 */
int plan_kinks_look(struct fitting *fitting, const struct plan_sphere *sphere, bool moves);

#endif
