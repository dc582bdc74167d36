/* How cupola-calib says what failed. */
#include "status.h"

#include <stdio.h>

int complain(const char *command, int status, const char *message)
{
    fprintf(stderr, "cupola-calib%s%s: ", *command ? " " : "", command);
    for (const char *at = message; *at; at++)
        fputc((unsigned char)*at < 0x20 ? '?' : *at, stderr);
    fputc('\n', stderr);
    return status;
}
