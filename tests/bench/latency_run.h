/* One run of frames that follow a tracker, and how late they are. */
#ifndef LATENCY_RUN_H
#define LATENCY_RUN_H

#include <stdbool.h>

struct latency_wishes {
    int size_px;
    int frames;
    bool predicted; /* by the filter's defaults, to when the frame is done; else each report as it
                     * is */
    bool control;   /* the eye is not handed on: no frame may be proven that has another */
    double rate_hz, flood_hz;
};

/* Median and 95th percentile. */
struct spread {
    double median, high;
};

struct latency_result {
    int frames;
    struct spread
        message_ms;         /* from sending a report to the end of the first frame that shows it or
                               * a newer one */
    struct spread age_ms;   /* of the newest report that a frame shows, at its end */
    struct spread poll_ms;  /* taking what has come */
    struct spread frame_ms; /* poll to glFinish */
    double lag_ms;          /* by which the eyes that are shown follow the head, on average */
    double error_mm;        /* root mean square of shown less true, at the end of frames */
    int unproven;           /* frames whose pixel shows another eye than the newest report's (not
                               * predicted) or than the one that was set */
    int reports;            /* that were sent while frames were drawn */
    int lost;               /* of these, by the kernel, whose queue was full */
    long flooded;           /* packets of the flood meanwhile */
};

/* False with one line in `message` (2048 bytes). Where a GL context is current. */
bool latency_run(const struct latency_wishes *wishes, struct latency_result *result, char *message);

#endif
