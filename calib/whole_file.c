/* Text files that appear whole or not at all. */
#include "whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "option_values.h"
#include "output_file.h"
#include "short_path.h"

static bool fail(const char *path, const char *what, int problem, char *message)
{
    snprintf(message, MESSAGE_SIZE, "%s: %s: %s", short_path(path).text, what, strerror(problem));
    return false;
}

static void forget(struct whole_file *file)
{
    free(file->path);
    free(file->temporary);
    *file = (struct whole_file){0};
}

/* By open and not by mkstemp, which does not ask the umask. */
static int create_temporary(struct whole_file *file)
{
    enum { ATTEMPTS = 100, SUFFIX_SIZE = 64 };
    const char *slash = strrchr(file->path, '/');
    size_t length = slash ? (size_t)(slash - file->path) + 1 : 0;

    file->temporary = malloc(length + SUFFIX_SIZE);
    if (!file->temporary)
        return -1;
    memcpy(file->temporary, file->path, length);
    for (int i = 0; i < ATTEMPTS; i++) {
        snprintf(file->temporary + length, SUFFIX_SIZE, ".cupola-calib-%ld-%d", (long)getpid(), i);
        int fd = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST)
            return fd;
    }
    return -1;
}

bool whole_file_begin(struct whole_file *file, const char *path, char *message)
{
    struct stat there;
    bool replaces = stat(path, &there) == 0;
    int fd;

    *file = (struct whole_file){0};
    if (replaces && !S_ISREG(there.st_mode)) {
        snprintf(message, MESSAGE_SIZE, "%s: is no plain file; allowed: a plain or a new one",
                 short_path(path).text);
        return false;
    }
    if (replaces && access(path, W_OK) != 0)
        return fail(path, "cannot be written", errno, message);
    file->path = output_file_behind_links(path);
    if (!file->path || (fd = create_temporary(file)) < 0) {
        fail(path, "cannot be written", errno ? errno : EIO, message);
        forget(file);
        return false;
    }
    if (replaces)
        fchmod(fd, there.st_mode & 0777); /* not every file system has permissions */
    file->stream = fdopen(fd, "wb");
    if (file->stream)
        return true;
    fail(path, "cannot be written", errno, message);
    close(fd);
    whole_file_abort(file);
    return false;
}

static bool give_up(struct whole_file *file, int problem, char *message)
{
    fail(file->path, "cannot be written", problem, message);
    whole_file_abort(file);
    return false;
}

bool whole_file_settle(struct whole_file *file, char *message)
{
    int problem = 0;

    errno = 0;
    if (ferror(file->stream) || fflush(file->stream) != 0 || fsync(fileno(file->stream)) != 0)
        problem = errno ? errno : EIO;
    if (fclose(file->stream) != 0 && !problem)
        problem = errno;
    file->stream = NULL;
    return !problem || give_up(file, problem, message);
}

bool whole_file_end(struct whole_file *file, char *message)
{
    if (file->stream && !whole_file_settle(file, message))
        return false;
    if (rename(file->temporary, file->path) != 0)
        return give_up(file, errno, message);
    forget(file);
    return true;
}

void whole_file_abort(struct whole_file *file)
{
    if (file->stream)
        fclose(file->stream);
    if (file->temporary)
        unlink(file->temporary);
    forget(file);
}

/* NULL with errno 0 where there is more. */
static char *read_stream(FILE *stream, size_t most, size_t *size)
{
    size_t room = 0, used = 0, got;
    char *text = NULL;

    do {
        char *more = realloc(text, room + 65536 + 1);
        if (!more) {
            free(text);
            errno = ENOMEM;
            return NULL;
        }
        text = more;
        room += 65536;
        got = fread(text + used, 1, room - used, stream);
        used += got;
    } while (used == room && used <= most);
    errno = ferror(stream) ? (errno ? errno : EIO) : 0;
    if (errno || used > most) {
        free(text);
        return NULL;
    }
    text[used] = 0;
    *size = used;
    return text;
}

char *whole_file_read(const char *path, size_t most, size_t *size, char *message)
{
    struct stat there;
    FILE *stream = NULL;
    char *text;

    if (stat(path, &there) != 0 || (!S_ISDIR(there.st_mode) && !(stream = fopen(path, "rb")))) {
        fail(path, "cannot be read", errno, message);
        return NULL;
    }
    if (!stream) {
        fail(path, "cannot be read", EISDIR, message);
        return NULL;
    }
    text = read_stream(stream, most, size);
    if (!text && errno)
        fail(path, "cannot be read", errno, message);
    else if (!text)
        snprintf(message, MESSAGE_SIZE, "%s: is too large; allowed: up to %zu bytes",
                 short_path(path).text, most);
    fclose(stream);
    return text;
}
