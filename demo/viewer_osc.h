/*
 * Reports of where the viewer's eye is, by OSC over UDP: from a socket into the filter of
 * cupola/viewer.h.
 *
 * There is no thread, and nothing ever waits. The socket is one of our own, because liblo's servers
 * listen on every interface; what came is read between frames, until nothing is left or a bound is
 * reached, and the kernel says when it came, so that reports are as old as they are and not as old
 * as a frame. What comes faster than it is read fills the kernel's queue of fixed size and is lost.
 * Where that is a flood of what nobody asked for, the kernel is told to keep it out, for a second
 * at a time, and reports get through.
 *
 * The clock is CLOCK_MONOTONIC. Time tags of bundles are by the sender's clock, which need not be
 * ours: a report counts from its arrival, at once, also one that is meant for the future. Tags only
 * tell that a bundle has overtaken another: one that is up to a second older than the newest is
 * late and dropped, one that is older still is of a clock that was set anew.
 */
#ifndef VIEWER_OSC_H
#define VIEWER_OSC_H

#include <cupola/viewer.h>

#include "option_values.h"

struct viewer_osc;

/* What has come. */
struct viewer_osc_counts {
    long packets;
    long taken;     /* reports, by the filter; of several in one packet the last alone counts */
    long refused;   /* reports, by the filter: far away, no finite numbers, twice at a time */
    long late;      /* overtaken packets */
    long malformed; /* packets that are no OSC */
    long others;    /* messages to other paths than /viewer, or with other arguments */
    long lost; /* packets that the kernel dropped, up to the last that came: its queue was full, or
                * they were kept out */
};

/* Whether a text is [HOST:]PORT; else one line in the message. */
bool viewer_osc_check(const struct value_context *context, const char *text);

/*
 * Listens on [HOST:]PORT: loopback alone where no host is named, every interface for 0.0.0.0 or
 * [::]; port 0: any that is free. NULL with one line in the message (MESSAGE_SIZE bytes).
 */
struct viewer_osc *viewer_osc_create(const char *address, char *message);

/* NULL is allowed. */
void viewer_osc_destroy(struct viewer_osc *osc);

/* Takes what has come to the viewer, in a few milliseconds at most. Between frames, one thread. */
void viewer_osc_poll(struct viewer_osc *osc, struct cupola_viewer *viewer);

/* The address that it listens on: "127.0.0.1:9000". Lives as long as osc. */
const char *viewer_osc_address(const struct viewer_osc *osc);

const struct viewer_osc_counts *viewer_osc_counts(const struct viewer_osc *osc);

/* The clock by which reports are dated. */
double viewer_osc_now_s(void);

#endif
