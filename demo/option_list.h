/* The names of cupola-demo's options. */
#ifndef OPTION_LIST_H
#define OPTION_LIST_H

#include <getopt.h>

/* The order makes groups: rig, plan, and what is drawn where. */
enum option_code {
    OPTION_HELP = 256,
    OPTION_VERSION,
    OPTION_SCENE,
    OPTION_FLAT,
    OPTION_CAMERA,
    OPTION_LOOK,
    OPTION_UP,
    OPTION_RIG,
    OPTION_SAVE_RIG,
    OPTION_PRESET,
    OPTION_LENS,
    OPTION_FOV,
    OPTION_LENS_K,
    OPTION_LENS_TABLE,
    OPTION_FLIP,
    OPTION_SIZE,
    OPTION_CIRCLE,
    OPTION_TILT,
    OPTION_CAP,
    OPTION_VIEWER,
    OPTION_PROJECTOR,
    OPTION_PROJECTOR_AIM,
    OPTION_RADIUS,
    OPTION_LAYOUT,
    OPTION_VIEWS,
    OPTION_DENSITY,
    OPTION_VIEW_SIZE,
    OPTION_GUARD,
    OPTION_TABLE,
    OPTION_PERSPECTIVE,
    OPTION_VIEWS_ONLY,
    OPTION_PREVIEW,
    OPTION_SHOW_OUTPUT,
    OPTION_HEADLESS,
    OPTION_FRAMES,
    OPTION_OUTPUT,
    OPTION_STATS,
    OPTION_MONITOR,
    OPTION_FULLSCREEN,
    OPTION_SWAP_INTERVAL,
};

/* For getopt_long. */
extern const struct option option_list[];

#endif
