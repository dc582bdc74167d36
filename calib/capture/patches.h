/*
 * Patches: from places of single pixels to fewer and more exact ones. Over each small square of the
 * photograph a smooth surface is fitted to the projector's places; what it says in the middle of
 * the square's decoded pixels has their noise averaged and wrong codes left out.
 */
#ifndef PATCHES_H
#define PATCHES_H

#include "capture/code_map.h"

struct patch {
    double camera_px[2];    /* of the photograph; both continuous, origin bottom left */
    double projector_px[2]; /* of the projector's image */
    double sd_px[2];        /* of projector_px, as the surface's own residuals say */
};

struct patches {
    struct patch *list;
    int count;
    int thin;  /* squares left out because too few of their pixels are decoded */
    int rough; /* squares left out because the places are not smooth there */
};

enum { PATCHES_MAX = 10000 };

/*
 * About `wanted` patches, spread evenly over what is decoded. False with one line in `message`,
 * MESSAGE_SIZE bytes, without memory; none at all is no failure.
 */
bool patches_find(const struct code_map *map, int wanted, struct patches *patches, char *message);

void patches_free(struct patches *patches);

#endif
