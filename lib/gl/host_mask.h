/* The host's GL state that only laying a mask changes; host_state.h has the rest. */
#ifndef HOST_MASK_H
#define HOST_MASK_H

#include "host_state.h"

/* What a face's stencil test is. */
struct host_stencil {
    GLint function, reference, fail, depth_fail, pass;
    GLint64 value_mask, write_mask; /* as GLint the uppermost bit would be lost */
};

struct host_mask {
    bool kept, stencil;
    GLint depth_function;
    GLdouble depth_range[2];
    struct host_stencil faces[2]; /* front, back */
};

/*
 * Between saving and restoring of the rest: what is drawn goes into depth, as it is, or sets the
 * uppermost bit of the stencil, and leaves colour alone. Kept: it is asked what was.
 */
void host_mask_begin(struct host_mask *mask, const struct host_features *features, bool stencil,
                     bool kept);
void host_mask_end(const struct host_mask *mask, const struct host_features *features);

#endif
