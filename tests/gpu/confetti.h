/* A host with a scene of confetti, drawn view by view or all views in one pass. */
#ifndef CONFETTI_H
#define CONFETTI_H

#include "fixture.h"

enum { CONFETTI_INSTANCES = 3, CONFETTI_VERTICES = 120, CONFETTI_BINDING = 3 };

/* One primitive for all of it. */
struct confetti {
    GLuint looped, passed, wrong; /* programs; wrong sends each instance to the next view */
    GLuint vertex_array;
    GLenum mode;
    float point_size;
};

/* A way that the context has. */
void confetti_create(struct confetti *confetti, enum cupola_pass_way way, GLenum mode);
void confetti_destroy(struct confetti *confetti);

/*
 * The program of a pass, with a geometry shader where the way has one. `place` is what stands
 * between Cupola's text and the host's.
 */
GLuint confetti_program(enum cupola_pass_way way, GLenum mode, const char *place);

/* A frame; reversed and so on as the host would set it. */
void confetti_loop(const struct confetti *confetti, const struct fixture *fixture,
                   const struct cupola_frame *frame);
void confetti_pass(const struct confetti *confetti, const struct fixture *fixture,
                   const struct cupola_frame *frame, GLuint program);

#endif
