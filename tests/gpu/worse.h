/* The larger of two errors, where an error that is no number is the worst there is. */
#ifndef WORSE_H
#define WORSE_H

#include <math.h>

static inline double worse_of(double worst, double error)
{
    if (error <= worst)
        return worst;
    return isnan(error) ? (double)INFINITY : error;
}

#endif
