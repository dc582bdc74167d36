/* Saving and restoring of what clearing and resolving views changes. */
#include "host_view.h"

GLboolean host_encoding_is_on(const struct host_features *features)
{
    return features->srgb_always ? GL_TRUE : glIsEnabled(GL_FRAMEBUFFER_SRGB);
}

/* Clears use the mask of front faces; that of back faces stays. */
GLuint host_stencil_unmask(bool asked)
{
    GLint64 before = 0; /* as GLint the uppermost bit would be lost */
    if (asked)
        glGetInteger64v(GL_STENCIL_WRITEMASK, &before);
    glStencilMaskSeparate(GL_FRONT, ~0u);
    return (GLuint)before;
}

void host_stencil_mask(GLuint mask)
{
    glStencilMaskSeparate(GL_FRONT, mask);
}
