/* The files that the demo writes. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "output_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cupola/gl.h>
#include <cupola/image_file.h>

#include "option_values.h"
#include "short_path.h"

bool output_file_is_pfm(const char *path)
{
    size_t length = strlen(path);
    return length > 4 && strcasecmp(path + length - 4, ".pfm") == 0;
}

bool output_file_check(const char *option, const char *path, char *message)
{
    struct stat file;
    const char *slash = strrchr(path, '/');
    char *directory;
    int problem = 0;

    if (stat(path, &file) != 0 && lstat(path, &file) == 0 && S_ISLNK(file.st_mode)) {
        snprintf(message, MESSAGE_SIZE,
                 "%s: %s is a symbolic link that leads nowhere; allowed: a "
                 "plain file, a new one or a link to a plain one",
                 option, short_path(path).text);
        return false;
    }
    if (stat(path, &file) == 0 && !S_ISREG(file.st_mode)) {
        snprintf(message, MESSAGE_SIZE, "%s: %s is no plain file; allowed: a plain or a new one",
                 option, short_path(path).text);
        return false;
    }
    directory = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    if (!directory)
        problem = ENOMEM;
    else if (stat(directory, &file) != 0 || access(directory, W_OK | X_OK) != 0)
        problem = errno;
    else if (!S_ISDIR(file.st_mode))
        problem = ENOTDIR;
    free(directory);
    if (problem)
        snprintf(message, MESSAGE_SIZE, "%s: %s cannot be written: %s", option,
                 short_path(path).text, strerror(problem));
    return problem == 0;
}

char *output_file_behind_links(const char *path)
{
    struct stat file;

    return lstat(path, &file) == 0 ? realpath(path, NULL) : strdup(path);
}

bool output_file_write(const char *path, const float *rgba, int width, int height, char *message)
{
    struct cupola_error error = {0};
    int status = output_file_is_pfm(path) ? cupola_pfm_write(path, rgba, width, height, &error)
                                          : cupola_png_write(path, rgba, width, height, &error);

    if (status < 0)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return status >= 0;
}

bool output_file_capture(const char *path, unsigned int framebuffer, int width, int height,
                         char *message)
{
    struct cupola_error error = {0};
    struct cupola_target target = {.framebuffer = framebuffer};
    float *rgba = malloc((size_t)width * (size_t)height * 4 * sizeof *rgba);
    bool written;

    if (!rgba) {
        snprintf(message, MESSAGE_SIZE, "%s: out of memory for %dx%d pixels", short_path(path).text,
                 width, height);
        return false;
    }
    written = cupola_gl_capture(&target, width, height, rgba, &error) >= 0;
    if (!written)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    written = written && output_file_write(path, rgba, width, height, message);
    free(rgba);
    return written;
}
