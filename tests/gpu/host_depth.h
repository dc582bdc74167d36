/* What a host does to draw with one of Cupola's ways of depth. */
#ifndef HOST_DEPTH_H
#define HOST_DEPTH_H

#include "context.h"
#include "cupola/cupola.h"

static inline bool has_clip_control(void)
{
    return context_has(45, "GL_ARB_clip_control", 1000, "GL_EXT_clip_control");
}

/* All of it. */
static inline void host_depth(const struct cupola_depth *depth)
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(depth->reversed ? GL_GREATER : GL_LESS);
    if (has_clip_control())
        glClipControl(GL_LOWER_LEFT, depth->zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
}

static inline void host_depth_reset(void)
{
    const struct cupola_depth plain = {.near_distance = 0};
    host_depth(&plain);
    glDisable(GL_DEPTH_TEST);
}

#endif
