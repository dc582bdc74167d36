/* The files that a session reads and writes: none of them is written over another. */
#ifndef TOOL_FILES_H
#define TOOL_FILES_H

#include <stdbool.h>

struct tool;

/* Of the command line; NULL: not given. The names are not copied. */
struct tool_files {
    const char *rig, *theatre, *marks, *script, *picture;
    bool output_given, marks_output_given; /* else where things are saved is a default */
};

/*
 * Whether saving the rig to `output` and marks to `marks_output`, NULL where nothing is saved,
 * would write over nothing else. Rig and marks may be saved to where they came from. False with
 * one line in `message`, MESSAGE_SIZE bytes.
 */
bool tool_files_check(const struct tool_files *files, const char *output, const char *marks_output,
                      char *message);

/*
 * The same for a file that a script names in its line `what`. Where that saves the rig it may be
 * the session's own.
 */
bool tool_files_check_line(const struct tool *tool, const char *what, const char *path,
                           bool saves_rig, char *message);

#endif
