/* The unknowns of pose.h as one vector of numbers, and what they should make 0. */
#ifndef POSE_MODEL_H
#define POSE_MODEL_H

#include "capture/pose.h"

enum {
    POSE_CAMERA_POSITION = 0, /* m, from the start */
    POSE_CAMERA_TURN = 3,     /* rad, vector of a rotation of the start */
    POSE_CAMERA_FOV = 6,      /* rad, from the start */
    POSE_CAMERA_CENTER = 7,   /* px, from the start */
    POSE_PROJECTOR_POSITION = 9,
    POSE_PROJECTOR_TURN = 12,
    POSE_UNKNOWNS = 15,
};

/* As somebody points at places of a photograph. */
#define POSE_REFERENCE_SD_PX 0.5

struct pose_model {
    const struct pose_request *request;
    const bool *rejected;        /* per patch */
    double start_projector[9];   /* its rotation */
    struct cupola_output lens;   /* the projector at the origin, not turned */
    int unknowns[POSE_UNKNOWNS]; /* which of them are free */
    int unknown_count;
    int left_out; /* reference that does not count; -1: none */
    double patch_sd_px,
        reference_sd_px; /* one coordinate, of the projector's image and the photo */
};

void pose_model_begin(const struct pose_request *request, const bool *rejected,
                      struct pose_model *model);

/* Two for each patch and three for each reference. */
int pose_model_residual_count(const struct pose_model *model);

/*
 * What free numbers mean. Each is 1 at the start and not 0: lmdif makes its steps as parts of them.
 */
void pose_model_apply(const struct pose_model *model, const double *numbers, struct camera *camera,
                      double projector_m[3], double projector_turn[9]);

/* In standard deviations; those of rejected patches are 0. */
void pose_model_residuals(const struct pose_model *model, const double *numbers, double *residuals);

/*
 * How far a patch's place is from the projector's, px, and a reference's ray from its point, in
 * angles of the pixel in the middle of the photograph.
 */
double pose_model_patch_px(const struct pose_model *model, const double *residuals, int patch);
double pose_model_reference_px(const struct pose_model *model, const double *residuals,
                               int reference);

#endif
