/* Times of phases, with the GL finished at their edges, and what is made of many of them. */
#ifndef STOPWATCH_H
#define STOPWATCH_H

enum clock {
    CLOCK_AUTO = 0, /* the GPU's where there is one, else the wall's */
    CLOCK_WALL,
    CLOCK_PROCESSOR, /* time of all of the process's threads: on a busy machine with a software
                      * rasteriser of one thread, what the wall clock would say of an idle one */
    CLOCK_GPU,       /* timer queries */
    CLOCKS
};

struct stopwatch {
    enum clock clock; /* never AUTO */
    unsigned int query;
    double start_ms;
    double wall_start_ms;
    double wall_ms; /* of what was timed last, by the wall clock whatever `clock` is */
};

struct quartiles {
    double low;
    double median;
    double high;
};

extern const char *const clock_names[CLOCKS];

/* CLOCK_AUTO asks the renderer's name whether it is software. */
void stopwatch_create(struct stopwatch *watch, enum clock clock);
void stopwatch_destroy(struct stopwatch *watch);

void stopwatch_start(struct stopwatch *watch);
/* Milliseconds since the start. */
double stopwatch_stop_ms(struct stopwatch *watch);

/* Sorts the values. */
struct quartiles quartiles_of(double *values, int count);

#endif
