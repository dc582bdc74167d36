/*
 * One packet of OSC, as a tracker sends it, read for the position of the viewer's eye: messages
 * `/viewer x y z`, by themselves or in bundles; metres, dome frame, three numbers of the types f,
 * d, i or h.
 */
#ifndef VIEWER_PACKET_H
#define VIEWER_PACKET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* So many bundles may lie in each other, and so many reports in one packet. */
enum { VIEWER_PACKET_DEPTH = 8, VIEWER_PACKET_REPORTS = 64 };

struct viewer_packet {
    int reports;          /* messages that are as they should be; the last of them wins: */
    double position_m[3]; /* may be no finite numbers */
    uint64_t time_tag;    /* of the bundle round it, in 2^-32 s since 1900; 1: of none, or "now" */
    int others;           /* messages to other paths, or with other arguments */
};

/*
 * False where the bytes are no packet of OSC, or more than one should hold; then nothing counts of
 * what they say. Takes time in proportion to `size`, whatever they are, and keeps no memory.
 * Patterns in paths are not matched: a star is a letter.
 */
bool viewer_packet_read(void *bytes, size_t size, struct viewer_packet *packet);

#endif
