/* The clock by which draws are timed; tests put another one in its place. */
#ifndef CLOCK_H
#define CLOCK_H

/* s since some moment; it is never set, so differences are never below 0. */
double clock_now_s(void);

#endif
