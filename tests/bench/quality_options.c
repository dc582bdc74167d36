/* The command line of cupola-quality. */
#include "quality_options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "probe.h"
#include "read_option.h"

static const double degree_rad = 3.14159265358979323846 / 180;

static const char help[] =
    "Usage: cupola-quality [OPTION...]\n"
    "Compares the ways of antialiasing with the mean of many frames, and writes JSON.\n"
    "\n"
    "  --scene NAME,...     zone-plate, siemens, checkers, starfield, model (all of them),\n"
    "                       checkers:PX for wider ones, or a load of cupola-bench\n"
    "  --lens NAME:DEG,...  hemispheric or angular, and its opening (hemispheric:140,\n"
    "                       hemispheric:180,angular:140,angular:180)\n"
    "  --eye X/Y/Z,...      the viewer, in radii of the screen (0/0/0,0/0.2/-0.1)\n"
    "  --method NAME,...    none (always there), texture, cone, adaptive, footprint; with\n"
    "                       :SAMPLES, :PATTERN and :turned behind it, as in cone:8:blue-noise\n"
    "                       (texture,texture:9,cone:4,adaptive,footprint)\n"
    "  --size N             side of the output, px (1024)\n"
    "  --density X          of the views: 1 is no loss (1)\n"
    "  --samples N          per texel of the views (1)\n"
    "  --table NAME         the warp's table (tiles)\n"
    "  --rays N             of the reference, through every pixel, a whole frame each (256)\n"
    "  --reference-density X  of its views (2)\n"
    "  --steps N            of the turn that shows shimmer; 0: none (20)\n"
    "  --shimmer-rays N     of the reference meanwhile (64)\n"
    "  --yaw DEG            of that turn, as a whole (0.1)\n"
    "  --frames N           rounds of which costs are medians; 0: no costs (20)\n"
    "  --clock NAME         auto, wall, processor, gpu (auto)\n"
    "  --model FILE         of the scene model (glmark2's horse)\n"
    "  --pictures FOLDER    writes the pictures, a file for each method\n"
    "  --cut-out X,Y,SIDE,SCALE  of them a square of SIDE px round a place, parts of the width\n"
    "                       and height, each pixel enlarged to SCALE px (all of it)\n"
    "  --check              also compares the reference with one that is found otherwise, which\n"
    "                       is for scenes that do not change within a pixel\n"
    "  --dry-run            only looks whether all of this can be measured\n"
    "  --output FILE        JSON (stdout)\n"
    "  --help               this\n";

enum wish {
    OPTION_SCENE,
    OPTION_LENS,
    OPTION_EYE,
    OPTION_METHOD,
    OPTION_SIZE,
    OPTION_DENSITY,
    OPTION_SAMPLES,
    OPTION_TABLE,
    OPTION_RAYS,
    OPTION_REFERENCE_DENSITY,
    OPTION_STEPS,
    OPTION_SHIMMER_RAYS,
    OPTION_YAW,
    OPTION_FRAMES,
    OPTION_CLOCK,
    OPTION_MODEL,
    OPTION_PICTURES,
    OPTION_CUT_OUT,
    OPTION_CHECK,
    OPTION_DRY_RUN,
    OPTION_OUTPUT,
    OPTION_HELP
};

static const struct option long_options[] = {
    {"scene", required_argument, NULL, OPTION_SCENE},
    {"lens", required_argument, NULL, OPTION_LENS},
    {"eye", required_argument, NULL, OPTION_EYE},
    {"method", required_argument, NULL, OPTION_METHOD},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"density", required_argument, NULL, OPTION_DENSITY},
    {"samples", required_argument, NULL, OPTION_SAMPLES},
    {"table", required_argument, NULL, OPTION_TABLE},
    {"rays", required_argument, NULL, OPTION_RAYS},
    {"reference-density", required_argument, NULL, OPTION_REFERENCE_DENSITY},
    {"steps", required_argument, NULL, OPTION_STEPS},
    {"shimmer-rays", required_argument, NULL, OPTION_SHIMMER_RAYS},
    {"yaw", required_argument, NULL, OPTION_YAW},
    {"frames", required_argument, NULL, OPTION_FRAMES},
    {"clock", required_argument, NULL, OPTION_CLOCK},
    {"model", required_argument, NULL, OPTION_MODEL},
    {"pictures", required_argument, NULL, OPTION_PICTURES},
    {"cut-out", required_argument, NULL, OPTION_CUT_OUT},
    {"check", no_argument, NULL, OPTION_CHECK},
    {"dry-run", no_argument, NULL, OPTION_DRY_RUN},
    {"output", required_argument, NULL, OPTION_OUTPUT},
    {"help", no_argument, NULL, OPTION_HELP},
    {0}};

