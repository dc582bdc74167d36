/* Keys and mouse of the window. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "display.h"
#include "window_state.h"

static const double RADIANS_PER_PX = 0.004;

static void next_lens(struct window *window)
{
    struct show_setup wished = window->setup;
    struct cupola_lens *lens = &wished.rig.outputs[wished.output].lens;
    int model = window->tried_lens;

    /* A polynomial or a table cannot be invented: only the rig's own comes round again. */
    do
        model = cupola_lens_model_name(model + 1) ? model + 1 : 0;
    while (model >= CUPOLA_LENS_POLYNOMIAL && model != (int)window->own_lens.model);
    window->tried_lens = model;
    if (model == (int)window->own_lens.model)
        *lens = window->own_lens;
    else
        *lens = (struct cupola_lens){.model = (enum cupola_lens_model)model,
                                     .fov_rad = window->own_lens.fov_rad};
    window_change(window, &wished);
}

static void next_layout(struct window *window)
{
    struct show_setup wished = window->setup;

    window->tried_layout =
        cupola_layout_name(window->tried_layout + 1) ? window->tried_layout + 1 : 0;
    wished.plan.layout = (enum cupola_layout)window->tried_layout;
    window_change(window, &wished);
}

static void next_table(struct window *window)
{
    struct show_setup wished = window->setup;

    wished.table = cupola_table_name((int)wished.table + 1)
                       ? (enum cupola_table)((int)wished.table + 1)
                       : (enum cupola_table)0;
    window_change(window, &wished);
}

static void next_preview(struct window *window)
{
    struct show_setup wished = window->setup;

    if (wished.mode == SHOW_PREVIEW_EYE)
        wished.mode = SHOW_PREVIEW_OUTSIDE;
    else if (wished.mode == SHOW_PREVIEW_OUTSIDE)
        wished.mode = window->own_mode;
    else
        wished.mode = SHOW_PREVIEW_EYE;
    window_change(window, &wished);
}

static void set_views(struct window *window, int views)
{
    struct show_setup wished = window->setup;

    wished.plan.views = views;
    window_change(window, &wished);
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    (void)scancode;
    (void)modifiers;
    if (action != GLFW_PRESS)
        return;
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_8) {
        set_views(window, key - GLFW_KEY_0);
        return;
    }
    switch (key) {
    case GLFW_KEY_L:
        next_lens(window);
        break;
    case GLFW_KEY_O:
        next_layout(window);
        break;
    case GLFW_KEY_T:
        next_table(window);
        break;
    case GLFW_KEY_P:
        next_preview(window);
        break;
    case GLFW_KEY_V:
        window->show_views = !window->show_views;
        break;
    case GLFW_KEY_G:
        window->show_grid = !window->show_grid;
        break;
    case GLFW_KEY_H:
    case GLFW_KEY_F1:
        window->show_help = !window->show_help;
        break;
    case GLFW_KEY_F12:
        window->wants_picture = true;
        break;
    case GLFW_KEY_HOME:
        eye_path_move(&window->eye, NULL);
        break;
    case GLFW_KEY_F:
        display_toggle_fullscreen(window->handle, &window->place);
        break;
    case GLFW_KEY_ESCAPE:
        glfwSetWindowShouldClose(handle, GLFW_TRUE);
        break;
    default:
        break;
    }
}

/* With the left button held the mouse turns the camera. */
static void on_cursor(GLFWwindow *handle, double x, double y)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    if (glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS)
        host_camera_turn(&window->world.camera, window->world.up,
                         -RADIANS_PER_PX * (x - window->cursor[0]),
                         -RADIANS_PER_PX * (y - window->cursor[1]));
    window->cursor[0] = x;
    window->cursor[1] = y;
    window->cursor_ms = now_ms();
}

static void on_resize(GLFWwindow *handle, int width, int height)
{
    struct window *window = glfwGetWindowUserPointer(handle);

    (void)width;
    (void)height;
    window->resized = true;
}

void window_listen(struct window *window)
{
    glfwSetKeyCallback(window->handle, on_key);
    glfwSetCursorPosCallback(window->handle, on_cursor);
    glfwSetFramebufferSizeCallback(window->handle, on_resize);
    glfwGetCursorPos(window->handle, &window->cursor[0], &window->cursor[1]);
}

bool window_picked(const struct window *window, double direction[3])
{
    const double shown_ms = 3000;
    struct cupola_ray ray;
    int width, height;

    glfwGetWindowSize(window->handle, &width, &height);
    if (window->setup.mode != SHOW_DOME || now_ms() - window->cursor_ms > shown_ms || width < 1 ||
        height < 1)
        return false;
    /* Screen coordinates run from the top left and need not be pixels. */
    if (cupola_dome_ray(show_dome(window->show), window->setup.output, NULL,
                        window->cursor[0] * window->width / width,
                        window->height - window->cursor[1] * window->height / height, &ray) != 1)
        return false;
    memcpy(direction, ray.direction, sizeof ray.direction);
    return true;
}

static double held(const struct window *window, int forth, int back)
{
    return (glfwGetKey(window->handle, forth) == GLFW_PRESS) -
           (glfwGetKey(window->handle, back) == GLFW_PRESS);
}

void window_fly(struct window *window)
{
    double step[3] = {held(window, GLFW_KEY_D, GLFW_KEY_A), held(window, GLFW_KEY_E, GLFW_KEY_Q),
                      held(window, GLFW_KEY_S, GLFW_KEY_W)};
    /* The viewer's, dome frame. */
    double eye[3] = {held(window, GLFW_KEY_RIGHT, GLFW_KEY_LEFT),
                     held(window, GLFW_KEY_UP, GLFW_KEY_DOWN),
                     held(window, GLFW_KEY_PAGE_DOWN, GLFW_KEY_PAGE_UP)};
    double radius = window->world.scene ? window->world.scene->radius : 0;
    double time_ms = now_ms();
    /* A long frame must not become a leap. */
    double passed_s = fmin(time_ms - window->moved_ms, 200) * 1e-3;
    double length = passed_s * (radius > 0 ? 0.4 * radius : 1);

    window->moved_ms = time_ms;
    if (glfwGetKey(window->handle, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS)
        length *= 4;
    for (int i = 0; i < 3; i++) {
        step[i] *= length;
        eye[i] *= passed_s; /* a second from the middle of the sphere to its border */
    }
    host_camera_move(&window->world.camera, step);
    eye_path_move(&window->eye, eye);
}
