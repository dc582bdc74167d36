/*
 * A camera of unknown pose, found together with the projector: a pixel of the photograph and the
 * projector's place that lights what it sees meet on the screen, a sphere of known radius. Turning
 * camera and projector together round the centre of the sphere changes nothing of that; so two or
 * more references, places of the photograph with known points, tell which way is which.
 */
#ifndef POSE_H
#define POSE_H

#include <cupola/rig.h>

#include "capture/camera.h"
#include "capture/patches.h"
#include "marks.h"

/* What of the camera is solved for; combine with |. The projector's position and aim always are. */
enum pose_free {
    POSE_POSITION = 1,
    POSE_AIM = 2,
    POSE_FOV = 4,    /* of an ordinary camera and of a fisheye */
    POSE_CENTER = 8, /* where the axis meets an ordinary camera's picture */
};

struct pose_request {
    const struct cupola_rig *rig; /* complete; its projector is the start */
    int output;
    const struct camera *camera; /* the start */
    int free;
    const struct patches *patches;
    const struct marks *references; /* their pixels are those of the photograph */
};

struct pose_result {
    struct camera camera;
    struct cupola_output projector;
    double camera_position_sd_m; /* each the largest of three */
    double camera_aim_sd_rad;
    double projector_position_sd_m;
    double projector_aim_sd_rad;
    double rms_px; /* of the projector's places, rejected ones left out */
    double worst_px;
    double reference_rms_px; /* of the photograph */
    int worst_reference;     /* index */
    double *reference_px;    /* each, of the photograph; NULL: nothing is known of them */
    bool *rejected;          /* per patch */
    int rejected_count;
};

/*
 * "pose,fov" as enum pose_free: position, aim, pose (both), fov, center. False with one line in
 * `message` that begins with `option`.
 */
bool pose_free_parse(const char *option, const char *text, int *free, char *message);

/*
 * False with one line in `message`, MESSAGE_SIZE bytes; `reference_px` then says how far each
 * reference is off as far as that is known. The result is to be freed in any case.
 */
bool pose_solve(const struct pose_request *request, struct pose_result *result, char *message);

void pose_result_free(struct pose_result *result);

#endif
