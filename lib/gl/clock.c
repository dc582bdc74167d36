/* The clock by which draws are timed, in a file of its own so that tests can replace it. */
#include "clock.h"

#include <time.h>

double clock_now_s(void)
{
    struct timespec time = {0, 0};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}
