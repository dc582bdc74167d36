/* The window in which patterns are shown. */
#include "capture/shown.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "capture/light.h"
#include "display.h"
#include "interruption.h"

struct shown {
    GLFWwindow *handle;
    int width, height;
    GLuint texture, framebuffer;
    unsigned char *rgba;
    enum shown_wish wish;
    bool started; /* GLFW */
};

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int mods)
{
    struct shown *shown = glfwGetWindowUserPointer(handle);

    (void)scancode;
    (void)mods;
    if (action == GLFW_RELEASE)
        return;
    if (key == GLFW_KEY_SPACE || key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER)
        shown->wish = SHOWN_NEXT;
    if (key == GLFW_KEY_BACKSPACE)
        shown->wish = SHOWN_BACK;
    if (key == GLFW_KEY_ESCAPE)
        shown->wish = SHOWN_END;
}

static bool choose_monitor(const struct shown *shown, int index, struct display_place *place,
                           char *message)
{
    const GLFWvidmode *mode;

    if (!place->fills && index < 0)
        return true;
    index = index < 0 ? 0 : index;
    place->monitor = display_monitor(index, message);
    if (!place->monitor)
        return false;
    mode = glfwGetVideoMode(place->monitor);
    if (!place->fills || (mode && mode->width == shown->width && mode->height == shown->height))
        return true;
    snprintf(message, MESSAGE_SIZE,
             "--monitor: monitor %d shows %d x %d px, and the patterns are of %d x %d; allowed: "
             "one size, or --window",
             index, mode ? mode->width : 0, mode ? mode->height : 0, shown->width, shown->height);
    return false;
}

static bool open_window(struct shown *shown, int index, bool window, char *message)
{
    struct display_place place = {.fills = !window, .width = shown->width, .height = shown->height};
    int width, height;

    if (!choose_monitor(shown, index, &place, message))
        return false;
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    shown->handle = display_window("cupola-calib capture", &place, message);
    if (!shown->handle)
        return false;
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(shown->handle, shown);
    glfwSetKeyCallback(shown->handle, on_key);
    glfwSetInputMode(shown->handle, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    glfwGetFramebufferSize(shown->handle, &width, &height);
    if (width == shown->width && height == shown->height)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "the window has %d x %d px, and the patterns are of %d x %d; allowed: one size, so "
             "that no pattern is scaled",
             width, height, shown->width, shown->height);
    return false;
}

static void make_texture(struct shown *shown)
{
    glGenTextures(1, &shown->texture);
    glBindTexture(GL_TEXTURE_2D, shown->texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, shown->width, shown->height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, NULL);
    glGenFramebuffers(1, &shown->framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown->framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shown->texture,
                           0);
}

struct shown *shown_create(int width, int height, int monitor, bool window, char *message)
{
    struct shown *shown = calloc(1, sizeof *shown);

    if (!shown || !(shown->rgba = malloc(4 * (size_t)width * (size_t)height))) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a picture of %dx%d", width, height);
        free(shown);
        return NULL;
    }
    shown->width = width;
    shown->height = height;
    shown->started = display_open(message);
    if (shown->started && open_window(shown, monitor, window, message)) {
        make_texture(shown);
        return shown;
    }
    shown_destroy(shown);
    return NULL;
}

void shown_destroy(struct shown *shown)
{
    if (!shown)
        return;
    if (shown->handle) {
        glDeleteFramebuffers(1, &shown->framebuffer);
        glDeleteTextures(1, &shown->texture);
        glfwDestroyWindow(shown->handle);
    }
    if (shown->started)
        glfwTerminate();
    free(shown->rgba);
    free(shown);
}

static void present(struct shown *shown)
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBlitFramebuffer(0, 0, shown->width, shown->height, 0, 0, shown->width, shown->height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(shown->handle);
}

void shown_picture(struct shown *shown, const struct photo *picture)
{
    size_t count = (size_t)shown->width * (size_t)shown->height;

    for (size_t i = 0; i < count; i++) {
        int number = (int)(255 * light_encode((double)picture->light[i]) + 0.5);
        memset(shown->rgba + 4 * i, number, 3);
        shown->rgba[4 * i + 3] = 255;
    }
    glBindTexture(GL_TEXTURE_2D, shown->texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, shown->width, shown->height, GL_RGBA, GL_UNSIGNED_BYTE,
                    shown->rgba);
    /* Twice, so that the one before has left the screen; then nothing is under way any more. */
    present(shown);
    present(shown);
    glFinish();
}

enum shown_wish shown_wait(struct shown *shown, double wait_s)
{
    double end = glfwGetTime() + wait_s;

    shown->wish = SHOWN_STAY;
    do {
        double rest = end - glfwGetTime();
        if (wait_s >= 0 && rest <= 0)
            glfwPollEvents();
        else
            glfwWaitEventsTimeout(wait_s < 0 || rest > 0.1 ? 0.1 : rest);
        if (glfwWindowShouldClose(shown->handle) || interruption_asked())
            shown->wish = SHOWN_END;
        if (shown->wish == SHOWN_STAY)
            present(shown); /* a window that was covered */
    } while (shown->wish == SHOWN_STAY && (wait_s < 0 || glfwGetTime() < end));
    return shown->wish;
}
