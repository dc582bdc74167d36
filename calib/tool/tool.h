/*
 * The state of the interactive tool and what may be done with it. There is no GL and no window in
 * it: keys come from a window or a script, and a frame is drawn from what stands here.
 */
#ifndef TOOL_H
#define TOOL_H

#include <stdbool.h>

#include <cupola/rig.h>

#include "marks.h"
#include "option_values.h"

struct history; /* history.h */
struct journal; /* journal.h */

/* What the projector shows. All but the cross-hair lives on the dome. */
enum pattern {
    PATTERN_GRID,      /* latitude and longitude, with degrees */
    PATTERN_MERIDIANS, /* through the viewer's straight ahead */
    PATTERN_CIRCLES,   /* concentric round it */
    PATTERN_CHECKER,   /* fields of equal solid angle */
    PATTERN_WEDGES,    /* for resolution and focus */
    PATTERN_RAMPS,     /* colours and greys */
    PATTERN_RIM,       /* rim of the screen, image circle, frame of the image */
    PATTERN_DOT,       /* one dot, steered by the arrow keys */
    PATTERN_COUNT
};

/* Which values the arrow keys change: left and right, up and down, page up and down. */
enum group {
    GROUP_CIRCLE,   /* centre x, centre y, radius */
    GROUP_LENS,     /* which coefficient, its value, field of view */
    GROUP_POSITION, /* of the projector: x, y, z */
    GROUP_AIM,      /* yaw, pitch, roll */
    GROUP_SCREEN,   /* tilt, cap, radius */
    GROUP_VIEWER,   /* x, y, z */
    GROUP_DOT,      /* the dot's yaw and pitch, its size */
    GROUP_MARKS,    /* the cross-hair: x, y; which mark */
    GROUP_COUNT
};

/* What is round a centre: the grid and its like. */
enum about {
    ABOUT_DOME,   /* the dome's own coordinates: the same for every viewer */
    ABOUT_VIEWER, /* the viewer's directions: straight ahead is the middle */
};

/* What the window shows beside the image. */
enum preview {
    PREVIEW_NONE,
    PREVIEW_EYE,     /* the simulated theatre from the viewer's eye, beside the image */
    PREVIEW_OUTSIDE, /* from outside */
    PREVIEW_COUNT
};

struct tool {
    struct cupola_rig rig;     /* complete, as it is now */
    struct cupola_rig before;  /* as it was at the start, or when it was saved last */
    struct cupola_rig theatre; /* what really stands there, for the preview */
    bool shows_before;
    int output; /* index of the projector that is set up */

    enum pattern pattern;
    enum about about;
    enum group group;
    int coefficient;                                 /* of a polynomial: 0 to 3 */
    double step_scale;                               /* 1; fine 0.1; coarse 10 */
    double dot_yaw_rad, dot_pitch_rad, dot_size_rad; /* from the viewer's straight ahead */

    struct marks marks; /* to be steered to; may be none */
    int mark;           /* index of the one that is being steered to */
    double cross_px[2]; /* where the cross-hair is */

    bool shows_legend; /* current values with units */
    bool text_on_dome; /* legend, help, warning and notice: upright as the viewer sees the dome;
                        * else plain, over the window */
    bool shows_labels; /* degrees and values on the dome */
    bool shows_help;
    enum preview preview;
    bool viewer_lives; /* the eye comes from a tracker */
    double live_eye_m[3];

    char warning[MESSAGE_SIZE]; /* why the last change was impossible; empty: it was not */
    char notice[MESSAGE_SIZE];  /* what happened: "saved lobby.cfg" */
    bool unsaved;
    bool ends;
    bool wants_picture;

    char *rig_path;   /* to save to */
    char *marks_path; /* likewise */
    struct history *history;
    struct journal *journal;
};

/* The rig that is shown: before or after, with the eye where it is at the moment. */
void tool_shown_rig(const struct tool *tool, struct cupola_rig *rig);

/* The command: cupola-calib ... without a further name. Returns its exit status. */
int tool_main(int argc, char **argv);

#endif
