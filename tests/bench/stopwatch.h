/* Times of phases, with the GL finished at their edges, and what is made of many of them. */
#ifndef STOPWATCH_H
#define STOPWATCH_H

#include <stdbool.h>

struct stopwatch {
    bool timer_queries; /* a hardware GPU: its own clock counts, not the CPU's */
    unsigned int query;
    double start_ms;
};

struct quartiles {
    double low;
    double median;
    double high;
};

/* Asks the renderer's name whether it is software. */
void stopwatch_create(struct stopwatch *watch);
void stopwatch_destroy(struct stopwatch *watch);

void stopwatch_start(struct stopwatch *watch);
/* Milliseconds since the start; by the GPU's clock where it has one. */
double stopwatch_stop_ms(struct stopwatch *watch);

/* Sorts the values. */
struct quartiles quartiles_of(double *values, int count);

#endif
