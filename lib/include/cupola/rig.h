/*
 * The rig: what stands in the theatre. Screen, projectors ("outputs"), the viewer's eye, the tilt.
 *
 * A rig is a plain value: copy it, keep it for an undo, compare it. Zero means the default in every
 * member, so `struct cupola_rig rig = {0}` is a domemaster of 1024 x 1024 pixels without tilt.
 *
 * Frames: right-handed, +X right, +Y up, -Z forward. The dome frame has its origin at the centre of
 * the screen sphere and -Z along the dome's axis (its pole). A vector w of the dome frame is
 * R_x(tilt) w in the frame of the host's camera, which stands at the centre of the dome.
 * Image coordinates are continuous with the origin at the bottom left; the centre of pixel (i, j)
 * is (i + 1/2, j + 1/2).
 */
#ifndef CUPOLA_RIG_H
#define CUPOLA_RIG_H

#include "lens.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { CUPOLA_OUTPUTS_MAX = 8 /* projectors in a rig */ };

/* The inside of a sphere round the origin of the dome frame, cut off at a cap round its axis. */
struct cupola_screen {
    double radius_m; /* 1e-6 to 1000; 0: 1 m */
    double cap_rad;  /* half-angle round the dome's axis, above 0 and up to pi; 0: pi, no limit */
};

/* Where the lens lands in the frame buffer. It may reach beyond it ("truncated dome"). */
struct cupola_circle {
    double center_x_px; /* from -1e7 to 1e7 */
    double center_y_px; /* from the bottom; from -1e7 to 1e7 */
    double radius_px;   /* 0: the largest circle that fits, in the middle; the centre is ignored.
                       * Else 1e-6 to 1e6; the circle must meet the frame buffer. */
};

/*
 * Q = R_y(yaw) R_x(pitch) R_z(roll), by the right-hand rule, applied to a lens that looks along
 * -Z: positive yaw turns left, positive pitch up, positive roll counter-clockwise as seen along the
 * axis. Each from -2 pi to 2 pi.
 */
struct cupola_aim {
    double yaw_rad;   /* to the left */
    double pitch_rad; /* up */
    double roll_rad;  /* counter-clockwise */
};

/* Mirrors the picture about the centre of the image circle, for rear projection; combine with |. */
enum cupola_flip {
    CUPOLA_FLIP_NONE = 0, /* as it is */
    CUPOLA_FLIP_X = 1,    /* left and right change places */
    CUPOLA_FLIP_Y = 2,    /* top and bottom change places */
};

/* One projector. */
struct cupola_output {
    int width_px;                /* of the frame buffer, 1 to 32768; 0: 1024 */
    int height_px;               /* of the frame buffer, 1 to 32768; 0: 1024 */
    struct cupola_circle circle; /* the image circle; all 0: the largest, in the middle */
    int flip;                    /* of enum cupola_flip */
    struct cupola_lens lens;     /* all 0: angular, 180 degrees */
    double position_m[3];        /* of the lens, dome frame; inside the screen sphere */
    struct cupola_aim aim;       /* of the lens, in the dome frame */
};

/* A whole theatre. */
struct cupola_rig {
    struct cupola_screen screen; /* all 0: a sphere of 1 m without limit */
    double eye_m[3];             /* the viewer's eye, dome frame; inside the screen sphere */
    double tilt_rad;        /* -pi to pi; 0: axis along the line of sight; pi/2: a planetarium */
    double units_per_metre; /* scene units in one metre, above 0 and up to 1e9; 0: 1 */
    int output_count;       /* 1 to CUPOLA_OUTPUTS_MAX; 0: 1 */
    struct cupola_output outputs[CUPOLA_OUTPUTS_MAX]; /* the first output_count of them count */
};

/*
 * A rig by name.
 *
 *   visionstation    1024 x 768, angular lens of 180 degrees, circle (512, 384, 512): 180 x 135
 *                    degrees are lit; R = 0.75 m and cap 90 degrees. The maker published image size
 *                    and opening; that projector and viewer are at the centre is assumed.
 *   domemaster       1024 x 1024, full circle, angular 180 degrees, tilt 90 degrees
 *   truncated-16x10  1920 x 1200, angular 180 degrees, circle (960, 600, 960): as wide as the
 *                    projector's image, cut off at top and bottom
 *
 * name     one of the names above
 * rig      out: complete, defaults filled in
 * error    may be NULL
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT with the names that exist
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_rig_preset(const char *name, struct cupola_rig *rig,
                                 struct cupola_error *error);

/*
 * The names of the presets.
 *
 * index    0, 1, ... until it returns NULL
 * returns  a static string, or NULL where there are no more
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_rig_preset_name(int index);

/*
 * Checks every value of a rig and fills in the defaults, so that the result holds no zero that
 * stands for something else.
 *
 * rig       as the user wrote it
 * complete  out; may be rig itself, may be NULL to check only
 * error     may be NULL
 * returns   CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT with the value and what is allowed
 * thread    any
 * since     0.1
 */
CUPOLA_API int cupola_rig_complete(const struct cupola_rig *rig, struct cupola_rig *complete,
                                   struct cupola_error *error);

/*
 * Gives an output another size and lets its image circle keep its place: everything scales by the
 * smaller of the two ratios and the rest is divided evenly on both sides (letterbox).
 *
 * output   changed; a size or circle of 0 counts as its default
 * width_px, height_px
 *          the new size of its frame buffer, 1 to 32768
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT where a size is outside 1 to 32768
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_output_resize(struct cupola_output *output, int width_px, int height_px,
                                    struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
