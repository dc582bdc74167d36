/* Text files that appear whole or not at all. Pictures and rigs have the library's own writers. */
#ifndef WHOLE_FILE_H
#define WHOLE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/*
 * A file of text that takes its name when it is done. Until then it stands beside it under a
 * temporary one. A link stays a link; devices, pipes and directories are refused.
 */
struct whole_file {
    FILE *stream;    /* to be written to; NULL: settled */
    char *path;      /* links followed */
    char *temporary; /* beside it */
};

/* False with one line in `message`, MESSAGE_SIZE bytes; nothing is then to be ended. */
bool whole_file_begin(struct whole_file *file, const char *path, char *message);

/*
 * Brings all of it to the disk, so that only the name is still to be given: with several files,
 * none is given one before all are there. False with one line; nothing is then to be ended.
 */
bool whole_file_settle(struct whole_file *file, char *message);

/*
 * Gives it its name, after bringing to the disk what is not yet there. False with one line; the old
 * file is as it was.
 */
bool whole_file_end(struct whole_file *file, char *message);

/* Gives up: the temporary file goes. Nothing happens to what is all zero, or ended. */
void whole_file_abort(struct whole_file *file);

/*
 * Reads all of a file, with a 0 after it; to be freed. NULL with one line where it cannot be read
 * or has more than `most` bytes.
 */
char *whole_file_read(const char *path, size_t most, size_t *size, char *message);

#endif
