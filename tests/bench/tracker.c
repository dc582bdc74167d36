/* A tracker in a thread, and a flood. */
#include "tracker.h"

#include <arpa/inet.h>
#include <math.h>
#include <netinet/in.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "viewer_osc.h"

enum { REPORTS_MAX = 1 << 18, FLOOD_BURST = 100 };

struct report {
    double sent_s;
    float x_m;
};

struct tracker {
    struct tracker_wishes wishes;
    int reporter, flooder; /* sockets */
    pthread_t threads[2];
    int thread_count;
    atomic_bool ends;
    atomic_int count;
    atomic_long flooded;
    struct report reports[REPORTS_MAX];
};

double tracker_head_x_m(double time_s)
{
    return 0.1 * sin(2 * 3.14159265358979323846 * fmod(time_s, 1));
}

static void wait_s(double seconds)
{
    struct timespec time = {.tv_sec = (time_t)seconds,
                            .tv_nsec = (long)(1e9 * (seconds - floor(seconds)))};

    nanosleep(&time, NULL);
}

/* "/viewer" with three floats, y and z 0. */
static void write_report(unsigned char packet[28], float x_m)
{
    uint32_t bits;

    memset(packet, 0, 28);
    memcpy(packet, "/viewer", 7);
    memcpy(packet + 8, ",fff", 4);
    memcpy(&bits, &x_m, sizeof bits);
    bits = htonl(bits);
    memcpy(packet + 16, &bits, sizeof bits);
}

static void *report(void *self)
{
    struct tracker *tracker = self;
    uint32_t chance = 1;

    while (!atomic_load(&tracker->ends)) {
        unsigned char packet[28];
        int index = atomic_load(&tracker->count);
        double now_s = viewer_osc_now_s();
        if (index == REPORTS_MAX)
            break;
        tracker->reports[index] = (struct report){now_s, (float)tracker_head_x_m(now_s)};
        atomic_store(&tracker->count, index + 1);
        write_report(packet, tracker->reports[index].x_m);
        (void)!send(tracker->reporter, packet, sizeof packet, 0);
        chance = chance * 1664525 + 1013904223; /* Numerical Recipes' generator: any will do */
        wait_s((0.75 + 0.5 * (chance >> 8) / (1 << 24)) / tracker->wishes.rate_hz);
    }
    return NULL;
}

/* Half of it other messages, half of it bytes that are no OSC. */
static void *flood(void *self)
{
    static const char other[] = "/head\0\0\0,fff\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0";
    static const char nonsense[] = "nothing that anybody could mean";
    struct tracker *tracker = self;
    double start_s = viewer_osc_now_s();

    while (!atomic_load(&tracker->ends)) {
        double due = tracker->wishes.flood_hz * (viewer_osc_now_s() - start_s);
        long sent = atomic_load(&tracker->flooded);
        for (int i = 0; i < FLOOD_BURST && (double)sent < due; i++, sent++)
            (void)!send(tracker->flooder, sent % 2 ? other : nonsense, 28, 0);
        atomic_store(&tracker->flooded, sent);
        if ((double)sent >= due)
            wait_s(200e-6);
    }
    return NULL;
}

static int open_socket(int port)
{
    struct sockaddr_in to = {.sin_family = AF_INET,
                             .sin_port = htons((uint16_t)port),
                             .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    int made = socket(AF_INET, SOCK_DGRAM, 0);

    if (made >= 0 && connect(made, (struct sockaddr *)&to, sizeof to) == 0)
        return made;
    if (made >= 0)
        close(made);
    return -1;
}

static bool start(struct tracker *tracker, void *(*work)(void *))
{
    if (pthread_create(&tracker->threads[tracker->thread_count], NULL, work, tracker) != 0)
        return false;
    tracker->thread_count++;
    return true;
}

struct tracker *tracker_create(const struct tracker_wishes *wishes, char *message)
{
    struct tracker *tracker = calloc(1, sizeof *tracker);

    snprintf(message, 1024, "no sockets or threads for a tracker");
    if (!tracker)
        return NULL;
    tracker->wishes = *wishes;
    tracker->reporter = open_socket(wishes->port);
    tracker->flooder = open_socket(wishes->port);
    if (tracker->reporter >= 0 && tracker->flooder >= 0 &&
        (!(wishes->rate_hz > 0) || start(tracker, report)) &&
        (!(wishes->flood_hz > 0) || start(tracker, flood)))
        return tracker;
    tracker_destroy(tracker);
    return NULL;
}

void tracker_destroy(struct tracker *tracker)
{
    if (!tracker)
        return;
    atomic_store(&tracker->ends, true);
    for (int i = 0; i < tracker->thread_count; i++)
        pthread_join(tracker->threads[i], NULL);
    if (tracker->reporter >= 0)
        close(tracker->reporter);
    if (tracker->flooder >= 0)
        close(tracker->flooder);
    free(tracker);
}

int tracker_count(const struct tracker *tracker)
{
    return atomic_load(&tracker->count);
}

double tracker_sent_s(const struct tracker *tracker, int index)
{
    return tracker->reports[index].sent_s;
}

float tracker_x_m(const struct tracker *tracker, int index)
{
    return tracker->reports[index].x_m;
}

long tracker_flooded(const struct tracker *tracker)
{
    return atomic_load(&tracker->flooded);
}
