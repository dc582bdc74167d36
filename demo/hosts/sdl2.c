/*
 * A host with a window by SDL2 that may be resized: then the output gets the window's size in
 * pixels, its image circle keeps its place, and dome, plan and gl are made anew.
 *
 *     cupola-host-sdl2 [FRAMES]
 */
#include <stdio.h>
#include <stdlib.h>

#include <SDL.h>
#include <epoxy/gl.h> /* brings its own prototypes: SDL_opengl.h is not needed */

#include <cupola/cupola.h>

#include "cubes.h"

struct host {
    SDL_Window *window;
    SDL_GLContext context;
    struct cupola_rig rig;
    cupola_gl *gl;
    struct cubes cubes;
};

static bool make_window(struct host *host)
{
    const struct cupola_output *output = &host->rig.outputs[0];

    if (SDL_Init(SDL_INIT_VIDEO) < 0)
        return false;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0); /* depth is the views' matter */
    host->window = SDL_CreateWindow(
        "cupola-host-sdl2", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, output->width_px,
        output->height_px, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (!host->window)
        return false;
    host->context = SDL_GL_CreateContext(host->window);
    return host->context != NULL;
}

/*
 * The window's size in pixels, which on a screen of high density is not its size in points. What
 * worked before stays until what shall replace it is there.
 */
static int fit_to_window(struct host *host, struct cupola_error *error)
{
    int width, height, status;
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    /* The scene's colours are those of the screen: mixed in linear light, and encoded again. */
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_SRGB8,
                                            .encoding = CUPOLA_ENCODING_SRGB};
    cupola_gl *gl = NULL;

    SDL_GL_GetDrawableSize(host->window, &width, &height);
    if (host->gl && width == host->rig.outputs[0].width_px &&
        height == host->rig.outputs[0].height_px)
        return CUPOLA_OK;
    if ((status = cupola_output_resize(&host->rig.outputs[0], width, height, error)) >= 0 &&
        (status = cupola_dome_create(&host->rig, &dome, error)) >= 0 &&
        (status = cupola_plan_create(dome, NULL, &plan, error)) >= 0 &&
        (status = cupola_gl_create(plan, &params, &gl, error)) >= 0) {
        cupola_gl_destroy(&host->gl);
        host->gl = gl;
    }
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    return status;
}

static int draw_frame(struct host *host, struct cupola_error *error)
{
    int status, views = cupola_gl_frame_begin(host->gl, NULL, error);

    if (views < 0)
        return views;
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        if ((status = cupola_gl_view_begin(host->gl, i, &view, error)) < 0)
            return status;
        cubes_draw(host->cubes, &view.camera);
        cupola_gl_view_end(host->gl, NULL);
    }
    return cupola_gl_warp(host->gl, 0, NULL, NULL, error);
}

static bool wants_to_quit(void)
{
    SDL_Event event;
    bool quit = false;

    while (SDL_PollEvent(&event))
        quit = quit || event.type == SDL_QUIT ||
               (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE);
    return quit;
}

int main(int argc, char **argv)
{
    int status = 1, frames = argc > 1 ? atoi(argv[1]) : -1;
    bool right = true;
    struct cupola_error error = {0};
    struct host host = {0};

    if (cupola_rig_preset("visionstation", &host.rig, &error) < 0 || !make_window(&host))
        goto fail;
    host.cubes = cubes_create();
    while (!wants_to_quit() && frames-- != 0) {
        if (fit_to_window(&host, &error) < 0 || draw_frame(&host, &error) < 0)
            goto fail;
        right = cubes_seen(0, &host.rig.outputs[0]); /* reads what was drawn: before the swap */
        SDL_GL_SwapWindow(host.window);
    }
    status = !right;
fail:
    if (status)
        fprintf(stderr, "cupola-host-sdl2: %s\n",
                error.status ? error.message
                : right      ? SDL_GetError()
                             : "the dome shows something else than the scene");
    cupola_gl_destroy(&host.gl);
    if (host.context)
        SDL_GL_DeleteContext(host.context);
    if (host.window)
        SDL_DestroyWindow(host.window);
    SDL_Quit();
    return status;
}
