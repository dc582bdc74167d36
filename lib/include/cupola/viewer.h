/*
 * A viewer who moves: from positions that a tracker reports now and then to the eye at the moment
 * at which a frame is seen.
 *
 * The filter is the critically damped g-h filter (fading memory of degree 1; Brookner, Tracking and
 * Kalman Filtering Made Easy, 1998, section 1.2.6) for reports at any intervals: position and
 * velocity per axis, corrected by g = 1 - theta^2 and h = (1 - theta)^2 of what a report differs
 * from the prediction, theta = exp(-interval / memory_s).
 *
 * A plain value without memory of its own; one thread at a time.
 */
#ifndef CUPOLA_VIEWER_H
#define CUPOLA_VIEWER_H

#include <stdbool.h>

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How a viewer is followed; zero means the default in every member. */
struct cupola_viewer_params {
    double memory_s; /* how long a report counts: larger is calmer and later; 1e-4 to 10; 0: 0.05 */
    double horizon_s; /* the furthest ahead of the last report that is predicted; beyond it the eye
                       * stays where it is; up to 1; 0: 0.1; below 0: nothing is predicted */
    double radius_m;  /* of the screen, or of the head's sphere: the eye is kept inside of reach */
    double reach;     /* of radius_m round `center_m`, above 0 and below 1; 0: 0.9 */
    double center_m[3]; /* dome frame */
};

/* All zero before the first cupola_viewer_start. */
struct cupola_viewer {
    struct cupola_viewer_params params; /* complete */
    int reports;                        /* taken so far */
    int refused;                        /* late, twice the same time, or no finite numbers */
    double time_s;                      /* of the last report that was taken */
    double position_m[3];               /* then, filtered; dome frame */
    double velocity_m_s[3];             /* then, filtered */
};

/*
 * Forgets whatever was and begins.
 *
 * viewer   out: all of it
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
 * Takes a report.
 *
 * time_s      of the report, by any clock that only goes forward
 * position_m  dome frame
 * returns     1: taken; 0: refused and counted, since it is not later than the last one, or is no
 *             finite number; CUPOLA_ERROR_ARGUMENT for a pointer that is NULL or a viewer that was
 *             not started
 * thread      any, one at a time
 * since       0.1
 */
CUPOLA_API int cupola_viewer_report(struct cupola_viewer *viewer, double time_s,
                                    const double position_m[3]);

/*
 * Where the eye is at a time, for cupola_gl_set_eye.
 *
 * time_s   by the same clock; when the frame will be seen
 * eye_m    out: dome frame, inside of reach; untouched unless 1 is returned
 * returns  1; 0 where nothing was reported yet; CUPOLA_ERROR_ARGUMENT as above
 * thread   any, one at a time
 * since    0.1
 */
CUPOLA_API int cupola_viewer_eye(const struct cupola_viewer *viewer, double time_s,
                                 double eye_m[3]);

#ifdef __cplusplus
}
#endif

#endif
