/*
 * Numbers out of a fuzzer's bytes. Random doubles are nearly all absurd, so most of what is drawn
 * here is of the size that a rig has, some of it lies on the bounds themselves, and some is any
 * double at all. When the bytes are used up every further number is 0.
 */
#ifndef VALUES_H
#define VALUES_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

struct values {
    const uint8_t *next;
    size_t left;
};

static inline uint8_t take_byte(struct values *values)
{
    if (values->left == 0)
        return 0;
    values->left--;
    return *values->next++;
}

static inline uint64_t take_bits(struct values *values, int bytes)
{
    uint64_t bits = 0;
    for (int i = 0; i < bytes; i++)
        bits |= (uint64_t)take_byte(values) << (8 * i);
    return bits;
}

static inline int take_int(struct values *values, int low, int high)
{
    return low + (int)(take_bits(values, 2) % (uint64_t)(high - low + 1));
}

/* A double whose ordinary size is `scale`. */
static inline double take_double(struct values *values, double scale)
{
    const double special[] = {
        0,        -0.0,      1,       -1,      nan(""),
        HUGE_VAL, -HUGE_VAL, DBL_MAX, DBL_MIN, 5e-324,
        1e-300,   1e-154,    1e-12,   1e-9,    0.99999999999999,
        1e154,    1e300,     pi / 4,  pi / 2,  pi,
        2 * pi,   1e6,       1e9,     0.5,
    };
    uint8_t kind = take_byte(values);
    if (kind < 16)
        return 0;
    if (kind < 128) /* coarse: 16 bits of fraction */
        return scale * ((double)take_bits(values, 2) / 32768.0 - 1);
    if (kind < 192)
        return scale * ((double)take_byte(values) / 128.0);
    if (kind < 224)
        return special[kind % (sizeof special / sizeof special[0])];
    if (kind < 240) /* round a multiple of the scale, a few units in the last place beside it */
        return scale * ((kind & 3) + 1) * (1 + (take_byte(values) - 128) * DBL_EPSILON);
    uint64_t bits = take_bits(values, 8);
    double any;
    memcpy(&any, &bits, sizeof any);
    return any;
}

#endif
