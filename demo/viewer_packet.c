/*
 * Packets of OSC. liblo reads the messages; bundles are walked here, because liblo would keep those
 * of the future until their time has come, as many as anyone likes to send.
 */
#include "viewer_packet.h"

#include <string.h>

#include <lo/lo.h>

static const char report_path[] = "/viewer";
enum { BUNDLE_HEAD = 16 }; /* "#bundle", 0, and the time tag */

/* A number out of a message whose bytes are in this machine's order; they need not be aligned. */
static bool number(char type, const lo_arg *argument, double *value)
{
    int32_t i;
    int64_t h;
    float f;

    switch (type) {
    case LO_INT32:
        memcpy(&i, argument, sizeof i);
        *value = i;
        return true;
    case LO_INT64:
        memcpy(&h, argument, sizeof h);
        *value = (double)h;
        return true;
    case LO_FLOAT:
        memcpy(&f, argument, sizeof f);
        *value = (double)f;
        return true;
    case LO_DOUBLE:
        memcpy(value, argument, sizeof *value);
        return true;
    default:
        return false;
    }
}

static bool take_report(lo_message message, uint64_t time_tag, struct viewer_packet *packet)
{
    const char *types = lo_message_get_types(message);
    lo_arg **arguments = lo_message_get_argv(message);
    double position_m[3];

    if (lo_message_get_argc(message) != 3)
        return false;
    for (int i = 0; i < 3; i++)
        if (!number(types[i], arguments[i], &position_m[i]))
            return false;
    memcpy(packet->position_m, position_m, sizeof position_m);
    packet->time_tag = time_tag;
    return true;
}

static bool read_message(unsigned char *bytes, size_t size, uint64_t time_tag,
                         struct viewer_packet *packet)
{
    lo_message message;

    if (!memchr(bytes, 0, size))
        return false;
    if (strcmp((const char *)bytes, report_path) != 0) {
        packet->others++;
        return true;
    }
    if (packet->reports == VIEWER_PACKET_REPORTS)
        return false;
    message = lo_message_deserialise(bytes, size, NULL);
    if (!message)
        return false;
    if (take_report(message, time_tag, packet))
        packet->reports++;
    else
        packet->others++;
    lo_message_free(message);
    return true;
}

static uint64_t big_endian(const unsigned char *bytes, int count)
{
    uint64_t value = 0;

    for (int i = 0; i < count; i++)
        value = value << 8 | bytes[i];
    return value;
}

/* NOLINTNEXTLINE(misc-no-recursion): no deeper than VIEWER_PACKET_DEPTH */
static bool read_element(unsigned char *bytes, size_t size, int depth, uint64_t time_tag,
                         struct viewer_packet *packet)
{
    if (size < 4 || size % 4 != 0)
        return false;
    if (bytes[0] == '/')
        return read_message(bytes, size, time_tag, packet);
    if (size < BUNDLE_HEAD || memcmp(bytes, "#bundle", 8) != 0 || depth == VIEWER_PACKET_DEPTH)
        return false;
    time_tag = big_endian(bytes + 8, 8);
    for (size_t at = BUNDLE_HEAD; at < size;) {
        size_t length = (size_t)big_endian(bytes + at, 4);
        at += 4;
        if (length > size - at || !read_element(bytes + at, length, depth + 1, time_tag, packet))
            return false;
        at += length;
    }
    return true;
}

bool viewer_packet_read(void *bytes, size_t size, struct viewer_packet *packet)
{
    *packet = (struct viewer_packet){.time_tag = 1};
    if (read_element(bytes, size, 0, 1, packet))
        return true;
    *packet = (struct viewer_packet){.time_tag = 1};
    return false;
}
