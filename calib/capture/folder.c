/* The folder of a series. */
#include "capture/folder.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "capture/photo.h"
#include "option_values.h"
#include "same_file.h"
#include "short_path.h"
#include "whole_file.h"

static const char series_file[] = "patterns";

enum { PHOTOS_MAX = 1000, SIDE_MAX = 32768 };

bool folder_make(const char *option, const char *folder, char *message)
{
    struct stat status;

    if (stat(folder, &status) == 0 && S_ISDIR(status.st_mode) && access(folder, W_OK | X_OK) == 0)
        return true;
    if (stat(folder, &status) == 0 && !S_ISDIR(status.st_mode))
        errno = ENOTDIR;
    else if (stat(folder, &status) != 0 && mkdir(folder, 0777) == 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s: %s cannot be written to: %s", option,
             short_path(folder).text, strerror(errno));
    return false;
}

bool folder_is_another(const char *folder, const char *patterns, char *message)
{
    if (!folder || !patterns || !same_file(patterns, folder))
        return true;
    snprintf(message, MESSAGE_SIZE,
             "--patterns and --folder are the same folder, %s; allowed: a folder of their own for "
             "the photographs",
             short_path(folder).text);
    return false;
}

bool folder_path(const char *folder, const char *name, const char *suffix, char path[PATH_MAX],
                 char *message)
{
    int length = snprintf(path, PATH_MAX, "%s/%s%s", folder, name, suffix);

    if (length < PATH_MAX)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s: the name is too long", short_path(folder).text);
    return false;
}

bool folder_write_series(const char *folder, const struct series *series, char *message)
{
    char path[PATH_MAX];
    struct whole_file file;

    if (!folder_path(folder, series_file, ".txt", path, message) ||
        !whole_file_begin(&file, path, message))
        return false;
    fprintf(file.stream,
            "# Pictures of structured light; shown, and photographed, in the order of their names."
            "\nversion = 1\nwidth_px = %d\nheight_px = %d\nperiod_px = %d\nsteps = %d\n"
            "# %d pictures: %d bits of x, %d bits of y\n",
            series->size_px[0], series->size_px[1], series->period_px, series->steps,
            series_count(series), series_bits(series, 0), series_bits(series, 1));
    return whole_file_end(&file, message);
}

static bool file_differs(const char *option, const char *path, bool written,
                         const struct named_file *others, int count, char *message)
{
    for (int i = 0; i < count; i++) {
        const struct named_file pair[] = {others[i],
                                          {.name = option, .path = path, .written = written}};
        if (!named_files_differ(pair, 2, message))
            return false;
    }
    return true;
}

bool folder_differs(const char *option, const char *folder, const char *suffix, bool written,
                    const struct series *series, const struct named_file *others, int count,
                    char *message)
{
    char path[PATH_MAX], name[SERIES_NAME_MAX + 1];

    if (!folder_path(folder, series_file, ".txt", path, message) ||
        !file_differs(option, path, written, others, count, message))
        return false;
    for (int i = 0; i < series_count(series); i++) {
        series_name(series, i, name);
        if (!folder_path(folder, name, suffix, path, message) ||
            !file_differs(option, path, written, others, count, message))
            return false;
    }
    return true;
}

static bool is_of_series(const struct series *series, const char *base, const char *suffix)
{
    char name[SERIES_NAME_MAX + 1];

    for (int i = 0; i < series_count(series); i++) {
        series_name(series, i, name);
        if (strncmp(base, name, strlen(name)) == 0 && strcmp(base + strlen(name), suffix) == 0)
            return true;
    }
    return false;
}

bool folder_is_for(const char *option, const char *folder, const char *suffix,
                   const struct series *series, char *message)
{
    DIR *directory = opendir(folder);
    struct dirent *entry;
    bool done = true;

    while (directory && done && (entry = readdir(directory))) {
        done = entry->d_name[0] == '.' || !photo_is_named(entry->d_name) ||
               is_of_series(series, entry->d_name, suffix);
        if (!done)
            snprintf(message, MESSAGE_SIZE,
                     "%s: %s has %.100s, which is not of this series; allowed: a folder without "
                     "pictures, or with those that are written anew",
                     option, short_path(folder).text, entry->d_name);
    }
    if (directory)
        closedir(directory);
    return done;
}

struct series_key {
    const char *name;
    int low, high;
    int *value;
    bool seen;
};

