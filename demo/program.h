/* Compiling and linking of the scenes' GL programs. */
#ifndef PROGRAM_H
#define PROGRAM_H

#include <stddef.h>

/*
 * A program from the sources of its two shaders; 0 on failure, with one line in `message`. Where a
 * GL context is current. `name` says which program failed.
 */
unsigned int program_create(const char *name, const char *vertex_source,
                            const char *fragment_source, char *message, size_t message_size);

/* The same with a fragment shader in two parts, the first of which has the #version. */
unsigned int program_create_of(const char *name, const char *vertex_source,
                               const char *fragment_functions, const char *fragment_main,
                               char *message, size_t message_size);

#endif
