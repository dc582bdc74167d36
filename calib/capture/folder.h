/* The folder of a series: pictures, photographs of them, the text that says what they are. */
#ifndef FOLDER_H
#define FOLDER_H

#include <limits.h>
#include <stdbool.h>

#include "capture/series.h"

/* All functions: false with one line in `message`, MESSAGE_SIZE bytes. */

/* Makes the folder where it is not there yet. */
bool folder_make(const char *option, const char *folder, char *message);

/* FOLDER/NAME and a suffix. */
bool folder_path(const char *folder, const char *name, const char *suffix, char path[PATH_MAX],
                 char *message);

/* FOLDER/patterns.txt */
bool folder_write_series(const char *folder, const struct series *series, char *message);
bool folder_read_series(const char *folder, struct series *series, char *message);

/* The photographs of a folder, sorted by name. */
struct folder_photos {
    char **paths;
    int count;
};
bool folder_list(const char *folder, struct folder_photos *photos, char *message);
void folder_photos_free(struct folder_photos *photos);

#endif
