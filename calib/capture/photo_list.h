/* The photographs of a series, by name or of a folder, before any of them is read. */
#ifndef PHOTO_LIST_H
#define PHOTO_LIST_H

#include "capture/folder.h"
#include "capture/options.h"

/* All zero: none. */
struct photo_list {
    char *const *paths;
    int count;
    struct folder_photos folder; /* none where they were given by name */
};

/* All: false with one line in `message`, MESSAGE_SIZE bytes. */

bool photo_list_find(const struct capture_options *options, struct photo_list *list, char *message);
void photo_list_free(struct photo_list *list);

/*
 * Whether there is one of each picture. Where files are called as the pictures are, each must stand
 * at its picture's place; all other names say nothing.
 */
bool photo_list_check(const struct photo_list *list, const struct series *series, char *message);

/* Whether nothing that decode writes is one of them or another file that it reads or writes. */
bool photo_list_differs(const struct photo_list *list, const struct capture_options *options,
                        char *message);

#endif
