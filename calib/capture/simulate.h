/*
 * Photographs of a simulated theatre: what a camera would take of the patterns, with all that
 * spoils photographs, so that everything can be tried without a theatre.
 */
#ifndef SIMULATE_H
#define SIMULATE_H

#include <stdint.h>

#include <cupola/rig.h>

#include "capture/camera.h"
#include "capture/photo.h"

struct simulation {
    const struct cupola_rig *rig; /* complete: what really stands there */
    int output;
    const struct camera *camera; /* fitted, with a pose */
    double exposure;             /* what light of 1 becomes in the middle of the picture */
    double ambient;    /* light on an unlit screen, as a part of what the projector throws */
    double vignetting; /* what is missing in the corners: 0.3 leaves 0.7 */
    double blur_px;    /* standard deviation of the lens's blur, px */
    double noise; /* standard deviation at full white; a quarter of its variance is always there */
    uint64_t seed;
};

struct simulator;

/*
 * Ordinary cameras see the library's simulated theatre, where there is a GL; all others, and
 * without a GL, by rays. NULL with one line in `message`, MESSAGE_SIZE bytes.
 */
struct simulator *simulator_create(const struct simulation *simulation, char *message);

/* By rays in any case. */
struct simulator *simulator_create_by_rays(const struct simulation *simulation, char *message);

/* Whether it draws by the GL. */
bool simulator_uses_gl(const struct simulator *simulator);

/*
 * Photographs a picture of the projector's size. The photograph is of the camera's size, and made
 * here. False with one line in `message`.
 */
bool simulator_take(struct simulator *simulator, const struct photo *shown, struct photo *photo,
                    char *message);

/* NULL is allowed. */
void simulator_destroy(struct simulator *simulator);

#endif
