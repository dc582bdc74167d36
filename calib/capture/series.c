/* Gray code and sines. */
#include "capture/series.h"

#include <math.h>
#include <stdio.h>

#include "angles.h"

int series_period_for(int width_px, int height_px)
{
    int longest = width_px > height_px ? width_px : height_px;
    int period = 16;

    while (period < SERIES_PERIOD_MAX && 64 * period < longest)
        period *= 2;
    return period;
}

int series_bits(const struct series *series, int axis)
{
    int half_px = series->period_px / 2;
    int stripes = (series->size_px[axis] + half_px - 1) / half_px;
    int bits = 1;

    while (1 << bits < stripes)
        bits++;
    return bits;
}

int series_count(const struct series *series)
{
    return 2 + 2 * (series_bits(series, 0) + series_bits(series, 1)) + 2 * series->steps;
}

struct series_picture series_picture(const struct series *series, int number)
{
    struct series_picture picture = {.kind = number == 0 ? SERIES_WHITE : SERIES_BLACK};

    number -= 2;
    for (int axis = 0; axis < 2 && number >= 0; axis++) {
        int codes = 2 * series_bits(series, axis);
        picture.axis = axis;
        if (number < codes) {
            picture.kind = number % 2 ? SERIES_INVERSE : SERIES_CODE;
            picture.index = number / 2;
            return picture;
        }
        number -= codes;
        if (number < series->steps) {
            picture.kind = SERIES_SINE;
            picture.index = number;
            return picture;
        }
        number -= series->steps;
    }
    return picture;
}

int series_find(const struct series *series, struct series_picture wanted)
{
    int start = 2;

    if (wanted.kind == SERIES_WHITE || wanted.kind == SERIES_BLACK)
        return wanted.kind == SERIES_WHITE ? 0 : 1;
    if (wanted.axis == 1)
        start += 2 * series_bits(series, 0) + series->steps;
    if (wanted.kind == SERIES_SINE)
        return start + 2 * series_bits(series, wanted.axis) + wanted.index;
    return start + 2 * wanted.index + (wanted.kind == SERIES_INVERSE);
}

void series_name(const struct series *series, int number, char name[SERIES_NAME_MAX + 1])
{
    static const char *const kinds[] = {"white", "black", "code", "inverse", "sine"};
    struct series_picture picture = series_picture(series, number);

    if (picture.kind == SERIES_WHITE || picture.kind == SERIES_BLACK)
        snprintf(name, SERIES_NAME_MAX + 1, "%02d-%s", number, kinds[picture.kind]);
    else
        snprintf(name, SERIES_NAME_MAX + 1, "%02d-%c-%s-%d", number, picture.axis ? 'y' : 'x',
                 kinds[picture.kind], picture.index);
}

static bool code_is_bright(const struct series *series, const struct series_picture *picture,
                           int place)
{
    unsigned int stripe = (unsigned int)place / (unsigned int)(series->period_px / 2);
    int shift = series_bits(series, picture->axis) - 1 - picture->index;

    return (stripe ^ stripe >> 1) >> shift & 1;
}

double series_light(const struct series *series, const struct series_picture *picture, int i, int j)
{
    int place = picture->axis ? j : i;

    switch (picture->kind) {
    case SERIES_WHITE:
        return 1;
    case SERIES_CODE:
        return code_is_bright(series, picture, place);
    case SERIES_INVERSE:
        return !code_is_bright(series, picture, place);
    case SERIES_SINE:
        return 0.5 + 0.5 * cos(2 * pi *
                               ((place + 0.5) / series->period_px -
                                (double)picture->index / series->steps));
    default:
        return 0;
    }
}

unsigned int series_from_gray(unsigned int gray)
{
    for (unsigned int shift = 1; shift < 32; shift *= 2)
        gray ^= gray >> shift;
    return gray;
}

double series_place(const struct series *series, unsigned int code, double phase_rad, double *off)
{
    double half_px = 0.5 * series->period_px;
    double middle = (code + 0.5) * half_px;
    double within = phase_rad / (2 * pi) * series->period_px;
    double place = within + series->period_px * round((middle - within) / series->period_px);

    *off = fabs(place - middle) / half_px;
    return place;
}
