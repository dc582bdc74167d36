/* What lies over the picture in the window, and pictures of the window. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <epoxy/gl.h>

#include "output_file.h"
#include "window_state.h"

static const double RADIANS = 3.14159265358979323846 / 180;

static const char keys_text[] =
    "W A S D, Q E\nmouse drag\narrows, page\nHome\nL\nO\n1-8, 0\nT\nV\nG\nP\nF\nF12\n"
    "H, F1\nEsc";
static const char meanings_text[] = "fly (shift: faster)\n"
                                    "look round\n"
                                    "move the viewer (--head-radius)\n"
                                    "viewer back to its place\n"
                                    "next lens\n"
                                    "next layout\n"
                                    "number of views, 0: automatic\n"
                                    "next table stage\n"
                                    "views as thumbnails\n"
                                    "test grid in degrees\n"
                                    "preview: off, eye, outside\n"
                                    "full screen\n"
                                    "save the picture\n"
                                    "this help\n"
                                    "quit";

void window_notice(struct window *window, const char *text)
{
    snprintf(window->notice, sizeof window->notice, "%s", text);
    window->notice_end_ms = now_ms() + 5000;
}

/* x and y from the top left, px. */
static void draw_text(struct window *window, double x, double y, double scale, const char *text)
{
    const struct overlay_place place = {
        .width = window->width, .height = window->height, .x = x, .y = y, .scale = scale};

    overlay_text(window->overlay, &place, text);
}

static double text_scale(const struct window *window)
{
    return window->width >= 700 && window->height >= 500 ? 2 : 1;
}

/* Breaks a long line where a blank is, so that it fits into the window. */
static void wrap(char *text, int columns)
{
    char *line = text, *blank = NULL;

    for (char *at = text; *at; at++) {
        if (*at == ' ')
            blank = at;
        if (at - line >= columns && blank) {
            *blank = '\n';
            line = blank + 1;
            blank = NULL;
        }
    }
}

static void draw_notice(struct window *window)
{
    char text[MESSAGE_SIZE];
    double width, height, scale = text_scale(window);

    if (now_ms() > window->notice_end_ms)
        return;
    memcpy(text, window->notice, sizeof text);
    wrap(text, (int)(window->width / (7 * scale)) - 4);
    overlay_size(text, scale, &width, &height);
    draw_text(window, (window->width - width) / 2, window->height - height - 4 * scale, scale,
              text);
}

static const char *mode_name(enum show_mode mode)
{
    static const char *const names[] = {"dome", "perspective", "views", "preview: eye",
                                        "preview: outside"};
    return names[mode];
}

/* The letters are not all of one width, so keys and meanings are two columns. */
static void draw_help(struct window *window)
{
    char text[600];
    double scale = text_scale(window), keys_width, height;
    const struct cupola_lens *lens = &window->setup.rig.outputs[window->setup.output].lens;
    const struct cupola_plan_report *report = show_report(window->show);
    size_t used = (size_t)snprintf(
        text, sizeof text, "%s, lens %s %.4g degrees\n", mode_name(window->setup.mode),
        cupola_lens_model_name((int)lens->model), lens->fov_rad / RADIANS);

    if (report)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "%s, %d views, %.2f texels shaded per pixel, table %s\n",
                                 cupola_layout_name((int)report->layout), report->views,
                                 report->texels_shaded_per_pixel,
                                 cupola_table_name((int)window->setup.table));
    snprintf(text + used, sizeof text - used, "%dx%d, %.1f frames per second", window->width,
             window->height, 1000 / fmax(window->frame_ms, 1e-3));
    overlay_size(keys_text, scale, &keys_width, &height);
    draw_text(window, 4, 4, scale, keys_text);
    draw_text(window, 4 + keys_width, 4, scale, meanings_text);
    draw_text(window, 4, 8 + height, scale, text);
}

/* A number at the place of the image that shows a point of the screen. */
static void draw_degree(struct window *window, double off_axis_deg, double round_axis_deg,
                        double degree)
{
    const cupola_dome *dome = show_dome(window->show);
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    double off = off_axis_deg * RADIANS, round = round_axis_deg * RADIANS;
    double to_point[3] = {sin(off) * cos(round), sin(off) * sin(round), -cos(off)};
    double direction[3], pixel[2], width, height;
    char text[16];

    for (int i = 0; i < 3; i++)
        to_point[i] = to_point[i] * rig->screen.radius_m - rig->eye_m[i];
    cupola_dome_to_camera(dome, to_point, direction);
    if (cupola_dome_pixel(dome, window->setup.output, NULL, direction, pixel) != 1)
        return;
    snprintf(text, sizeof text, "%g", degree);
    overlay_size(text, 1, &width, &height);
    draw_text(window, pixel[0] - width / 2, window->height - pixel[1] - height / 2, 1, text);
}

static void draw_degrees(struct window *window)
{
    for (int off = 15; off < 180; off += 15)
        draw_degree(window, off, 7.5, off);
    for (int round = 0; round < 360; round += 45)
        draw_degree(window, 52.5, round, round);
}

static void draw_thumbnails(struct window *window)
{
    const struct cupola_plan_report *report = show_report(window->show);
    double scale;

    if (!report)
        return;
    scale = fmin(0.3 * window->width / report->atlas_width_px,
                 0.3 * window->height / report->atlas_height_px);
    show_draw_atlas(window->show, 0,
                    &(struct cupola_rect){0, 0, (int)(scale * report->atlas_width_px),
                                          (int)(scale * report->atlas_height_px)});
}

void window_draw_overlay(struct window *window)
{
    if (window->show_grid && window->setup.mode == SHOW_DOME)
        draw_degrees(window);
    if (window->show_views)
        draw_thumbnails(window);
    if (window->show_help)
        draw_help(window);
    draw_notice(window);
}

void window_save_picture(struct window *window)
{
    char name[40], message[MESSAGE_SIZE];

    for (int i = 1; i < 10000; i++) {
        snprintf(name, sizeof name, "cupola-%04d.png", i);
        if (access(name, F_OK) != 0)
            break;
        name[0] = 0;
    }
    if (!name[0])
        snprintf(message, sizeof message, "cupola-0001.png to cupola-9999.png are all there");
    else if (output_file_capture(name, 0, window->width, window->height, message))
        snprintf(message, sizeof message, "saved %s", name);
    window_notice(window, message);
}
