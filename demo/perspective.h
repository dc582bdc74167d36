/* Cameras without a plan: one plain view, a face of a cube. */
#ifndef PERSPECTIVE_H
#define PERSPECTIVE_H

#include <cupola/plan.h>

struct perspective {
    double rotation[9]; /* rows: right, up and backward axes in the host's camera frame */
    double eye[3];      /* host's camera frame, scene units */
    double left;        /* of the base rectangle at distance 1, as: */
    double right;       /* above left */
    double bottom;      /* lower edge */
    double top;         /* above bottom */
    double near_distance;
    double far_distance;
};

/* Matrices and planes as cupola_plan_camera gives them, with depth from -1 to 1. */
void perspective_camera(const struct perspective *perspective, struct cupola_camera *camera);

#endif
