/* How cupola-calib says what failed. */
#include "status.h"

#include <stdio.h>

#include "plain_text.h"

int complain(const char *command, int status, const char *message)
{
    fprintf(stderr, "cupola-calib%s%s: ", *command ? " " : "", command);
    plain_text_print(message, stderr);
    fputc('\n', stderr);
    return status;
}
