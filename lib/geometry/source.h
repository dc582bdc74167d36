/*
 * From points of the screen to places in pictures; shaders/source.glsl says the same under the same
 * names.
 */
#ifndef SOURCE_PRIVATE_H
#define SOURCE_PRIVATE_H

#include "cupola/source.h"
#include "dome.h"

enum { SOURCE_KINDS = CUPOLA_SOURCE_CUBE + 1 };

/* A picture's frame: a point D of the screen lies at frame (D - center) in it. */
struct source_frame {
    double rotation[9];
    double center_m[3]; /* dome frame */
    double half_fov;    /* of a domemaster */
};

/* CUPOLA_ERROR_ARGUMENT for a field outside of its range; textures are not asked for. */
int source_check(const struct cupola_source *source, struct cupola_error *error);

/* For a source that has been checked and is not the views. */
void source_frame_prepare(const cupola_dome *dome, const struct cupola_source *source,
                          struct source_frame *frame);

/* In the picture's frame, not of unit length. */
void source_direction(const struct source_frame *frame, const struct varying *point,
                      struct varying *direction);

/*
 * Places in a picture from 0 to 1, {across, up}. A domemaster, whose shorter side is side_px, ends
 * at its rim: what is returned is the part of the pixel inside of it.
 */
double domemaster_place(const struct source_frame *frame, const struct varying *direction,
                        int side_px, double place[2]);
void equirectangular_place(const double direction[3], double place[2]);

/* Face 0 to 5 (+X, -X, +Y, -Y, +Z, -Z) and the place in it; OpenGL 3.3 core section 3.8.10. */
int cube_place(const double direction[3], double place[2]);

#endif
