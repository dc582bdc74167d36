/* A tracker that moves the tool's eye, and what the tool tells of what came from it. */
#ifndef TRACKER_H
#define TRACKER_H

#include "tool/tool.h"

struct tracker;

/*
 * Listens at [HOST:]PORT and says so on stdout; the eye is predicted so far ahead. NULL with one
 * line in the message (MESSAGE_SIZE bytes).
 */
struct tracker *tracker_open(struct tool *tool, const char *address, double ahead_ms,
                             char *message);

/* NULL is allowed. */
void tracker_close(struct tracker *tracker);

/*
 * Before every frame: the eye is where it is at tool->time_s. What is told of packets changes a few
 * times a second, so that a flood alone makes no frames.
 */
void tracker_hear(struct tool *tool, void *tracker);

#endif
