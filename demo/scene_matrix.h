/*
 * What scenes compute from a camera's matrices: in double, since a view's matrices are products of
 * several floats already.
 */
#ifndef SCENE_MATRIX_H
#define SCENE_MATRIX_H

#include <stdbool.h>

#include "scene.h"

/* projection view, and projection view host; column-major. */
void scene_clip_from_camera(const struct scene_camera *camera, double clip[16]);
void scene_clip_from_world(const struct scene_camera *camera, double clip[16]);

/*
 * The rays of a perspective view: in the frame that `clip` starts from, the ray of the place (x, y)
 * of a view, in normalised device coordinates, points along basis (x, y, 1). Not of unit length,
 * always forward, and independent of near and far. basis is column-major; eye is where all rays
 * start. False for a matrix that is no perspective.
 */
bool scene_rays(const double clip[16], double basis[9], double eye[3]);

void scene_to_float(const double *from, int count, float *to);

#endif
