/* The tool in a window: opening it, its events, and a frame whenever something has changed. */
#include "tool/window.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "display.h"
#include "output_file.h"
#include "status.h"
#include "tool/stage.h"

struct window {
    GLFWwindow *handle;
    struct tool *tool;
    struct tool shown; /* as it was when the last frame was drawn */
    struct stage *stage;
    int width, height; /* of the framebuffer, px */
    double cursor[2];  /* screen coordinates, by the last event */
    struct display_place place;
    bool dirty; /* to be drawn anew whatever the tool says */
};

static void toggle_fullscreen(struct window *window)
{
    const GLFWvidmode *mode;

    display_toggle_fullscreen(window->handle, &window->place);
    mode = window->place.fills ? glfwGetVideoMode(window->place.monitor) : NULL;
    /* What fills the projector's monitor has its size. */
    if (mode)
        tool_resize(window->tool, mode->width, mode->height);
    window->dirty = true;
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    (void)scancode;
    if (action == GLFW_RELEASE)
        return;
    window->tool->time_s = glfwGetTime();
    /* Locks are no modifiers. */
    modifiers &= GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    if (action == GLFW_REPEAT)
        tool_key_repeat(window->tool, key, modifiers);
    else
        tool_key(window->tool, key, modifiers);
    if (window->tool->wants_fullscreen)
        toggle_fullscreen(window);
    window->tool->wants_fullscreen = false;
}

/* Tells the tool where the mouse is, as the image lies now. */
static void point(struct window *window)
{
    int width, height;
    double pixel[2];

    glfwGetWindowSize(window->handle, &width, &height);
    if (width < 1 || height < 1)
        return;
    window->tool->time_s = glfwGetTime();
    /* Screen coordinates need not be pixels. */
    stage_pixel(window->tool, window->width, window->height,
                window->cursor[0] * window->width / width,
                window->cursor[1] * window->height / height, pixel);
    tool_mouse(window->tool, pixel[0], pixel[1]);
}

static void on_cursor(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    window->cursor[0] = x;
    window->cursor[1] = y;
    point(window);
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    (void)modifiers;
    if (button != GLFW_MOUSE_BUTTON_LEFT)
        return;
    /*
     * Where the mouse is was said by the last event: asked now, it may be further on already. The
     * image may since have gone elsewhere under it.
     */
    point(window);
    tool_mouse_button(window->tool, action == GLFW_PRESS);
}

static void on_size(GLFWwindow *handle, int width, int height)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    window->width = width;
    window->height = height;
    window->dirty = true;
}

static void on_refresh(GLFWwindow *handle)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    window->dirty = true;
}

static void listen(struct window *window)
{
    glfwSetWindowUserPointer(window->handle, window);
    glfwSetKeyCallback(window->handle, on_key);
    glfwSetCursorPosCallback(window->handle, on_cursor);
    glfwSetMouseButtonCallback(window->handle, on_button);
    glfwSetFramebufferSizeCallback(window->handle, on_size);
    glfwSetWindowRefreshCallback(window->handle, on_refresh);
}

static bool open_window(struct window *window, const struct window_wishes *wishes, char *message)
{
    struct display_place *place = &window->place;

    *place = (struct display_place){.monitor = display_monitor(wishes->monitor, message),
                                    .fills = wishes->width < 1,
                                    .width = wishes->width,
                                    .height = wishes->height};
    /* Where there is no monitor at all, a window can still be. */
    if (!place->monitor && (place->fills || wishes->monitor > 0))
        return false;
    window->handle = display_window("cupola-calib", place, message);
    if (!window->handle)
        return false;
    glfwSwapInterval(wishes->swap_interval);
    glfwGetFramebufferSize(window->handle, &window->width, &window->height);
    /* What fills the projector's monitor has its size. */
    if (place->fills)
        tool_resize(window->tool, window->width, window->height);
    listen(window);
    return true;
}

/* What the window shows, into a new file of the current directory. */
static void save_picture(struct window *window)
{
    struct tool *tool = window->tool;
    char name[40], message[MESSAGE_SIZE];

    tool->wants_picture = false;
    for (int i = 1; i < 10000; i++) {
        snprintf(name, sizeof name, "cupola-calib-%04d.png", i);
        if (access(name, F_OK) != 0)
            break;
        name[0] = 0;
    }
    if (!name[0])
        snprintf(tool->warning, MESSAGE_SIZE,
                 "cupola-calib-0001.png to cupola-calib-9999.png are all there");
    else if (output_file_capture(name, 0, window->width, window->height, message))
        snprintf(tool->notice, MESSAGE_SIZE, "saved %s", name);
    else
        memcpy(tool->warning, message, sizeof message);
}

/* Padding counts too, a frame too many does no harm; the clock and where the mouse is do not. */
static bool has_changed(struct window *window)
{
    window->shown.time_s = window->tool->time_s;
    memcpy(window->shown.mouse_px, window->tool->mouse_px, sizeof window->shown.mouse_px);
    return window->dirty || memcmp(&window->shown, window->tool, sizeof window->shown) != 0;
}

static bool frame(struct window *window, char *message)
{
    memcpy(&window->shown, window->tool, sizeof window->shown);
    window->dirty = false;
    if (!stage_draw(window->stage, window->tool, 0, window->width, window->height, message))
        return false;
    if (window->tool->wants_picture)
        save_picture(window);
    glfwSwapBuffers(window->handle);
    return true;
}

/* Where nothing changes, for a while: a tracker's reports must not wait long, nor keep it busy. */
static void rest(struct window *window, const struct window_wishes *wishes)
{
    if (wishes->frames > 0 || has_changed(window))
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(wishes->before_frame ? 0.004 : 0.1);
    window->tool->time_s = glfwGetTime();
}

static bool loop(struct window *window, const struct window_wishes *wishes, char *message)
{
    int left = wishes->frames;

    while (!window->tool->ends) {
        rest(window, wishes);
        if (glfwWindowShouldClose(window->handle))
            break;
        if (wishes->before_frame)
            wishes->before_frame(window->tool, wishes->user);
        tool_idle(window->tool);
        window->dirty |= left > 0;
        if (has_changed(window) && !frame(window, message))
            return false;
        if (left > 0 && --left == 0)
            break;
    }
    return true;
}

int window_run(struct tool *tool, const struct window_wishes *wishes, char *message)
{
    struct window *window;
    int status = STATUS_FAILED;

    if (!display_open(message))
        return STATUS_FAILED;
    window = calloc(1, sizeof *window);
    if (!window) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        glfwTerminate();
        return STATUS_FAILED;
    }
    window->tool = tool;
    window->dirty = true;
    window->cursor[0] = window->cursor[1] = -1; /* beside it until it is known */
    if (open_window(window, wishes, message)) {
        window->stage = stage_create(message);
        if (window->stage && loop(window, wishes, message))
            status = STATUS_OK;
        stage_destroy(window->stage);
        glfwDestroyWindow(window->handle);
    }
    free(window);
    glfwTerminate();
    return status;
}
