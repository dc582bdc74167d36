/* What draws or computes a stage's table, apart from the instance that it may belong to. */
#ifndef TABLE_GL_H
#define TABLE_GL_H

#include <epoxy/gl.h>

#include "cupola/gl.h"
#include "geometry/plan.h"

/* The program of a stage's table, of so many views. 0 on failure. */
GLuint table_program_create(const cupola_dome *dome, int output, int view_count,
                            enum cupola_table stage, struct cupola_error *error);

/*
 * Fills the texture that is bound to GL_TEXTURE_2D, of the output's size, by the C functions, row
 * by row. The plan has the views of the stage coordinates; other stages need none.
 */
int table_fill_by_cpu(const cupola_dome *dome, const cupola_plan *plan, int output,
                      enum cupola_table stage, struct cupola_error *error);

#endif
