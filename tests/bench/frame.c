/* One frame of a dome. */
#include "frame.h"

#include <stdio.h>

static bool draw_views(cupola_gl *gl, const struct setting *setting, struct cupola_error *error)
{
    struct scene *scene = setting->scene;
    struct cupola_frame frame = {.depth = setting->depth};
    struct cupola_gl_view view;
    int views;

    for (int i = 0; i < 4; i++)
        frame.clear_color[i] = scene->clear_color[i];
    views = cupola_gl_frame_begin(gl, &frame, error);
    for (int i = 0; i < views; i++) {
        if (cupola_gl_view_begin(gl, i, &view, error) < 0)
            return false;
        scene->draw(scene, &(struct scene_camera){&view.camera, setting->host, false});
        if (cupola_gl_view_end(gl, error) < 0)
            return false;
    }
    return views > 0;
}

bool frame_draw(cupola_gl *gl, const struct setting *setting, const struct cupola_target *target,
                char *message)
{
    struct cupola_error error = {0};

    if (draw_views(gl, setting, &error) && cupola_gl_warp(gl, 0, NULL, target, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "a frame cannot be drawn: %.900s", error.message);
    return false;
}
