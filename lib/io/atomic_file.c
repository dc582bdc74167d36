/* A file that appears whole or not at all. */
#define _XOPEN_SOURCE 700 /* realpath */

#include "atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "error.h"
#include "input_file.h"

const char *file_reason(int number, char reason[FILE_REASON_SIZE])
{
    if (strerror_r(number, reason, FILE_REASON_SIZE) != 0)
        snprintf(reason, FILE_REASON_SIZE, "error %d", number);
    return reason;
}

static int fail_with(struct cupola_error *error, const char *path, const char *what, int number)
{
    char reason[FILE_REASON_SIZE];
    return error_set(error, CUPOLA_ERROR_FILE, "%s: %s: %s", path, what,
                     file_reason(number, reason));
}

static int fail_memory(struct cupola_error *error, const char *path)
{
    return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", path);
}

/* Finds out where the file will really be, and whether it may be there. */
static int resolve(struct atomic_file *file, const char *path, mode_t *mode,
                   struct cupola_error *error)
{
    struct stat status;
    if (stat(path, &status) != 0) {
        int number = errno;
        if (lstat(path, &status) == 0)
            return fail_with(error, path, "is a symbolic link that leads nowhere", number);
        if (number != ENOENT)
            return fail_with(error, path, "cannot be written", number);
        file->path = strdup(path);
        return file->path ? CUPOLA_OK : fail_memory(error, path);
    }
    if (!S_ISREG(status.st_mode))
        return error_set(error, CUPOLA_ERROR_FILE,
                         "%s: is %s; allowed: a regular file or a new name", path,
                         S_ISDIR(status.st_mode) ? "a directory" : "a device or a pipe");
    /* The rename would not ask. */
    if (faccessat(AT_FDCWD, path, W_OK, AT_EACCESS) != 0)
        return fail_with(error, path, "cannot be written", errno);
    file->replaces = true;
    *mode = status.st_mode & 0777;
    file->path = realpath(path, NULL);
    return file->path ? CUPOLA_OK : fail_with(error, path, "cannot be written", errno);
}

static size_t directory_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

/* Creates the temporary file by open and not by mkstemp, because only open respects the umask. */
static int create_temporary(struct atomic_file *file)
{
    enum { ATTEMPTS = 100, SUFFIX_SIZE = 64 };
    size_t length = directory_length(file->path);
    file->temporary = malloc(length + SUFFIX_SIZE);
    if (!file->temporary)
        return -1;
    memcpy(file->temporary, file->path, length);
    for (int i = 0; i < ATTEMPTS; i++) {
        struct timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        snprintf(file->temporary + length, SUFFIX_SIZE, ".cupola-%ld-%lx-%lx", (long)getpid(),
                 (unsigned long)now.tv_nsec, (unsigned long)(uintptr_t)file + (unsigned long)i);
        int fd = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST)
            return fd;
    }
    return -1;
}

static void forget(struct atomic_file *file)
{
    free(file->path);
    free(file->temporary);
    *file = (struct atomic_file){0};
}

int atomic_file_begin(struct atomic_file *file, const char *path, struct cupola_error *error)
{
    mode_t mode = 0;
    *file = (struct atomic_file){0};
    if (!path || !*path)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "file name is empty; allowed: a path");
    int status = resolve(file, path, &mode, error);
    if (status != CUPOLA_OK)
        goto fail;
    int fd = create_temporary(file);
    if (fd < 0) {
        status = file->temporary ? fail_with(error, path, "cannot be written", errno)
                                 : fail_memory(error, path);
        goto fail;
    }
    if (file->replaces && fchmod(fd, mode) != 0)
        status = fail_with(error, path, "permissions cannot be kept", errno);
    else if (!(file->stream = fdopen(fd, "wb")))
        status = fail_with(error, path, "cannot be written", errno);
    if (status == CUPOLA_OK)
        return CUPOLA_OK;
    close(fd);
    unlink(file->temporary);

fail:
    forget(file);
    return status;
}

int atomic_file_add(struct atomic_file *file, const void *bytes, size_t size,
                    struct cupola_error *error)
{
    errno = 0;
    if (fwrite(bytes, 1, size, file->stream) != size)
        return fail_with(error, file->path, "cannot be written", errno ? errno : EIO);
    return CUPOLA_OK;
}

/* Copies and does not link: not every file system has links. */
static int copy_to_backup(const char *path, const char *backup, struct cupola_error *error)
{
    struct atomic_file copy;
    FILE *previous;
    uint64_t size;
    char block[16384];
    int status = input_file_open(path, &previous, &size, error);
    if (status != CUPOLA_OK)
        return status;
    status = atomic_file_begin(&copy, backup, error);
    if (status != CUPOLA_OK) {
        fclose(previous);
        return status;
    }
    size_t count;
    while (status == CUPOLA_OK && (count = fread(block, 1, sizeof block, previous)) > 0)
        status = atomic_file_add(&copy, block, count, error);
    if (status == CUPOLA_OK && ferror(previous))
        status = fail_with(error, path, "cannot be read", EIO);
    fclose(previous);
    if (status == CUPOLA_OK)
        return atomic_file_commit(&copy, false, error);
    atomic_file_abort(&copy);
    return status;
}

static int back_up(const char *path, struct cupola_error *error)
{
    size_t size = strlen(path) + sizeof ".bak";
    char *backup = malloc(size);
    if (!backup)
        return fail_memory(error, path);
    snprintf(backup, size, "%s.bak", path);
    int status = copy_to_backup(path, backup, error);
    free(backup);
    return status;
}

/*
 * Brings the new name itself to the disk. The rename is done and cannot be undone, and some file
 * systems refuse this, so that a failure here is none of the call's.
 */
static void sync_directory(char *path)
{
    size_t length = directory_length(path);
    path[length] = 0;
    int fd = open(length ? path : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0)
        return;
    fsync(fd);
    close(fd);
}

int atomic_file_commit(struct atomic_file *file, bool keep_previous, struct cupola_error *error)
{
    int status = CUPOLA_OK;
    if (fflush(file->stream) != 0 || fsync(fileno(file->stream)) != 0)
        status = fail_with(error, file->path, "cannot be written", errno);
    int closed = fclose(file->stream);
    file->stream = NULL;
    if (status == CUPOLA_OK && closed != 0)
        status = fail_with(error, file->path, "cannot be written", errno);
    if (status == CUPOLA_OK && keep_previous && file->replaces)
        status = back_up(file->path, error);
    if (status == CUPOLA_OK && rename(file->temporary, file->path) != 0)
        status = fail_with(error, file->path, "cannot be replaced", errno);
    if (status != CUPOLA_OK) {
        atomic_file_abort(file);
        return status;
    }
    sync_directory(file->path);
    forget(file);
    return CUPOLA_OK;
}

void atomic_file_abort(struct atomic_file *file)
{
    if (file->stream)
        fclose(file->stream);
    if (file->temporary)
        unlink(file->temporary);
    forget(file);
}
