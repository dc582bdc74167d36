/* Whether the mean of many frames is what another way to the same picture finds. */
#ifndef TRUTH_CHECK_H
#define TRUTH_CHECK_H

#include "setting.h"

/* PSNR against reference.h, which shares only the rays with the library. */
struct truth_check {
    double psnr_db;
    double moved_db; /* of the truth moved by a quarter of a pixel: the control */
};

/* For scenes that do not change within a pixel. False with one line in `message`. */
bool truth_check_run(const struct setting *setting, double density, int rays,
                     struct truth_check *check, char *message);

#endif
