/*
 * The command line of cupola-demo. What was not given is marked, so that a rig file or preset keeps
 * its own value.
 */
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stdbool.h>

#include <cupola/gl.h>

#include "marks.h"
#include "option_values.h"
#include "scene.h"

enum { STATUS_OK = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

enum show_mode {
    SHOW_DOME = 0,
    SHOW_PERSPECTIVE,
    SHOW_VIEWS,
    SHOW_PREVIEW_EYE,
    SHOW_PREVIEW_OUTSIDE,
    SHOW_MAP,
};

enum scene_kind { SCENE_CUBE = 0, SCENE_DIRECTIONS, SCENE_SCREEN, SCENE_FOREST };

enum submission_wish { SUBMISSION_AUTO = 0, SUBMISSION_LOOP, SUBMISSION_ONCE };

/* A number or some that may be missing. */
struct optional {
    bool given;
    double value[4];
};

struct options {
    char *const *words; /* of the command line, without the program's name */
    int word_count;

    bool help;
    bool version;

    const char *model; /* NULL: a built-in scene */
    bool scene_given;
    enum scene_kind scene;
    bool flat;
    int shading;   /* -1: not given; else of enum scene_shading */
    int triangles; /* 0: not given */
    int seed;      /* -1: not given */

    const char *show; /* a file, or a pattern of names; NULL: the scene */
    enum cupola_source_kind show_as;
    struct optional frame_rate;
    struct optional picture_fov_rad;
    struct optional picture_aim_rad;
    enum cupola_source_place picture_place;

    struct mark marks[MARKS_MAX];
    int mark_count;

    struct optional camera;
    struct optional look;
    struct optional up;

    const char *rig;
    const char *save_rig;
    const char *preset;
    int lens; /* -1: not given; else of enum cupola_lens_model */
    struct optional fov_rad;
    struct optional lens_k;
    const char *lens_table;
    int flip;      /* -1: not given; else of enum cupola_flip */
    int width_px;  /* 0: not given */
    int height_px; /* 0: not given */
    struct optional circle_px;
    struct optional tilt_rad;
    struct optional cap_rad;
    struct optional viewer_m;
    struct optional projector_m;
    struct optional aim_rad;
    struct optional radius_m;

    bool views_given; /* any of the options about views */
    bool table_given;
    bool plan_given; /* any of those that one perspective view has no use for */
    struct cupola_plan_params plan;
    bool goal_auto; /* the plan's prices are measured */
    struct optional head_radius_m, eye_circle_m;
    const char *osc; /* where a tracker reports the eye to; NULL: nowhere */
    struct optional lookahead_ms;
    enum cupola_table table;
    int view_format; /* -1: not given; else of enum cupola_format */
    int samples;     /* per texel of a view; 0: not given */
    struct cupola_filter filter;
    int dither_bits;
    bool filter_given, pattern_given; /* any of the options about antialiasing; about patterns */
    bool aa_given;
    bool reversed_depth;
    int mask; /* of enum cupola_mask */
    enum submission_wish submission;
    enum show_mode mode;
    int show_output; /* index; -1: not given */

    bool headless;
    int frames;    /* 0: not given */
    int reference; /* frames of which a picture is the mean; 0: not given */
    const char *output;
    const char *stats;  /* "-": stdout */
    const char *report; /* likewise */

    int monitor; /* -1: not given */
    bool fullscreen;
    int swap_interval; /* -1: not given */
};

/*
 * Reads a command line. Returns STATUS_OK or STATUS_USAGE with one line in message (MESSAGE_SIZE
 * bytes). Strings point into argv.
 */
int options_parse(int argc, char **argv, struct options *options, char *message);

/*
 * The rig that the options ask for: preset, then rig file, then the options themselves, which
 * change the output that is shown; complete and possible. STATUS_OK, STATUS_USAGE where options
 * contradict each other or the rig, or STATUS_FAILED.
 */
int options_rig(const struct options *options, struct cupola_rig *rig, char *message);

/* The index of the output that is shown, and that the options change. */
int options_output(const struct options *options);

/* What the options wish of a scene. */
struct scene_wishes options_scene_wishes(const struct options *options);

/* Whether the plan's prices are to be measured, by drawing the scene's views. */
bool options_time_views(const struct options *options);

/* Whether the scene's colours are numbers. */
bool options_scene_is_numbers(const struct options *options);

/* Says on stderr that only one of the rig's outputs is shown, unless the user chose it. */
void options_notice(const struct options *options, const struct cupola_rig *rig);

/* Prints --help to stdout. */
void options_print_help(void);

#endif
