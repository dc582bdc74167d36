/* The interactive tool's command line. */
#include "status.h"
#include "tool/tool.h"

int tool_main(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return complain("", STATUS_USAGE, "not there yet");
}
