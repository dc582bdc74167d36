/* Files that the command line names twice, so that one would be written over another. */
#ifndef FILE_CLASH_H
#define FILE_CLASH_H

#include <stdbool.h>

#include "options.h"

/*
 * Whether the files to be written differ from each other and from those to be read. The one
 * exception: --rig and --save-rig may be one file, which is how a rig is changed in place. Files
 * that are there count as the same by device and inode, others by folder and name.
 *
 * picture  the picture to be written; NULL: none
 *
 * False with one line in `message`, MESSAGE_SIZE bytes.
 */
bool file_clash_check(const struct options *options, const char *picture, char *message);

#endif