static const char *const allowed[] = {
    [OPTION_SCENE] = "zone-plate, siemens, checkers, starfield, model, or a load of cupola-bench",
    [OPTION_LENS] = "hemispheric:DEG up to 180, angular:DEG up to 300",
    [OPTION_EYE] = "X/Y/Z, each from -0.9 to 0.9",
    [OPTION_METHOD] = "none, texture, cone, adaptive, footprint, then :SAMPLES, 1 to 64, :PATTERN, "
                      "regular, rotated-grid or blue-noise, and :turned; 23 of them",
    [OPTION_SIZE] = "16 to 16384",
    [OPTION_DENSITY] = "1/16 to 16",
    [OPTION_SAMPLES] = "1 to 64",
    [OPTION_TABLE] = "the stages by name, as cupola-demo --table has them",
    [OPTION_RAYS] = "1 to 65536",
    [OPTION_REFERENCE_DENSITY] = "1/16 to 16",
    [OPTION_STEPS] = "0 to 10000",
    [OPTION_SHIMMER_RAYS] = "1 to 65536",
    [OPTION_YAW] = "-360 to 360",
    [OPTION_FRAMES] = "0 to 100000",
    [OPTION_CLOCK] = "auto, wall, processor, gpu",
    [OPTION_CUT_OUT] = "X,Y from 0 to 1, SIDE 1 to 16384 and SCALE 1 to 64, both whole",
};

/* NAME:DEG */
static bool read_lens(char *word, struct cupola_lens *lens)
{
    char *colon = strchr(word, ':');
    double fov_deg;

    if (!colon || !read_number(colon + 1, 1, 300, &fov_deg))
        return false;
    *colon = '\0';
    int model = cupola_lens_model_find(word);
    *colon = ':';
    *lens = (struct cupola_lens){.model = (enum cupola_lens_model)model,
                                 .fov_rad = fov_deg * degree_rad};
    return model == CUPOLA_LENS_ANGULAR || (model == CUPOLA_LENS_HEMISPHERIC && fov_deg <= 180);
}

