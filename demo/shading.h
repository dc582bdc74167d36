/* Programs of surfaces: one vertex and one fragment shader, and the light that falls on them. */
#ifndef SHADING_H
#define SHADING_H

#include "scene_views.h"

/* Where a scene's lamps hang: evenly over a sphere, from `lowest` up to its top, 1. */
struct shading_lamps {
    double center[3]; /* world */
    double radius;
    double lowest;   /* -1 to below 1 */
    double light;    /* in the middle, of all lamps together; 0: 1 */
    float bump_size; /* width of the coarsest bumps, world units */
    float smoothest; /* the least roughness of surfaces, above 0 and up to 0.6; 0: 0.25 */
};

/* Towards the sun, unit length: over the left shoulder of someone who looks along -Z. */
extern const float shading_sun[3];

/*
 * The source's fragment shader has no #version and calls vec3 shaded(vec3 base, vec3 place, vec3
 * normal, vec3 eye), all in the world, the normal as interpolated on the side that is seen. Its
 * `functions` is that function for SCENE_LAMBERT. Uniforms are set; `eye` is the caller's. False
 * with one line in `message`, and nothing made.
 */
bool shading_programs_create(struct scene_programs *programs, const struct program_source *source,
                             const struct shading_lamps *lamps, const struct scene_wishes *wishes,
                             char *message, size_t message_size);

#endif
