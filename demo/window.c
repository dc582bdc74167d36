/* The demo in a window: opening it, the loop, and what changes with its size. */
#include "window.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/rig_file.h>

#include "display.h"
#include "film_output.h"
#include "prices.h"
#include "stats.h"
#include "window_state.h"

bool window_change(struct window *window, const struct show_setup *setup)
{
    char message[MESSAGE_SIZE];
    struct cupola_error error = {0};
    struct show_setup fitted = *setup;
    struct show *show = NULL;

    fitted.plan.earlier = window->show ? show_plan(window->show) : NULL;
    if (cupola_output_resize(&fitted.rig.outputs[setup->output], window->width, window->height,
                             &error) < 0 ||
        cupola_rig_complete(&fitted.rig, &fitted.rig, &error) < 0)
        snprintf(message, sizeof message, "%s", error.message);
    else
        show = show_create(&fitted, message);
    if (!show) {
        window_notice(window, message);
        return false;
    }
    show_destroy(window->show);
    window->show = show;
    window->setup = *setup;
    return true;
}

/* The output's size, smaller where the monitor is. */
static void choose_size(const struct cupola_output *output, struct display_place *place)
{
    GLFWmonitor *screen = place->monitor ? place->monitor : glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = screen ? glfwGetVideoMode(screen) : NULL;
    int width = output->width_px, height = output->height_px;
    double scale = 1;

    if (mode && width > mode->width)
        scale = (double)mode->width / width;
    if (mode && height * scale > mode->height)
        scale = (double)mode->height / height;
    place->width = width * scale < 1 ? 1 : (int)(width * scale);
    place->height = height * scale < 1 ? 1 : (int)(height * scale);
}

static bool open_window(struct window *window, const struct options *options, char *message)
{
    struct display_place *place = &window->place;

    place->fills = options->fullscreen;
    if (options->monitor >= 0 || options->fullscreen) {
        place->monitor = display_monitor(options->monitor >= 0 ? options->monitor : 0, message);
        if (!place->monitor)
            return false;
    }
    choose_size(&window->setup.rig.outputs[window->setup.output], place);
    window->handle = display_window("cupola-demo", place, message);
    if (!window->handle)
        return false;
    glfwSwapInterval(options->swap_interval >= 0 ? options->swap_interval : 1);
    glfwSetWindowUserPointer(window->handle, window);
    glfwGetFramebufferSize(window->handle, &window->width, &window->height);
    return true;
}

