/*
 * The host's own camera: where the dome's centre stands in the world and which way it looks. It
 * also knows how near and far a scene is.
 */
#ifndef HOST_CAMERA_H
#define HOST_CAMERA_H

#include <stdbool.h>
#include <stddef.h>

#include "scene.h"

struct host_camera {
    double place[3];    /* world */
    double rotation[9]; /* rows: right, up and backward axes, world */
};

/*
 * A camera at `place` that looks at the point `look` (NULL: along -Z) with `up` upwards (NULL: +Y).
 * False with one line in `message` where these do not define a rotation.
 */
bool host_camera_set(struct host_camera *camera, const double place[3], const double *look,
                     const double *up, char *message, size_t message_size);

/* World to camera frame, column-major. */
void host_camera_matrix(const struct host_camera *camera, float matrix[16]);

/* The rig's eye in the camera's frame (scene units), and in the world. */
void host_camera_eye(const struct host_camera *camera, const cupola_dome *dome, double eye[3],
                     double world[3]);

/* Moves along its own axes: right, up, backward. */
void host_camera_move(struct host_camera *camera, const double step[3]);

/* Turns to the left about the world's direction `up`, then upwards about its own right axis. */
void host_camera_turn(struct host_camera *camera, const double up[3], double yaw_rad,
                      double pitch_rad);

/* How near the scene is, remembered so that a camera that moves seldom has to ask. */
struct scene_range {
    bool known;
    double place[3]; /* where the distance was asked for last */
    double distance;
};

/*
 * Near and far along the axis of any view from `eye` (world), so that nothing is cut off.
 */
void scene_range_update(struct scene_range *range, const struct scene *scene, const double eye[3],
                        double *near_distance, double *far_distance);

#endif
