/*
 * Where the projector may stand and aim, whatever the start says: poses that fit a few marks and
 * then most of them. In directions as seen from the lens, for speed: the lens and the image circle
 * are taken as the start has them.
 */
#ifndef SEARCH_H
#define SEARCH_H

#include "solve/model.h"

enum { SEARCH_POSES = 4 };

struct pose {
    double position_m[3];
    double aim[9];    /* lens to dome */
    double error_rad; /* which most of the marks keep to */
};

/*
 * The best poses, differing from each other, best first; only what is free differs from the
 * start, which is always among them. Returns how many; 0 without memory.
 */
int search_poses(const struct model *model, const int *chosen, int count,
                 struct pose poses[SEARCH_POSES]);

/* How many of some marks are taken for most of them when `values` are free. */
int search_most(int count, int values);

#endif
