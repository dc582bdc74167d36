/*
 * cupola-calib: makes a dome right for its viewer. Without a command it is the interactive tool;
 * `solve` finds the projector from marks; `capture` finds marks by structured light. Uses Cupola's
 * public headers only, like any other host.
 */
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "capture/capture.h"
#include "solve/solve.h"
#include "status.h"
#include "tool/tool.h"

int main(int argc, char **argv)
{
    int status;

    signal(SIGXFSZ, SIG_IGN); /* a file that becomes too large is an ordinary error */
    if (argc > 1 && strcmp(argv[1], "solve") == 0)
        status = solve_main(argc - 1, argv + 1);
    else if (argc > 1 && strcmp(argv[1], "capture") == 0)
        status = capture_main(argc - 1, argv + 1);
    else
        status = tool_main(argc, argv);
    if (fflush(stdout) != 0 && status == STATUS_OK)
        return complain("", STATUS_FAILED, "standard output cannot be written");
    return status;
}
