/* Reading a target back. */
#include "error.h"
#include "instance.h"

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
    struct host_state state;
    struct host_features features;
    host_features_find(&features);
    host_state_save(&state, &features);
    status = target_bind(place.framebuffer, error);
    if (status == CUPOLA_OK) {
        gl_errors_drop();
        glReadPixels(place.x, place.y, width, height, GL_RGBA, GL_FLOAT, rgba);
        GLenum failure = glGetError(); /* multisampled, or without a colour to read */
        if (failure != GL_NO_ERROR)
            status = error_set(error, CUPOLA_ERROR_GL,
                               "the GL cannot read from framebuffer %u (error 0x%x)",
                               place.framebuffer, failure);
    }
    host_state_restore(&state);
    return status;
}
