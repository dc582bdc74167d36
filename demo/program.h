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

/* A program whose vertices go to a view, or each to one of all views. */
struct program_source {
    const char *name;
    /* Without #version; calls place_vertex or cover_view of all_views.glsl. */
    const char *vertex;
    const char *const *varyings; /* its outputs: "flat vec3 normal" */
    int varying_count;
    const char *functions; /* of the fragment shader: its first part; NULL: none */
    const char *fragment;  /* the first part has the #version */
};

/* way: of enum cupola_pass_way, for all views in one pass; 0: for one view. Else as above. */
unsigned int program_create_of(int way, const struct program_source *source, char *message,
                               size_t message_size);

#endif
