/* Opening of files to be read: regular files only, with a size that is known beforehand. */
#ifndef INPUT_FILE_H
#define INPUT_FILE_H

#include <stdint.h>
#include <stdio.h>

#include "cupola/error.h"

/*
 * Opens a regular file; directories, devices and pipes are refused.
 *
 * file     out: to be closed by the caller
 * size     out: bytes
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT for no path; CUPOLA_ERROR_FILE
 */
int input_file_open(const char *path, FILE **file, uint64_t *size, struct cupola_error *error);

#endif