/* So many numbers with one sign between them. */
static bool read_numbers(const char *text, char between, int count, double *numbers)
{
    for (int i = 0; i < count; i++) {
        char *end = NULL;
        numbers[i] = strtod(text, &end);
        if (end == text || *end != (i + 1 < count ? between : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

static bool read_eye(const char *word, double eye_m[3])
{
    bool read = read_numbers(word, '/', 3, eye_m);

    for (int k = 0; read && k < 3; k++)
        read = eye_m[k] >= -0.9 && eye_m[k] <= 0.9;
    return read;
}

/* None is there before. */
static bool add_method(struct quality_options *options, char *word)
{
    if (strcmp(word, options->methods[0].name) == 0)
        return true;
    return options->method_count < METHODS_MAX &&
           method_find(word, &options->methods[options->method_count++]);
}

/* One word of a list. */
static bool add(struct quality_options *options, int option, char *word)
{
    switch (option) {
    case OPTION_SCENE:
        if (options->scene_count >= QUALITY_LIST_MAX)
            return false;
        options->scenes[options->scene_count++] = word;
        return true;
    case OPTION_LENS:
        return options->lens_count < QUALITY_LIST_MAX &&
               read_lens(word, &options->lenses[options->lens_count++]);
    case OPTION_EYE:
        return options->eye_count < QUALITY_LIST_MAX &&
               read_eye(word, options->eyes_m[options->eye_count++]);
    case OPTION_METHOD:
        return add_method(options, word);
    }
    return false;
}

static bool add_list(struct quality_options *options, int option, char *list, const char **word)
{
    bool any = false;

    for (char *one = strtok(list, ","); one; one = strtok(NULL, ",")) {
        *word = one;
        if (!add(options, option, one))
            return false;
        any = true;
    }
    return any;
}

static bool take_cut_out(const char *value, struct cut_out *cut_out)
{
    double numbers[4];

    if (!read_numbers(value, ',', 4, numbers))
        return false;
    for (int i = 0; i < 2; i++)
        if (!(numbers[i] >= 0 && numbers[i] <= 1))
            return false;
    if (!(numbers[2] >= 1 && numbers[2] <= 16384 && numbers[3] >= 1 && numbers[3] <= 64))
        return false;
    if (numbers[2] != (int)numbers[2] || numbers[3] != (int)numbers[3])
        return false;
    cut_out->x = numbers[0];
    cut_out->y = numbers[1];
    cut_out->side_px = (int)numbers[2];
    cut_out->scale = (int)numbers[3];
    return true;
}

/* What each trial is told. */
static bool take_wish(struct trial_wishes *trial, int option, const char *value)
{
    double yaw_deg;

    switch (option) {
    case OPTION_RAYS:
        return read_whole(value, 1, 65536, &trial->rays);
    case OPTION_REFERENCE_DENSITY:
        return read_number(value, 1.0 / 16, 16, &trial->reference_density);
    case OPTION_STEPS:
        return read_whole(value, 0, 10000, &trial->steps);
    case OPTION_SHIMMER_RAYS:
        return read_whole(value, 1, 65536, &trial->shimmer_rays);
    case OPTION_YAW:
        if (!read_number(value, -360, 360, &yaw_deg))
            return false;
        trial->yaw_rad = yaw_deg * degree_rad;
        return true;
    case OPTION_FRAMES:
        return read_whole(value, 0, 100000, &trial->cost.frames);
    case OPTION_CLOCK:
        return read_clock(value, &trial->cost.clock);
    case OPTION_PICTURES:
        trial->cut_out.folder = value;
        return true;
    case OPTION_CUT_OUT:
        return take_cut_out(value, &trial->cut_out);
    case OPTION_CHECK:
        trial->check = true;
        return true;
    }
    return false;
}

static bool take(struct quality_options *options, int option, char *value)
{
    switch (option) {
    case OPTION_SIZE:
        return read_whole(value, 16, 16384, &options->size_px);
    case OPTION_SAMPLES:
        return read_whole(value, 1, 64, &options->samples);
    case OPTION_TABLE:
        options->table = cupola_table_find(value);
        return options->table >= 0;
    case OPTION_DENSITY:
        return read_number(value, 1.0 / 16, 16, &options->density);
    case OPTION_MODEL:
        options->model = value;
        return true;
    case OPTION_OUTPUT:
        options->output = value;
        return true;
    case OPTION_DRY_RUN:
        options->dry_run = true;
        return true;
    }
    return take_wish(&options->trial, option, value);
}

static void set_defaults(struct quality_options *options)
{
    const enum cupola_lens_model models[2] = {CUPOLA_LENS_HEMISPHERIC, CUPOLA_LENS_ANGULAR};
    char methods[] = "texture,texture:9,cone:4,adaptive,footprint";
    const char *word;

    for (int i = 0; options->scene_count == 0 && probe_names[i]; i++)
        options->scenes[i] = probe_names[i];
    while (options->scenes[options->scene_count])
        options->scene_count++;
    if (options->lens_count == 0)
        while (options->lens_count < 4) {
            int i = options->lens_count++;
            options->lenses[i].model = models[i / 2];
            options->lenses[i].fov_rad = (i % 2 ? 180 : 140) * degree_rad;
        }
    if (options->eye_count == 0) {
        options->eye_count = 2;
        options->eyes_m[1][1] = 0.2;
        options->eyes_m[1][2] = -0.1;
    }
    if (options->method_count == 1)
        add_list(options, OPTION_METHOD, methods, &word);
}

static struct quality_options first_values(void)
{
    return (struct quality_options){.methods = {{"none", {.method = CUPOLA_ANTIALIASING_NONE}}},
                                    .method_count = 1,
                                    .size_px = 1024,
                                    .density = 1,
                                    .table = CUPOLA_TABLE_TILES,
                                    .model = "/usr/share/glmark2/models/horse.3ds",
                                    .trial = {.rays = 256,
                                              .reference_density = 2,
                                              .steps = 20,
                                              .shimmer_rays = 64,
                                              .yaw_rad = 0.1 * degree_rad,
                                              .cost = {.frames = 20, .warm_up = 2},
                                              .cut_out = {.scale = 1}}};
}

bool quality_options_read(struct quality_options *options, int argc, char **argv, int *status)
{
    int option, index = 0;

    *options = first_values();
    *status = 2;
    while ((option = getopt_long(argc, argv, "", long_options, &index)) != -1) {
        if (option == OPTION_HELP) {
            fputs(help, stdout);
            *status = 0;
            return false;
        }
        if (option == '?')
            return false;
        const char *word = optarg;
        bool list = option <= OPTION_METHOD;
        if (!(list ? add_list(options, option, optarg, &word) : take(options, option, optarg))) {
            fprintf(stderr, "cupola-quality: --%s has '%s'; allowed: %s\n",
                    long_options[index].name, word, allowed[option]);
            return false;
        }
    }
    if (optind < argc) {
        fprintf(stderr, "cupola-quality: '%s' is no option; see --help\n", argv[optind]);
        return false;
    }
    if (options->trial.cut_out.side_px > 0 && !options->trial.cut_out.folder) {
        fputs(
            "cupola-quality: --cut-out is a part of pictures, and there is no --pictures FOLDER\n",
            stderr);
        return false;
    }
    set_defaults(options);
    return true;
}
