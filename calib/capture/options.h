/* The command line of `cupola-calib capture`. */
#ifndef CAPTURE_OPTIONS_H
#define CAPTURE_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include <cupola/rig.h>

#include "capture/photo.h"

enum capture_command {
    CAPTURE_PATTERNS, /* write the pictures that the projector shows */
    CAPTURE_SHOW,     /* show them, and photograph them */
    CAPTURE_DECODE,   /* marks from photographs */
    CAPTURE_SIMULATE, /* photographs of a simulated theatre */
    CAPTURE_COMMANDS
};

/* NULL, 0 or false where the command line says nothing, unless a default is named. */
struct capture_options {
    enum capture_command command;
    bool help;
    const char *rig;
    int projector; /* index */
    const char *folder;
    const char *patterns;
    int period_px, steps; /* 0: by the size; 4 */

    int monitor; /* index; -1: the first */
    bool window;
    double every_s; /* 0: by keys, or as fast as the camera allows */
    const char *device;
    int shots;  /* 1 */
    int settle; /* 5 */

    char **photos;
    int photo_count;
    bool linear;
    double contrast; /* 0.02 */
    int marks;       /* 300 */
    const char *output;
    const char *solved;

    const char *camera;
    const char *references;
    bool circle_given, position_given, aim_given;
    struct cupola_circle circle;
    double position_m[3];
    struct cupola_aim aim;
    int free; /* of enum pose_free */

    int width, height; /* of photographs; 0: 1280x960, or the device's own */
    double noise, vignetting, ambient, blur_px;
    double exposure; /* 0.8 */
    uint64_t seed;
    enum photo_format format;
};

/* Returns STATUS_OK or STATUS_USAGE with one line in `message`, MESSAGE_SIZE bytes. */
int capture_options_parse(int argc, char **argv, struct capture_options *options, char *message);

/* "patterns"; NULL beyond. */
const char *capture_command_name(int index);

/* Prints what `cupola-calib capture --help` says. */
void capture_help(void);

#endif
