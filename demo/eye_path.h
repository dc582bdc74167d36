/*
 * Where the viewer's eye is in each frame: at --viewer, on the way of --eye-circle, or where a
 * tracker says (--osc); moved by keys in the sphere of --head-radius.
 */
#ifndef EYE_PATH_H
#define EYE_PATH_H

#include <stdio.h>

#include "options.h"
#include "viewer_feed.h"

/* Frames of one turn where nothing says how many, and how long it takes in a window. */
enum { EYE_PATH_FRAMES = 120 };
#define EYE_PATH_TURN_MS 8000.0

struct eye_path {
    double home_m[3]; /* the rig's eye, dome frame */
    double circle_m;  /* 0: none */
    double head_m;    /* 0: the eye rests */
    double moved_m[3];
    bool was_moved;
    struct viewer_feed *feed; /* NULL: no tracker */
};

/* The radius of the sphere that the eye stays in; 0: it rests. */
double eye_path_head_radius_m(const struct options *options, const struct cupola_rig *rig);

/* Listens for a tracker, if there shall be one. STATUS_OK, or another with one line in message. */
int eye_path_create(struct eye_path *path, const struct options *options,
                    const struct cupola_rig *rig, char *message);
void eye_path_destroy(struct eye_path *path);

/* Says to `news` where a tracker is listened for. */
void eye_path_announce(const struct eye_path *path, FILE *news);

/*
 * Where the eye is after some turns, in metres, dome frame; false: at the rig's eye, where it has
 * been ever since.
 */
bool eye_path_place(struct eye_path *path, double turns, double eye_m[3]);

/* Moves it by parts of the sphere's radius; NULL: back. */
void eye_path_move(struct eye_path *path, const double step[3]);

/* NULL without a tracker. */
const struct viewer_osc_counts *eye_path_counts(const struct eye_path *path);

#endif
