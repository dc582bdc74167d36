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

/* "0 (HDMI-1, 1024 x 768 px), 1 (...)" into `text`, as far as it goes. */
static void list_monitors(GLFWmonitor **monitors, int count, char *text, size_t size)
{
    size_t length = 0;

    text[0] = 0;
    for (int i = 0; i < count && length < size; i++) {
        const GLFWvidmode *mode = glfwGetVideoMode(monitors[i]);

        length += (size_t)snprintf(text + length, size - length, "%s%d (%.40s, %d x %d px)",
                                   i ? ", " : "", i, glfwGetMonitorName(monitors[i]),
                                   mode ? mode->width : 0, mode ? mode->height : 0);
    }
}

GLFWmonitor *display_monitor(int index, char *message)
{
    char list[MESSAGE_SIZE - 80];
    int count = 0;
    GLFWmonitor **monitors = glfwGetMonitors(&count);

    if (index >= 0 && index < count)
        return monitors[index];
    list_monitors(monitors, count, list, sizeof list);
    if (count == 0)
        snprintf(message, MESSAGE_SIZE, "--monitor: this display has no monitor");
    else
        snprintf(message, MESSAGE_SIZE, "--monitor: %d is not allowed; allowed: %s", index, list);
    return NULL;
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

static void fill_size(const struct display_place *place, int *width, int *height)
{
    const GLFWvidmode *mode =
        place->fills && place->monitor ? glfwGetVideoMode(place->monitor) : NULL;

    *width = mode ? mode->width : place->width;
    *height = mode ? mode->height : place->height;
}

GLFWwindow *display_window(const char *title, struct display_place *place, char *message)
{
    GLFWwindow *handle;
    int width, height;

    fill_size(place, &width, &height);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    handle = glfwCreateWindow(width, height, title, place->fills ? place->monitor : NULL, NULL);
    if (!handle) {
        say_refusal(title, message);
        return NULL;
    }
    if (place->width < 1)
        place->width = width;
    if (place->height < 1)
        place->height = height;
    if (place->monitor)
        glfwGetMonitorPos(place->monitor, &place->x, &place->y);
    if (place->monitor && !place->fills)
        glfwSetWindowPos(handle, place->x, place->y);
    glfwMakeContextCurrent(handle);
    return handle;
}

static int overlap(int a, int a_size, int b, int b_size)
{
    int begin = a > b ? a : b, end = a + a_size < b + b_size ? a + a_size : b + b_size;

    return end > begin ? end - begin : 0;
}

/* The monitor that shows most of the window; the primary one where none does. */
static GLFWmonitor *monitor_under(const struct display_place *place)
{
    int count = 0, x, y;
    GLFWmonitor **monitors = glfwGetMonitors(&count);
    GLFWmonitor *best = count > 0 ? monitors[0] : NULL;
    double most = 0;

    for (int i = 0; i < count; i++) {
        const GLFWvidmode *mode = glfwGetVideoMode(monitors[i]);
        double area;

        if (!mode)
            continue;
        glfwGetMonitorPos(monitors[i], &x, &y);
        area = (double)overlap(place->x, place->width, x, mode->width) *
               overlap(place->y, place->height, y, mode->height);
        if (area > most) {
            most = area;
            best = monitors[i];
        }
    }
    return best;
}

void display_toggle_fullscreen(GLFWwindow *window, struct display_place *place)
{
    const GLFWvidmode *mode;

    if (glfwGetWindowMonitor(window)) {
        glfwSetWindowMonitor(window, NULL, place->x, place->y, place->width, place->height,
                             GLFW_DONT_CARE);
        place->fills = false;
        return;
    }
    glfwGetWindowPos(window, &place->x, &place->y);
    glfwGetWindowSize(window, &place->width, &place->height);
    place->monitor = monitor_under(place);
    mode = place->monitor ? glfwGetVideoMode(place->monitor) : NULL;
    place->fills = mode != NULL;
    if (mode)
        glfwSetWindowMonitor(window, place->monitor, 0, 0, mode->width, mode->height,
                             mode->refreshRate);
}
