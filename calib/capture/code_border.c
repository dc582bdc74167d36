/* The borders of the stripes in photographs. */
#include "capture/code_border.h"

#include <math.h>
#include <stdlib.h>

enum { PAIRS_MIN = 4 };

/* Of one border's pairs with each other. */
static const double least_agreement = 0.5;

bool code_borders_begin(struct code_borders *borders, int bits)
{
    borders->count = 1u << bits;
    borders->list = calloc(borders->count, sizeof *borders->list);
    return borders->list != NULL;
}

void code_borders_add(struct code_borders *borders, const struct code_pixel *pixel,
                      const struct code_pixel *neighbour)
{
    unsigned int border = pixel->stripe > neighbour->stripe ? pixel->stripe : neighbour->stripe;
    double first = hypot(pixel->cosine, pixel->sine);
    double second = hypot(neighbour->cosine, neighbour->sine);
    double cosine = pixel->cosine / first + neighbour->cosine / second;
    double sine = pixel->sine / first + neighbour->sine / second;
    double length = hypot(cosine, sine);
    double sign = border % 2 ? -1 : 1; /* stripes are half periods */
    struct code_border *at;

    if (pixel->stripe + 1 != neighbour->stripe && neighbour->stripe + 1 != pixel->stripe)
        return;
    /* More than 120 degrees apart they do not tell what is between them. */
    if (!(length >= 1) || border >= borders->count)
        return;
    at = borders->list + border;
    at->cosine += sign * cosine / length;
    at->sine += sign * sine / length;
    at->pairs++;
}

struct code_phase code_borders_end(struct code_borders *borders)
{
    struct code_phase phase = {0};
    double cosine = 0, sine = 0;

    for (unsigned int i = 0; i < borders->count; i++) {
        const struct code_border *at = borders->list + i;
        double length = hypot(at->cosine, at->sine);
        if (at->pairs < PAIRS_MIN || length < least_agreement * at->pairs)
            continue;
        cosine += at->cosine / length;
        sine += at->sine / length;
        phase.borders++;
    }
    phase.off_rad = atan2(sine, cosine);
    phase.agreement = phase.borders > 0 ? hypot(cosine, sine) / phase.borders : 0;
    free(borders->list);
    *borders = (struct code_borders){0};
    return phase;
}
