/*
 * GL calls seen and spoiled on their way: libepoxy's function pointers are replaced by functions
 * that count, fail the n-th time, or behave as in a context that has been lost.
 */
#ifndef INTERPOSED_H
#define INTERPOSED_H

#include <epoxy/gl.h>
#include <stdbool.h>

/* What a lost context writes where it is asked for a number. */
enum { GARBAGE = -1234567 };

struct interposed {
    int asked;        /* calls that ask the GL for something: glGet..., glIs..., glCheck... */
    int resets_asked; /* of those, whether the context was lost */
    int made;         /* calls that make objects, storage, shaders and programs */
    int called;       /* all of those, and clears, draws, groups and framebuffers bound */

    int to_go;          /* calls that may fail, up to the one that does; 0: none will, or it has */
    bool out_of_memory; /* was what failed */
    GLenum error;       /* what the failure left pending */

    bool robust;      /* tells that it may be lost, whether it may or not */
    bool lost;        /* as after a reset */
    bool versionless; /* and as after the reset has been asked for: has no version any more */
    int lose_in;      /* calls until then; 0: never */
};

extern struct interposed interposed;

void interposed_begin(void);
void interposed_end(void);

#endif
