/* Measured times as JSON. */
#include "stats.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include "option_names.h"
#include "output_file.h"
#include "short_path.h"

enum { TABLE_RUNS = 4 };

/* Numbers in the order in which they came. */
struct series {
    double *values;
    int count;
    int room;
};

struct stats {
    const char *path;
    char *whole;     /* behind links, NULL until written */
    char *temporary; /* NULL until written, and for stdout */
    bool warm;       /* the first frame is over */
    struct series frame_ms;
    struct series views_ms;
    struct series warp_ms;
    struct series tables_ms;
    bool tracked;
    struct viewer_osc_counts reports;
};

struct stats *stats_create(const char *path)
{
    struct stats *stats = calloc(1, sizeof *stats);

    if (stats)
        stats->path = path;
    return stats;
}

void stats_destroy(struct stats *stats)
{
    if (!stats)
        return;
    if (stats->temporary)
        unlink(stats->temporary);
    free(stats->temporary);
    free(stats->whole);
    free(stats->frame_ms.values);
    free(stats->views_ms.values);
    free(stats->warp_ms.values);
    free(stats->tables_ms.values);
    free(stats);
}

int stats_frames(int frames)
{
    return frames > 0 ? frames : 10;
}

/* A number that finds no memory is left out. */
static void series_add(struct series *series, double value)
{
    if (series->count == series->room) {
        int room = series->room ? 2 * series->room : 64;
        double *values = realloc(series->values, (size_t)room * sizeof *values);
        if (!values)
            return;
        series->values = values;
        series->room = room;
    }
    series->values[series->count++] = value;
}

void stats_add_frame(struct stats *stats, const struct frame_times *times)
{
    if (!stats->warm) {
        stats->warm = true;
        return;
    }
    series_add(&stats->frame_ms, times->frame_ms);
    series_add(&stats->views_ms, times->views_ms);
    series_add(&stats->warp_ms, times->warp_ms);
}

void stats_add_reports(struct stats *stats, const struct viewer_osc_counts *counts)
{
    stats->tracked = counts != NULL;
    if (counts)
        stats->reports = *counts;
}

void stats_time_tables(struct stats *stats, const struct show *show)
{
    for (int i = 0; i < TABLE_RUNS; i++) {
        double time_ms = show_time_tables_ms(show);
        if (i > 0 && time_ms >= 0)
            series_add(&stats->tables_ms, time_ms);
    }
}