static int create(struct window *window, const struct options *options, FILE *news, char *message)
{
    struct cupola_error error = {0};
    int status;

    status = eye_path_create(&window->eye, options, &window->setup.rig, message);
    if (status != STATUS_OK)
        return status;
    if (!open_window(window, options, message))
        return STATUS_FAILED;
    status = world_create(&window->world, options, &window->setup.rig, news, message);
    if (status != STATUS_OK)
        return status;
    if (!film_output_check_files(options, window->world.film, NULL, message))
        return STATUS_FAILED;
    window->setup.one_pass = window->world.way != 0;
    window->setup.floats |= window->world.scene && window->world.scene->needs_float;
    window->setup.overlays = true; /* the mouse's cursor */
    if (!marks_create(&window->marks, options->marks, options->mark_count, message))
        return STATUS_FAILED;
    window->overlay = overlay_create(message, MESSAGE_SIZE);
    window->grid = window->overlay ? grid_create(window->world.way, message, MESSAGE_SIZE) : NULL;
    if (!window->grid)
        return STATUS_FAILED;
    if (window->setup.measures_prices && window->world.scene &&
        !prices_measure(&window->setup, window->world.scene, &window->world.camera, message))
        return STATUS_FAILED;
    if (!window_change(window, &window->setup)) {
        memcpy(message, window->notice, MESSAGE_SIZE);
        return STATUS_FAILED;
    }
    if (options->save_rig && cupola_rig_write(options->save_rig, &window->setup.rig, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--save-rig: %s", error.message);
        return STATUS_FAILED;
    }
    window_listen(window);
    options_notice(options, &window->setup.rig);
    eye_path_announce(&window->eye, news);
    window_notice(window, "H: help");
    return STATUS_OK;
}

static void destroy(struct window *window)
{
    eye_path_destroy(&window->eye);
    if (!window->handle)
        return;
    show_destroy(window->show);
    marks_destroy(&window->marks);
    grid_destroy(window->grid);
    overlay_destroy(window->overlay);
    world_destroy(&window->world);
    glfwDestroyWindow(window->handle);
}

/* The image circle keeps its place in the window. */
static void follow_size(struct window *window)
{
    int width, height;

    glfwGetFramebufferSize(window->handle, &width, &height);
    window->resized = false;
    if (width < 1 || height < 1 || (width == window->width && height == window->height))
        return;
    window->width = width;
    window->height = height;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    window_change(window, &window->setup);
}

static bool draw(struct window *window, struct stats *stats, char *message)
{
    struct frame_times times;
    double direction[3], eye_m[3];
    struct show_frame frame = {
        .source = window->world.film ? film_source(window->world.film) : NULL,
        .scene = window->world.scene,
        .camera = &window->world.camera,
        .range = &window->range,
        .grid = window->show_grid ? window->grid : NULL,
        .overlays = window->marks.overlays,
        .overlay_count = window->marks.count,
        .width = window->width,
        .height = window->height,
        .times = stats ? &times : NULL,
    };

    if (window_picked(window, direction))
        window->marks.overlays[frame.overlay_count++] = mark_cursor(direction);
    if (window->world.film &&
        !film_seek(window->world.film, film_index(window->world.film, now_ms() - window->start_ms),
                   message))
        return false;
    if (eye_path_place(&window->eye, (now_ms() - window->start_ms) / EYE_PATH_TURN_MS, eye_m))
        frame.eye_m = eye_m;
    if (!show_draw(window->show, &frame, message))
        return false;
    if (stats)
        stats_add_frame(stats, &times);
    window_draw_overlay(window);
    if (window->wants_picture) {
        window->wants_picture = false;
        window_save_picture(window);
    }
    return true;
}

static bool loop(struct window *window, const struct options *options, struct stats *stats,
                 char *message)
{
    /* The first frame is not counted where times are measured. */
    int frames_left = options->frames > 0 ? options->frames + (stats != NULL) : -1;
    double last_ms = now_ms();

    window->moved_ms = last_ms;
    window->start_ms = last_ms;
    while (!glfwWindowShouldClose(window->handle) && frames_left != 0) {
        double time_ms;
        glfwPollEvents();
        if (window->resized)
            follow_size(window);
        window_fly(window);
        if (!draw(window, stats, message))
            return false;
        glfwSwapBuffers(window->handle);
        time_ms = now_ms();
        window->frame_ms += 0.1 * (time_ms - last_ms - window->frame_ms);
        last_ms = time_ms;
        if (frames_left > 0)
            frames_left--;
    }
    if (!stats)
        return true;
    stats_time_tables(stats, window->show);
    stats_add_reports(stats, eye_path_counts(&window->eye));
    return stats_write(stats, window->show, window->world.scene,
                       (const char *)glGetString(GL_RENDERER), message) &&
           stats_keep(stats, message);
}

int window_run(const struct options *options, const struct show_setup *setup, char *message)
{
    const struct cupola_lens *lens = &setup->rig.outputs[setup->output].lens;
    FILE *news = options->stats && strcmp(options->stats, "-") == 0 ? stderr : stdout;
    struct stats *stats = options->stats ? stats_create(options->stats) : NULL;
    struct window *window;
    int status;

    if (!display_open(message)) {
        stats_destroy(stats);
        return WINDOW_NO_DISPLAY;
    }
    window = calloc(1, sizeof *window);
    if (!window || (options->stats && !stats)) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        status = STATUS_FAILED;
    } else {
        window->setup = *setup;
        window->own_lens = *lens;
        window->own_mode = setup->mode == SHOW_PREVIEW_EYE || setup->mode == SHOW_PREVIEW_OUTSIDE
                               ? SHOW_DOME
                               : setup->mode;
        window->tried_lens = (int)lens->model;
        window->tried_layout = (int)setup->plan.layout;
        status = create(window, options, news, message);
        if (status == STATUS_OK && !loop(window, options, stats, message))
            status = STATUS_FAILED;
        destroy(window);
    }
    stats_destroy(stats);
    free(window);
    glfwTerminate();
    return status;
}
