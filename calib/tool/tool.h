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
#include "tool/parameters.h"
#include "tool/tool_files.h"
#include "viewer_osc.h"

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
    PATTERN_DOT,       /* one dot, steered by group dot */
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
    ABOUT_COUNT
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
    double cross_px[2]; /* where the cross-hair is; within the image */

    bool shows_legend; /* current values with units */
    bool text_on_dome; /* legend, help, warning and notice: upright as the viewer sees the dome;
                        * else plain, over the window */
    bool shows_labels; /* degrees and values on the dome */
    bool shows_help;
    enum preview preview;
    bool viewer_lives; /* the eye comes from a tracker */
    double live_eye_m[3];
    struct {
        char address[80]; /* that is listened on; empty: none is */
        struct viewer_osc_counts counts;
    } tracker;

    char warning[MESSAGE_SIZE];  /* why the last change was impossible; empty: it was not */
    char standing[MESSAGE_SIZE]; /* likewise, until its cause goes: no journal can be written */
    char notice[MESSAGE_SIZE];   /* what happened: "saved lobby.cfg" */
    bool unsaved;
    bool ends;
    bool wants_fullscreen; /* F11: the other way; whoever does it makes it false again */
    bool wants_picture;    /* of what the window shows; whoever writes it makes it false again */
    double time_s;         /* now, by any clock that goes forward; set before keys and mouse */

    char *rig_path;          /* to save to */
    char *marks_path;        /* likewise; NULL without marks */
    struct tool_files files; /* that it was begun with */
    struct history *history;
    struct journal *journal; /* NULL: none is kept */

    struct marks saved_marks; /* pixels as they are in the file */
    bool asked_to_quit;       /* Escape once, with unsaved changes */
    bool drags;               /* the mouse's button is down */
    double mouse_px[2];       /* beside the image until it is known */
    int drag;                 /* number of the present or last drag: one is one step of history */
};

/*
 * Begins with a complete rig. The marks become the tool's own, also on failure; paths are copied.
 * There is no journal yet. False with one line in `message`.
 */
bool tool_open(struct tool *tool, const struct cupola_rig *rig, int output, struct marks *marks,
               const char *rig_path, const char *marks_path, char *message);

/* Gives everything back; the journal goes if nothing is unsaved. */
void tool_close(struct tool *tool);

/* The rig that is shown: before or after, with the eye where it is at the moment. */
void tool_shown_rig(const struct tool *tool, struct cupola_rig *rig);

/* How far from the centre of a screen of this radius an eye that moves may be. */
double tool_eye_reach_m(double radius_m);

/* Where a tracker has the eye, kept in reach within such a screen; untouched where none has one. */
void tool_live_eye(const struct tool *tool, double radius_m, double eye_m[3]);

/* The three values of a group, in the order of the arrow keys; false where a place has none. */
bool tool_group_parameter(const struct tool *tool, int which, enum parameter *parameter);

/* "projector position", "image circle". */
const char *tool_group_name(enum group group);
/* "position", "circle", as scripts have it; NULL beyond the last. */
const char *tool_group_word(int group);
/* "grid", as scripts and --pattern have it; NULL beyond the last. */
const char *tool_pattern_name(int pattern);
/* "dome", "viewer"; "none", "eye", "outside"; NULL beyond the last. */
const char *tool_about_name(int about);
const char *tool_preview_name(int preview);

/*
 * A key of GLFW with its modifiers, pressed or repeated while it is held. What repetition makes no
 * sense for ignores it. Returns whether the key means anything.
 */
bool tool_key(struct tool *tool, int key, int modifiers);
bool tool_key_repeat(struct tool *tool, int key, int modifiers);

/*
 * The mouse, continuous pixels of the output, origin bottom left; and its button. It may be beside
 * the image: no drag begins there, but one that began in it goes on.
 */
void tool_mouse(struct tool *tool, double x_px, double y_px);
void tool_mouse_button(struct tool *tool, bool pressed);

/* Sets one value, in the unit of its name, as a step of history. False with a warning. */
bool tool_set(struct tool *tool, enum parameter parameter, double value);

/*
 * Makes whatever differs from the last step a step of history: `values` as they were before, `mark`
 * an index or -1 with its state before. Steps of the same key within a moment become one; -1 never.
 */
struct mark_state;
void tool_commit(struct tool *tool, const struct values *before, int mark,
                 const struct mark_state *mark_before, int key);

void tool_undo(struct tool *tool);
void tool_redo(struct tool *tool);

/* Saves the rig, and marks that have pixels or had some in the file. False with a warning. */
bool tool_save(struct tool *tool, const char *rig_path);

/*
 * Gives the image another size: circle, cross-hair, pixels of marks, and all of history keep their
 * place in the picture (cupola_output_resize). False with a warning.
 */
bool tool_resize(struct tool *tool, int width_px, int height_px);

/* All that is warned of now, with `between` between what stays and what the last change did. */
void tool_warnings(const struct tool *tool, const char *between, char text[2 * MESSAGE_SIZE]);

/* To be called every frame: brings the journal to the disk now and then. */
void tool_idle(struct tool *tool);

/* The command: cupola-calib ... without a further name. Returns its exit status. */
int tool_main(int argc, char **argv);

#endif
