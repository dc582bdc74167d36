/*
 * A tracker, and somebody who floods its port, each in a thread of its own: what a receiver of
 * reports is measured with.
 */
#ifndef TRACKER_H
#define TRACKER_H

#include <stdbool.h>

struct tracker;

struct tracker_wishes {
    int port;        /* on 127.0.0.1 */
    double rate_hz;  /* of reports; intervals vary by a quarter; 0: none */
    double flood_hz; /* of packets that are no reports; 0: none */
};

/* Begins to send. NULL with one line in the message (1024 bytes). */
struct tracker *tracker_create(const struct tracker_wishes *wishes, char *message);

/* Ends the threads. NULL is allowed. */
void tracker_destroy(struct tracker *tracker);

/* Where the head really is: to and fro by 0.1 m, once a second; metres, along x. */
double tracker_head_x_m(double time_s);

/* How many reports have been sent, when number `index` was (CLOCK_MONOTONIC), and what it said. */
int tracker_count(const struct tracker *tracker);
double tracker_sent_s(const struct tracker *tracker, int index);
float tracker_x_m(const struct tracker *tracker, int index);

/* How many packets of the flood have been sent. */
long tracker_flooded(const struct tracker *tracker);

#endif
