/*
 * A GL context without a display, by EGL. Real GPUs come first: every device of the device platform
 * in turn, software devices left out; then Mesa's surfaceless platform; then what is left.
 */
#include "headless.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEVICES_MAX = 64, VERSION_NEEDED = 33 };

/*
 * eglTerminate unloads Mesa's drivers, and a leak checker can then no longer tell their leaks from
 * ours by name: under one the display stays.
 */
#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define KEEP_DISPLAY 1
#endif
#endif
#if defined __SANITIZE_ADDRESS__ && !defined KEEP_DISPLAY
#define KEEP_DISPLAY 1
#endif

static void end_display(EGLDisplay display)
{
#ifdef KEEP_DISPLAY
    (void)display;
#else
    eglTerminate(display);
#endif
}

struct headless {
    EGLDisplay display;
    EGLContext context;
};

/* A whole word in one of EGL's lists of extensions. */
static bool has_word(const char *list, const char *word)
{
    size_t length = strlen(word);
    const char *at = list;

    while (at && (at = strstr(at, word))) {
        if ((at == list || at[-1] == ' ') && (at[length] == 0 || at[length] == ' '))
            return true;
        at += length;
    }
    return false;
}

static const char *client_extensions(void)
{
    const char *list = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return list ? list : "";
}

/* EGL 1.4 demands a config unless the extension lets a context live without one. */
static EGLConfig config_for(EGLDisplay display, const char *extensions)
{
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;

    if (has_word(extensions, "EGL_KHR_no_config_context") ||
        has_word(extensions, "EGL_MESA_configless_context"))
        return NULL; /* EGL_NO_CONFIG_KHR */
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
        return NULL;
    return config;
}

/*
 * Makes a core context current on an initialised display. `version` is that of the best context
 * that was found, also where it is too old: 10 major + minor, or untouched.
 */
static bool make_context(EGLDisplay display, EGLContext *context, int *version)
{
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                           3,
                           EGL_CONTEXT_MINOR_VERSION_KHR,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                           EGL_NONE};
    const EGLint any[] = {EGL_NONE};
    const EGLint *const wishes[] = {core, any};
    const char *extensions = eglQueryString(display, EGL_EXTENSIONS);

    if (!extensions || !has_word(extensions, "EGL_KHR_surfaceless_context"))
        return false;
    if (!eglBindAPI(EGL_OPENGL_API))
        return false;
    /* The second wish is there to learn, for the message, which version an old driver has. */
    for (int i = 0; i < 2; i++) {
        EGLContext made =
            eglCreateContext(display, config_for(display, extensions), EGL_NO_CONTEXT, wishes[i]);
        if (made == EGL_NO_CONTEXT)
            continue;
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made)) {
            int found = epoxy_gl_version();
            if (found > *version)
                *version = found;
            if (i == 0 && found >= VERSION_NEEDED) {
                *context = made;
                return true;
            }
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, made);
    }
    return false;
}

static bool try_display(struct headless *headless, EGLDisplay display, int *version)
{
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL))
        return false;
    if (make_context(display, &headless->context, version)) {
        headless->display = display;
        return true;
    }
    end_display(display);
    return false;
}

/* Every device of one kind: software renderers or not. */
static bool try_devices(struct headless *headless, bool software, int *version)
{
    EGLDeviceEXT devices[DEVICES_MAX];
    EGLint count = 0;
    const char *extensions = client_extensions();

    if (!has_word(extensions, "EGL_EXT_platform_base") ||
        !has_word(extensions, "EGL_EXT_platform_device") ||
        !(has_word(extensions, "EGL_EXT_device_enumeration") ||
          has_word(extensions, "EGL_EXT_device_base")))
        return false;
    if (!eglQueryDevicesEXT(DEVICES_MAX, devices, &count))
        return false;
    for (EGLint i = 0; i < count; i++) {
        const char *kind = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        if (has_word(kind, "EGL_MESA_device_software") != software)
            continue;
        if (try_display(headless,
                        eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL),
                        version))
            return true;
    }
    return false;
}

static bool try_surfaceless(struct headless *headless, int *version)
{
    const char *extensions = client_extensions();

    if (!has_word(extensions, "EGL_EXT_platform_base") ||
        !has_word(extensions, "EGL_MESA_platform_surfaceless"))
        return false;
    return try_display(
        headless,
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL),
        version);
}

struct headless *headless_create(char *message, size_t message_size)
{
    int version = 0;
    struct headless *headless = calloc(1, sizeof *headless);

    if (!headless) {
        snprintf(message, message_size, "out of memory");
        return NULL;
    }
    if (try_devices(headless, false, &version) || try_surfaceless(headless, &version) ||
        try_devices(headless, true, &version))
        return headless;
    if (version > 0)
        snprintf(message, message_size, "the OpenGL found is %d.%d%s; needed: 3.3 core or newer",
                 version / 10, version % 10, version >= VERSION_NEEDED ? " without core" : "");
    else
        snprintf(message, message_size,
                 "no EGL device and no surfaceless EGL gives an OpenGL context; needed: OpenGL 3.3 "
                 "core or newer");
    free(headless);
    return NULL;
}

void headless_destroy(struct headless *headless)
{
    if (!headless)
        return;
    eglMakeCurrent(headless->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(headless->display, headless->context);
    end_display(headless->display);
    eglReleaseThread();
    free(headless);
}
