/* Whether the framebuffer that is bound has colours that can be drawn or read. */
#include "target_color.h"

#include "error.h"

/*
 * The kind of number that a draw or read buffer of a host's framebuffer holds; GL_NONE where it is
 * none. The default framebuffer is not asked: it holds normalised numbers or floats.
 */
static GLenum color_type(GLenum binding, GLenum buffer_name)
{
    GLint buffer = GL_NONE, object = GL_NONE, type = GL_NONE;
    glGetIntegerv(buffer_name, &buffer);
    if (buffer == GL_NONE)
        return GL_NONE;
    glGetFramebufferAttachmentParameteriv(binding, (GLenum)buffer,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &object);
    if (object != GL_NONE)
        glGetFramebufferAttachmentParameteriv(binding, (GLenum)buffer,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    return (GLenum)type;
}

static bool is_integer(GLenum type)
{
    return type == GL_INT || type == GL_UNSIGNED_INT;
}

int target_check_color(GLuint framebuffer, struct cupola_error *error)
{
    if (!framebuffer) {
        GLint buffer = GL_NONE;
        glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
        return buffer != GL_NONE ? CUPOLA_OK
                                 : error_set(error, CUPOLA_ERROR_GL,
                                             "the default framebuffer's draw buffer 0 is none; "
                                             "allowed: one of its colours (glDrawBuffer)");
    }
    GLenum type = color_type(GL_DRAW_FRAMEBUFFER, GL_DRAW_BUFFER0);
    if (type != GL_NONE && !is_integer(type))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_GL,
                     "target's framebuffer %u has %s as its draw buffer 0; allowed: a colour whose "
                     "format is of floats or normalised numbers",
                     framebuffer, type == GL_NONE ? "no colour" : "integers");
}

int target_unreadable(GLuint framebuffer, GLenum failure, struct cupola_error *error)
{
    GLint samples = 0;
    GLenum type = GL_NONE;
    const char *why = "";
    if (framebuffer) { /* else what the GL says is all that is known */
        glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
        type = color_type(GL_READ_FRAMEBUFFER, GL_READ_BUFFER);
        why = samples > 0        ? ", which has several samples per pixel,"
              : type == GL_NONE  ? ", whose read buffer is no colour,"
              : is_integer(type) ? ", whose colour is of integers,"
                                 : "";
    }
    return error_set(error, CUPOLA_ERROR_GL,
                     "the GL cannot read from framebuffer %u%s (error 0x%x); allowed: one sample "
                     "per pixel and a read buffer of floats or normalised numbers",
                     framebuffer, why, failure);
}
