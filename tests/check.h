/*
 * Assertions on numbers for cmocka, whose own cast to float and accept NaN: these are of the form
 * !(error <= tolerance), so a NaN fails.
 */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define check_near(actual, expected, tolerance)                                                    \
    check_near_at((double)(actual), (double)(expected), (double)(tolerance), #actual, __FILE__,    \
                  __LINE__)
#define check_at_most(actual, bound)                                                               \
    check_at_most_at((double)(actual), (double)(bound), #actual, __FILE__, __LINE__)
#define check_at_least(actual, bound)                                                              \
    check_at_most_at(-(double)(actual), -(double)(bound), "-" #actual, __FILE__, __LINE__)

static inline void check_near_at(double actual, double expected, double tolerance, const char *text,
                                 const char *file, int line)
{
    if (fabs(actual - expected) <= tolerance)
        return;
    print_error("%s = %.17g, expected %.17g within %g\n", text, actual, expected, tolerance);
    _fail(file, line);
}

static inline void check_at_most_at(double actual, double bound, const char *text, const char *file,
                                    int line)
{
    if (actual <= bound)
        return;
    print_error("%s = %.17g, allowed at most %.17g\n", text, actual, bound);
    _fail(file, line);
}

/* Seeded random numbers (splitmix64, Steele et al. 2014): a failure replays by its seed. */
static inline double random_between(uint64_t *state, double low, double high)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * ((double)(z >> 11) * 0x1p-53);
}

#endif
