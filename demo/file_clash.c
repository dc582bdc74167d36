/* Files that the command line names twice. */
#include "file_clash.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "same_file.h"
#include "short_path.h"

struct named {
    const char *name; /* as the user knows it */
    const char *path; /* NULL: not given */
    bool written;
};

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
