/* GL objects that are more than names, each checked and named. */
#include "error.h"
#include "instance.h"

GLuint vertex_array_create(const struct guest *guest, struct cupola_error *error)
{
    GLuint vertex_array = 0;
    glGenVertexArrays(1, &vertex_array);
    if (!vertex_array) {
        gl_refused(glGetError(), error, "a vertex array");
        return 0;
    }
    glBindVertexArray(vertex_array);
    guest_name(guest, GL_VERTEX_ARRAY, vertex_array, "full screen");
    return vertex_array;
}

GLuint sampler_create(const struct guest *guest, const char *name, struct cupola_error *error)
{
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    if (!sampler) {
        gl_refused(glGetError(), error, "a sampler");
        return 0;
    }
    glBindSampler(0, sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    guest_name(guest, GL_SAMPLER, sampler, "%s", name);
    glBindSampler(0, 0);
    return sampler;
}
