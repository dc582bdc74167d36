/* From a tracker's reports to the eye of a frame. */
#include "viewer_feed.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct viewer_feed {
    struct viewer_osc *osc;
    struct cupola_viewer viewer;
    double ahead_s;
};

struct viewer_feed *viewer_feed_create(const struct viewer_feed_wishes *wishes, char *message)
{
    /*
     * All of the sphere, but that no rounding takes the eye out of it. Reports that are a little
     * late, or that one of is missing, do not end the prediction.
     */
    struct cupola_viewer_params params = {
        .radius_m = wishes->radius_m, .reach = 0.999, .horizon_s = 0.1 + wishes->ahead_s};
    struct viewer_feed *feed = calloc(1, sizeof *feed);
    struct cupola_error error = {0};

    if (!feed) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    memcpy(params.center_m, wishes->center_m, sizeof params.center_m);
    feed->ahead_s = wishes->ahead_s;
    if (cupola_viewer_start(&feed->viewer, &params, &error) < 0)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    else
        feed->osc = viewer_osc_create(wishes->address, message);
    if (feed->osc)
        return feed;
    free(feed);
    return NULL;
}

void viewer_feed_destroy(struct viewer_feed *feed)
{
    if (feed)
        viewer_osc_destroy(feed->osc);
    free(feed);
}

void viewer_feed_set_radius(struct viewer_feed *feed, double radius_m)
{
    const struct cupola_viewer last = feed->viewer;
    struct cupola_viewer_params params = last.params;

    params.radius_m = radius_m;
    if (radius_m == last.params.radius_m || cupola_viewer_start(&feed->viewer, &params, NULL) < 0)
        return;
    if (last.reports > 0)
        cupola_viewer_report(&feed->viewer, last.time_s, last.position_m);
}

bool viewer_feed_eye(struct viewer_feed *feed, double eye_m[3])
{
    viewer_osc_poll(feed->osc, &feed->viewer);
    return cupola_viewer_eye(&feed->viewer, viewer_osc_now_s() + feed->ahead_s, eye_m) == 1;
}

void viewer_feed_announce(const struct viewer_feed *feed, FILE *news)
{
    fprintf(news, "listens for /viewer on %s, head radius %g m\n", viewer_feed_address(feed),
            feed->viewer.params.radius_m);
    fflush(news);
}

const char *viewer_feed_address(const struct viewer_feed *feed)
{
    return viewer_osc_address(feed->osc);
}

const struct viewer_osc_counts *viewer_feed_counts(const struct viewer_feed *feed)
{
    return viewer_osc_counts(feed->osc);
}
