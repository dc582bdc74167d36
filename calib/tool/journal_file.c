/* The file of a journal. */
#include "tool/journal_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "option_values.h"
#include "short_path.h"

enum {
    FILE_BYTES_MAX = 1 << 30,
    PENDING_BYTES_MAX = 16 << 20, /* beyond, changes are not written any more */
    NAMES_MAX = 1000,
};

static enum journal_file_opened refuse(struct journal_file *file, char *message, const char *why)
{
    snprintf(message, MESSAGE_SIZE, "%s cannot be used as a journal: %s",
             short_path(file->path).text, why);
    journal_file_close(file, false);
    return JOURNAL_FILE_REFUSED;
}

/* Whether the path still leads to the open file: another tool may just have removed it. */
static bool is_current(const struct journal_file *file)
{
    struct stat opened, named;

    return fstat(file->fd, &opened) == 0 && stat(file->path, &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

static void sync_directory(const char *path)
{
    const char *slash = strrchr(path, '/');
    char *directory = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    int fd = directory ? open(directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;

    if (fd >= 0) {
        fsync(fd);
        close(fd);
    }
    free(directory);
}

static enum journal_file_opened open_once(struct journal_file *file, char *message)
{
    struct stat found;

    file->fd = open(file->path, O_RDWR | O_CREAT | O_APPEND | O_NONBLOCK | O_CLOEXEC, 0666);
    if (file->fd < 0)
        return refuse(file, message, strerror(errno));
    if (fstat(file->fd, &found) != 0 || !S_ISREG(found.st_mode))
        return refuse(file, message, "it is no plain file");
    if (flock(file->fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        snprintf(message, MESSAGE_SIZE,
                 "%s is in use: another cupola-calib works on the same rig; allowed: one at a time",
                 short_path(file->path).text);
        journal_file_close(file, false);
        return JOURNAL_FILE_USED;
    }
    return JOURNAL_FILE_OPEN; /* also where a file system knows no locks */
}

enum journal_file_opened journal_file_open(struct journal_file *file, const char *path,
                                           char *message)
{
    *file = (struct journal_file){.fd = -1, .path = strdup(path)};
    if (!file->path) {
        snprintf(message, MESSAGE_SIZE, "out of memory for the journal's name");
        return JOURNAL_FILE_REFUSED;
    }
    for (int attempt = 0; attempt < 10; attempt++) {
        enum journal_file_opened opened = open_once(file, message);
        if (opened != JOURNAL_FILE_OPEN)
            return opened;
        if (is_current(file))
            return JOURNAL_FILE_OPEN;
        close(file->fd);
        file->fd = -1;
    }
    return refuse(file, message, "it comes and goes");
}

char *journal_file_read(struct journal_file *file, size_t *size, char *message)
{
    struct stat found;
    char *bytes = NULL;
    size_t done = 0;

    if (fstat(file->fd, &found) == 0 && found.st_size <= FILE_BYTES_MAX)
        bytes = malloc((size_t)found.st_size + 1);
    while (bytes && done < (size_t)found.st_size) {
        ssize_t part = pread(file->fd, bytes + done, (size_t)found.st_size - done, (off_t)done);
        if (part < 0 && errno == EINTR)
            continue;
        if (part <= 0)
            break;
        done += (size_t)part;
    }
    if (bytes && done == (size_t)found.st_size) {
        *size = done;
        return bytes;
    }
    snprintf(message, MESSAGE_SIZE, "%s cannot be read, or is larger than %d bytes",
             short_path(file->path).text, (int)FILE_BYTES_MAX);
    free(bytes);
    return NULL;
}

bool journal_file_keep_aside(struct journal_file *file, const char *ending, char *name,
                             size_t name_size, char *message)
{
    struct stat found;

    for (int i = 1; i <= NAMES_MAX; i++) {
        int length = i == 1 ? snprintf(name, name_size, "%s.%s", file->path, ending)
                            : snprintf(name, name_size, "%s.%s.%d", file->path, ending, i);
        if (length < 0 || (size_t)length >= name_size)
            break;
        if (lstat(name, &found) == 0)
            continue;
        if (rename(file->path, name) != 0)
            break;
        sync_directory(name);
        return true;
    }
    snprintf(message, MESSAGE_SIZE, "%s cannot be moved aside: %s", short_path(file->path).text,
             strerror(errno));
    return false;
}

bool journal_file_cut(struct journal_file *file, size_t size)
{
    return ftruncate(file->fd, (off_t)size) == 0;
}

/* Returns how much was written. */
static size_t write_all(int fd, const char *bytes, size_t size)
{
    size_t done = 0;

    while (done < size) {
        ssize_t part = write(fd, bytes + done, size - done);
        if (part < 0 && errno == EINTR)
            continue;
        if (part <= 0)
            break;
        done += (size_t)part;
    }
    return done;
}

void journal_file_give_up(struct journal_file *file, int problem)
{
    if (file->given_up == 0)
        file->given_up = problem;
}

/* Behind what already waits. What does not fit is lost, and with it all that follows. */
static void keep(struct journal_file *file, const char *bytes, size_t size)
{
    int problem = errno;
    char *more = NULL;

    if (file->pending_size + size <= PENDING_BYTES_MAX)
        more = realloc(file->pending, file->pending_size + size);
    if (more) {
        memcpy(more + file->pending_size, bytes, size);
        file->pending = more;
        file->pending_size += size;
    } else {
        journal_file_give_up(file, ENOSPC);
    }
    errno = problem;
}

bool journal_file_flush(struct journal_file *file)
{
    size_t done;

    if (file->given_up) {
        errno = file->given_up;
        return false;
    }
    if (file->pending_size > 0) {
        done = write_all(file->fd, file->pending, file->pending_size);
        file->pending_size -= done;
        memmove(file->pending, file->pending + done, file->pending_size);
        file->dirty = true;
    }
    return file->pending_size == 0;
}

bool journal_file_append(struct journal_file *file, const char *bytes, size_t size)
{
    bool flushed = journal_file_flush(file);
    size_t done;

    if (file->given_up)
        return false;
    done = flushed ? write_all(file->fd, bytes, size) : 0;
    file->dirty = true;
    if (done == size)
        return true;
    keep(file, bytes + done, size - done);
    return false;
}

void journal_file_sync(struct journal_file *file)
{
    if (file->fd >= 0 && file->dirty) {
        fdatasync(file->fd);
        if (!file->named)
            sync_directory(file->path);
        file->named = true;
    }
    file->dirty = false;
}

void journal_file_close(struct journal_file *file, bool remove_file)
{
    if (file->fd >= 0) {
        if (remove_file && is_current(file))
            unlink(file->path); /* before the lock goes */
        else
            journal_file_sync(file);
        close(file->fd);
    }
    free(file->path);
    free(file->pending);
    *file = (struct journal_file){.fd = -1};
}
