/* GL programs from embedded shader files. */
#ifndef PROGRAM_PRIVATE_H
#define PROGRAM_PRIVATE_H

#include <epoxy/gl.h>

#include "cupola/gl.h"
#include "geometry/dome.h"
#include "geometry/plan.h"

/* A file of a shader: its name for messages, and its text. */
struct shader_file {
    const char *name;
    const char *text;
};

/*
 * Compiles the full-screen triangle with a fragment shader made of `count` files, `defines` before
 * them. 0 on failure, with the compiler's words and file and line in the error. A file has fewer
 * than 1000 lines.
 */
GLuint program_create(const char *defines, const struct shader_file *files, int count,
                      struct cupola_error *error);

/* The same with another vertex shader, which has the defines before it, too. */
GLuint program_create_by(const struct shader_file *vertex, const char *defines,
                         const struct shader_file *files, int count, struct cupola_error *error);

/* Lines that the files of shaders/ rely on. */
enum { PROGRAM_DEFINES_MAX = 512 };
void program_defines(const cupola_dome *dome, int output, int view_count, int stage,
                     char defines[PROGRAM_DEFINES_MAX]);

/* What the files of shaders/ know under a name: float, vec2 to vec4, or mat3 row by row. */
struct shader_value {
    const char *type, *name;
    double numbers[9];
    int count;
};

/* What lens.glsl and points.glsl know of an output, but for circle_radius, knots and eye. */
enum { PROJECTOR_VALUES = 12 };
void program_projector_values(const cupola_dome *dome, int output,
                              struct shader_value values[PROJECTOR_VALUES]);

/* Set the uniforms of lens.glsl, points.glsl and views.glsl; the program must be in use. */
void program_set_projector(GLuint program, const cupola_dome *dome, int output);
void program_set_views(GLuint program, const cupola_plan *plan);

/* What follows an eye that moves, by location, of the program in use; -1: nothing. */
void program_place_eye(GLint location, const cupola_dome *dome);
void program_place_bases(GLint location, const cupola_plan *plan);

/* Numbers to a uniform by name; names that the compiler dropped are ignored. */
void program_set_vector(GLuint program, const char *name, const double *values, int count);
void program_set_rotation(GLuint program, const char *name, const double rotation[9]);

#endif
