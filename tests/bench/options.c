/* The bench's command line. */
#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read_option.h"

const char *const family_names[FAMILIES] = {
    [FAMILY_WARP] = "warp",       [FAMILY_EYE] = "eye",     [FAMILY_FRAME] = "frame",
    [FAMILY_PARTS] = "parts",     [FAMILY_LAMPS] = "lamps", [FAMILY_TRIANGLES] = "triangles",
    [FAMILY_FILTERS] = "filters", [FAMILY_VIEWS] = "views", [FAMILY_SIZE] = "size"};

static const char help[] =
    "Usage: cupola-bench [OPTION...]\n"
    "Measures what a dome costs, as ratios within one run, and writes JSON.\n"
    "\n"
    "  --family NAME,...   warp, eye, frame, parts, lamps, triangles, views, size,\n"
    "                      filters (all)\n"
    "  --size N,...        sides of the output, px (1024)\n"
    "  --fov DEG,...       of the lens (140)\n"
    "  --lens NAME,...     angular, hemispheric (angular)\n"
    "  --load NAME,...     light, lambert, heavy[:LAMPS], forest[:TRIANGLES], directions, or\n"
    "                      ns:COST: the lamps that make a pixel cost so many ns (light,heavy)\n"
    "  --contenders N,...  by the names in the results, besides the first (all)\n"
    "  --table NAME        the warp's table in whole frames (auto; what is published: tiles)\n"
    "  --samples N         rays of a pixel, of the family filters (4)\n"
    "  --frames N          rounds that count (200)\n"
    "  --warm-up N         frames before them (5)\n"
    "  --clock NAME        auto: gpu, and wall for software rasterisers; or processor, for busy\n"
    "                      machines and LP_NUM_THREADS=0 (auto)\n"
    "  --no-quality        compares no pictures\n"
    "  --output FILE       JSON (stdout)\n"
    "  --help              this\n";

enum wish {
    OPTION_FAMILY,
    OPTION_SIZE,
    OPTION_FOV,
    OPTION_LENS,
    OPTION_LOAD,
    OPTION_CONTENDERS,
    OPTION_TABLE,
    OPTION_SAMPLES,
    OPTION_FRAMES,
    OPTION_WARM_UP,
    OPTION_CLOCK,
    OPTION_NO_QUALITY,
    OPTION_OUTPUT,
    OPTION_HELP
};

static const struct option long_options[] = {
    {"family", required_argument, NULL, OPTION_FAMILY},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"fov", required_argument, NULL, OPTION_FOV},
    {"lens", required_argument, NULL, OPTION_LENS},
    {"load", required_argument, NULL, OPTION_LOAD},
    {"contenders", required_argument, NULL, OPTION_CONTENDERS},
    {"table", required_argument, NULL, OPTION_TABLE},
    {"samples", required_argument, NULL, OPTION_SAMPLES},
    {"frames", required_argument, NULL, OPTION_FRAMES},
    {"warm-up", required_argument, NULL, OPTION_WARM_UP},
    {"clock", required_argument, NULL, OPTION_CLOCK},
    {"no-quality", no_argument, NULL, OPTION_NO_QUALITY},
    {"output", required_argument, NULL, OPTION_OUTPUT},
    {"help", no_argument, NULL, OPTION_HELP},
    {0}};

static const char *const allowed[] = {
    [OPTION_FAMILY] = "warp, eye, frame, parts, lamps, triangles, views, size, filters",
    [OPTION_SIZE] = "16 to 16384, up to 16 of them",
    [OPTION_FOV] = "1 to 300, up to 16 of them",
    [OPTION_LENS] = "angular, hemispheric",
    [OPTION_LOAD] = "up to 16 of them",
    [OPTION_CONTENDERS] = "up to 32 of them",
    [OPTION_TABLE] = "the stages by name, as cupola-demo --table has them",
    [OPTION_SAMPLES] = "1 to 64",
    [OPTION_FRAMES] = "1 to 100000",
    [OPTION_WARM_UP] = "0 to 100000",
    [OPTION_CLOCK] = "auto, wall, processor, gpu",
};

