/* What PNG and PFM files have in common. */
#include "image_file.h"

#include <stdlib.h>

#include "error.h"

int image_file_check(const char *path, const float *rgba, int width, int height,
                     struct cupola_error *error)
{
    if (!path || !*path)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "file name is empty; allowed: a path");
    if (!rgba)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s: image is NULL; allowed: pixels", path);
    if (width < 1 || width > IMAGE_SIDE_MAX_PX || height < 1 || height > IMAGE_SIDE_MAX_PX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "%s: image is %d x %d px; allowed: 1 to %d each", path, width, height,
                         (int)IMAGE_SIDE_MAX_PX);
    return CUPOLA_OK;
}

int image_file_no_memory(struct cupola_error *error, const char *path, int width, int height)
{
    return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory for an image of %d x %d px",
                     path, width, height);
}

int image_file_finish(struct atomic_file *file, int status, struct cupola_error *error)
{
    if (status == CUPOLA_OK)
        return atomic_file_commit(file, false, error);
    atomic_file_abort(file);
    return status;
}

void cupola_image_free(float **rgba)
{
    if (!rgba)
        return;
    free(*rgba);
    *rgba = NULL;
}
