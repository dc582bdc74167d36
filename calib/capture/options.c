/* The command line of `cupola-calib capture`. */
#include "capture/options.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "capture/folder.h"
#include "capture/pose.h"
#include "capture/series.h"
#include "option_paths.h"
#include "option_values.h"
#include "status.h"

enum name {
    HELP,
    RIG,
    PROJECTOR,
    FOLDER,
    PATTERNS,
    PERIOD,
    STEPS,
    MONITOR,
    WINDOW,
    EVERY,
    DEVICE,
    SHOTS,
    SETTLE,
    LINEAR,
    CONTRAST,
    MARKS,
    OUTPUT,
    SOLVED,
    CAMERA,
    REFERENCES,
    CIRCLE,
    POSITION,
    AIM,
    FREE,
    PHOTO_SIZE,
    NOISE,
    VIGNETTING,
    AMBIENT,
    BLUR,
    EXPOSURE,
    SEED,
    FORMAT,
    NAMES
};

enum {
    P = 1 << CAPTURE_PATTERNS,
    S = 1 << CAPTURE_SHOW,
    D = 1 << CAPTURE_DECODE,
    M = 1 << CAPTURE_SIMULATE
};

/* Which commands know which option, and which cannot do without. */
static const struct {
    const char *name;
    int known, needed;
    bool plain; /* without a value */
} table[NAMES] = {
    [HELP] = {"help", P | S | D | M, 0, true},
    [RIG] = {"rig", P | D | M, P | D | M},
    [PROJECTOR] = {"projector", P | D | M, 0},
    [FOLDER] = {"folder", P | S | D | M, P | M},
    [PATTERNS] = {"patterns", S | D | M, S | M},
    [PERIOD] = {"period", P, 0},
    [STEPS] = {"steps", P, 0},
    [MONITOR] = {"monitor", S, 0},
    [WINDOW] = {"window", S, 0, true},
    [EVERY] = {"every", S, 0},
    [DEVICE] = {"device", S, 0},
    [SHOTS] = {"shots", S, 0},
    [SETTLE] = {"settle", S, 0},
    [LINEAR] = {"linear", D, 0, true},
    [CONTRAST] = {"contrast", D, 0},
    [MARKS] = {"marks", D, 0},
    [OUTPUT] = {"output", D, D},
    [SOLVED] = {"solved", D, 0},
    [CAMERA] = {"camera", D | M, D | M},
    [REFERENCES] = {"references", D | M, 0},
    [CIRCLE] = {"camera-circle", D | M, 0},
    [POSITION] = {"camera-position", D | M, 0},
    [AIM] = {"camera-aim", D | M, 0},
    [FREE] = {"camera-free", D, 0},
    [PHOTO_SIZE] = {"photo-size", S | M, 0},
    [NOISE] = {"noise", M, 0},
    [VIGNETTING] = {"vignetting", M, 0},
    [AMBIENT] = {"ambient", M, 0},
    [BLUR] = {"blur", M, 0},
    [EXPOSURE] = {"exposure", M, 0},
    [SEED] = {"seed", M, 0},
    [FORMAT] = {"format", M, 0},
};

const char *capture_command_name(int index)
{
    static const char *const names[] = {"patterns", "show", "decode", "simulate"};

    return index >= 0 && index < CAPTURE_COMMANDS ? names[index] : NULL;
}

static bool take_circle(const struct value_context *context, const char *text,
                        struct capture_options *options)
{
    double numbers[3];
    const struct number_range range = {.low = -1e6, .high = 1e6};

    if (!value_numbers(context, text, "X,Y,RADIUS", range, 3, 3, numbers))
        return false;
    options->circle = (struct cupola_circle){numbers[0], numbers[1], numbers[2]};
    options->circle_given = true;
    if (numbers[2] > 0)
        return true;
    snprintf(context->message, MESSAGE_SIZE, "%s: a radius of %g is not allowed; allowed: above 0",
             context->option, numbers[2]);
    return false;
}

static bool take_aim(const struct value_context *context, const char *text,
                     struct capture_options *options)
{
    double numbers[3];
    const struct number_range range = {.low = -360, .high = 360, .degrees = true};

    if (!value_numbers(context, text, "YAW,PITCH,ROLL", range, 1, 3, numbers))
        return false;
    options->aim = (struct cupola_aim){numbers[0], numbers[1], numbers[2]};
    options->aim_given = true;
    return true;
}

