/* The command `capture show`. */
#include <stdio.h>

#include "capture/command.h"
#include "option_values.h"
#include "status.h"

int capture_show(const struct capture_options *options, char *message)
{
    (void)options;
    snprintf(message, MESSAGE_SIZE, "not there yet");
    return STATUS_FAILED;
}
