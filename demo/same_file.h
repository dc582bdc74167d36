/* Whether two names are of one file. */
#ifndef SAME_FILE_H
#define SAME_FILE_H

#include <stdbool.h>

/* Files that are there by device and inode, others by folder and name. */
bool same_file(const char *a, const char *b);

#endif
