/* What the tests of structured light share: a folder of their own, and command lines. */
#ifndef CAPTURE_FIXTURE_H
#define CAPTURE_FIXTURE_H

#include <cupola/rig.h>

#include "capture/series.h"

/* A new empty directory becomes the current one; it and all in it goes at the end. */
int capture_enter_directory(void **state);
int capture_leave_directory(void **state);

/*
 * `capture` with words that single blanks part, within this process. Returns its exit status;
 * `message` has what it would complain of, MESSAGE_SIZE bytes.
 */
int capture_run(const char *line, char *message);

/* The same with this exit status and a reason within one line, and without a file m.csv. */
void capture_refuse(const char *line, int status, const char *reason);

void capture_write_rig(const char *path, const struct cupola_rig *rig);

/* Writes a PFM photograph NAME.pfm into a folder for each picture of a series: light(i, j) */
typedef double capture_light(const struct series_picture *picture, int i, int j, void *data);
void capture_write_photos(const char *folder, const struct series *series, int width, int height,
                          capture_light *light, void *data);

#endif
