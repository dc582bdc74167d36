/*
 * What the search knows: candidates, prices, what a view comes to on the samples, families, and the
 * choices that it ends in. Part of plan.h.
 */
#ifndef PLAN_SEARCH_H
#define PLAN_SEARCH_H

#include "plan.h"

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

/* Of a quarter turn, where roll is tried. */
enum { PLAN_ROLLS = 6 };

/* Whether rectangles matter about as much as what pixels sample. */
static inline bool plan_prices_rects(const struct plan_prices *prices)
{
    return prices->unmasked || prices->allocated > 0.1;
}

/* Whether rectangles matter so much, or a metric so little, that other rolls than its own do. */
static inline bool plan_rolls_freely(const struct plan_prices *prices, const struct plan_metric *x)
{
    static const double round = 1.01;
    double mean = 0.5 * (x->uu + x->vv), apart = 0.5 * (x->uu - x->vv);
    double half = sqrt(apart * apart + x->uv * x->uv);
    return plan_prices_rects(prices) || mean + half < round * (mean - half);
}

/* What a view comes to on the samples. */
struct plan_view_fit {
    double rotation[9];
    double density[2];   /* texels per unit along u and v */
    double core[4];      /* left, right, bottom, top */
    double area;         /* of the base plane that its pixels cover */
    double shaded;       /* texels, guard band included */
    double rect;         /* texels allocated */
    double cost;         /* of both, in shaded texels */
    double drawn;        /* solid angle of the objects drawn into it, sr */
    double out_of_reach; /* 0, or by how much a ray lies beyond 80 degrees, in cosines */
    int samples;         /* that fall to it */
};

/* Texels and cost, of area, core and densities; the core is that much too short each way. */
void plan_price_view(const struct plan_prices *prices, double short_px, struct plan_view_fit *fit);
/* What places in pixels' middles leave out: half a pixel on each side, and whole texels. */
#define PLAN_WHOLE_PX 2.0

/* The view that a sample falls to, the next best, and the first one's part of the sample. */
struct plan_member {
    int view, next;
    double product, next_product; /* with their selectors */
    double part;                  /* 1/2 on the border between them, to 1 */
    double shared;                /* of it, what objects reach across the border into the next */
    double others;                /* the same, into all other views */
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

/* Where views meet, see plan_meetings.c. */
struct plan_meeting {
    double at[3];
    unsigned views; /* a bit for each */
};

enum { PLAN_MEETINGS_MAX = 128 };

struct plan_meetings {
    int count;
    struct plan_meeting list[PLAN_MEETINGS_MAX];
};

void plan_meet(const struct plan_samples *samples, const struct plan_state *state,
               struct plan_meetings *meetings);

/* Room for footprints while a view is fitted; one per search. */
struct plan_scratch {
    struct plan_meetings meetings;
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
/* Of all directions round the eye, with objects of 2 degrees, by all views together. */
double plan_drawn(const struct plan_samples *samples, const struct plan_state *state);
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
        double area; /* of the base plane that its pixels cover, about */
    } views[CUPOLA_VIEWS_MAX];
    char family[CUPOLA_FAMILY_MAX];
    double drawn; /* of all directions round the eye, by all views together */
    double cost;  /* in shaded texels; PLAN_IMPOSSIBLE and more: some rays are out of reach */
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

#endif
