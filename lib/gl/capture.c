/* Reading a target back. */
#include "error.h"
#include "guest.h"
#include "target_color.h"
#include "target_gl.h"

/* What the read buffer of the framebuffer that is bound consists of; GL_NONE: there is none. */
static GLint read_buffer_type(void)
{
    GLint buffer = GL_NONE, object = GL_NONE, type = GL_NONE;
    glGetIntegerv(GL_READ_BUFFER, &buffer);
    if (buffer == GL_NONE)
        return GL_NONE;
    glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, (GLenum)buffer,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &object);
    if (object != GL_NONE)
        glGetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, (GLenum)buffer,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    return type;
}

/* Bytes at the beginning of the floats' memory become floats, the last one first. */
static void widen(float *values, size_t count)
{
    const unsigned char *bytes = (const unsigned char *)values;
    for (size_t i = count; i-- > 0;) {
        float value = (float)bytes[i] / 255.0f;
        values[i] = value;
    }
}

/*
 * OpenGL ES reads floats from buffers of floats only; all others it reads as bytes. Mesa's crashes
 * if there is no read buffer.
 */
static GLenum read_pixels(const struct cupola_target *place, int width, int height, bool es,
                          float *rgba)
{
    GLint type = es ? read_buffer_type() : GL_FLOAT;
    gl_errors_drop();
    if (type == GL_NONE)
        return GL_INVALID_OPERATION;
    glReadPixels(place->x, place->y, width, height, GL_RGBA,
                 type == GL_FLOAT ? GL_FLOAT : GL_UNSIGNED_BYTE, rgba);
    GLenum failure = glGetError(); /* multisampled, or without a colour to read */
    if (failure == GL_NO_ERROR && type != GL_FLOAT)
        widen(rgba, 4 * (size_t)width * (size_t)height);
    return failure;
}

int cupola_gl_capture(const struct cupola_target *target, int width, int height, float *rgba,
                      struct cupola_error *error)
{
    if (!rgba)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "rgba is NULL");
    if (width < 1 || height < 1 || width > 32768 || height > 32768)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "capture of %d x %d px; allowed: 1 to 32768 each way", width, height);
    int status = context_check(error);
    if (status != CUPOLA_OK)
        return status;
    struct cupola_target place = target ? *target : (struct cupola_target){0};
    struct host_features features;
    struct guest guest = {.features = &features};
    struct guest_work work;
    host_features_find(&features);
    if ((status = guest_check(&guest, error)) != CUPOLA_OK)
        return status;
    guest_begin(&guest, &work, "capture");
    status = target_bind(&guest, &place, error);
    if (status == CUPOLA_OK) {
        GLenum failure = read_pixels(&place, width, height, features.es, rgba);
        if (failure != GL_NO_ERROR)
            status = target_unreadable(place.framebuffer, failure, error);
    }
    guest_end(&guest, &work);
    return status;
}
