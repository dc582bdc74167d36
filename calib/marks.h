/*
 * Marks: known places of the screen and the pixels that light them, as CSV files with a header. The
 * columns may stand in any order: name, x_px, y_px, and either dir_x, dir_y, dir_z (the direction
 * from the centre of the screen) or x_m, y_m, z_m (the point), both in the dome frame.
 */
#ifndef MARKS_H
#define MARKS_H

#include <stdbool.h>

#include "whole_file.h"

enum {
    MARK_NAME_MAX = 63, /* bytes */
    MARKS_MAX = 100000, /* in a file */
};

/* How the places of a file are given. */
enum marks_kind {
    MARKS_DIRECTIONS, /* unit length, from the centre of the screen */
    MARKS_POINTS,     /* metres */
};

struct mark {
    char name[MARK_NAME_MAX + 1];
    double place[3];    /* by the kind of the marks; dome frame */
    double pixel_px[2]; /* continuous, origin bottom left */
    bool steered;       /* it has a pixel */
};

struct marks {
    enum marks_kind kind;
    struct mark *list;
    int count;
};

/*
 * Reads a file. Without `needs_pixels` x_px and y_px may be missing, as columns or in single rows:
 * places that have not been steered to yet. False with one line in `message`, MESSAGE_SIZE bytes,
 * that names file, line, column, value and what is allowed; nothing is then to be freed.
 */
bool marks_read(const char *path, bool needs_pixels, struct marks *marks, char *message);

/* Writes a file, whole or not at all, that reads back as the same numbers to the last bit. */
bool marks_write(const char *path, const struct marks *marks, char *message);

/*
 * The same up to its name, which whole_file_end gives: for a file that is to appear with others.
 * False with one line; nothing is then to be ended.
 */
bool marks_settle(struct whole_file *file, const char *path, const struct marks *marks,
                  char *message);

/* Frees the list; all zero afterwards. */
void marks_free(struct marks *marks);

#endif
