/* Files that the command line names twice. */
#include "file_clash.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "short_path.h"

struct named {
    const char *name; /* as the user knows it */
    const char *path; /* NULL: not given */
    bool written;
};

static bool same_place(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* The folder of a path, and the name in it. False where there is no such folder. */
static bool find_folder(const char *path, struct stat *folder, const char **name)
{
    char parent[PATH_MAX];
    const char *slash = strrchr(path, '/');
    size_t length = slash ? (size_t)(slash - path) + 1 : 0;

    *name = path + length;
    if (length >= sizeof parent)
        return false;
    memcpy(parent, path, length);
    parent[length] = 0;
    return stat(length ? parent : ".", folder) == 0;
}

static bool same_file(const char *a, const char *b)
{
    struct stat place[2];
    const char *name[2];

    if (strcmp(a, b) == 0)
        return true;
    if (stat(a, &place[0]) == 0 && stat(b, &place[1]) == 0)
        return same_place(&place[0], &place[1]);
    return find_folder(a, &place[0], &name[0]) && find_folder(b, &place[1], &name[1]) &&
           same_place(&place[0], &place[1]) && strcmp(name[0], name[1]) == 0;
}

bool file_clash_check(const struct options *options, const char *picture, char *message)
{
    const char *stats = options->stats;
    char backup[PATH_MAX] = "", part[PATH_MAX] = "";
    const char *save = options->save_rig;
    bool is_stdout = stats && strcmp(stats, "-") == 0;
    bool report_to_stdout = options->report && strcmp(options->report, "-") == 0;

    if (save && snprintf(backup, sizeof backup, "%s.bak", save) >= (int)sizeof backup)
        backup[0] = 0;
    if (options->reference && picture &&
        snprintf(part, sizeof part, "%s.part", picture) >= (int)sizeof part)
        part[0] = 0;
    const struct named files[] = {
        {"--rig", options->rig, false},
        {"--lens-table", options->lens_table, false},
        {"MODEL", options->model, false},
        {"--save-rig", save, true},
        {"--save-rig (what was there)", *backup ? backup : NULL, true},
        {"--stats", is_stdout ? NULL : stats, true},
        {"--output", picture, true},
        {"--reference", *part ? part : NULL, true},
        {"--show", options->show, false},
        {"--report", report_to_stdout ? NULL : options->report, true},
    };
    enum { COUNT = sizeof files / sizeof *files };

    for (int i = 0; i < COUNT; i++) {
        for (int j = i + 1; j < COUNT; j++) {
            /* The rig itself, or its last state: both are still there afterwards. */
            bool in_place = i == 0 && (j == 3 || j == 4);
            if (!files[i].path || !files[j].path || !(files[i].written || files[j].written) ||
                in_place || !same_file(files[i].path, files[j].path))
                continue;
            snprintf(message, MESSAGE_SIZE,
                     "%s and %s are the same file, %s; allowed: files of their own", files[i].name,
                     files[j].name, short_path(files[j].path).text);
            return false;
        }
    }
    return true;
}
