/*
 * Light that is added up by blending before it is encoded: sums of codes are not codes of sums. A
 * texture of half floats; where OpenGL ES cannot draw into such, one of sRGB, in which the GL
 * itself blends linear light, to half a step of 8 bits for each addition.
 */
#ifndef LIGHT_SUM_H
#define LIGHT_SUM_H

#include "instance.h"

struct light_sum {
    GLuint program; /* 0 where nothing is ever added */
    GLint target_corner;
    GLuint texture, framebuffer; /* 0 until they are needed */
    int width, height;
};

int light_sum_create(const struct guest *guest, struct light_sum *sum, struct cupola_error *error);
void light_sum_destroy(struct light_sum *sum);

/*
 * With the host's state saved: has the next passes draw into the sum, from its corner on, instead
 * of the target; makes the texture anew where its size is another.
 */
int light_sum_begin(const struct guest *guest, struct light_sum *sum, int width, int height,
                    struct cupola_error *error);

/* Encodes the sum into the target. */
void light_sum_end(const struct guest *guest, const struct light_sum *sum, GLuint vertex_array,
                   struct cupola_target place);

#endif
