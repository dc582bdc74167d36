/* Times of phases by the wall clock, or by the GPU's own where there is one. */
#include "stopwatch.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <epoxy/gl.h>

static double now_ms(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
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

void stopwatch_create(struct stopwatch *watch)
{
    const char *renderer = (const char *)glGetString(GL_RENDERER);

    *watch = (struct stopwatch){.timer_queries = !is_software(renderer ? renderer : "Software")};
    glGenQueries(1, &watch->query);
}

void stopwatch_destroy(struct stopwatch *watch)
{
    glDeleteQueries(1, &watch->query);
}

void stopwatch_start(struct stopwatch *watch)
{
    glFinish();
    if (watch->timer_queries)
        glBeginQuery(GL_TIME_ELAPSED, watch->query);
    watch->start_ms = now_ms();
}

double stopwatch_stop_ms(struct stopwatch *watch)
{
    GLuint64 elapsed_ns = 0;

    if (watch->timer_queries)
        glEndQuery(GL_TIME_ELAPSED);
    glFinish();
    if (!watch->timer_queries)
        return now_ms() - watch->start_ms;
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
