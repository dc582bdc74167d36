/* Packets of OSC, built by hand byte by byte, for the tests of what reads them. */
#ifndef OSC_BYTES_H
#define OSC_BYTES_H

#include <stdint.h>
#include <string.h>

struct bytes {
    unsigned char at[65536];
    size_t size;
};

static struct bytes packet; /* being made */

static inline void add(const void *bytes, size_t size)
{
    memcpy(packet.at + packet.size, bytes, size);
    packet.size += size;
}

/* Padded with 1 to 4 zeros. */
static inline void add_text(const char *text)
{
    size_t length = strlen(text);

    add(text, length);
    add("\0\0\0", 4 - length % 4);
}

static inline void add_number(uint64_t number, int count)
{
    while (count-- > 0)
        add(&(unsigned char){(unsigned char)(number >> 8 * count)}, 1);
}

static inline void add_float(float value)
{
    uint32_t bits;

    memcpy(&bits, &value, sizeof bits);
    add_number(bits, 4);
}

static inline void add_double(double value)
{
    uint64_t bits;

    memcpy(&bits, &value, sizeof bits);
    add_number(bits, 8);
}

static inline void add_report(float x)
{
    add_text("/viewer");
    add_text(",fff");
    add_float(x);
    add_float(2);
    add_float(3);
}

enum { REPORT_SIZE = 8 + 8 + 12 };

static inline void begin(void)
{
    packet.size = 0;
}

static inline void begin_bundle(uint64_t tag)
{
    begin();
    add_text("#bundle");
    add_number(tag, 8);
}

#endif
