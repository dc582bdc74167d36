/*
 * A file that appears whole or not at all: what is written goes into a temporary file in the same
 * directory, which is brought to the disk and then takes the name. A process that is killed leaves
 * the old file as it was (and perhaps a temporary file ".cupola-...").
 */
#ifndef ATOMIC_FILE_H
#define ATOMIC_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "cupola/error.h"

enum { FILE_REASON_SIZE = 128 };

/* What an errno means, into a buffer of the caller's; returns the buffer. */
const char *file_reason(int number, char reason[FILE_REASON_SIZE]);

struct atomic_file {
    FILE *stream;
    char *path;      /* where the file will be; symbolic links are followed, so that they stay */
    char *temporary; /* beside it */
    bool replaces;   /* there was a file at path */
};

/*
 * Begins a file. A path that exists must be a regular file that may be written; its permissions
 * are kept. A new file gets those that the umask leaves.
 *
 * file     out: to be given to either atomic_file_commit or atomic_file_abort, unless this fails
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT for no path; CUPOLA_ERROR_FILE; CUPOLA_ERROR_MEMORY
 */
int atomic_file_begin(struct atomic_file *file, const char *path, struct cupola_error *error);

/* Adds bytes. On failure atomic_file_abort is still the caller's to call. */
int atomic_file_add(struct atomic_file *file, const void *bytes, size_t size,
                    struct cupola_error *error);

/*
 * Brings the bytes to the disk and gives them their name; on failure the temporary file is removed
 * and the old file is as it was.
 *
 * keep_previous  a file that had the name before stays as PATH.bak
 */
int atomic_file_commit(struct atomic_file *file, bool keep_previous, struct cupola_error *error);

/* Removes the temporary file. */
void atomic_file_abort(struct atomic_file *file);

#endif