static bool read_line(const char *path, int number, char *line, struct series_key *keys, int count,
                      char *message)
{
    char name[32], text[32], rest;

    if (line[strspn(line, " \t\r\n")] == 0 || line[strspn(line, " \t")] == '#')
        return true;
    if (sscanf(line, " %31[a-z_] = %31s %c", name, text, &rest) == 2) {
        for (int i = 0; i < count; i++) {
            char option[SHORT_PATH_MAX + 64];
            struct value_context context = {option, message};
            if (strcmp(name, keys[i].name) != 0)
                continue;
            snprintf(option, sizeof option, "%s:%d: %s", short_path(path).text, number, name);
            if (keys[i].seen) {
                snprintf(message, MESSAGE_SIZE, "%s is there twice; allowed: once", option);
                return false;
            }
            keys[i].seen = true;
            return value_integer(&context, text, keys[i].low, keys[i].high, keys[i].value);
        }
    }
    snprintf(message, MESSAGE_SIZE,
             "%s:%d: '%.60s' is not allowed; allowed: KEY = NUMBER with version, width_px, "
             "height_px, period_px, steps",
             short_path(path).text, number, strtok(line, "\r\n"));
    return false;
}

static bool check_keys(const char *path, const struct series_key *keys, int count, char *message)
{
    for (int i = 0; i < count; i++) {
        if (!keys[i].seen) {
            snprintf(message, MESSAGE_SIZE, "%s: %s is missing", short_path(path).text,
                     keys[i].name);
            return false;
        }
    }
    return true;
}

static bool read_series(FILE *file, const char *path, struct series *series, char *message)
{
    int version = 0;
    char line[256];
    struct series_key keys[] = {
        {"version", 1, 1, &version, false},
        {"width_px", 1, SIDE_MAX, &series->size_px[0], false},
        {"height_px", 1, SIDE_MAX, &series->size_px[1], false},
        {"period_px", SERIES_PERIOD_MIN, SERIES_PERIOD_MAX, &series->period_px, false},
        {"steps", SERIES_STEPS_MIN, SERIES_STEPS_MAX, &series->steps, false},
    };
    int count = (int)(sizeof keys / sizeof *keys);

    for (int number = 1; fgets(line, sizeof line, file); number++) {
        if (strlen(line) == sizeof line - 1 && line[sizeof line - 2] != '\n') {
            snprintf(message, MESSAGE_SIZE, "%s:%d: the line is too long; allowed: %d bytes",
                     short_path(path).text, number, (int)sizeof line - 2);
            return false;
        }
        if (!read_line(path, number, line, keys, count, message))
            return false;
    }
    if (!check_keys(path, keys, count, message))
        return false;
    if (series->period_px % 2 == 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s: period_px: %d is not allowed; allowed: even numbers",
             short_path(path).text, series->period_px);
    return false;
}

bool folder_read_series(const char *folder, struct series *series, char *message)
{
    char path[PATH_MAX];
    FILE *file;
    bool done;

    if (!folder_path(folder, series_file, ".txt", path, message))
        return false;
    file = fopen(path, "r");
    if (!file) {
        snprintf(message, MESSAGE_SIZE,
                 "%s cannot be read: %s; it says what the pictures are, and 'capture patterns' "
                 "writes it (--patterns names its folder)",
                 short_path(path).text, strerror(errno));
        return false;
    }
    done = read_series(file, path, series, message);
    fclose(file);
    return done;
}

void folder_photos_free(struct folder_photos *photos)
{
    for (int i = 0; i < photos->count; i++)
        free(photos->paths[i]);
    free(photos->paths);
    *photos = (struct folder_photos){0};
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static bool collect(DIR *directory, const char *folder, struct folder_photos *photos, char *message)
{
    struct dirent *entry;
    char path[PATH_MAX];

    photos->paths = calloc(PHOTOS_MAX, sizeof *photos->paths);
    while (photos->paths && (entry = readdir(directory))) {
        if (entry->d_name[0] == '.' || !photo_is_named(entry->d_name))
            continue;
        if (photos->count == PHOTOS_MAX) {
            snprintf(message, MESSAGE_SIZE, "%s: more than %d pictures", short_path(folder).text,
                     PHOTOS_MAX);
            return false;
        }
        if (!folder_path(folder, entry->d_name, "", path, message))
            return false;
        photos->paths[photos->count] = strdup(path);
        if (!photos->paths[photos->count])
            break;
        photos->count++;
    }
    if (photos->paths && photos->count > 0) {
        qsort(photos->paths, (size_t)photos->count, sizeof *photos->paths, by_name);
        return true;
    }
    snprintf(message, MESSAGE_SIZE,
             "%s: no photographs there; allowed: files *.png, *.jpg, *.jpeg, *.pfm",
             short_path(folder).text);
    return false;
}

bool folder_list(const char *folder, struct folder_photos *photos, char *message)
{
    DIR *directory = opendir(folder);
    bool done;

    *photos = (struct folder_photos){0};
    if (!directory) {
        snprintf(message, MESSAGE_SIZE, "%s cannot be read: %s", short_path(folder).text,
                 strerror(errno));
        return false;
    }
    done = collect(directory, folder, photos, message);
    closedir(directory);
    if (!done)
        folder_photos_free(photos);
    return done;
}
