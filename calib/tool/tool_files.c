/* The files that a session reads and writes: none of them is written over another. */
#include "tool/tool_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "named_files.h"
#include "output_file.h"
#include "same_file.h"
#include "tool/journal.h"
#include "tool/tool.h"

/* Of a session; what a line of a script names comes behind them. */
enum { NAMES = 9, ALL_NAMES = NAMES + 2 };

/* What saving a rig leaves beside it, to be freed; NULL: a link that leads nowhere, or no rig. */
struct beside {
    char *backup, *journal;
};

static struct beside find_beside(const char *output)
{
    char *rig = output ? output_file_behind_links(output) : NULL;
    size_t size = (rig ? strlen(rig) : 0) + sizeof ".bak";
    struct beside beside = {rig ? malloc(size) : NULL, output ? journal_path_beside(output) : NULL};

    if (beside.backup)
        snprintf(beside.backup, size, "%s.bak", rig);
    free(rig);
    return beside;
}

static void forget_beside(struct beside *beside)
{
    free(beside->backup);
    free(beside->journal);
}

static bool same(const char *a, const char *b)
{
    return a && b && same_file(a, b);
}

static void list_session(const struct tool_files *files, const char *output,
                         const char *marks_output, const struct beside *beside,
                         struct named_file list[ALL_NAMES])
{
    /* The rig may be its own theatre, as it is without the option. */
    bool own_theatre = same(files->theatre, files->rig),
         own_marks = same(files->marks, marks_output);
    /* Who gave no name is told where it comes from. */
    bool given = files->output_given;
    const struct named_file session[NAMES] = {
        {.name = "--rig", .path = files->rig},
        {given ? "--output" : "default --output", output, true, true},
        {given ? "--output (what was there)" : "default --output (what was there)", beside->backup,
         true, true},
        {given ? "--output (its journal)" : "default --output (its journal)", beside->journal, true,
         false},
        {.name = "--theatre", .path = own_theatre ? NULL : files->theatre},
        {.name = "--marks", .path = own_marks ? NULL : files->marks},
        {.name = files->marks_output_given ? "--marks-output" : "default --marks-output",
         .path = marks_output,
         .written = true},
        {.name = "--script", .path = files->script},
        {.name = "--picture", .path = files->picture, .written = true},
    };

    memcpy(list, session, sizeof session);
}

bool tool_files_check(const struct tool_files *files, const char *output, const char *marks_output,
                      char *message)
{
    struct named_file list[ALL_NAMES];
    struct beside beside = find_beside(output);
    bool differ;

    list_session(files, output, marks_output, &beside, list);
    differ = named_files_differ(list, NAMES, message);
    forget_beside(&beside);
    return differ;
}

bool tool_files_check_line(const struct tool *tool, const char *what, const char *path,
                           bool saves_rig, char *message)
{
    struct named_file list[ALL_NAMES];
    struct tool_files files = tool->files;
    struct beside session, line;
    bool differ;

    if (saves_rig && same(path, tool->rig_path))
        return true;
    if (saves_rig && same(path, files.rig)) {
        /* Both were read, and neither is read again. */
        if (same(files.theatre, files.rig))
            files.theatre = NULL;
        files.rig = NULL;
    }
    session = find_beside(tool->rig_path);
    line = find_beside(path);
    list_session(&files, tool->rig_path, tool->marks_path, &session, list);
    list[NAMES] = (struct named_file){.name = what, .path = path, .written = true};
    list[NAMES + 1] =
        (struct named_file){.name = what, .path = saves_rig ? line.backup : NULL, .written = true};
    differ = named_files_differ(list, ALL_NAMES, message);
    forget_beside(&line);
    forget_beside(&session);
    return differ;
}
