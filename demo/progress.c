/* A bar on a terminal. */
#include "progress.h"

#include <stdio.h>
#include <unistd.h>

#include "show.h"

enum { BAR = 40, TEXT = 160 };

/* Between two looks of the bar. */
static const double pause_ms = 100;

void progress_begin(struct progress *progress, long done, long total)
{
    *progress = (struct progress){.terminal = isatty(STDERR_FILENO) == 1,
                                  .begun = done,
                                  .total = total,
                                  .start_ms = now_ms(),
                                  .shown_ms = -pause_ms};
}

static void write_rest(double rest_s, char *text, size_t size)
{
    long s = (long)(rest_s + 0.5);

    if (s >= 3600)
        snprintf(text, size, "%ld h %02ld min left", s / 3600, s / 60 % 60);
    else if (s >= 60)
        snprintf(text, size, "%ld min %02ld s left", s / 60, s % 60);
    else
        snprintf(text, size, "%ld s left", s);
}

void progress_show(struct progress *progress, long done)
{
    char bar[BAR + 1], rest[TEXT] = "";
    double time_ms = now_ms();
    long filled = BAR * done / progress->total;

    if (!progress->terminal || (done < progress->total && time_ms < progress->shown_ms + pause_ms))
        return;
    for (int i = 0; i < BAR; i++)
        bar[i] = i < filled ? '#' : '.';
    bar[BAR] = 0;
    if (done > progress->begun)
        write_rest((time_ms - progress->start_ms) / 1e3 * (double)(progress->total - done) /
                       (double)(done - progress->begun),
                   rest, sizeof rest);
    fprintf(stderr, "\r[%s] %ld of %ld frames, %s\033[K", bar, done, progress->total, rest);
    fflush(stderr);
    progress->shown_ms = time_ms;
    progress->drawn = true;
}

void progress_end(struct progress *progress)
{
    if (progress->drawn)
        fputc('\n', stderr);
    progress->drawn = false;
}
