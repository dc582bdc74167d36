/* A lens out of a fuzzer's bytes. */
#ifndef LENS_VALUES_H
#define LENS_VALUES_H

#include "cupola/lens.h"
#include "values.h"

static inline struct cupola_lens take_lens(struct values *values)
{
    struct cupola_lens lens;
    memset(&lens, 0, sizeof lens);
    uint8_t kind = take_byte(values);
    lens.model = (enum cupola_lens_model)(kind == 255 ? 77 : kind % 6);
    lens.fov_rad = take_double(values, pi);
    if (lens.model == CUPOLA_LENS_POLYNOMIAL)
        for (int i = 0; i < 4; i++)
            lens.k[i] = take_double(values, i == 0 ? 1 : 0.1);
    if (lens.model != CUPOLA_LENS_TABLE)
        return lens;
    kind = take_byte(values);
    lens.table_count = kind == 255 ? -1 : kind % (CUPOLA_LENS_TABLE_MAX + 2);
    /* Steps rather than values: values at random hardly ever rise. */
    double angle = 0, radius = 0;
    int steps = kind & 64;
    for (int i = 0; i < lens.table_count && i < CUPOLA_LENS_TABLE_MAX; i++) {
        double a = take_double(values, steps ? 0.1 : pi), r = take_double(values, 1);
        lens.table[i].angle_rad = angle = steps ? angle + fabs(a) : a;
        lens.table[i].radius = radius = steps ? radius + fabs(r) : r;
    }
    return lens;
}

#endif
