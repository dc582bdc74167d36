/* What the parts of the window share: opening and running it, its keys, and what they do. */
#ifndef WINDOW_STATE_H
#define WINDOW_STATE_H

#include "display.h"
#include "eye_path.h"
#include "grid.h"
#include "overlay.h"
#include "show.h"
#include "world.h"

struct window {
    GLFWwindow *handle;
    struct world world;
    struct scene_range range;
    struct eye_path eye;
    struct marks marks;
    struct overlay *overlay;
    struct grid *grid;

    struct show_setup setup; /* as wished, with the rig's own size */
    struct show *show;       /* of `setup` at the window's size */
    struct cupola_lens own_lens;
    enum show_mode own_mode;
    int width; /* of the framebuffer, px */
    int height;

    bool show_grid;
    bool show_views;
    bool show_help;
    bool wants_picture; /* the next frame goes into a file */
    bool resized;
    int tried_lens; /* the last that a key asked for, possible or not */
    int tried_layout;

    char notice[MESSAGE_SIZE];
    double notice_end_ms;
    double cursor[2]; /* screen coordinates */
    double cursor_ms; /* when the mouse was moved last */
    double moved_ms;  /* when the camera was moved last */
    double start_ms;  /* of the first frame */
    double frame_ms;  /* between frames, smoothed */
    struct display_place place;
};

/* Sets the callbacks for keys and mouse. The handle's user pointer must be the window. */
void window_listen(struct window *window);

/* The direction under the mouse, if it was moved lately and one is there. */
bool window_picked(const struct window *window, double direction[3]);

/* Moves camera and viewer by the keys that are held down. */
void window_fly(struct window *window);

/*
 * Makes another setup the window's, at the window's size. Where it is impossible the old one stays,
 * a notice says why, and false is returned.
 */
bool window_change(struct window *window, const struct show_setup *setup);

void window_notice(struct window *window, const char *text);

/* Draws what lies over the picture: views, degrees of the grid, help, notice. */
void window_draw_overlay(struct window *window);

/* Writes what the window shows into a new PNG file in the current directory. */
void window_save_picture(struct window *window);

#endif
