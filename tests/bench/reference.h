/*
 * What a perfect dome and a perfect plain view would show: for each pixel the mean of many rays
 * through it, from a scene drawn several times as finely as any contender draws it. It shares
 * cupola_dome_ray with the library and nothing else.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "contender.h"

struct reference {
    int size_px;
    double oversampling;                   /* texels per wished texel along a line */
    float *pictures[SHOWS_PLAIN_VIEW + 1]; /* RGBA; alpha is 1 where a pixel counts */
};

/* False with one line in `message`. */
bool reference_create(struct reference *reference, const struct setting *setting, char *message);
void reference_destroy(struct reference *reference);

/* Signal (255) to noise of the setting's target in dB; 0 where there is nothing to compare with. */
double reference_psnr_db(const struct reference *reference, const struct setting *setting,
                         enum shows shows);

#endif
