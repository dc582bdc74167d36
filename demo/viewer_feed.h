/* The eye of a viewer who is tracked, for each frame: reports by OSC, filter and prediction. */
#ifndef VIEWER_FEED_H
#define VIEWER_FEED_H

#include <stdio.h>

#include "viewer_osc.h"

/* How far ahead, where nothing is said, and at most. */
enum { VIEWER_FEED_USUAL_MS = 20, VIEWER_FEED_MOST_MS = 500 };

struct viewer_feed;

struct viewer_feed_wishes {
    const char *address; /* [HOST:]PORT */
    double ahead_s;      /* of the moment at which the eye is asked for, up to 0.5 */
    double center_m[3];  /* the eye stays in a sphere; dome frame */
    double radius_m;
};

/* NULL with one line in the message (MESSAGE_SIZE bytes). */
struct viewer_feed *viewer_feed_create(const struct viewer_feed_wishes *wishes, char *message);

/* NULL is allowed. */
void viewer_feed_destroy(struct viewer_feed *feed);

/*
 * Another sphere round the same centre. The eye goes on from where it was reported last, at rest. A
 * radius that is not allowed (cupola/viewer.h) changes nothing.
 */
void viewer_feed_set_radius(struct viewer_feed *feed, double radius_m);

/*
 * Takes what has come, and says where the eye will be: dome frame, inside of the sphere. False, and
 * the eye untouched, until something was reported. Never waits; once a frame, one thread.
 */
bool viewer_feed_eye(struct viewer_feed *feed, double eye_m[3]);

/* One line: where it listens, and how far the eye may go. */
void viewer_feed_announce(const struct viewer_feed *feed, FILE *news);

const char *viewer_feed_address(const struct viewer_feed *feed);
const struct viewer_osc_counts *viewer_feed_counts(const struct viewer_feed *feed);

#endif
