/* The default framebuffer as a target, whichever of its buffers the host draws into. */
#include <epoxy/egl.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"

/* A surface for the context that is current; EGL_NO_SURFACE where there is none to be had. */
static EGLSurface surface_make(void)
{
    const EGLint wished[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             context_is_es() ? EGL_OPENGL_ES3_BIT_KHR : EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_ALPHA_SIZE,
                             8,
                             EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, GUEST_SIZE, EGL_HEIGHT, GUEST_SIZE, EGL_NONE};
    EGLDisplay display = eglGetCurrentDisplay();
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglChooseConfig(display, wished, &config, 1, &count) || count < 1)
        return EGL_NO_SURFACE;
    EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    if (surface == EGL_NO_SURFACE ||
        eglMakeCurrent(display, surface, surface, eglGetCurrentContext()))
        return surface;
    eglDestroySurface(display, surface);
    return EGL_NO_SURFACE;
}

static void surface_release(EGLSurface surface)
{
    EGLDisplay display = eglGetCurrentDisplay();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, eglGetCurrentContext());
    eglDestroySurface(display, surface);
}

/* Into one of its buffers; whether the GL has that. */
static bool draw_into(struct guest_house *house, GLenum buffer)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    GLint bound = -1;
    if (context_is_es())
        glDrawBuffers(1, &buffer);
    else
        glDrawBuffer(buffer);
    if (glGetError() != GL_NO_ERROR)
        return false;
    glGetIntegerv(GL_DRAW_BUFFER0, &bound);
    if (buffer == GL_NONE) {
        assert_int_equal(guest_frame(house, &error), CUPOLA_ERROR_GL);
        assert_non_null(strstr(error.message, "draw buffer 0 is none"));
    } else if (guest_frame(house, &error) < 0)
        fail_msg("draw buffer 0x%x: %s", buffer, error.message);
    GLenum pending = glGetError();
    if (pending != GL_NO_ERROR)
        fail_msg("draw buffer 0x%x (0x%x): GL error 0x%x", buffer, (GLenum)bound, pending);
    return true;
}

static void every_buffer_of_it_is_drawn_into_without_an_error(void **state)
{
    static const GLenum buffers[] = {GL_BACK,           GL_FRONT,       GL_LEFT,      GL_RIGHT,
                                     GL_FRONT_LEFT,     GL_FRONT_RIGHT, GL_BACK_LEFT, GL_BACK_RIGHT,
                                     GL_FRONT_AND_BACK, GL_NONE};
    struct guest_house house;
    int drawn = 0, count = context_is_es() ? 1 : (int)(sizeof buffers / sizeof *buffers);
    (void)state;
    EGLSurface surface = surface_make();
    if (surface == EGL_NO_SURFACE)
        skip();
    guest_house_build(&house);
    const struct cupola_target own = house.target;
    house.target = (struct cupola_target){0};
    for (int encoding = 0; encoding < 2; encoding++) {
        const struct cupola_gl_params params = {.encoding = (enum cupola_encoding)encoding};
        assert_int_equal(guest_gl_create(&house, &params, NULL), CUPOLA_OK);
        for (int i = 0; i < count; i++)
            drawn += draw_into(&house, buffers[i]);
        cupola_gl_destroy(&house.gl);
    }
    printf("  %d draw buffers\n", drawn / 2);
    check_at_least(drawn, context_is_es() ? 2 : 4);
    house.target = own;
    guest_house_release(&house);
    surface_release(surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_buffer_of_it_is_drawn_into_without_an_error),
    };
    context_open();
    int failures = cmocka_run_group_tests_name("default_framebuffer", tests, NULL, NULL);
    context_close();
    return failures;
}
