/* Opening of files to be read. */
#include "input_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "atomic_file.h"
#include "error.h"

int input_file_open(const char *path, FILE **file, uint64_t *size, struct cupola_error *error)
{
    char reason[FILE_REASON_SIZE];
    struct stat status;
    if (!path || !*path)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "file name is empty; allowed: a path");
    /* Without O_NONBLOCK a pipe would wait here for somebody to write. */
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0)
        return error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be opened: %s", path,
                         file_reason(errno, reason));
    if (fstat(fd, &status) != 0) {
        error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be read: %s", path,
                  file_reason(errno, reason));
        goto fail;
    }
    if (!S_ISREG(status.st_mode)) {
        error_set(error, CUPOLA_ERROR_FILE, "%s: is %s; allowed: a regular file", path,
                  S_ISDIR(status.st_mode) ? "a directory" : "a device or a pipe");
        goto fail;
    }
    *file = fdopen(fd, "rb");
    if (!*file) {
        error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be read: %s", path,
                  file_reason(errno, reason));
        goto fail;
    }
    *size = (uint64_t)status.st_size;
    return CUPOLA_OK;

fail:
    close(fd);
    return CUPOLA_ERROR_FILE;
}
