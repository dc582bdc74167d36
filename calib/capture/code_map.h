/*
 * What photographs of a series say of every pixel of the camera: the place in the projector's image
 * that lights what it sees, and how sure that is.
 */
#ifndef CODE_MAP_H
#define CODE_MAP_H

#include "capture/code_check.h"
#include "capture/photo.h"
#include "capture/series.h"

/* Why a pixel of the camera has no place, the first of them that holds. */
enum code_state {
    CODE_DECODED,
    CODE_SATURATED, /* as bright as the file holds: its sines would be cut off */
    CODE_DARK,      /* too little contrast between all light and none */
    CODE_UNSURE,    /* bits too faint, sines too weak, or code and phase disagree */
    CODE_NOISY,     /* the place would be off by more than an eighth of a period */
    CODE_NO_NUMBER, /* in one of the photographs that decide */
    CODE_STATES
};

struct code_map {
    int width;
    int height;
    float *place_px[2];   /* of the projector's image, continuous, origin bottom left */
    float *sd_px[2];      /* its standard deviation as the noise predicts it */
    unsigned char *state; /* of enum code_state */
    int counts[CODE_STATES];
    /* Of one photograph, half way between none and all of the projector's light, ambient light
     * included; the median of what is decoded. 1: all that a photograph holds. */
    double noise;
    struct code_check check;
    double contrast; /* median between all light and none of what is decoded; 0: nothing is */
};

struct code_settings {
    const struct series *series;
    char *const *paths; /* one photograph for each picture of the series, in its order */
    enum photo_encoding encoding;
    double least_contrast; /* light */
};

/*
 * Reads the photographs one after the other. False with one line in `message`, MESSAGE_SIZE bytes,
 * and nothing to be freed. A map without a decoded pixel is no failure.
 */
bool code_map_read(const struct code_settings *settings, struct code_map *map, char *message);

void code_map_free(struct code_map *map);

/* "dark" and so on, for reports. */
const char *code_state_text(enum code_state state);

#endif
