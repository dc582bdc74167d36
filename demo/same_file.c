/* Whether two names are of one file. */
#include "same_file.h"

#include <limits.h>
#include <string.h>
#include <sys/stat.h>

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

bool same_file(const char *a, const char *b)
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
