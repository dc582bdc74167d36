/*
 * cupola-latency: how long a tracker's report takes to become a picture, as JSON.
 * docs/benchmarks.md explains it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "headless.h"
#include "json.h"
#include "latency_run.h"
#include "read_option.h"

/* A machine without any GL context: Meson counts it as skipped. */
enum { EXIT_SKIPPED = 77, SIZES_MAX = 8 };

struct wishes {
    int sizes[SIZES_MAX], size_count;
    struct latency_wishes run;
    double flood_hz;
    const char *output;
};

static const char help[] =
    "Usage: cupola-latency [OPTIONS]\n"
    "  --size PX,...   of the output, default 512,1024\n"
    "  --frames N      of each run, default 300\n"
    "  --rate HZ       of the tracker's reports, default 120; 0: none\n"
    "  --flood HZ      packets a second that are no reports, default 100000\n"
    "  --control       leaves the eye where it is: its frames must not count as proven\n"
    "  --output FILE   JSON, default stdout\n";

static bool read_sizes(const char *text, struct wishes *wishes)
{
    char list[100], *rest = list;

    if (strlen(text) >= sizeof list)
        return false;
    snprintf(list, sizeof list, "%s", text);
    wishes->size_count = 0;
    for (char *word; (word = strtok_r(rest, ",", &rest));)
        if (wishes->size_count == SIZES_MAX ||
            !read_whole(word, 16, 8192, &wishes->sizes[wishes->size_count++]))
            return false;
    return wishes->size_count > 0;
}

static bool read_option(const char *name, const char *value, struct wishes *wishes)
{
    if (strcmp(name, "--size") == 0)
        return read_sizes(value, wishes);
    if (strcmp(name, "--frames") == 0)
        return read_whole(value, 1, 100000, &wishes->run.frames);
    if (strcmp(name, "--rate") == 0)
        return read_number(value, 0, 10000, &wishes->run.rate_hz);
    if (strcmp(name, "--flood") == 0)
        return read_number(value, 0, 1e7, &wishes->flood_hz);
    wishes->output = value;
    return strcmp(name, "--output") == 0 && *value;
}

static bool read_options(int argc, char **argv, struct wishes *wishes)
{
    for (int i = 1; i < argc; i++) {
        const char *name = argv[i], *value;
        if (strcmp(name, "--control") == 0) {
            wishes->run.control = true;
            continue;
        }
        value = i + 1 < argc ? argv[++i] : "";
        if (read_option(name, value, wishes))
            continue;
        fprintf(stderr, "cupola-latency: '%s %s' is not allowed; --help names what is\n", name,
                value);
        return false;
    }
    return true;
}

/* JSON has no other numbers: without a report there is neither. */
static void put_spread(FILE *file, const char *name, struct spread spread)
{
    if (isfinite(spread.median) && isfinite(spread.high))
        fprintf(file, "\"%s\": [%.6g, %.6g], ", name, spread.median, spread.high);
    else
        fprintf(file, "\"%s\": [null, null], ", name);
}

static void put_run(FILE *file, const struct latency_wishes *wishes,
                    const struct latency_result *result)
{
    fprintf(file, "  {\"size_px\": %d, \"predicted\": %s, ", wishes->size_px,
            wishes->predicted ? "true" : "false");
    json_put_number(file, "rate_hz", wishes->rate_hz);
    json_put_number(file, "flood_hz", wishes->flood_hz);
    put_spread(file, "message_ms", result->message_ms);
    put_spread(file, "age_ms", result->age_ms);
    put_spread(file, "poll_ms", result->poll_ms);
    put_spread(file, "frame_ms", result->frame_ms);
    json_put_number(file, "lag_ms", result->lag_ms);
    json_put_number(file, "error_mm", result->error_mm);
    fprintf(file,
            "\"frames\": %d, \"unproven\": %d, \"reports\": %d, \"lost\": %d, \"flooded\": %ld}",
            result->frames, result->unproven, result->reports, result->lost, result->flooded);
}

/* Every size, with and without prediction, in peace and under a flood. */
static bool run_all(struct wishes *wishes, FILE *file, char *message)
{
    struct latency_result result;
    bool first = true;

    fputs("{\n", file);
    json_put_machine(file, CLOCK_WALL);
    fputs(",\n \"runs\": [\n", file);
    for (int i = 0; i < 4 * wishes->size_count; i++) {
        wishes->run.size_px = wishes->sizes[i / 4];
        wishes->run.predicted = i % 2;
        wishes->run.flood_hz = i % 4 >= 2 ? wishes->flood_hz : 0;
        if (i % 4 >= 2 && !(wishes->flood_hz > 0))
            continue;
        if (!latency_run(&wishes->run, &result, message))
            return false;
        if (!first)
            fputs(",\n", file);
        put_run(file, &wishes->run, &result);
        first = false;
    }
    fputs("\n ]\n}\n", file);
    return true;
}

int main(int argc, char **argv)
{
    struct wishes wishes = {.sizes = {512, 1024},
                            .size_count = 2,
                            .run = {.frames = 300, .rate_hz = 120},
                            .flood_hz = 100000};
    char message[2048] = ""; /* MESSAGE_SIZE of the demo, and more */
    struct headless *headless;
    FILE *file = stdout;
    bool done;

    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        fputs(help, stdout);
        return EXIT_SUCCESS;
    }
    if (!read_options(argc, argv, &wishes))
        return 2;
    headless = headless_create(message, sizeof message);
    if (!headless) {
        fprintf(stderr, "cupola-latency: %s\n", message);
        return EXIT_SKIPPED;
    }
    if (wishes.output && !(file = fopen(wishes.output, "w")))
        snprintf(message, sizeof message, "'%s' cannot be written", wishes.output);
    done = file && run_all(&wishes, file, message);
    if (file && !json_close(file, wishes.output, message))
        done = false;
    if (!done)
        fprintf(stderr, "cupola-latency: %s\n", message);
    headless_destroy(headless);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
