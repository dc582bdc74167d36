/* The eye of a viewer who moves: on a circle round the dome's axis, by a tracker or by keys. */
#include "eye_path.h"

#include <math.h>
#include <string.h>

static const double HEAD_USUAL = 0.2; /* of the screen's radius */

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double eye_path_head_radius_m(const struct options *options, const struct cupola_rig *rig)
{
    double most_m = 0.9 * rig->screen.radius_m - length(rig->eye_m);

    if (options->head_radius_m.given)
        return options->head_radius_m.value[0];
    if (options->eye_circle_m.given)
        return options->eye_circle_m.value[0];
    return options->osc ? fmin(HEAD_USUAL * rig->screen.radius_m, 0.5 * fmax(most_m, 0)) : 0;
}

int eye_path_create(struct eye_path *path, const struct options *options,
                    const struct cupola_rig *rig, char *message)
{
    struct viewer_feed_wishes wishes = {.address = options->osc};
    double ahead_ms =
        options->lookahead_ms.given ? options->lookahead_ms.value[0] : VIEWER_FEED_USUAL_MS;

    *path = (struct eye_path){.circle_m =
                                  options->eye_circle_m.given ? options->eye_circle_m.value[0] : 0,
                              .head_m = eye_path_head_radius_m(options, rig)};
    memcpy(path->home_m, rig->eye_m, sizeof path->home_m);
    if (!options->osc)
        return STATUS_OK;
    memcpy(wishes.center_m, rig->eye_m, sizeof wishes.center_m);
    wishes.radius_m = path->head_m;
    wishes.ahead_s = ahead_ms / 1000;
    path->feed = viewer_feed_create(&wishes, message);
    return path->feed ? STATUS_OK : STATUS_FAILED;
}

void eye_path_destroy(struct eye_path *path)
{
    viewer_feed_destroy(path->feed);
    path->feed = NULL;
}

void eye_path_announce(const struct eye_path *path, FILE *news)
{
    if (path->feed)
        viewer_feed_announce(path->feed, news);
}

/* The sphere is what the plan was made for. */
static void keep_inside(const struct eye_path *path, double eye_m[3])
{
    double offset[3];

    for (int i = 0; i < 3; i++)
        offset[i] = eye_m[i] - path->home_m[i];
    if (length(offset) <= path->head_m)
        return;
    for (int i = 0; i < 3; i++)
        eye_m[i] = path->home_m[i] + offset[i] * (path->head_m / length(offset));
}

bool eye_path_place(struct eye_path *path, double turns, double eye_m[3])
{
    double angle = turns * (2 * 3.14159265358979323846);
    double place_m[3];
    bool moves = path->circle_m > 0 || path->was_moved;

    memcpy(place_m, path->home_m, sizeof place_m);
    if (path->feed && viewer_feed_eye(path->feed, place_m))
        moves = true;
    if (!moves)
        return false;
    if (path->circle_m > 0) {
        place_m[0] += path->circle_m * cos(angle);
        place_m[1] += path->circle_m * sin(angle);
    }
    for (int i = 0; i < 3; i++)
        place_m[i] += path->moved_m[i];
    keep_inside(path, place_m);
    memcpy(eye_m, place_m, sizeof place_m);
    return true;
}

void eye_path_move(struct eye_path *path, const double step[3])
{
    double offset;

    if (!(path->head_m > 0))
        return;
    if (!step) {
        memset(path->moved_m, 0, sizeof path->moved_m);
        return;
    }
    for (int i = 0; i < 3; i++)
        path->moved_m[i] += path->head_m * step[i];
    offset = length(path->moved_m);
    path->was_moved |= offset > 0;
    for (int i = 0; i < 3 && offset > path->head_m; i++)
        path->moved_m[i] *= path->head_m / offset;
}

const struct viewer_osc_counts *eye_path_counts(const struct eye_path *path)
{
    return path->feed ? viewer_feed_counts(path->feed) : NULL;
}
