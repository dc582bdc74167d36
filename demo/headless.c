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

enum { DEVICES_MAX = 64 };

/* What is asked for. */
struct api {
    EGLenum name;
    EGLint renderable; /* of configs */
    int version;       /* 10 major + minor, the least that will do */
    const EGLint *wish;
    const char *needed; /* in words, beginning with the API */
};

static const EGLint core_wish[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION_KHR,
                                   3,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                   EGL_NONE};
static const EGLint es_wish[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};

static const struct api desktop_api = {EGL_OPENGL_API, EGL_OPENGL_BIT, 33, core_wish,
                                       "OpenGL 3.3 core or newer"};
static const struct api es_api = {EGL_OPENGL_ES_API, EGL_OPENGL_ES3_BIT_KHR, 30, es_wish,
                                  "OpenGL ES 3.0 or newer"};

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
    const struct api *api;
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
static EGLConfig config_for(EGLDisplay display, const char *extensions, EGLint renderable)
{
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, renderable, EGL_SURFACE_TYPE, 0, EGL_NONE};
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
 * Makes a context current on an initialised display. `version` is that of the best context that was
 * found, also where it is too old: 10 major + minor, or untouched.
 */
static bool make_context(struct headless *headless, EGLDisplay display, int *version)
{
    const EGLint any[] = {EGL_NONE};
    const struct api *api = headless->api;
    const EGLint *const wishes[] = {api->wish, any};
    const char *extensions = eglQueryString(display, EGL_EXTENSIONS);

    if (!extensions || !has_word(extensions, "EGL_KHR_surfaceless_context"))
        return false;
    if (!eglBindAPI(api->name))
        return false;
    /* The second wish is there to learn, for the message, which version an old driver has. */
    for (int i = 0; i < 2; i++) {
        EGLContext made = eglCreateContext(
            display, config_for(display, extensions, api->renderable), EGL_NO_CONTEXT, wishes[i]);
        if (made == EGL_NO_CONTEXT)
            continue;
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made)) {
            int found = epoxy_gl_version();
            if (found > *version)
                *version = found;
            if (i == 0 && found >= api->version) {
                headless->context = made;
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
    if (make_context(headless, display, version)) {
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

static struct headless *create(const struct api *api, char *message, size_t message_size)
{
    int version = 0;
    struct headless *headless = calloc(1, sizeof *headless);

    if (!headless) {
        snprintf(message, message_size, "out of memory");
        return NULL;
    }
    headless->api = api;
    if (try_devices(headless, false, &version) || try_surfaceless(headless, &version) ||
        try_devices(headless, true, &version))
        return headless;
    if (version > 0)
        snprintf(message, message_size, "the OpenGL%s found is %d.%d%s; needed: %s",
                 api == &es_api ? " ES" : "", version / 10, version % 10,
                 version >= api->version ? " without core" : "", api->needed);
    else
        snprintf(message, message_size,
                 "no EGL device and no surfaceless EGL gives an OpenGL%s context; needed: %s",
                 api == &es_api ? " ES" : "", api->needed);
    free(headless);
    return NULL;
}

struct headless *headless_create(char *message, size_t message_size)
{
    return create(&desktop_api, message, message_size);
}

struct headless *headless_create_es(char *message, size_t message_size)
{
    return create(&es_api, message, message_size);
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
