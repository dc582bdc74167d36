/* The command `capture`. */
#include "capture/capture.h"
#include "status.h"

int capture_main(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return complain("capture", STATUS_USAGE, "not there yet");
}