static bool add_family(struct options *options, const char *word)
{
    for (int i = 0; i < FAMILIES; i++)
        if (strcmp(word, family_names[i]) == 0) {
            options->families[i] = true;
            return true;
        }
    return false;
}

/* One word of a list. */
static bool add(struct options *options, int option, char *word)
{
    int model;

    switch (option) {
    case OPTION_FAMILY:
        return add_family(options, word);
    case OPTION_SIZE:
        return options->size_count < LIST_MAX &&
               read_whole(word, 16, 16384, &options->sizes_px[options->size_count++]);
    case OPTION_FOV:
        return options->fov_count < LIST_MAX &&
               read_number(word, 1, 300, &options->fovs_deg[options->fov_count++]);
    case OPTION_LENS:
        model = cupola_lens_model_find(word);
        if (options->lens_count >= LIST_MAX ||
            (model != CUPOLA_LENS_ANGULAR && model != CUPOLA_LENS_HEMISPHERIC))
            return false;
        options->lenses[options->lens_count++] = (enum cupola_lens_model)model;
        return true;
    case OPTION_LOAD:
        if (options->load_count >= LIST_MAX)
            return false;
        options->loads[options->load_count++] = word;
        return true;
    case OPTION_CONTENDERS:
        if (options->contender_count >= NAMES_MAX)
            return false;
        options->contenders[options->contender_count++] = word;
        return true;
    }
    return false;
}

/* `word` is what is not allowed where it returns false. */
static bool take(struct options *options, int option, char *value, const char **word)
{
    *word = value;
    switch (option) {
    case OPTION_TABLE:
        options->table = cupola_table_find(value);
        return options->table >= 0;
    case OPTION_SAMPLES:
        return read_whole(value, 1, CUPOLA_RAYS_MAX, &options->samples);
    case OPTION_FRAMES:
        return read_whole(value, 1, 100000, &options->wishes.frames);
    case OPTION_WARM_UP:
        return read_whole(value, 0, 100000, &options->wishes.warm_up);
    case OPTION_CLOCK:
        return read_clock(value, &options->wishes.clock);
    case OPTION_NO_QUALITY:
        options->no_quality = true;
        return true;
    case OPTION_OUTPUT:
        options->output = value;
        return true;
    }
    bool any = false;
    for (char *one = strtok(value, ","); one; one = strtok(NULL, ",")) {
        *word = one;
        if (!add(options, option, one))
            return false;
        any = true;
    }
    if (!any)
        return false;
    return true;
}

static void set_defaults(struct options *options)
{
    bool any = false;

    for (int i = 0; i < FAMILIES; i++)
        any |= options->families[i];
    for (int i = 0; i < FAMILIES; i++)
        options->families[i] |= !any;
    /* What a host asks for that wants speed. */
    if (options->table < 0)
        options->table = cupola_table_find("auto");
    if (options->table < 0)
        options->table = CUPOLA_TABLE_TILES;
    if (options->size_count == 0)
        options->sizes_px[options->size_count++] = 1024;
    if (options->fov_count == 0)
        options->fovs_deg[options->fov_count++] = 140;
    if (options->lens_count == 0)
        options->lenses[options->lens_count++] = CUPOLA_LENS_ANGULAR;
    options->load_given = options->load_count > 0;
    if (options->load_count == 0) {
        options->loads[options->load_count++] = "light";
        options->loads[options->load_count++] = "heavy";
    }
}

bool options_read(struct options *options, int argc, char **argv, int *status)
{
    int option, index = 0;
    const char *word = NULL;

    *options = (struct options){.table = -1, .samples = 4, .wishes = {.frames = 200, .warm_up = 5}};
    *status = 2;
    while ((option = getopt_long(argc, argv, "", long_options, &index)) != -1) {
        if (option == OPTION_HELP) {
            fputs(help, stdout);
            *status = 0;
            return false;
        }
        if (option == '?')
            return false;
        if (!take(options, option, optarg, &word)) {
            fprintf(stderr, "cupola-bench: --%s has '%s'; allowed: %s\n", long_options[index].name,
                    word, allowed[option]);
            return false;
        }
    }
    if (optind < argc) {
        fprintf(stderr, "cupola-bench: '%s' is no option; see --help\n", argv[optind]);
        return false;
    }
    set_defaults(options);
    return true;
}
