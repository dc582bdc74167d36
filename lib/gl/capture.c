/* Reading a target back. */
#include "error.h"
#include "instance.h"

int cupola_gl_capture(const struct cupola_target *target, int width, int height, float *rgba,
                      struct cupola_error *error)
{
    int status = context_check(error);
    if (status != CUPOLA_OK)
        return status;
    if (width < 1 || height < 1 || width > 32768 || height > 32768 || !rgba)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "capture of %d x %d px; allowed: 1 to 32768 each way", width, height);
    struct cupola_target place = target ? *target : (struct cupola_target){0};
    struct host_state state;
    host_state_save(&state);
    glBindFramebuffer(GL_FRAMEBUFFER, place.framebuffer);
    bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (complete)
        glReadPixels(place.x, place.y, width, height, GL_RGBA, GL_FLOAT, rgba);
    host_state_restore(&state);
    return complete ? CUPOLA_OK
                    : error_set(error, CUPOLA_ERROR_GL, "target's framebuffer %u is not complete",
                                place.framebuffer);
}
