/* Targets of the host: bound, and asked what they are made of. */
#include "target_gl.h"

#include "error.h"

enum { COLORS_MAX = 32 }; /* as many as the GL has names for */

/* As far as a float counts pixels. */
enum { CORNER_MAX = 1 << 24 };

static bool near_enough(int at)
{
    return at >= -CORNER_MAX && at <= CORNER_MAX;
}

int target_bind(const struct guest *guest, const struct cupola_target *place,
                struct cupola_error *error)
{
    GLuint framebuffer = place->framebuffer;
    bool asked = !guest->leaves_state;
    if (!near_enough(place->x) || !near_enough(place->y))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "target's corner is (%d, %d) px; allowed: -%d to %d each way", place->x,
                         place->y, CORNER_MAX, CORNER_MAX);
    if (asked && framebuffer && !glIsFramebuffer(framebuffer))
        return error_set(error, CUPOLA_ERROR_GL, "target's framebuffer %u does not exist",
                         framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (asked && glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return error_set(error, CUPOLA_ERROR_GL, "target's framebuffer %u is not complete",
                         framebuffer);
    return CUPOLA_OK;
}

/* The name of the texture that is the bound framebuffer's colour of an index; 0 if none is. */
static GLuint color_texture(int index)
{
    GLenum place = (GLenum)(GL_COLOR_ATTACHMENT0 + index);
    GLint type = GL_NONE, name = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, place,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE)
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, place,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    return (GLuint)name;
}

int target_check_sampled(GLuint framebuffer, const GLuint *textures, int count,
                         struct cupola_error *error)
{
    GLint colors = 0;
    if (!framebuffer)
        return CUPOLA_OK; /* the default framebuffer has no textures */
    glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &colors);
    if (colors > COLORS_MAX)
        colors = COLORS_MAX;
    for (int i = 0; i < colors; i++) {
        GLuint attached = color_texture(i);
        for (int k = 0; attached && k < count; k++)
            if (textures[k] == attached)
                return error_set(error, CUPOLA_ERROR_ARGUMENT,
                                 "target's framebuffer %u has texture %u, which is sampled, as its "
                                 "color attachment %d; allowed: other textures",
                                 framebuffer, attached, i);
    }
    return CUPOLA_OK;
}

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
