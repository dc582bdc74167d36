/* A display by GLFW. */
#include "display.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

/* GLFW reports errors to a function that gets no pointer of ours. */
static char reason[300];

static void on_error(int code, const char *text)
{
    (void)code;
    snprintf(reason, sizeof reason, "%s", text);
}

bool display_open(char *message)
{
    const char *x = getenv("DISPLAY"), *wayland = getenv("WAYLAND_DISPLAY");

    glfwSetErrorCallback(on_error);
    if (!(x && *x) && !(wayland && *wayland)) {
        snprintf(message, MESSAGE_SIZE,
                 "a window needs a display, but neither DISPLAY nor WAYLAND_DISPLAY is set");
        return false;
    }
    if (glfwInit())
        return true;
    snprintf(message, MESSAGE_SIZE, "a window needs a display: %s", reason);
    return false;
}

GLFWmonitor *display_monitor(int index)
{
    int count = 0;
    GLFWmonitor **monitors = glfwGetMonitors(&count);

    return index >= 0 && index < count ? monitors[index] : NULL;
}

/* The version of the best context that a hidden window gets; 0 for none. */
static int find_version(const char *title)
{
    int version;
    GLFWwindow *handle;

    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    handle = glfwCreateWindow(16, 16, title, NULL, NULL);
    if (!handle)
        return 0;
    glfwMakeContextCurrent(handle);
    version = epoxy_gl_version();
    glfwMakeContextCurrent(NULL);
    glfwDestroyWindow(handle);
    return version;
}

static void say_refusal(const char *title, char *message)
{
    char first[sizeof reason];
    int version;

    memcpy(first, reason, sizeof first);
    version = find_version(title);
    if (version > 0 && version < 33)
        snprintf(message, MESSAGE_SIZE, "the OpenGL found is %d.%d; needed: 3.3 core or newer",
                 version / 10, version % 10);
    else
        snprintf(message, MESSAGE_SIZE, "no window with OpenGL 3.3 core: %s", first);
}

GLFWwindow *display_window(const char *title, int width, int height, GLFWmonitor *monitor,
                           char *message)
{
    GLFWwindow *handle;

    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    handle = glfwCreateWindow(width, height, title, monitor, NULL);
    if (!handle) {
        say_refusal(title, message);
        return NULL;
    }
    glfwMakeContextCurrent(handle);
    return handle;
}

bool display_toggle_fullscreen(GLFWwindow *window, GLFWmonitor *monitor, int place[4],
                               const GLFWvidmode **filled)
{
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;

    if (filled)
        *filled = NULL;
    if (glfwGetWindowMonitor(window)) {
        glfwSetWindowMonitor(window, NULL, place[0], place[1], place[2], place[3], GLFW_DONT_CARE);
        return true;
    }
    if (!mode)
        return false;
    glfwGetWindowPos(window, &place[0], &place[1]);
    glfwGetWindowSize(window, &place[2], &place[3]);
    glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    if (filled)
        *filled = mode;
    return true;
}
