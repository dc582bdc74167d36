/* The tool as a user runs it: a line of a shell, its exit status and what it said. */
#ifndef COMMAND_FIXTURE_H
#define COMMAND_FIXTURE_H

#include "tool_fixture.h"

static char output[200000]; /* of the last run */

/* Runs a shell's line in which $C is the program; returns its exit status. */
static inline int run(const char *line)
{
    size_t length;
    FILE *process;
    int status;
    char command[4000];

    snprintf(command, sizeof command, "unset DISPLAY WAYLAND_DISPLAY; C='%s'; { %s; } 2>&1",
             getenv("CUPOLA_CALIB"), line);
    process = popen(command, "r");
    assert_non_null(process);
    length = fread(output, 1, sizeof output - 1, process);
    output[length] = '\0';
    status = pclose(process);
    return status < 0 ? status : status >> 8;
}

static inline void check_run(const char *line, int status, const char *says)
{
    int ended = run(line);

    if (ended != status || !strstr(output, says))
        fail_msg("%s: status %d, expected %d with '%s': %s", line, ended, status, says, output);
}

#endif
