/* What does not change while a cupola_gl lives, as constants of its shaders. */
#ifndef CONSTANTS_H
#define CONSTANTS_H

#include "instance.h"

/* 8 views of 9 + 9 + 4 + 4 + 3 numbers, 60 others, 20 characters each. */
enum { CONSTANTS_MAX = 8192 };

/*
 * RIG_BAKED and the constants of lens.glsl, points.glsl and views.glsl of one output, in place of
 * the uniforms of these names; measured lenses' knots stay uniforms. With a plan whose eye cannot
 * move, and without jitters, EYE_BAKED, too, and the constants that follow it.
 * Fails where the room above should not suffice.
 */
int constants_write(const cupola_gl *gl, int output, char words[CONSTANTS_MAX],
                    struct cupola_error *error);

#endif