static bool take_position(const struct value_context *context, const char *text,
                          struct capture_options *options)
{
    const struct number_range range = {.low = -1000, .high = 1000};

    options->position_given = true;
    return value_numbers(context, text, "X,Y,Z", range, 3, 3, options->position_m);
}

/* Of photographs that decode would take. */
static bool take_photo_size(const struct value_context *context, const char *text,
                            struct capture_options *options)
{
    return value_size(context, text, &options->width, &options->height) &&
           photo_size_is_allowed(context->option, options->width, options->height,
                                 context->message);
}

static bool take_period(const struct value_context *context, const char *text,
                        struct capture_options *options)
{
    if (!value_integer(context, text, SERIES_PERIOD_MIN, SERIES_PERIOD_MAX, &options->period_px))
        return false;
    if (options->period_px % 2 == 0)
        return true;
    snprintf(context->message, MESSAGE_SIZE, "%s: %d is not allowed; allowed: even numbers",
             context->option, options->period_px);
    return false;
}

static bool take_format(const struct value_context *context, const char *text,
                        struct capture_options *options)
{
    int index;

    if (!value_name(context, text, photo_format_name, &index))
        return false;
    options->format = (enum photo_format)index;
    return true;
}

static bool take_seed(const struct value_context *context, const char *text,
                      struct capture_options *options)
{
    int seed;

    if (!value_integer(context, text, 0, 1000000, &seed))
        return false;
    options->seed = (uint64_t)seed;
    return true;
}

/* Options of one number. */
static bool take_number(enum name name, const struct value_context *context, const char *text,
                        struct capture_options *options)
{
    static const struct number_range ranges[NAMES] = {
        [EVERY] = {.low = 0, .high = 3600, .above_low = true},
        [CONTRAST] = {.low = 0, .high = 1, .above_low = true},
        [NOISE] = {.low = 0, .high = 1},
        [VIGNETTING] = {.low = 0, .high = 0.95},
        [AMBIENT] = {.low = 0, .high = 10},
        [BLUR] = {.low = 0, .high = 16},
        [EXPOSURE] = {.low = 0, .high = 100, .above_low = true},
    };
    double *number = name == EVERY        ? &options->every_s
                     : name == CONTRAST   ? &options->contrast
                     : name == NOISE      ? &options->noise
                     : name == VIGNETTING ? &options->vignetting
                     : name == AMBIENT    ? &options->ambient
                     : name == BLUR       ? &options->blur_px
                                          : &options->exposure;

    return value_number(context, text, ranges[name], number);
}

/* Options of one whole number; all others have one with a fraction. */
static bool take_integer(enum name name, const struct value_context *context, const char *text,
                         struct capture_options *options)
{
    switch (name) {
    case PROJECTOR:
        return value_integer(context, text, 0, CUPOLA_OUTPUTS_MAX - 1, &options->projector);
    case STEPS:
        return value_integer(context, text, SERIES_STEPS_MIN, SERIES_STEPS_MAX, &options->steps);
    case MONITOR:
        return value_integer(context, text, 0, 63, &options->monitor);
    case SHOTS:
        return value_integer(context, text, 1, 1000, &options->shots);
    case SETTLE:
        return value_integer(context, text, 0, 1000, &options->settle);
    case MARKS:
        return value_integer(context, text, 12, 5000, &options->marks);
    default:
        return take_number(name, context, text, options);
    }
}

/* Options that name a file or a folder, and those of numbers. */
static bool take_file(enum name name, const struct value_context *context, const char *text,
                      struct capture_options *options)
{
    switch (name) {
    case RIG:
        return value_path(context, text, &options->rig);
    case FOLDER:
        return value_path(context, text, &options->folder);
    case PATTERNS:
        return value_path(context, text, &options->patterns);
    case DEVICE:
        return value_path(context, text, &options->device);
    case OUTPUT:
        return value_path(context, text, &options->output);
    case SOLVED:
        return value_path(context, text, &options->solved);
    case REFERENCES:
        return value_path(context, text, &options->references);
    default:
        return take_integer(name, context, text, options);
    }
}

