/* Files that a command line names twice, so that one would be written over another. */
#ifndef NAMED_FILES_H
#define NAMED_FILES_H

#include <stdbool.h>

struct named_file {
    const char *name; /* as the user knows it */
    const char *path; /* NULL: not given */
    bool written;
    bool in_place; /* may be the first of the list, which is how a file is changed in place */
};

/*
 * Whether the files to be written differ from each other and from those to be read. Files that are
 * there count as the same by device and inode, others by folder and name. False with one line in
 * `message`, MESSAGE_SIZE bytes.
 */
bool named_files_differ(const struct named_file *files, int count, char *message);

#endif
