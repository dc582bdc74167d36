/* A scene into the views of a plan: one by one, or all of them in one pass. */
#ifndef SUBMISSION_H
#define SUBMISSION_H

#include <cupola/one_pass.h>

#include "grid.h"
#include "scene.h"

struct submission {
    cupola_gl *gl;
    const cupola_plan *plan;
    const cupola_dome *dome;
    bool stencil;  /* what no pixel samples is masked there: see cupola/gl.h */
    bool one_pass; /* for a gl, a scene and a grid that have been made for that */
    struct scene *scene;
    struct grid *grid; /* drawn over every view; NULL: none */
};

/* Of the camera, views and passes are set here. False with a reason in the error. */
bool submission_draw(const struct submission *submission, const struct cupola_frame *frame,
                     struct scene_camera camera, struct cupola_error *error);

#endif
