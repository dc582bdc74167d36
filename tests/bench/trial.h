/*
 * One scene through one lens: every method's picture beside the truth, while the camera turns, and
 * what the method costs.
 */
#ifndef TRIAL_H
#define TRIAL_H

#include "comparison.h"
#include "method.h"
#include "similarity.h"
#include "truth.h"
#include "truth_check.h"

/* A square part of pictures, to be written as files. */
struct cut_out {
    const char *folder; /* NULL: none */
    double x, y;        /* of its middle, parts of the picture's width and height */
    int side_px;        /* 0: the whole picture */
    int scale;          /* each pixel becomes a square of so many */
};

struct trial_wishes {
    int rays;                 /* of the truth, through each pixel */
    double reference_density; /* of its views, as in plan.h */
    int steps;                /* of the camera's turn; 0: it rests */
    int shimmer_rays;         /* of the truth meanwhile */
    double yaw_rad;
    struct comparison_wishes cost; /* no frames: not measured */
    struct cut_out cut_out;
    bool check; /* the truth, too */
};

struct verdict {
    struct similarity likeness; /* before the turn */
    double shimmer;             /* see struct trial */
    double warp_blits;          /* of medians, as all that follow; 0: not measured */
    double warp_ms;
    double frame_ratio; /* to the first method's */
    double frame_ms;
};

/*
 * Shimmer is the root of the mean square, over pixels and steps, of what a picture changes from one
 * step to the next, less what the truth does: in steps of 8 bits. `change` is the same of the truth
 * alone.
 */
struct trial {
    struct verdict verdicts[METHODS_MAX];
    double pixels; /* that count: r < 1 */
    double change;
    double blit_ms;
    struct truth_check check; /* all zero where it is not wished */
};

/* The first method is what whole frames are measured in. False with one line in `message`. */
bool trial_run(struct setting *setting, const char *name, const struct method *methods, int count,
               const struct trial_wishes *wishes, struct trial *trial, char *message);

#endif