static int by_size(const void *a, const void *b)
{
    double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

static void write_series(FILE *file, const char *name, struct series *series)
{
    int n = series->count;
    double median = 0, low = 0, high = 0;

    if (n > 0) {
        qsort(series->values, (size_t)n, sizeof *series->values, by_size);
        median = (series->values[(n - 1) / 2] + series->values[n / 2]) / 2;
        low = series->values[0];
        high = series->values[n - 1];
    }
    fprintf(file, "  \"%s\": {\"median\": %.6g, \"min\": %.6g, \"max\": %.6g},\n", name, median,
            low, high);
}

static void write_string(FILE *file, const char *text)
{
    fputc('"', file);
    for (const unsigned char *at = (const unsigned char *)text; *at; at++) {
        if (*at == '"' || *at == '\\')
            fprintf(file, "\\%c", *at);
        else if (*at < 0x20 || *at >= 0x7f) /* drivers' names are Latin-1 at best */
            fprintf(file, "\\u%04x", *at);
        else
            fputc(*at, file);
    }
    fputc('"', file);
}

/* A price of nothing is 1e-9 to the planner, for which 0 means the usual one. */
static void write_price(FILE *file, const char *name, double price)
{
    fprintf(file, "  \"%s\": %.6g,\n", name, price > 1.5e-9 ? price : 0);
}

/* A name, or null. */
static void write_name(FILE *file, const char *key, const char *name)
{
    fprintf(file, "  \"%s\": ", key);
    if (name)
        write_string(file, name);
    else
        fputs("null", file);
    fputs(",\n", file);
}

/* How the views are drawn; null where no views are. */
static void write_ways(FILE *file, const struct show *show)
{
    const struct show_setup *setup = show_setup_of(show);
    bool views = show_plan(show) && setup->source == CUPOLA_SOURCE_VIEWS;
    const char *mask = setup->mask == CUPOLA_MASK_AUTO ? option_mask_name(CUPOLA_MASK_DEPTH)
                                                       : option_mask_name((int)setup->mask);

    write_name(file, "mask", views ? mask : NULL);
    write_name(file, "submission", views ? (setup->one_pass ? "once" : "loop") : NULL);
    write_name(file, "table", views ? show_table(show) : NULL);
}

static void write_reports(FILE *file, const struct viewer_osc_counts *counts)
{
    fprintf(file,
            "  \"viewer_reports\": {\"packets\": %ld, \"taken\": %ld, \"refused\": %ld, \"late\": "
            "%ld, \"malformed\": %ld, \"others\": %ld, \"lost\": %ld},\n",
            counts->packets, counts->taken, counts->refused, counts->late, counts->malformed,
            counts->others, counts->lost);
}

static void write_texels(FILE *file, const struct cupola_plan_report *report, bool masked)
{
    double shaded = masked ? report->texels_masked_per_pixel : report->texels_shaded_per_pixel;

    fprintf(file, "  \"texels_allocated_per_pixel\": %.6g,\n", report->texels_allocated_per_pixel);
    fprintf(file, "  \"texels_in_views_per_pixel\": %.6g,\n", report->texels_shaded_per_pixel);
    fprintf(file, "  \"texels_shaded_per_pixel\": %.6g,\n", shaded);
    fprintf(file, "  \"texels_masked_per_pixel\": %.6g,\n", report->texels_masked_per_pixel);
    fprintf(file, "  \"texels_sampled_per_pixel\": %.6g,\n", report->texels_sampled_per_pixel);
}

static void write_object(struct stats *stats, const struct show *show, const struct scene *scene,
                         const char *renderer, FILE *file)
{
    /* A plain perspective view has one texel for every pixel. */
    static const struct cupola_plan_report plain = {
        .views = 1,
        .texels_allocated_per_pixel = 1,
        .texels_shaded_per_pixel = 1,
        .texels_sampled_per_pixel = 1,
        .texels_masked_per_pixel = 1,
        .reason = "a perspective view has no plan",
    };
    const struct cupola_plan_report *report = show_report(show);
    const struct show_setup *setup = show_setup_of(show);
    /* Films have no scene. */
    const struct scene_counts whole = scene ? scene->whole : (struct scene_counts){0, 0};
    const struct scene_counts drawn = scene ? scene->drawn : (struct scene_counts){0, 0};
    struct rusage usage = {0};

    if (!report)
        report = &plain;
    getrusage(RUSAGE_SELF, &usage);
    fputs("{\n  \"renderer\": ", file);
    write_string(file, renderer);
    fprintf(file, ",\n  \"frames\": %d,\n", stats->frame_ms.count);
    write_series(file, "frame_ms", &stats->frame_ms);
    write_series(file, "views_ms", &stats->views_ms);
    write_series(file, "tables_ms", &stats->tables_ms);
    write_series(file, "warp_ms", &stats->warp_ms);
    fprintf(file, "  \"views\": %d,\n", report->views);
    write_texels(file, report, setup->mask != CUPOLA_MASK_NONE);
    if (setup->measures_prices) {
        write_price(file, "price_view", setup->plan.cost.view);
        write_price(file, "price_texel_allocated", setup->plan.cost.texel_allocated);
        write_price(file, "price_vertices", setup->plan.cost.vertices);
    }
    fprintf(file, "  \"family\": \"%s\",\n  \"reason\": ", report->family);
    write_string(file, report->reason);
    fputs(",\n", file);
    write_ways(file, show);
    if (stats->tracked)
        write_reports(file, &stats->reports);
    fprintf(file, "  \"triangles\": %ld,\n", whole.triangles);
    fprintf(file, "  \"triangles_drawn\": %ld,\n", drawn.triangles);
    fprintf(file, "  \"instances\": %ld,\n", whole.instances);
    fprintf(file, "  \"instances_drawn\": %ld,\n", drawn.instances);
    /* Linux counts in kibibytes. */
    fprintf(file, "  \"peak_rss_bytes\": %.0f\n}\n", (double)usage.ru_maxrss * 1024);
}

/* Of the file and of the one that it is until it is whole; errno says what is wrong. */
static bool name_files(struct stats *stats)
{
    stats->whole = output_file_behind_links(stats->path);
    if (!stats->whole)
        return false;
    size_t length = strlen(stats->whole) + 32;
    stats->temporary = malloc(length);
    if (stats->temporary)
        snprintf(stats->temporary, length, "%s.%ld.tmp", stats->whole, (long)getpid());
    return stats->temporary != NULL;
}

bool stats_write(struct stats *stats, const struct show *show, const struct scene *scene,
                 const char *renderer, char *message)
{
    bool to_stdout = strcmp(stats->path, "-") == 0;
    FILE *file = stdout;
    bool failed;

    if (!to_stdout) {
        if (!name_files(stats))
            goto fail;
        file = fopen(stats->temporary, "wx");
        if (!file)
            goto fail;
    }
    write_object(stats, show, scene, renderer, file);
    failed = ferror(file) != 0;
    if ((to_stdout ? fflush(file) : fclose(file)) != 0 || failed)
        goto fail;
    return true;

fail:
    snprintf(message, MESSAGE_SIZE, "--stats: %s cannot be written: %s",
             short_path(stats->path).text, strerror(errno));
    return false;
}

bool stats_keep(struct stats *stats, char *message)
{
    if (!stats->temporary)
        return true;
    if (rename(stats->temporary, stats->whole) != 0) {
        snprintf(message, MESSAGE_SIZE, "--stats: %s cannot be written: %s",
                 short_path(stats->path).text, strerror(errno));
        return false;
    }
    free(stats->temporary);
    stats->temporary = NULL;
    return true;
}
