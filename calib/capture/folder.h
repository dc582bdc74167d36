/* The folder of a series: pictures, photographs of them, the text that says what they are. */
#ifndef FOLDER_H
#define FOLDER_H

#include <limits.h>
#include <stdbool.h>

#include "capture/series.h"
#include "named_files.h"

/* All functions: false with one line in `message`, MESSAGE_SIZE bytes. */

/* Makes the folder where it is not there yet. */
bool folder_make(const char *option, const char *folder, char *message);

/* Whether photographs have a folder of their own; NULL: not given. */
bool folder_is_another(const char *folder, const char *patterns, char *message);

/* FOLDER/NAME and a suffix. */
bool folder_path(const char *folder, const char *name, const char *suffix, char path[PATH_MAX],
                 char *message);

/* FOLDER/patterns.txt */
bool folder_write_series(const char *folder, const struct series *series, char *message);
bool folder_read_series(const char *folder, struct series *series, char *message);

/*
 * Whether the files of a series, patterns.txt and pictures that end in `suffix`, are none of some
 * others, where either are written.
 */
bool folder_differs(const char *option, const char *folder, const char *suffix, bool written,
                    const struct series *series, const struct named_file *others, int count,
                    char *message);

/*
 * Whether a folder holds no pictures but those of a series, which are to be written anew: an
 * earlier series of another period would be mixed with it. A folder that is not there holds none.
 */
bool folder_is_for(const char *option, const char *folder, const char *suffix,
                   const struct series *series, char *message);

/* The photographs of a folder, sorted by name. */
struct folder_photos {
    char **paths;
    int count;
};
bool folder_list(const char *folder, struct folder_photos *photos, char *message);
void folder_photos_free(struct folder_photos *photos);

#endif
