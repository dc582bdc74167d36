/* Saving and restoring of viewports and scissor rectangles of index 1 and above. */
#include "host_areas.h"

void host_areas_save(struct host_areas *areas, int count)
{
    areas->count = count;
    for (int i = 1; i < count; i++) {
        GLuint index = (GLuint)i;
        glGetFloati_v(GL_VIEWPORT, index, areas->viewports[i]);
        glGetIntegeri_v(GL_SCISSOR_BOX, index, areas->scissors[i]);
        areas->tests[i] = glIsEnabledi(GL_SCISSOR_TEST, index);
    }
}

void host_areas_restore(const struct host_areas *areas)
{
    for (int i = 1; i < areas->count; i++) {
        GLuint index = (GLuint)i;
        const GLfloat *v = areas->viewports[i];
        const GLint *s = areas->scissors[i];
        glViewportIndexedf(index, v[0], v[1], v[2], v[3]);
        glScissorIndexed(index, s[0], s[1], s[2], s[3]);
        if (areas->tests[i])
            glEnablei(GL_SCISSOR_TEST, index);
        else
            glDisablei(GL_SCISSOR_TEST, index);
    }
}

void host_areas_set(int index, const struct cupola_rect *rect)
{
    glViewportIndexedf((GLuint)index, (GLfloat)rect->x, (GLfloat)rect->y, (GLfloat)rect->width,
                       (GLfloat)rect->height);
    glScissorIndexed((GLuint)index, rect->x, rect->y, rect->width, rect->height);
    glEnablei(GL_SCISSOR_TEST, (GLuint)index);
}
