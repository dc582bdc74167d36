/*
 * A host without any window: OpenGL from EGL's surfaceless platform, the dome drawn into a
 * framebuffer of the host's own, and the last image written as PNG. So a render farm or a server
 * makes dome films.
 *
 *     cupola-host-egl [FRAMES [FILE.png]]
 */
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cupola/cupola.h>
#include <cupola/image_file.h>

#include "cubes.h"

/*
 * Makes a core context current that has no surface at all. eglGetPlatformDisplayEXT and not the
 * function without EXT, which a loader offers only once it knows of a display with EGL 1.5.
 */
static EGLDisplay make_context(EGLContext *context)
{
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                 EGL_NONE};
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);

    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL) ||
        !eglBindAPI(EGL_OPENGL_API))
        return EGL_NO_DISPLAY;
    *context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (*context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, *context))
        return EGL_NO_DISPLAY;
    return display;
}

/* There is no default framebuffer here: the warp needs one of ours. Depth is the views' matter. */
static GLuint make_framebuffer(int width, int height, GLuint *texture)
{
    GLuint framebuffer;

    glGenTextures(1, texture);
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *texture, 0);
    return framebuffer;
}

static int draw_frame(cupola_gl *gl, struct cubes cubes, const struct cupola_target *target,
                      struct cupola_error *error)
{
    int views = cupola_gl_frame_begin(gl, NULL, error);

    if (views < 0)
        return views;
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        int status = cupola_gl_view_begin(gl, i, &view, error);
        if (status < 0)
            return status;
        cubes_draw(cubes, &view.camera);
        cupola_gl_view_end(gl, NULL);
    }
    return cupola_gl_warp(gl, 0, NULL, target, error);
}

static int write_image(const char *path, const struct cupola_target *target,
                       const struct cupola_output *output, struct cupola_error *error)
{
    int width = output->width_px, height = output->height_px, status = CUPOLA_ERROR_MEMORY;
    float *rgba = malloc(4 * sizeof *rgba * (size_t)width * (size_t)height);

    if (rgba && (status = cupola_gl_capture(target, width, height, rgba, error)) >= 0)
        status = cupola_png_write(path, rgba, width, height, error);
    free(rgba);
    return status;
}

int main(int argc, char **argv)
{
    int status = 1, frames = argc > 1 ? atoi(argv[1]) : 1;
    const char *path = argc > 2 ? argv[2] : NULL;
    EGLContext context = EGL_NO_CONTEXT;
    EGLDisplay display = make_context(&context);
    GLuint texture;
    struct cupola_error error = {0};
    struct cupola_rig rig;
    struct cupola_target target = {0};
    struct cubes cubes;
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    /* The scene's colours are those of the screen: mixed in linear light, and encoded again. */
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_SRGB8,
                                            .encoding = CUPOLA_ENCODING_SRGB};
    cupola_gl *gl = NULL;

    if (display == EGL_NO_DISPLAY) {
        fprintf(stderr, "cupola-host-egl: no OpenGL 3.3 on EGL's surfaceless platform\n");
        return 1;
    }
    if (cupola_rig_preset("visionstation", &rig, &error) < 0 ||
        cupola_dome_create(&rig, &dome, &error) < 0 ||
        cupola_plan_create(dome, NULL, &plan, &error) < 0 ||
        cupola_gl_create(plan, &params, &gl, &error) < 0)
        goto fail;
    target.framebuffer =
        make_framebuffer(rig.outputs[0].width_px, rig.outputs[0].height_px, &texture);
    cubes = cubes_create();
    while (frames-- > 0)
        if (draw_frame(gl, cubes, &target, &error) < 0)
            goto fail;
    if (!cubes_seen(target.framebuffer, &rig.outputs[0]) ||
        (path && write_image(path, &target, &rig.outputs[0], &error) < 0))
        goto fail;
    status = 0;
fail:
    if (status)
        fprintf(stderr, "cupola-host-egl: %s\n",
                error.status ? error.message : "the dome shows something else than the scene");
    cupola_gl_destroy(&gl); /* while the context is still current */
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglTerminate(display);
    return status;
}
