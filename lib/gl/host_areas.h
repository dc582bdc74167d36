/*
 * The viewports and scissor rectangles that only a pass over all views changes, those of index 1
 * and above; host_state.h has index 0. For contexts with viewport arrays.
 */
#ifndef HOST_AREAS_H
#define HOST_AREAS_H

#include <epoxy/gl.h>

#include "cupola/plan.h"

struct host_areas {
    int count; /* index 0 is not in here, but counts */
    GLfloat viewports[CUPOLA_VIEWS_MAX][4];
    GLint scissors[CUPOLA_VIEWS_MAX][4];
    GLboolean tests[CUPOLA_VIEWS_MAX];
};

void host_areas_save(struct host_areas *areas, int count);
void host_areas_restore(const struct host_areas *areas);

/* Sets viewport and scissor rectangle of one index, 0 included. */
void host_areas_set(int index, const struct cupola_rect *rect);

#endif
