/* A display by GLFW, and why there is none or no window on it. */
#ifndef DISPLAY_H
#define DISPLAY_H

#include <stdbool.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "option_values.h"

/* Begins with GLFW. False with one line in `message`, MESSAGE_SIZE bytes; nothing is then to end.
 */
bool display_open(char *message);

/* A monitor by its index, 0 the primary one; NULL with one line in `message` that names them all.
 */
GLFWmonitor *display_monitor(int index, char *message);

/* Where a window is, or would be if it did not fill a monitor; in screen coordinates. */
struct display_place {
    GLFWmonitor *monitor; /* NULL: wherever the desktop puts it */
    bool fills;           /* all of the monitor */
    int x, y;             /* of its corner */
    int width, height;    /* 0 and `fills`: the monitor's */
};

/*
 * A window of OpenGL 3.3 core, by the hints that are set besides, its context current; in the
 * monitor's corner unless it fills it, and `place` says so then. It stays where it is while
 * another monitor is worked on. NULL with one line in `message` that says which OpenGL there is
 * where that is the reason.
 */
GLFWwindow *display_window(const char *title, struct display_place *place, char *message);

/*
 * From a window to the whole of the monitor that most of it is on, or back. `place` keeps where it
 * was. Without a monitor to fill it stays a window.
 */
void display_toggle_fullscreen(GLFWwindow *window, struct display_place *place);

#endif
