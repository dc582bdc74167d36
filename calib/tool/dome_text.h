/*
 * Text on the dome: flat, facing the eye, level as the viewer sees it, sharp in every pixel of the
 * projector. As cupola_gl_overlay lays it, but from the point table alone, so that a rig that
 * changes with every key costs no plan.
 */
#ifndef DOME_TEXT_H
#define DOME_TEXT_H

#include <stdbool.h>

#include <cupola/dome.h>

enum { DOME_LABEL_TEXT = 2000 /* bytes */ };

struct dome_label {
    const char *text;    /* NULL: ground alone, `size` large */
    double direction[3]; /* host's camera frame, from the eye, any length above 0 */
    double unit_rad;     /* of the letters: capitals are 7 high, lines 12 apart */
    double corner[2];    /* of the text's lower left, from the direction, in such units */
    double size[2];      /* of ground without text, in such units */
    float ink[3];        /* linear light */
    float ground;        /* 0 to 1: how much of what is behind it is kept away */
    bool matters;        /* panels over the window stay clear of it */
};

struct dome_text;

/* NULL with one line in `message`, MESSAGE_SIZE bytes. Where a GL context is current, as below. */
struct dome_text *dome_text_create(char *message);

/* NULL is allowed. */
void dome_text_destroy(struct dome_text *text);

/* Of a text, in units of its letters; 0 for one that cannot be drawn. */
void dome_text_size(const char *text, double *width, double *height);

/*
 * How wide a pixel is for the viewer, in this direction of the camera frame; where nothing is
 * lit there, in the middle of the image circle.
 */
double dome_pixel_rad(const cupola_dome *dome, int output, const double direction[3]);

/*
 * Puts a label beside its direction: -1, 0, 1 are left or below, on, right or above; 0, 0 puts its
 * middle there.
 */
void dome_label_anchor(struct dome_label *label, int across, int up);

/*
 * The pixels of the image that a label may touch: lower left, width and height. False where it is
 * not in the image.
 */
bool dome_label_box(const struct cupola_rig *rig, int output, const struct dome_label *label,
                    int box[4]);

/*
 * Draws a label into the framebuffer that is bound, blended in linear light. `points` is the point
 * table of the rig's output. Text without any character is none; a text that is too large is left
 * out.
 */
void dome_text_draw(struct dome_text *text, const struct cupola_rig *rig, int output,
                    unsigned int points, const struct dome_label *label);

#endif
