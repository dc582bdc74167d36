/* GL objects that are more than names, each checked and named. */
#include "gl_objects.h"

#include "error.h"
#include "host_cube.h"

GLuint vertex_array_create(const struct guest *guest, const char *name, struct cupola_error *error)
{
    GLuint vertex_array = 0;
    glGenVertexArrays(1, &vertex_array);
    if (!vertex_array) {
        gl_refused(glGetError(), error, "a vertex array");
        return 0;
    }
    glBindVertexArray(vertex_array);
    guest_name(guest, GL_VERTEX_ARRAY, vertex_array, "%s", name);
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

GLuint texture_create(GLenum internal_format, int width_px, int height_px, GLenum filter,
                      struct cupola_error *error)
{
    GLuint texture = 0;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width_px > largest || height_px > largest) {
        error_set(error, CUPOLA_ERROR_ARGUMENT,
                  "a texture of %d x %d px is needed; allowed by this GL: up to %d each way",
                  width_px, height_px, largest);
        return 0;
    }
    gl_errors_drop();
    glGenTextures(1, &texture);
    if (!texture) {
        gl_refused(glGetError(), error, "a texture's name");
        return 0;
    }
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLint)filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLint)filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    GLenum format = internal_format == GL_R32F ? GL_RED : GL_RGBA;
    bool bytes = internal_format == GL_RGBA8 || internal_format == GL_SRGB8_ALPHA8;
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal_format, width_px, height_px, 0, format,
                 bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, NULL);
    GLenum failure = glGetError();
    if (failure == GL_NO_ERROR)
        return texture;
    glDeleteTextures(1, &texture);
    gl_refused(failure, error, "a texture of %d x %d px", width_px, height_px);
    return 0;
}

GLuint framebuffer_create(GLuint texture, const char *what, struct cupola_error *error)
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    if (!framebuffer) {
        gl_refused(glGetError(), error, "a framebuffer's name");
        return 0;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return framebuffer;
    glDeleteFramebuffers(1, &framebuffer);
    error_set(error, CUPOLA_ERROR_GL, "the GL cannot draw into %s", what);
    return 0;
}

void draw_fullscreen(GLuint vertex_array)
{
    glBindVertexArray(vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool texture_bind(GLenum target, GLuint name)
{
    GLint bound = 0;
    GLenum binding = target == GL_TEXTURE_2D         ? GL_TEXTURE_BINDING_2D
                     : target == GL_TEXTURE_2D_ARRAY ? GL_TEXTURE_BINDING_2D_ARRAY
                                                     : GL_TEXTURE_BINDING_CUBE_MAP;
    if (!name || !glIsTexture(name))
        return false;
    glBindTexture(target, name);
    glGetIntegerv(binding, &bound);
    if ((GLuint)bound == name)
        return true;
    glGetError(); /* of that binding */
    return false;
}

bool texture_found(const struct guest *guest, GLenum target, GLuint name)
{
    struct host_cube host;
    if (guest->leaves_state)
        return name != 0;
    if (target != GL_TEXTURE_CUBE_MAP)
        return texture_bind(target, name);
    host_cube_save(&host);
    bool found = texture_bind(target, name);
    host_cube_restore(&host);
    return found;
}
