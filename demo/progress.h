/* A bar on a terminal: how much is done, and how long the rest will take. Elsewhere nothing. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>

struct progress {
    bool terminal, drawn;
    long begun, total; /* what was done already, and all of it */
    double start_ms, shown_ms;
};

/* Of stderr. */
void progress_begin(struct progress *progress, long done, long total);
void progress_show(struct progress *progress, long done);

/* Leaves the bar as it is, with a new line after it. */
void progress_end(struct progress *progress);

#endif
