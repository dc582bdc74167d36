/* The command line of cupola-quality. */
#ifndef QUALITY_OPTIONS_H
#define QUALITY_OPTIONS_H

#include "trial.h"

enum { QUALITY_LIST_MAX = 16 };

struct quality_options {
    const char *scenes[QUALITY_LIST_MAX];
    int scene_count;
    struct cupola_lens lenses[QUALITY_LIST_MAX];
    int lens_count;
    double eyes_m[QUALITY_LIST_MAX][3]; /* dome frame; the screen's radius is 1 */
    int eye_count;
    struct method methods[METHODS_MAX]; /* the first is none */
    int method_count;
    int size_px;
    double density; /* of the views that are judged, as in plan.h */
    int samples;    /* per texel */
    int table;      /* of enum cupola_table */
    struct trial_wishes trial;
    const char *model;
    const char *output; /* NULL: stdout */
    bool dry_run;       /* nothing is measured */
};

/* True to go on; else `status` is what to exit with, and it has been said why. */
bool quality_options_read(struct quality_options *options, int argc, char **argv, int *status);

#endif
