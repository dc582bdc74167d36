/* Triangles of one colour, drawn as a host draws them: by a view's matrices. */
#ifndef TRIANGLES_H
#define TRIANGLES_H

#include <epoxy/gl.h>

#include "cupola/cupola.h"

struct triangles {
    GLuint program, vertex_array, buffer;
};

struct triangles triangles_create(void);
void triangles_release(const struct triangles *triangles);

/* Points of the host's camera frame, three for each triangle; leaves its objects bound. */
void triangles_draw(const struct triangles *triangles, const struct cupola_camera *camera,
                    const float color[4], float (*points)[3], int count);

/*
 * Two triangles over a view's base rectangle that make one plane. Its nearness, 1 / distance along
 * the view's axis, is nearness[0] + nearness[1] x + nearness[2] y, x and y from -1 to 1 over the
 * view; above 0 everywhere.
 */
void plane_over_view(const cupola_plan *plan, int view, const double nearness[3],
                     float points[6][3]);

#endif
