/*
 * From marks to a rig: where the projector stands, where it aims, and what else the marks can tell,
 * by least squares over the pixels of the marks, with wrong marks found and left out.
 */
#ifndef SOLVE_H
#define SOLVE_H

#include <cupola/rig.h>

#include "marks.h"

/* What may be solved for; combine with |. */
enum solve_free {
    SOLVE_CIRCLE = 1,        /* the centre of the image circle */
    SOLVE_CIRCLE_RADIUS = 2, /* its radius */
    SOLVE_LENS = 4,          /* the field of view, and of a polynomial its coefficients */
    SOLVE_POSITION = 8,      /* of the projector */
    SOLVE_AIM = 16,
    SOLVE_RADIUS = 32, /* of the screen; marks that are points tell it by their distances */
};

struct solve_request {
    const struct cupola_rig *start; /* 0 means the default in every member */
    int output;                     /* index of the projector */
    const struct marks *marks;      /* each with a pixel */
    int free;                       /* of enum solve_free; 0: position and aim */
    bool flips;                     /* the picture may be mirrored otherwise than in the start */
};

enum { SOLVE_WARNINGS_MAX = 24, SOLVE_WARNING_SIZE = 240 };

/* What became of one mark. */
struct solve_mark {
    double residual_px[2]; /* its pixel less that of the solved rig */
    bool rejected;
};

/* Standard deviations of values that were not free are 0. */
struct solve_result {
    struct cupola_rig rig; /* as the start, but for what was free */
    int free;              /* of enum solve_free */
    double position_sd_m[3];
    double aim_sd_rad[3]; /* yaw, pitch, roll */
    double turn_sd_rad;   /* of yaw less roll where pitch is above 0, of their sum elsewhere */
    double fov_sd_rad;
    double k_sd[4];
    double circle_sd_px[3]; /* centre, radius */
    double radius_sd_m;
    double noise_px;         /* per coordinate, as estimated from the residuals */
    double rms_px;           /* of the residuals' lengths, rejected marks left out */
    double worst_px;         /* their longest */
    double direction_sd_rad; /* of the viewer's directions: median over what the projector lights */
    double worst_direction_sd_rad;
    struct solve_mark *marks; /* as many as there are marks */
    int rejected;             /* how many */
    int warning_count;
    char warnings[SOLVE_WARNINGS_MAX]
                 [SOLVE_WARNING_SIZE]; /* what the marks tell badly, and so on */
};

/*
 * Solves. False with one line in `message`, MESSAGE_SIZE bytes, where the marks cannot determine
 * what is free: which value, why, and what would help; nothing is then to be freed.
 */
bool solve(const struct solve_request *request, struct solve_result *result, char *message);

void solve_result_free(struct solve_result *result);

/*
 * A list as on the command line, "position,aim", as enum solve_free. False with one line in
 * `message` that begins with `option`.
 */
bool solve_free_parse(const char *option, const char *text, int *free, char *message);

/* The names of such lists by index, and NULL beyond; what the index-th stands for is 1 << index. */
const char *solve_free_name(int index);

/* "none", "x", "y" or "xy" by CUPOLA_FLIP_X and CUPOLA_FLIP_Y, as in rig files; NULL beyond. */
const char *solve_flip_name(int flip);

/* The command: cupola-calib solve ... Returns its exit status. */
int solve_main(int argc, char **argv);

#endif
