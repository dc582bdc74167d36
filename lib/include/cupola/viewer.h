/*
 * A viewer who moves: from positions that a tracker reports now and then to the eye at the moment
 * at which a frame is seen.
 *
 * The filter is the critically damped g-h filter (fading memory of degree 1; Brookner, Tracking and
 * Kalman Filtering Made Easy, 1998, section 1.2.6) for reports at any intervals: position and
 * velocity per axis, corrected by g = 1 - theta^2 and h = (1 - theta)^2 of what a report differs
 * from the prediction, theta = exp(-interval / memory_s). A velocity that does not change is
 * followed without lag.
 *
 * A plain value: nothing is allocated, and a copy is a viewer of its own. One thread at a time.
 */
#ifndef CUPOLA_VIEWER_H
#define CUPOLA_VIEWER_H

#include <stdbool.h>

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a viewer is followed; zero means the default in every member but radius_m. */
struct cupola_viewer_params {
    /* How long a report counts: larger is calmer and later; 1e-4 to 10. 0: 0.02, which predicts
     * heads best where reports err by millimetres. */
    double memory_s;
    /* The furthest ahead of the last report that is predicted, up to 1: beyond it the eye stays
     * where it is. 0: 0.1; below 0: nothing is predicted. */
    double horizon_s;
    /* Of the screen, or of the sphere in which the eye may move (head_radius_m of plan.h); above 0,
     * up to 1e6. */
    double radius_m;
    /* The eye is kept inside of this part of radius_m round center_m, between 0 and 1. 0: 0.9 */
    double reach;
    /* Dome frame; up to 1e6 each. The screen's is 0, a head's sphere has the rig's eye. */
    double center_m[3];
};

/* All zero before the first cupola_viewer_start. For reading only. */
struct cupola_viewer {
    struct cupola_viewer_params params; /* complete */
    bool started;                       /* cupola_viewer_start was called */
    long reports;                       /* taken so far */
    long refused;                       /* by cupola_viewer_report */
    double time_s;                      /* of the last report that was taken */
    double position_m[3];               /* then, filtered; dome frame; may be out of reach */
    double velocity_m_s[3];             /* then, filtered */
};

/*
 * Forgets whatever was and begins.
 *
 * viewer   out: all of it; untouched where CUPOLA_OK is not returned
 * params   radius_m is needed
 * error    may be NULL
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT with the value and what is allowed
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_viewer_start(struct cupola_viewer *viewer,
                                   const struct cupola_viewer_params *params,
                                   struct cupola_error *error);

/*
 * Takes a report. After a gap of more than a second (of more than 10 memory_s where that is longer)
 * the filter begins anew with it, at rest.
 *
 * viewer      started; changed
 * time_s      of the report, by any clock that only goes forward
 * position_m  dome frame
 * returns     1: taken; 0: refused and counted, since it is not later than the last one that was
 *             taken, holds a number that is not finite, or is more than 100 radius_m from center_m;
 *             CUPOLA_ERROR_ARGUMENT for a pointer that is NULL or a viewer that was not started
 * thread      any, one at a time
 * since       0.1
 */
CUPOLA_API int cupola_viewer_report(struct cupola_viewer *viewer, double time_s,
                                    const double position_m[3]);

/*
 * Where the eye is at a time, for cupola_gl_set_eye. Moments before the last report have its
 * position.
 *
 * viewer   started
 * time_s   by the same clock; when the frame will be seen
 * eye_m    out: dome frame, inside of reach; untouched unless 1 is returned
 * returns  1; 0 where nothing was reported yet; CUPOLA_ERROR_ARGUMENT for a pointer that is NULL, a
 *          viewer that was not started, or a time that is not finite
 * thread   any, one at a time
 * since    0.1
 */
CUPOLA_API int cupola_viewer_eye(const struct cupola_viewer *viewer, double time_s,
                                 double eye_m[3]);

#ifdef __cplusplus
}
#endif

#endif
