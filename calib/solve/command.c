/* The command `solve`. */
#include "solve/solve.h"
#include "status.h"

int solve_main(int argc, char **argv)
{
    (void)argc;
    (void)argv;
    return complain("solve", STATUS_USAGE, "not there yet");
}
