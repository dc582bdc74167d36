/* Files that the command line names twice. */
#include "file_clash.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "named_files.h"

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
    /* The rig itself, or its last state: both are still there afterwards. */
    const struct named_file files[] = {
        {.name = "--rig", .path = options->rig},
        {.name = "--lens-table", .path = options->lens_table},
        {.name = "MODEL", .path = options->model},
        {"--save-rig", save, true, true},
        {"--save-rig (what was there)", *backup ? backup : NULL, true, true},
        {.name = "--stats", .path = is_stdout ? NULL : stats, .written = true},
        {.name = "--output", .path = picture, .written = true},
        {.name = "--reference", .path = *part ? part : NULL, .written = true},
        {.name = "--show", .path = options->show},
        {.name = "--report", .path = report_to_stdout ? NULL : options->report, .written = true},
    };

    return named_files_differ(files, (int)(sizeof files / sizeof *files), message);
}
