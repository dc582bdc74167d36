/* From a tracker to the eye of the tool. */
#include "tool/tracker.h"

#include <stdio.h>
#include <stdlib.h>

#include "viewer_feed.h"

static const double TOLD_EVERY_S = 0.25;

struct tracker {
    struct viewer_feed *feed;
    double told_s; /* when what came was told last */
};

struct tracker *tracker_open(struct tool *tool, const char *address, double ahead_ms, char *message)
{
    const struct viewer_feed_wishes wishes = {.address = address,
                                              .ahead_s = ahead_ms / 1000,
                                              .radius_m =
                                                  tool_eye_reach_m(tool->rig.screen.radius_m)};
    struct tracker *tracker = calloc(1, sizeof *tracker);

    if (!tracker) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    tracker->feed = viewer_feed_create(&wishes, message);
    if (!tracker->feed) {
        free(tracker);
        return NULL;
    }
    viewer_feed_announce(tracker->feed, stdout);
    snprintf(tool->tracker.address, sizeof tool->tracker.address, "%s",
             viewer_feed_address(tracker->feed));
    tracker->told_s = -TOLD_EVERY_S;
    return tracker;
}

void tracker_close(struct tracker *tracker)
{
    if (tracker)
        viewer_feed_destroy(tracker->feed);
    free(tracker);
}

void tracker_hear(struct tool *tool, void *user)
{
    struct tracker *tracker = user;

    viewer_feed_set_radius(tracker->feed, tool_eye_reach_m(tool->rig.screen.radius_m));
    if (viewer_feed_eye(tracker->feed, tool->live_eye_m))
        tool->viewer_lives = true;
    if (tool->time_s < tracker->told_s + TOLD_EVERY_S)
        return;
    tool->tracker.counts = *viewer_feed_counts(tracker->feed);
    tracker->told_s = tool->time_s;
}
