/* What PNG and PFM files have in common. */
#ifndef IMAGE_FILE_PRIVATE_H
#define IMAGE_FILE_PRIVATE_H

#include "atomic_file.h"
#include "cupola/image_file.h"

enum { IMAGE_SIDE_MAX_PX = 32768, IMAGE_CHANNELS = 3 };

/* Whether an image can be written under this name at all. */
int image_file_check(const char *path, const float *rgba, int width, int height,
                     struct cupola_error *error);

/* Says that there is no memory for an image. */
int image_file_no_memory(struct cupola_error *error, const char *path, int width, int height);

/* Gives the file its name, or removes it where something failed before; returns what happened. */
int image_file_finish(struct atomic_file *file, int status, struct cupola_error *error);

#endif
