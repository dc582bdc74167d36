/* Labels and cursors on the dome, by direction. */
#ifndef MARKS_H
#define MARKS_H

#include <cupola/overlay.h>

#include "option_values.h"

enum { MARKS_MAX = 32, MARK_TEXT_MAX = 100, MARK_BYTES_MAX = 4 * MARK_TEXT_MAX };

/* One of them, as typed. */
struct mark {
    char text[MARK_BYTES_MAX + 1]; /* UTF-8; empty: a cursor */
    double yaw_rad, pitch_rad;     /* of the host's camera: to the left, up */
    double height_rad;
};

/* "TEXT@YAW,PITCH[,HEIGHT]" and "YAW,PITCH", degrees. */
bool value_label(const struct value_context *context, const char *text, struct mark *mark);
bool value_cursor(const struct value_context *context, const char *text, struct mark *mark);

/* What is laid over the dome's image, with room for the mouse's cursor after the marks. */
struct marks {
    struct cupola_overlay overlays[MARKS_MAX + 1];
    int count;
};

/* Makes the labels' pictures. False with one line in `message`. Runs where a context is current. */
bool marks_create(struct marks *marks, const struct mark *wished, int count, char *message);
void marks_destroy(struct marks *marks);

/* The overlay of a cursor in some direction of the host's camera. */
struct cupola_overlay mark_cursor(const double direction[3]);

#endif
