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

/* A monitor by its index, 0 the primary one; NULL beyond. */
GLFWmonitor *display_monitor(int index);

/*
 * A window of OpenGL 3.3 core, by the hints that are set besides, its context current. NULL with
 * one line in `message` that says which OpenGL there is where that is the reason.
 */
GLFWwindow *display_window(const char *title, int width, int height, GLFWmonitor *monitor,
                           char *message);

/*
 * From a window to the whole of a monitor, keeping its place and size in `place`, or back. False
 * where there is no monitor to fill. `filled` is NULL or out: what it fills, NULL for a window.
 */
bool display_toggle_fullscreen(GLFWwindow *window, GLFWmonitor *monitor, int place[4],
                               const GLFWvidmode **filled);

#endif
