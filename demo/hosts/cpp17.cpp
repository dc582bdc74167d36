/*
 * A host in C++17: every handle in a unique_ptr, every error an exception. What a C++ program needs
 * of Cupola comes from pkg-config alone:
 *
 *     g++ -std=c++17 cpp17.cpp $(pkg-config --cflags --libs cupola glfw3 epoxy)
 *
 *     cupola-host-cpp17 [FRAMES]
 */
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cupola/cupola.h>

#include "cubes.h"

namespace
{

/* Cupola's destroyers take the address of a handle; unique_ptr gives the handle itself. */
template <auto destroy> struct destroyer {
    template <class T> void operator()(T *handle) const
    {
        destroy(&handle);
    }
};
using dome_ptr = std::unique_ptr<cupola_dome, destroyer<cupola_dome_destroy>>;
using plan_ptr = std::unique_ptr<cupola_plan, destroyer<cupola_plan_destroy>>;
using gl_ptr = std::unique_ptr<cupola_gl, destroyer<cupola_gl_destroy>>;

struct window_destroyer {
    void operator()(GLFWwindow *window) const
    {
        glfwDestroyWindow(window);
    }
};
using window_ptr = std::unique_ptr<GLFWwindow, window_destroyer>;

struct glfw {
    glfw()
    {
        if (!glfwInit())
            throw std::runtime_error("GLFW finds no display");
    }
    ~glfw()
    {
        glfwTerminate();
    }
    glfw(const glfw &) = delete;
    glfw &operator=(const glfw &) = delete;
};

struct dome_error : std::runtime_error {
    explicit dome_error(const cupola_error &error)
        : std::runtime_error(error.message), status(error.status)
    {
    }
    cupola_status status;
};

/* Any call whose last argument is a cupola_error; its result where that is no error. */
template <class Call, class... Arguments> int checked(Call call, Arguments... arguments)
{
    cupola_error error = {};
    int result = call(arguments..., &error);
    if (result < 0)
        throw dome_error(error);
    return result;
}

template <class Pointer, class Call, class... Arguments>
Pointer made(Call call, Arguments... arguments)
{
    typename Pointer::pointer handle = nullptr;
    checked(call, arguments..., &handle);
    return Pointer(handle);
}

window_ptr make_window(const cupola_output &output)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    window_ptr window(
        glfwCreateWindow(output.width_px, output.height_px, "cupola-host-cpp17", nullptr, nullptr));
    if (!window)
        throw std::runtime_error("no window with OpenGL 3.3");
    glfwMakeContextCurrent(window.get());
    return window;
}

void run(int frames)
{
    cupola_rig rig = {};
    checked(cupola_rig_preset, "visionstation", &rig);
    const dome_ptr dome = made<dome_ptr>(cupola_dome_create, &rig);
    const plan_ptr plan = made<plan_ptr>(cupola_plan_create, dome.get(), nullptr);

    /* The scene's colours are those of the screen: mixed in linear light, and encoded again. */
    cupola_gl_params params = {};
    params.format = CUPOLA_FORMAT_SRGB8;
    params.encoding = CUPOLA_ENCODING_SRGB;

    const glfw library;
    const window_ptr window = make_window(rig.outputs[0]);
    /* Declared after the window, so destroyed before it, while the context is still there. */
    const gl_ptr gl = made<gl_ptr>(cupola_gl_create, plan.get(), &params);
    const cubes scene = cubes_create();

    while (!glfwWindowShouldClose(window.get()) && frames-- != 0) {
        const int views = checked(cupola_gl_frame_begin, gl.get(), nullptr);
        for (int i = 0; i < views; i++) {
            cupola_gl_view view = {};
            checked(cupola_gl_view_begin, gl.get(), i, &view);
            cubes_draw(scene, &view.camera);
            checked(cupola_gl_view_end, gl.get());
        }
        checked(cupola_gl_warp, gl.get(), 0, nullptr, nullptr);
        if (!cubes_seen(0, &rig.outputs[0]))
            throw std::runtime_error("the dome shows something else than the scene");
        glfwSwapBuffers(window.get());
        glfwPollEvents();
    }
    cubes_destroy(scene);
}

} // namespace

int main(int argc, char **argv)
{
    try {
        run(argc > 1 ? std::atoi(argv[1]) : -1);
    } catch (const std::exception &exception) {
        std::cerr << "cupola-host-cpp17: " << exception.what() << '\n';
        return 1;
    }
    return 0;
}
