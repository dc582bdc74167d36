/* How many objects a context has. */
#ifndef LIVE_OBJECTS_H
#define LIVE_OBJECTS_H

#include <epoxy/gl.h>

/* Those whose names are below `names`; a GL gives small ones first. */
static inline int live_objects(GLuint names)
{
    int count = 0;
    for (GLuint name = 1; name < names; name++)
        count += glIsTexture(name) + glIsFramebuffer(name) + glIsRenderbuffer(name) +
                 glIsVertexArray(name) + glIsProgram(name) + glIsShader(name) + glIsBuffer(name) +
                 glIsSampler(name);
    return count;
}

#endif
