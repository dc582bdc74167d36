/* The photographs of a series, before any of them is read. */
#include "capture/photo_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "named_files.h"
#include "option_values.h"
#include "short_path.h"

void photo_list_free(struct photo_list *list)
{
    folder_photos_free(&list->folder);
    *list = (struct photo_list){0};
}

bool photo_list_find(const struct capture_options *options, struct photo_list *list, char *message)
{
    *list = (struct photo_list){.paths = options->photos, .count = options->photo_count};
    if (!options->folder)
        return true;
    if (!folder_list(options->folder, &list->folder, message))
        return false;
    list->paths = list->folder.paths;
    list->count = list->folder.count;
    return true;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

/* The picture that a file is called after; -1: none. */
static int find_number(const struct series *series, const char *path)
{
    const char *base = base_name(path);
    int count = series_count(series);

    for (int i = 0; i < count; i++) {
        char name[SERIES_NAME_MAX + 1];
        series_name(series, i, name);
        if (strncmp(base, name, strlen(name)) == 0 && base[strlen(name)] == '.')
            return i;
    }
    return -1;
}

/* "; none is called 05-x-inverse-1" or "; DSC_1.JPG is none of them", where names tell it. */
static void describe_names(const struct photo_list *list, const struct series *series, char *text,
                           size_t text_size)
{
    int all = series_count(series), found = 0, foreign = -1, missing = 0;
    bool *there = calloc((size_t)all, sizeof *there);
    char name[SERIES_NAME_MAX + 1];

    *text = 0;
    for (int i = 0; there && i < list->count; i++) {
        int number = find_number(series, list->paths[i]);
        if (number < 0 && foreign < 0)
            foreign = i;
        if (number < 0 || there[number])
            continue;
        there[number] = true;
        found++;
    }
    while (there && missing < all && there[missing])
        missing++;
    free(there);
    if (found <= all / 2)
        return;
    if (missing < all) {
        series_name(series, missing, name);
        snprintf(text, text_size, "; none is called %s", name);
    } else if (foreign >= 0) {
        snprintf(text, text_size, "; %s is called as none of them is",
                 short_path(list->paths[foreign]).text);
    }
}

bool photo_list_check(const struct photo_list *list, const struct series *series, char *message)
{
    int all = series_count(series);
    char name[SERIES_NAME_MAX + 1], reason[SHORT_PATH_MAX + 100];

    if (list->count != all) {
        describe_names(list, series, reason, sizeof reason);
        snprintf(message, MESSAGE_SIZE,
                 "%d photograph%s; allowed: %d, one of each pattern, in the order of the "
                 "patterns%s",
                 list->count, list->count == 1 ? "" : "s", all, reason);
        return false;
    }
    for (int i = 0; i < all; i++) {
        int number = find_number(series, list->paths[i]);
        if (number < 0 || number == i)
            continue;
        series_name(series, i, name);
        snprintf(message, MESSAGE_SIZE,
                 "photograph %d is %s; allowed: the order of the patterns, where %s has this place",
                 i + 1, short_path(list->paths[i]).text, name);
        return false;
    }
    return true;
}

bool photo_list_differs(const struct photo_list *list, const struct capture_options *options,
                        char *message)
{
    char backup[PATH_MAX] = "";
    const char *solved = options->solved;
    enum { OTHERS = 5 };
    struct named_file *files = calloc((size_t)list->count + OTHERS, sizeof *files);
    bool done;

    if (!files) {
        snprintf(message, MESSAGE_SIZE, "out of memory for %d photographs", list->count);
        return false;
    }
    if (solved && snprintf(backup, sizeof backup, "%s.bak", solved) >= (int)sizeof backup)
        backup[0] = 0;
    files[0] = (struct named_file){.name = "--rig", .path = options->rig};
    files[1] = (struct named_file){.name = "--references", .path = options->references};
    files[2] = (struct named_file){"--output", options->output, true, false};
    files[3] = (struct named_file){"--solved", solved, true, true};
    files[4] =
        (struct named_file){"--solved (what was there)", *backup ? backup : NULL, true, true};
    for (int i = 0; i < list->count; i++)
        files[OTHERS + i] = (struct named_file){.name = "a photograph", .path = list->paths[i]};
    done = named_files_differ(files, list->count + OTHERS, message);
    free(files);
    return done;
}
