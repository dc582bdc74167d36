/* Times of phases by the clock that is wished. */
#include "stopwatch.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <epoxy/gl.h>

const char *const clock_names[CLOCKS] = {[CLOCK_AUTO] = "auto",
                                         [CLOCK_WALL] = "wall",
                                         [CLOCK_PROCESSOR] = "processor",
                                         [CLOCK_GPU] = "gpu"};

static double now_ms(enum clock clock)
{
    struct timespec now;

    clock_gettime(clock == CLOCK_PROCESSOR ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static bool is_software(const char *renderer)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "SWR", "lavapipe", "Software"};

    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strstr(renderer, names[i]))
            return true;
    return false;
}

void stopwatch_create(struct stopwatch *watch, enum clock clock)
{
    const char *renderer = (const char *)glGetString(GL_RENDERER);

    if (clock == CLOCK_AUTO)
        clock = is_software(renderer ? renderer : "Software") ? CLOCK_WALL : CLOCK_GPU;
    *watch = (struct stopwatch){.clock = clock};
    glGenQueries(1, &watch->query);
}

void stopwatch_destroy(struct stopwatch *watch)
{
    glDeleteQueries(1, &watch->query);
}

void stopwatch_start(struct stopwatch *watch)
{
    glFinish();
    if (watch->clock == CLOCK_GPU)
        glBeginQuery(GL_TIME_ELAPSED, watch->query);
    watch->wall_start_ms = now_ms(CLOCK_WALL);
    watch->start_ms = now_ms(watch->clock);
}

double stopwatch_stop_ms(struct stopwatch *watch)
{
    GLuint64 elapsed_ns = 0;

    if (watch->clock == CLOCK_GPU)
        glEndQuery(GL_TIME_ELAPSED);
    glFinish();
    double stop_ms = now_ms(watch->clock);
    watch->wall_ms = now_ms(CLOCK_WALL) - watch->wall_start_ms;
    if (watch->clock != CLOCK_GPU)
        return stop_ms - watch->start_ms;
    glGetQueryObjectui64v(watch->query, GL_QUERY_RESULT, &elapsed_ns);
    return 1e-6 * (double)elapsed_ns;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double at(const double *sorted, int count, double part)
{
    double place = part * (count - 1);
    int below = (int)place, above = below + 1 < count ? below + 1 : below;
    return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
}

struct quartiles quartiles_of(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, compare);
    return (struct quartiles){at(values, count, 0.25), at(values, count, 0.5),
                              at(values, count, 0.75)};
}
