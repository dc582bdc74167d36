/* Saving and restoring of what showing a cube map changes. */
#include "host_cube.h"

void host_cube_set(void)
{
    if (epoxy_is_desktop_gl())
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void host_cube_save(struct host_cube *cube)
{
    glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &cube->texture);
    cube->seamless = GL_TRUE;
    if (!epoxy_is_desktop_gl())
        return; /* always so in OpenGL ES 3.0, without a switch */
    cube->seamless = glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    host_cube_set();
}

void host_cube_restore(const struct host_cube *cube)
{
    glBindTexture(GL_TEXTURE_CUBE_MAP, (GLuint)cube->texture);
    if (!cube->seamless)
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}
