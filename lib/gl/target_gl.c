/* What the GL itself does to the colours that are drawn into a target. */
#include "error.h"
#include "instance.h"

/*
 * One buffer of those that a draw buffer of a default framebuffer may stand for, by the names that
 * desktop OpenGL before 4.5 can be asked for; OpenGL ES has GL_BACK alone, and knows it.
 */
static GLenum one_buffer(GLenum buffer)
{
    switch (buffer) {
    case GL_BACK:
        return GL_BACK_LEFT;
    case GL_FRONT:
    case GL_LEFT:
    case GL_FRONT_AND_BACK:
        return GL_FRONT_LEFT;
    case GL_RIGHT:
        return GL_FRONT_RIGHT;
    default:
        return buffer;
    }
}

/* What draw buffer 0 of the framebuffer that is bound draws into; GL_NONE for nothing. */
static GLenum first_attachment(const struct host_features *features)
{
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
    return features->es ? (GLenum)buffer : one_buffer((GLenum)buffer);
}

static GLint first_attachment_value(const struct host_features *features, GLenum name)
{
    GLenum buffer = first_attachment(features);
    GLint type = GL_NONE, value = 0;
    if (buffer == GL_NONE)
        return 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type != GL_NONE)
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer, name, &value);
    return value;
}

bool target_is_srgb(const struct host_features *features)
{
    return first_attachment_value(features, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_SRGB;
}

bool target_encodes(const struct host_features *features)
{
    return features->srgb_always && target_is_srgb(features);
}

int target_check_encoding(const struct host_features *features, GLuint framebuffer,
                          enum cupola_encoding encoding, struct cupola_error *error)
{
    if (encoding != CUPOLA_ENCODING_LINEAR || !target_encodes(features))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_GL,
                     "target's framebuffer %u has an sRGB format, into which this OpenGL ES always "
                     "encodes; allowed: another format, or the encoding sRGB",
                     framebuffer);
}

bool target_is_float32(const struct host_features *features)
{
    return first_attachment_value(features, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT &&
           first_attachment_value(features, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 32;
}