static bool take(enum name name, const struct value_context *context, const char *text,
                 struct capture_options *options)
{
    switch (name) {
    case HELP:
        return options->help = true;
    case WINDOW:
        return options->window = true;
    case LINEAR:
        return options->linear = true;
    case CAMERA:
        options->camera = text;
        return true;
    case FREE:
        return pose_free_parse(context->option, text, &options->free, context->message);
    case PHOTO_SIZE:
        return take_photo_size(context, text, options);
    case PERIOD:
        return take_period(context, text, options);
    case CIRCLE:
        return take_circle(context, text, options);
    case POSITION:
        return take_position(context, text, options);
    case AIM:
        return take_aim(context, text, options);
    case FORMAT:
        return take_format(context, text, options);
    case SEED:
        return take_seed(context, text, options);
    default:
        return take_file(name, context, text, options);
    }
}

static bool check(const struct capture_options *options, const bool *given, char *message)
{
    const char *problem = NULL;
    int bit = 1 << options->command;

    for (int i = 0; i < NAMES; i++) {
        bool refused = given[i] && !(table[i].known & bit);
        bool missing = !given[i] && table[i].needed & bit;
        if (!refused && !missing)
            continue;
        snprintf(message, MESSAGE_SIZE,
                 refused ? "--%s is not for %s" : "--%s is missing; %s needs it", table[i].name,
                 capture_command_name((int)options->command));
        return false;
    }
    if (options->command != CAPTURE_DECODE && options->photo_count > 0) {
        snprintf(message, MESSAGE_SIZE, "'%.200s' is not allowed; allowed: options",
                 options->photos[0]);
        return false;
    }
    if (options->command == CAPTURE_DECODE && !options->photo_count == !options->folder)
        problem = "decode needs photographs: either their names in order or --folder DIR, not both";
    else if (options->command == CAPTURE_DECODE && !options->patterns && !options->folder)
        problem = "--patterns is missing; decode needs it where photographs are given by name";
    else if (given[SHOTS] > given[DEVICE] || given[SETTLE] > given[DEVICE] ||
             (options->command == CAPTURE_SHOW && given[DEVICE] != given[FOLDER]))
        problem = "--shots, --settle and --folder of show need --device, and --device needs "
                  "--folder";
    if (problem)
        snprintf(message, MESSAGE_SIZE, "%s", problem);
    return !problem;
}

static bool read_all(int argc, char **argv, struct capture_options *options, bool *given,
                     char *message)
{
    struct option list[NAMES + 1] = {{0}};
    int value;

    for (int i = 0; i < NAMES; i++)
        list[i] = (struct option){table[i].name, table[i].plain ? no_argument : required_argument,
                                  NULL, i};
    optind = 0;
    while ((value = getopt_long(argc, argv, ":", list, NULL)) != -1) {
        char option[64];
        struct value_context context = {option, message};
        if (value == '?' || value == ':') {
            snprintf(message, MESSAGE_SIZE,
                     value == ':' ? "%.200s needs a value" : "%.200s is no option of capture",
                     argv[optind - 1]);
            return false;
        }
        snprintf(option, sizeof option, "--%s", table[value].name);
        if (!take((enum name)value, &context, optarg, options))
            return false;
        given[value] = true;
    }
    options->photos = argv + optind;
    options->photo_count = argc - optind;
    return true;
}

int capture_options_parse(int argc, char **argv, struct capture_options *options, char *message)
{
    bool given[NAMES] = {false};
    int command = 0;

    *options = (struct capture_options){
        .steps = 4,
        .monitor = -1,
        .shots = 1,
        .settle = 5,
        .contrast = 0.02,
        .marks = 300,
        .exposure = 0.8,
    };
    if (argc > 1 && strcmp(argv[1], "--help") == 0) {
        options->help = true;
        return STATUS_OK;
    }
    while (argc > 1 && capture_command_name(command) &&
           strcmp(argv[1], capture_command_name(command)) != 0)
        command++;
    if (argc < 2 || !capture_command_name(command)) {
        snprintf(message, MESSAGE_SIZE,
                 "'%.100s' is no command of capture; allowed: patterns, "
                 "show, decode, simulate (--help says more)",
                 argc < 2 ? "" : argv[1]);
        return STATUS_USAGE;
    }
    options->command = (enum capture_command)command;
    opterr = 0;
    if (!read_all(argc - 1, argv + 1, options, given, message))
        return STATUS_USAGE;
    if (options->help || (check(options, given, message) &&
                          (options->command == CAPTURE_DECODE ||
                           folder_is_another(options->folder, options->patterns, message))))
        return STATUS_OK;
    return STATUS_USAGE;
}
