/* The files that the demo writes: checks before the work, pictures after it. */
#ifndef OUTPUT_FILE_H
#define OUTPUT_FILE_H

#include <stdbool.h>

/* Whether a path ends in .pfm: a file of floats. */
bool output_file_is_pfm(const char *path);

/*
 * Whether a file can probably be written: its directory is there and writable, and what has its
 * name is a plain file, behind links, too. False with one line in `message`, MESSAGE_SIZE bytes,
 * that begins with `option`.
 */
bool output_file_check(const char *option, const char *path, char *message);

/*
 * Where a file is to be written that has this name: links are followed, so that they stay. To be
 * freed; NULL without memory or where the path cannot be followed, and errno says why.
 */
char *output_file_behind_links(const char *path);

/*
 * Writes what a framebuffer shows, as PFM or PNG by the path's end. The file appears whole or not
 * at all.
 */
bool output_file_capture(const char *path, unsigned int framebuffer, int width, int height,
                         char *message);
/* The same with RGBA floats, rows from the bottom up. */
bool output_file_write(const char *path, const float *rgba, int width, int height, char *message);

#endif
