/* What the GL itself does to the colours that are drawn into a target. */
#include "error.h"
#include "instance.h"

/* What draw buffer 0 of the framebuffer that is bound draws into; GL_NONE for nothing. */
static GLenum first_attachment(void)
{
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
    return (GLenum)buffer;
}

static GLint first_attachment_value(GLenum name)
{
    GLenum buffer = first_attachment();
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
    GLenum buffer = first_attachment();
    GLint type = GL_NONE, encoding = GL_LINEAR;
    if (buffer == GL_BACK && !features->es)
        buffer = GL_BACK_LEFT; /* desktop OpenGL before 4.5 knows it by this name only */
    if (buffer == GL_NONE)
        return false;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type != GL_NONE)
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, buffer,
                                              GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, &encoding);
    return encoding == GL_SRGB;
}

bool target_encodes(const struct host_features *features)
{
    return features->srgb_always &&
           first_attachment_value(GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_SRGB;
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

bool target_is_float32(void)
{
    return first_attachment() != GL_BACK &&
           first_attachment_value(GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT &&
           first_attachment_value(GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 32;
}
